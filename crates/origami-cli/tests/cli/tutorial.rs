//! docs/TUTORIAL.md says what the program says.
#![cfg(feature = "newton")]

use std::fs;
use std::path::Path;

use crate::place::Place;

/// A command of the page, and the lines that it shows.
struct Shown<'a> {
    words: &'a str,
    lines: Vec<&'a str>,
}

/// All commands of the page that are this program's alone.
fn shown(page: &str) -> Vec<Shown<'_>> {
    let mut all = Vec::new();
    let blocks = page.split("```console\n").skip(1).filter_map(|block| block.split_once("```").map(|(own, _)| own));
    for line in blocks.flat_map(str::lines) {
        match line.strip_prefix("$ ") {
            Some(command) => all.push(Shown { words: command, lines: Vec::new() }),
            None => all.last_mut().into_iter().for_each(|last: &mut Shown<'_>| last.lines.push(line)),
        }
    }
    all.retain(|shown| shown.words.starts_with("origami ") && !shown.words.contains(['|', ';', '>']));
    all
}

/// Without the estimate and the time, which differ from one machine to another.
fn lasting(line: &str) -> String {
    let (before, after) = match line.split_once(" (distance ") {
        Some((before, rest)) => (before, rest.split_once(')').map_or("", |(_, after)| after)),
        None => (line, ""),
    };
    let all = format!("{before}{after}");
    match all.rsplit_once(", ") {
        Some((before, time)) if time.ends_with(" ms") || time.ends_with(" s") => before.to_owned(),
        _ => all,
    }
}

#[test]
fn its_commands_say_what_it_shows() {
    let place = Place::new();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let page = fs::read_to_string(root.join("docs/TUTORIAL.md")).unwrap();
    fs::create_dir_all(place.path("examples/patterns")).unwrap();
    for name in ["miura", "crane", "hypar"] {
        let name = format!("examples/patterns/{name}.fold");
        fs::copy(root.join(&name), place.path(&name)).unwrap();
    }
    for (name, after) in [("map.fold", "as `map.fold`:"), ("cross.fold", "as\n`cross.fold`:")] {
        let (_, text) = page.split_once(after).unwrap().1.split_once("```json\n").unwrap();
        place.put(name, text.split_once("```").unwrap().0);
    }
    let all = shown(&page);
    assert!(all.len() > 15, "{} commands", all.len());
    for Shown { words, lines } in all {
        // A study takes seconds.
        if words.contains("study") {
            continue;
        }
        let ran = place.run(words.strip_prefix("origami ").unwrap());
        let said: Vec<String> = ran.stderr.lines().chain(ran.stdout.lines()).map(lasting).collect();
        for line in lines {
            assert!(said.contains(&lasting(line)), "{words}: it does not say {line:?}, but {said:#?}");
        }
    }
}

#[test]
fn what_lasts_is_compared() {
    let line =
        "m.fold: folded to 60 % in 720 steps, not converged (distance 5.2e-5 of the radius), strain mean 0.71 %, 34 ms";
    let lasts = "m.fold: folded to 60 % in 720 steps, not converged, strain mean 0.71 %";
    assert_eq!(lasting(line), lasts);
    assert_eq!(lasting("  model       9 vertices, 16 beams"), "  model       9 vertices, 16 beams");
    let page = "```console\n$ origami info a\nb\nc\n$ jq . a\nd\n```\n";
    let all = shown(page);
    assert_eq!((all.len(), all[0].words, all[0].lines.as_slice()), (1, "origami info a", &["b", "c"][..]));
}
