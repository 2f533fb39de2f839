//! What one may expect of any program: nothing silent, nothing late, nothing raw.

use std::time::{Duration, Instant};

use serde_json::json;

use crate::place::{Place, SQUARE};

/// With a sheet that is a ring in space.
#[cfg(feature = "render")]
fn with_ring() -> Place {
    let place = Place::new();
    let ring = Place::new();
    ring.run("pattern kresling-ring -o ring.fold").succeeds();
    place.put("ring.fold", &ring.text("ring.fold"));
    place
}

#[cfg(feature = "render")]
#[test]
fn what_cannot_be_is_refused_before_the_first_step_and_before_any_output() {
    let place = with_ring();
    place.put("a.obj", "as it was");
    for (words, expected) in [
        ("fold ring.fold -o a.obj -o b.svg", "ring.fold: vertices_coords: the sheet is not flat"),
        ("fold square.fold -o a.obj -o a.png --size 1x1", "1 x 1 pixels leave no room for the sheet"),
        ("fold square.fold -o a.obj --frames 2 --animate f.gif --size 1x1", "leave no room"),
        ("fold square.fold -o a.obj --sheet s.png --size 1x1", "leave no room"),
        ("render ring.fold -o a.png -o a.svg", "the sheet is not flat"),
        ("convert ring.fold -o a.fold -o b.svg", "ring.fold: "),
        ("sweep ring.fold -o out --folded obj,svg", "ring.fold: vertices_coords: the sheet is not flat"),
        (
            "fold square.fold -o a.obj -o x.glb --frames 40000",
            "40001 states are more than a file holds; expected at most",
        ),
    ] {
        let begun = Instant::now();
        place.run(words).fails(1, expected);
        assert!(begun.elapsed() < Duration::from_secs(20), "{words}");
        assert_eq!(place.text("a.obj"), "as it was", "{words}");
        assert_eq!(place.names(), ["a.obj", "ring.fold", "square.fold"], "{words} leaves nothing behind");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn what_cannot_be_written_is_refused_before_any_output() {
    let place = Place::new();
    for words in [
        "fold square.fold -o a.obj --report /sys/r.json",
        "fold square.fold -o a.obj -o /sys/a.stl",
        "fold square.fold -o a.obj -o /sys/new/",
        "sweep square.fold -o /sys/out",
        "pattern miura -o /sys/a.fold",
        "convert square.fold -o a.fold -o /sys/a.fold",
        "render square.fold -o a.png -o /sys/a.svg",
    ] {
        let ran = place.run(words);
        ran.fails(1, "nothing can be written into the folder /sys: ");
        assert!(!ran.stderr.contains(".part"), "{}", ran.stderr);
        assert_eq!(place.names(), ["square.fold"], "{words}");
    }
}

#[cfg(feature = "render")]
#[test]
fn a_report_says_what_was_written_before_an_error() {
    let place = Place::new();
    std::fs::create_dir(place.path("f-001.png")).unwrap();
    let words = "fold square.fold -o a.obj --frames 2 --animate f-.png --size 60x60 --samples 1 --report r.json";
    let ran = place.run(words);
    ran.fails(1, "f-001.png: ");
    let report = place.json("r.json");
    assert_eq!(report["outputs"], json!(["a.obj"]));
    assert!(report["error"].as_str().unwrap().contains("f-001.png"));
    assert!(place.has("a.obj"));
}

#[test]
fn text_from_outside_steers_no_terminal() {
    let place = Place::new();
    place.put("letter.fold", &SQUARE.replace("\"V\"", "\"\\u001b[31mV\""));
    place.put(
        "title.fold",
        &SQUARE.replace("\"file_spec\": 1.2", r#""file_spec": 1.2, "file_title": "a\u202etxt.exe""#),
    );
    place.put("\u{1b}[31mx.fold", SQUARE);
    for words in [
        &["info", "letter.fold"][..],
        &["info", "title.fold"],
        &["info", "\u{1b}[31mx.fold"],
        &["info", "\u{1b}[31mmissing.fold"],
        &["fold", "\u{1b}[31mx.fold", "-o", "\u{1b}[2Ja.obj"],
        &["fold", "\u{1b}[31mx.fold", "letter.fold", "-o", "out/"],
        &["sweep", "\u{1b}[31mx.fold", "-o", "\u{1b}[2Jout", "--percent", "1"],
        &["render", "\u{1b}[31mx.fold", "-o", "\u{1b}[2Ja.svg"],
        &["convert", "\u{1b}[31mx.fold", "-o", "\u{1b}[2Ja.fold"],
        &["pattern", "\u{1b}[31mmiura", "-o", "b.fold"],
        &["pattern", "miura", "--set", "\u{1b}[31m=3", "-o", "b.fold"],
        &["\u{1b}[31mfold"],
        &["fold", "square.fold", "--\u{1b}[31mpercent"],
        &["fold", "square.fold", "-o", "a.obj", "--backend", "gpu", "--adapter", "\u{1b}[31mnone\u{202e}"],
    ] {
        let output = place.command().args(words).output().unwrap();
        for said in [output.stdout, output.stderr] {
            let said = String::from_utf8(said).unwrap();
            assert!(!said.contains(['\u{1b}', '\u{202e}', '\r']), "{words:?}: {said:?}");
        }
    }
    let ran = place.run("info letter.fold");
    assert!(ran.stdout.contains(r"3 edges") || ran.stdout.contains(r"(\u{1b}[31mV 1, B 4)"), "{}", ran.stdout);
    assert!(place.run("info title.fold").stdout.contains(r"a\u{202e}txt.exe"));
    // For programs all is as it is.
    let facts: serde_json::Value = serde_json::from_str(&place.run("info title.fold --json").stdout).unwrap();
    assert_eq!(facts["file"]["title"], json!("a\u{202e}txt.exe"));
}

#[test]
fn a_long_title_is_cut() {
    let place = Place::new();
    let title = format!(r#""file_spec": 1.2, "file_title": "{}""#, "x".repeat(100_000));
    place.put("long.fold", &SQUARE.replace("\"file_spec\": 1.2", &title));
    let ran = place.run("info long.fold");
    assert!(ran.stdout.contains("xxx... and 99 800 more characters\n") && ran.stdout.len() < 2000);
}

#[test]
fn more_threads_than_help_are_not_started() {
    let place = Place::new();
    for command in ["fold square.fold -o a.obj", "sweep square.fold -o out --percent 1"] {
        let begun = Instant::now();
        let ran = place.run(&format!("{command} --threads 18446744073709551615"));
        assert_eq!(ran.code, 0, "{}", ran.stderr);
        assert!(ran.stderr.starts_with("warning: --threads 18446744073709551615: more than help; "), "{}", ran.stderr);
        assert!(begun.elapsed() < Duration::from_secs(20));
    }
}

#[cfg(feature = "render")]
#[test]
fn a_picture_beside_an_output_changes_nothing_in_it() {
    let place = Place::new();
    place.run("pattern waterbomb -o w.fold").succeeds();
    let fold = "fold w.fold --percent 70 --quiet --report r.json -o a.obj -o a.fold";
    let timeless = || {
        let mut report = place.json("r.json");
        for key in ["seconds", "outputs"] {
            report.as_object_mut().unwrap().remove(key).unwrap();
        }
        (report, place.text("a.obj"), place.text("a.fold"))
    };
    place.run(fold).succeeds();
    let alone = timeless();
    for pictures in [
        "-o p.png",
        "--sheet s.png",
        "--png p.png --strain",
        "--sheet s.png --map energy -o p.svg",
        "--animate t.gif --turntable 2",
        "-o p.glb",
    ] {
        // Warned of where it is no picture: glTF has no size.
        assert_eq!(place.run(&format!("{fold} {pictures} --size 300x240 --samples 1")).code, 0);
        assert!(timeless() == alone, "{pictures}");
    }
    // And the pictures are those that they are without the outputs.
    let sheet = std::fs::read(place.path("s.png")).unwrap();
    place.run("fold w.fold --percent 70 --quiet --sheet t.png --map energy --size 300x240 --samples 1").succeeds();
    assert!(std::fs::read(place.path("t.png")).unwrap() == sheet);
}

#[cfg(feature = "render")]
#[test]
fn only_a_pattern_needs_no_folding() {
    let place = Place::new();
    let ran = place.run("fold square.fold -o out/ --format svg");
    assert!(ran.succeeds().starts_with("square.fold: the crease pattern is drawn, and nothing is folded, "));
    place.run("fold square.fold -o a.svg --report r.json --quiet").succeeds();
    assert_eq!(place.text("out/square.svg"), place.text("a.svg"));
    assert_eq!(place.json("r.json")["converged"], json!(true), "a report needs it");
}

#[cfg(feature = "render")]
#[test]
fn options_that_change_nothing_in_a_picture_are_told() {
    let place = Place::new();
    for (words, expected) in [
        ("-o a.svg --caption x", "--caption has no effect on SVG"),
        (
            "-o a.svg --azimuth 3 --zoom 2 --samples 4",
            "--samples has no effect on SVG\nwarning: --azimuth has no effect on SVG\nwarning: --zoom has no effect on SVG",
        ),
        ("-o a.svg --strain --clip 1", "--strain has no effect on SVG\nwarning: --clip has no effect on SVG"),
        ("-o a.svg --size 300x200", "--size 300x200: SVG has the pattern's proportions, its longer side is 300"),
        (
            "-o a.glb --size 300x200 --background black",
            "--size has no effect on glTF\nwarning: --background has no effect on glTF",
        ),
        ("-o a.svg -o a.glb --caption x", "--caption has no effect on SVG and glTF"),
        (
            "--frames 1 --animate f-.png --fps 3 --size 40x40 --samples 1",
            "--fps has no effect on pictures with numbers",
        ),
        ("-o a.obj --steps 3 --max-steps 5", "--max-steps has no effect with --steps"),
    ] {
        let ran = place.run(&format!("fold square.fold {words}"));
        assert_eq!((ran.code, ran.stderr), (0, format!("warning: {expected}\n")), "{words}");
    }
    place.run("fold square.fold -o a.svg -o a.png --caption x --size 60x60 --samples 1").succeeds();
    let ran = place.run("render square.fold -o a.png --camera front --size 60x60 --samples 1 --adapter x");
    let expected = "warning: --camera has no effect on pictures of crease patterns\nwarning: --adapter has no effect without --backend gpu\n";
    assert_eq!((ran.code, ran.stderr.as_str()), (0, expected));
    let ran = place.run("sweep square.fold -o out --perturbation 0 --seeds 2 --percent 1");
    assert_eq!(ran.stderr, "warning: --seeds has no effect where --perturbation is 0\n");
}

#[cfg(feature = "render")]
#[test]
fn numbered_pictures_have_their_folder_made() {
    let place = Place::new();
    place.run("fold square.fold --frames 1 --animate new/a-.png --size 40x40 --samples 1 --quiet").succeeds();
    assert!(place.has("new/a-000.png") && place.has("new/a-001.png"));
    place.run("fold square.fold --frames 1 --animate other/a.gif").fails(1, "there is no folder other");
}

#[test]
fn help_and_version_are_commands_too() {
    let place = Place::new();
    assert_eq!(place.run("help fold").succeeds(), place.run("fold --help").succeeds());
    assert_eq!(place.run("help").succeeds(), place.run("--help").succeeds());
    assert_eq!(place.run("version").succeeds(), place.run("--version").succeeds());
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told_of_help_too() {
    let place = Place::new();
    for words in ["--help", "fold --help", "help", "--version", "version", "man", "pattern --list", "completions bash"]
    {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let mut command = std::process::Command::new(assert_cmd::cargo::cargo_bin!("origami"));
        let output = command.args(words.split(' ')).current_dir(place.path("")).stdout(full).output().unwrap();
        let told = String::from_utf8(output.stderr).unwrap();
        assert_eq!(
            (output.status.code(), told.as_str()),
            (Some(1), "error: -: No space left on device (os error 28)\n"),
            "{words}"
        );
    }
}

#[test]
fn minus_nothing_is_nothing() {
    let place = Place::new();
    place.run("sweep square.fold --percent=-0,0 -o out --quiet").succeeds();
    let text = place.text("out/sweep.csv");
    let percents: Vec<&str> = text.lines().skip(1).map(|line| line.split(',').nth(8).unwrap()).collect();
    assert_eq!(percents, ["0.0", "0.0"]);
    place.run("fold square.fold --percent -0 --report r.json").succeeds();
    assert!(place.text("r.json").contains("\"percent\": 0.0"));
}

#[test]
fn numbers_are_rounded_for_people_and_whole_for_programs() {
    let place = Place::new();
    place.put("third.fold", &SQUARE.replace("[1, 0], [1, 1], [0, 1]", "[5.999999919246756, 0], [5, 5], [0, 5]"));
    let ran = place.run("info third.fold");
    assert!(ran.stdout.contains("longest side 6\n"), "{}", ran.stdout);
    place.run("fold square.fold --frames 3 -o a.fold --quiet").succeeds();
    let film = place.json("a.fold");
    let titles: Vec<&str> =
        film["file_frames"].as_array().unwrap().iter().map(|f| f["frame_title"].as_str().unwrap()).collect();
    assert_eq!(titles, ["0 %", "33.3333 %", "66.6667 %", "100 %"]);
    assert_eq!(film["file_frames"][1]["origami:percent"], json!(100.0 / 3.0));
}

#[test]
fn what_a_killed_program_left_goes_away() {
    let place = Place::new();
    place.put(".origami-abcdef.part", "left over");
    let file = std::fs::File::options().write(true).open(place.path(".origami-abcdef.part")).unwrap();
    place.run("fold square.fold -o a.obj --quiet").succeeds();
    assert!(place.has(".origami-abcdef.part"), "another program may still write it");
    file.set_modified(std::time::SystemTime::now() - Duration::from_hours(25)).unwrap();
    place.run("fold square.fold -o a.obj --quiet").succeeds();
    assert_eq!(place.names(), ["a.obj", "square.fold"]);
}

#[test]
fn the_manual_page_keeps_its_lines_and_names_no_page_that_is_missing() {
    let place = Place::new();
    let page = place.run("man");
    let page = page.succeeds();
    assert!(!page.contains("EXTRA") && !page.contains("origami\\-fold(1)"), "{page}");
    assert!(
        page.contains(".SH \"EXAMPLES\"\n.nf\n  origami pattern miura \\-\\-set columns=6 \\-o miura.fold  "),
        "{page}"
    );
    assert!(page.contains(".TP\n\\fBsweep\\fR\nFold one crease pattern in many ways"), "{page}");
    assert_eq!(page.matches(".nf\n").count(), page.matches(".fi\n").count());
}

#[test]
fn completion_knows_the_patterns() {
    let place = Place::new();
    for shell in ["bash", "zsh", "fish"] {
        let script = place.run(&format!("completions {shell}"));
        for name in ["miura", "waterbomb", "square-twist"] {
            assert!(script.succeeds().contains(name), "{shell}: {name}");
        }
    }
}

/// Where there is no display, Mesa's libraries complain, whoever has loaded them.
#[cfg(target_os = "linux")]
#[test]
fn the_libraries_of_drivers_stay_silent() {
    let place = Place::new();
    for words in ["adapters", "sweep square.fold --percent 0:100:0.03 --steps 1 -o out --quiet"] {
        let mut command = place.command();
        command.env_remove("NODEVICE_SELECT").env_remove("XDG_RUNTIME_DIR").args(words.split(' '));
        let output = command.output().unwrap();
        let told = String::from_utf8(output.stderr).unwrap();
        assert!(!told.contains("XDG_RUNTIME_DIR"), "{words}: {told}");
    }
}
