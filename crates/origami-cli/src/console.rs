//! What a person reads. Nothing here fails where nobody reads.

use std::fmt::Display;
use std::io::{self, Write};

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
    let _ = writeln!(io::stderr().lock(), "{line}");
}

/// Bytes to standard output.
///
/// # Errors
/// What the system says; a broken pipe among them.
pub(crate) fn print(bytes: &[u8]) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(bytes)?;
    stdout.flush()
}
