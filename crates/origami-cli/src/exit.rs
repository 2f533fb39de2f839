//! How the program ends.

use std::io;
use std::process::ExitCode;

/// What became of a run, the least severe first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Exit {
    /// Converged, or the asked number of steps done: 0.
    Done,
    /// The step limit came before convergence: 3.
    NotConverged,
    /// The state diverged: 2.
    Diverged,
    /// Bad input or usage: 1.
    BadInput,
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(match exit {
            Exit::Done => 0,
            Exit::BadInput => 1,
            Exit::Diverged => 2,
            Exit::NotConverged => 3,
        })
    }
}

/// Why a command ends early.
#[derive(Debug)]
pub(crate) enum Failure {
    /// What standard error is told.
    Message(String),
    /// Nobody reads standard output any more.
    BrokenPipe,
}

impl From<String> for Failure {
    fn from(message: String) -> Self {
        Self::Message(message)
    }
}

impl From<origami::Error> for Failure {
    fn from(error: origami::Error) -> Self {
        match error {
            origami::Error::Io { source, .. } if source.kind() == io::ErrorKind::BrokenPipe => Self::BrokenPipe,
            other => Self::Message(other.to_string()),
        }
    }
}

/// From writing to standard output.
impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::BrokenPipe,
            _ => Self::Message(format!("-: {error}")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_most_severe_is_the_largest() {
        let order = [Exit::Done, Exit::NotConverged, Exit::Diverged, Exit::BadInput];
        assert!(order.is_sorted());
        let codes = order.map(|exit| format!("{:?}", ExitCode::from(exit)));
        assert_eq!(codes, [0, 3, 2, 1].map(|code| format!("{:?}", ExitCode::from(code))));
    }
}
