//! What is said of a command line that cannot be read, in the words of all other messages.

use std::error::Error as _;

use clap::error::{ContextKind, ContextValue, ErrorKind};

use crate::nearest::nearest;

/// The message, without `error: `.
pub(crate) fn message(error: &clap::Error) -> String {
    let said = match error.kind() {
        ErrorKind::InvalidSubcommand => subcommand(error),
        ErrorKind::UnknownArgument => unknown(error),
        ErrorKind::InvalidValue => value(error),
        ErrorKind::ValueValidation => error.source().map(|source| format!("{}: {source}", given(error))),
        ErrorKind::MissingRequiredArgument => Some(missing(error)),
        ErrorKind::ArgumentConflict => conflict(error),
        _ => None,
    };
    said.unwrap_or_else(|| {
        // Its first paragraph: what follows is how to ask for help.
        let text = error.to_string();
        let first = text.split("\n\n").next().unwrap_or_default();
        first.trim_start_matches("error: ").split_whitespace().collect::<Vec<_>>().join(" ")
    })
}

fn subcommand(error: &clap::Error) -> Option<String> {
    let name = text(error, ContextKind::InvalidSubcommand)?;
    let definition = super::definition();
    let names: Vec<&str> = definition.get_subcommands().map(clap::Command::get_name).collect();
    let perhaps = perhaps(&name, &names);
    Some(format!("{name}: there is no such command{perhaps}; expected {}", either(&names)))
}

fn unknown(error: &clap::Error) -> Option<String> {
    let given = text(error, ContextKind::InvalidArg)?;
    let usage = usage(error);
    if !given.starts_with('-') || given == "-" {
        return Some(format!("{given}: is one too many; expected {usage}"));
    }
    let perhaps = text(error, ContextKind::SuggestedArg).map_or_else(String::new, |name| format!(", perhaps {name}"));
    let command: Vec<&str> = usage.split(' ').take_while(|word| !word.starts_with(['[', '<', '-'])).collect();
    Some(format!("{given}: there is no such option{perhaps}; `{} --help` has those there are", command.join(" ")))
}

fn value(error: &clap::Error) -> Option<String> {
    let values = texts(error, ContextKind::ValidValue);
    let values: Vec<&str> = values.iter().map(String::as_str).collect();
    let given_value = text(error, ContextKind::InvalidValue)?;
    if given_value.is_empty() {
        let argument = text(error, ContextKind::InvalidArg)?;
        let expected = if values.is_empty() { "one".to_owned() } else { either(&values) };
        return Some(format!("{argument}: no value is given; expected {expected}"));
    }
    let perhaps = perhaps(&given_value, &values);
    Some(format!("{}: is not known{perhaps}; expected {}", given(error), either(&values)))
}

fn missing(error: &clap::Error) -> String {
    let mut names = texts(error, ContextKind::InvalidArg);
    names.sort_by_key(|name| name.starts_with('-'));
    format!("missing: {}; expected {}", names.join(", "), usage(error))
}

fn conflict(error: &clap::Error) -> Option<String> {
    let (one, others) = (text(error, ContextKind::InvalidArg)?, texts(error, ContextKind::PriorArg));
    if others.contains(&one) {
        return Some(format!("{one}: is given twice; expected it once"));
    }
    let others = if others.is_empty() { "other arguments".to_owned() } else { others.join(", ") };
    Some(format!("{one}: cannot be used with {others}; expected one of them"))
}

/// The option and its value as given; of what has no name the value.
fn given(error: &clap::Error) -> String {
    let argument = text(error, ContextKind::InvalidArg).unwrap_or_default();
    let value = text(error, ContextKind::InvalidValue).unwrap_or_default();
    match argument.split([' ', '=']).next().filter(|name| name.starts_with('-')) {
        Some(name) => format!("{name} {value}"),
        None => value,
    }
}

/// How the command is to be used, in one line.
fn usage(error: &clap::Error) -> String {
    let text = match error.get(ContextKind::Usage) {
        Some(ContextValue::StyledStr(usage)) => usage.to_string(),
        _ => return "`origami --help`".to_owned(),
    };
    text.trim_start_matches("Usage:").split_whitespace().collect::<Vec<_>>().join(" ")
}

fn text(error: &clap::Error, kind: ContextKind) -> Option<String> {
    texts(error, kind).into_iter().next()
}

fn texts(error: &clap::Error, kind: ContextKind) -> Vec<String> {
    match error.get(kind) {
        Some(ContextValue::String(one)) => vec![one.clone()],
        Some(ContextValue::Strings(many)) => many.clone(),
        _ => Vec::new(),
    }
}

/// Such as `, perhaps miura`.
fn perhaps(given: &str, names: &[&str]) -> String {
    nearest(given, names.iter().copied()).map_or_else(String::new, |name| format!(", perhaps {name}"))
}

/// Such as `auto, cpu or gpu`.
fn either(names: &[&str]) -> String {
    match names {
        [] => "another".to_owned(),
        [one] => (*one).to_owned(),
        [others @ .., last] => format!("{} or {last}", others.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;
    use crate::args::Cli;

    #[test]
    fn messages_say_what_is_there_and_what_was_expected() {
        let cases = [
            ("swep", "swep: there is no such command, perhaps sweep; expected fold, sweep, merge, "),
            ("unfurl", "unfurl: there is no such command; expected fold, sweep, "),
            (
                "fold a.fold --persent 3 -o b",
                "--persent: there is no such option, perhaps --percent; `origami fold --help` has",
            ),
            ("info a.fold b.fold", "b.fold: is one too many; expected origami info [OPTIONS] <INPUT>"),
            ("fold a.fold -o b --backend tpu", "--backend tpu: is not known; expected auto, cpu or gpu"),
            (
                "fold a.fold -o b --solver rela",
                "--solver rela: is not known, perhaps relax; expected relax, dynamics, newton or reflect",
            ),
            ("fold a.fold -o b --percent nan", "--percent nan: expected a finite number"),
            ("fold a.fold -o b --threads 0", "--threads 0: expected a whole number of at least 1"),
            ("fold a.fold -o b --frames 0", "--frames 0: expected a whole number from 1 to 100000"),
            ("fold a.fold -o b --steps 1.5", "--steps 1.5: expected a whole number of at least 0"),
            ("fold a.fold -o b --percent", "--percent <P>: no value is given; expected one"),
            (
                "fold a.fold -o b --solver",
                "--solver <SOLVER>: no value is given; expected relax, dynamics, newton or reflect",
            ),
            ("fold", "missing: <INPUT>..., --output <OUT>; expected origami fold [OPTIONS] <INPUT>... -o <OUT>"),
            (
                "fold a.fold -o b --strain --map energy",
                "--strain: cannot be used with --map <QUANTITY>; expected one of them",
            ),
            ("fold a.fold -o b --percent 3 --percent 4", "--percent <P>: is given twice; expected it once"),
            ("pattern miurra -o a.fold", "miurra: is not known, perhaps miura; expected "),
        ];
        for (words, expected) in cases {
            let words = std::iter::once("origami").chain(words.split(' '));
            let error = Cli::try_parse_from(words).map(drop).expect_err(expected);
            let said = message(&error);
            assert!(said.starts_with(expected), "{said}");
        }
    }
}
