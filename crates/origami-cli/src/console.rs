//! What a person reads. Nothing here fails where nobody reads, and nothing that comes from outside steers the terminal.

use std::fmt::Display;
use std::io::{self, Write};

use crate::text::{plain, plain_lines};

/// To standard error, after `error: `.
pub(crate) fn error(message: &str) {
    say(&format!("error: {message}"));
}

/// To standard error, after `warning: `.
pub(crate) fn warning(message: impl Display) {
    say(&format!("warning: {message}"));
}

/// A line to standard error. The macro of the standard library panics where that is closed.
pub(crate) fn say(line: &str) {
    let _ = writeln!(io::stderr().lock(), "{}", plain(line));
}

/// Lines for a person to standard output.
///
/// # Errors
/// What the system says; a broken pipe among them.
pub(crate) fn print_text(text: &str) -> io::Result<()> {
    print(plain_lines(text).as_bytes())
}

/// Bytes for a program to standard output.
///
/// # Errors
/// What the system says; a broken pipe among them.
pub(crate) fn print(bytes: &[u8]) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(bytes)?;
    stdout.flush()
}
