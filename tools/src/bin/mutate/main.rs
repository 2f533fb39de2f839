//! Mutates crease patterns of all formats, puts each through readers, solver and writers, and counts what came of it.
//!
//! `cargo run --release -p origami-tools --bin mutate -- SECONDS SEED FILE ...`
//!
//! A panic, an input that takes longer than `LIMIT`, a number that is none in an output, and an output that does not read
//! back are faults: the input is kept in the folder `faults`, and the exit code is 1.
#![expect(clippy::print_stdout, reason = "a tool prints what it found")]

mod mutation;
mod trial;

use std::collections::BTreeMap;
use std::error::Error;
use std::panic::catch_unwind;
use std::process::ExitCode;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};

use mutation::{Random, mutated};
use origami::formats::Format;
use trial::Reached;

/// One input may take this long.
const LIMIT: Duration = Duration::from_secs(60);

/// What came of an input.
type Answer = Result<Reached, String>;

/// A thread that tries what it is sent, until it hangs.
struct Trier {
    inputs: Sender<Vec<u8>>,
    answers: Receiver<Answer>,
}

impl Trier {
    fn start() -> Self {
        let (inputs, received) = channel::<Vec<u8>>();
        let (answer, answers) = channel();
        std::thread::spawn(move || {
            for bytes in received {
                let tried = catch_unwind(|| trial::run(&bytes)).unwrap_or_else(|_| Err("a panic".into()));
                if answer.send(tried).is_err() {
                    break;
                }
            }
        });
        Self { inputs, answers }
    }

    /// `None` where it hangs: it cannot be used again.
    fn try_it(&self, bytes: &[u8]) -> Option<Answer> {
        self.inputs.send(bytes.to_vec()).ok()?;
        self.answers.recv_timeout(LIMIT).ok()
    }
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let mut words = std::env::args().skip(1);
    let (Some(seconds), Some(seed)) = (words.next(), words.next()) else {
        return Err("expected SECONDS SEED FILE ...".into());
    };
    let end = Instant::now() + Duration::from_secs(seconds.parse()?);
    let mut random = Random::new(seed.parse()?);
    let files = words.map(std::fs::read).collect::<Result<Vec<_>, _>>()?;
    if files.is_empty() {
        return Err("expected files to mutate".into());
    }
    let mut trier = Trier::start();
    let mut counts: BTreeMap<String, [usize; 5]> = BTreeMap::new();
    let (mut faults, mut slowest) = (0, Duration::ZERO);
    while Instant::now() < end {
        let (file, other) = (&files[random.below(files.len())], &files[random.below(files.len())]);
        let bytes = mutated(file, other, &mut random);
        let begun = Instant::now();
        let answer = trier.try_it(&bytes);
        slowest = slowest.max(begun.elapsed());
        match answer {
            Some(Ok(reached)) => {
                let format = Format::of(&bytes, None).map_or("none".to_owned(), |format| format!("{format:?}"));
                counts.entry(format).or_default()[reached as usize] += 1;
            }
            fault => {
                if fault.is_none() {
                    trier = Trier::start();
                }
                let told = fault.map_or("a hang".to_owned(), |answer| answer.err().unwrap_or_default());
                std::fs::create_dir_all("faults")?;
                std::fs::write(format!("faults/{faults:04}"), &bytes)?;
                println!("faults/{faults:04}: {told}");
                faults += 1;
            }
        }
    }
    println!("| format | refused | lines only | no model | not folded | folded |\n|---|---|---|---|---|---|");
    for (format, [refused, read, cleaned, built, folded]) in counts {
        println!("| {format} | {refused} | {read} | {cleaned} | {built} | {folded} |");
    }
    println!("{faults} faults; slowest {:.2} s", slowest.as_secs_f64());
    Ok(if faults == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
