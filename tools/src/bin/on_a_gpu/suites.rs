//! The tests, and the command, as whoever has this machine would run them.

use std::error::Error;
use std::fs::{File, read_to_string};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::results::{Results, Row};
use crate::run::{Asked, ended_within};
use crate::section::Ended;

/// What the command is asked to do, each word by itself; `*` is the run's folder.
const COMMANDS: [&str; 4] = [
    "adapters",
    "pattern miura --set columns=20 --set rows=20 -o */miura.fold",
    "fold */miura.fold --backend gpu --percent 60 -o */miura-folded.fold --report */miura-report.json",
    "sweep */miura.fold --backend gpu --percent 20,40,60 -o */sweep",
];

/// Runs each program that holds tests, then the command. What they say is kept in files of their names.
///
/// # Errors
/// If one of them cannot be run, or fails.
pub(crate) fn run(asked: &Asked, seconds: f64) -> Result<Ended, Box<dyn Error>> {
    let deadline = Instant::now() + Duration::from_secs_f64(seconds);
    let results = Results::new(&asked.folder, "tests");
    let (mut cut, mut failed) = (false, Vec::new());
    if let Some(origami) = &asked.command {
        for (i, words) in COMMANDS.iter().enumerate() {
            let mut command = Command::new(origami);
            command.args(words.split(' ').map(|word| word.replace('*', &asked.folder.to_string_lossy())));
            let told = asked.folder.join(format!("command-{i}.txt"));
            let ended = finish(command, &told, deadline)?;
            let passed = ended == Some(true);
            let row = Row { sheet: format!("origami {words}"), quantity: "passed".into(), ..Row::default() };
            results.add(Row { value: f64::from(u8::from(passed)), ..row })?;
            if !passed {
                failed.push(format!("origami {words}"));
            }
        }
    }
    for program in &asked.tests {
        let name = program.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let told = asked.folder.join(format!("{name}.txt"));
        let began = Instant::now();
        let ended = finish(Command::new(program), &told, deadline)?;
        let [passed, not_passed] = counted(&read_to_string(&told)?);
        for (quantity, value) in
            [("tests passed", passed), ("tests failed", not_passed), ("seconds", began.elapsed().as_secs_f64())]
        {
            results.add(Row { sheet: name.clone(), quantity: quantity.into(), value, ..Row::default() })?;
        }
        println!("{name}: {passed} tests passed, {not_passed} failed");
        match ended {
            None => cut = true,
            Some(false) => failed.push(name),
            Some(true) => {}
        }
    }
    match failed.is_empty() {
        true => Ok(if cut { Ended::Cut } else { Ended::Whole }),
        false => Err(format!("{}: see the files of their names", failed.join(", ")).into()),
    }
}

/// Whether a program ended well, `None` where it was ended at the deadline; what it says goes to the file `told`.
fn finish(mut command: Command, told: &Path, deadline: Instant) -> Result<Option<bool>, Box<dyn Error>> {
    let out = File::create(told)?;
    command.env("ORIGAMI_REQUIRE_GPU", "1").stdin(Stdio::null()).stderr(out.try_clone()?).stdout(out);
    Ok(ended_within(&mut command.spawn()?, deadline)?.map(|status| status.success()))
}

/// How many tests passed and failed, as the harness tells while they run: it may not come to its summary.
fn counted(told: &str) -> [f64; 2] {
    let count = |ending: &str| told.lines().filter(|l| l.starts_with("test ") && l.ends_with(ending)).count() as f64;
    [count("... ok"), count("... FAILED")]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tests_are_counted_without_a_summary() {
        let told =
            "running 3 tests\ntest a::b ... ok\ntest c ... FAILED\ntest d - should panic ... ok\ntest e ... ignored\n";
        assert_eq!(counted(told), [2.0, 1.0]);
    }
}
