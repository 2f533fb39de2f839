//! Completions, the manual page and the version, all made from the definition of the command line.

use std::fmt::Write;

use clap_complete::Shell;
use origami::generate::catalog;

use crate::args;
use crate::console;
use crate::exit::{Exit, Failure};

/// Fish's condition for the names of patterns.
const IN_PATTERN: &str = "__fish_origami_using_subcommand pattern";

/// A completion script.
pub(super) fn completions(shell: Shell) -> Result<Exit, Failure> {
    let mut text = Vec::new();
    clap_complete::generate(shell, &mut args::definition(), "origami", &mut text);
    if shell == Shell::Fish {
        // What is generated for fish has the values of options alone.
        let names = catalog::names().join(" ");
        text.extend(format!("complete -c origami -n \"{IN_PATTERN}\" -f -a \"{names}\"\n").into_bytes());
    }
    console::print(&text)?;
    Ok(Exit::Done)
}

/// The same as `--version`.
pub(super) fn version() -> Result<Exit, Failure> {
    console::print(args::definition().render_version().as_bytes())?;
    Ok(Exit::Done)
}

/// The manual page, with a part for each command.
pub(super) fn man() -> Result<Exit, Failure> {
    let mut definition = args::definition();
    definition.build();
    let mut text = Vec::new();
    let page = clap_mangen::Man::new(definition.clone());
    page.render_title(&mut text)?;
    page.render_name_section(&mut text)?;
    page.render_synopsis_section(&mut text)?;
    page.render_description_section(&mut text)?;
    page.render_options_section(&mut text)?;
    text.extend(commands(&definition).into_bytes());
    text.extend(verbatim(&definition).into_bytes());
    for command in definition.get_subcommands().filter(|command| command.get_name() != "help") {
        let page = clap_mangen::Man::new(command.clone());
        page.render_name_section(&mut text)?;
        page.render_synopsis_section(&mut text)?;
        page.render_description_section(&mut text)?;
        page.render_options_section(&mut text)?;
        text.extend(verbatim(command).into_bytes());
    }
    page.render_version_section(&mut text)?;
    console::print(&text)?;
    Ok(Exit::Done)
}

/// The commands with what each does; all are on this page.
fn commands(definition: &clap::Command) -> String {
    let mut text = ".SH COMMANDS\n".to_owned();
    for command in definition.get_subcommands() {
        let about = command.get_about().map_or_else(String::new, ToString::to_string);
        // Writing to a string cannot fail.
        let _ = write!(text, ".TP\n\\fB{}\\fR\n{}\n", roff(command.get_name()), roff(about.trim()));
    }
    text
}

/// Examples and exit codes, line for line as help has them, each under a heading of its own.
fn verbatim(command: &clap::Command) -> String {
    let after = command.get_after_help().map_or_else(String::new, ToString::to_string);
    let mut text = String::new();
    let mut open = false;
    for line in after.lines().filter(|line| !line.is_empty()) {
        let (heading, rest) = match line.split_once(':') {
            Some(("Example" | "Examples", rest)) => ("EXAMPLES", rest),
            Some(("Exit codes", rest)) => ("EXIT STATUS", rest),
            _ => ("", line),
        };
        if !heading.is_empty() {
            let end = if open { ".fi\n" } else { "" };
            let _ = write!(text, "{end}.SH \"{heading}\"\n.nf\n");
            open = true;
        }
        if !rest.is_empty() {
            let rest = if heading.is_empty() { rest } else { rest.trim() };
            let _ = writeln!(text, "{}", roff(rest));
        }
    }
    if open {
        text += ".fi\n";
    }
    text
}

/// As roff has it: a line that begins with a dot or a quotation mark is no request.
fn roff(line: &str) -> String {
    let line = line.replace('\\', "\\e").replace('-', "\\-");
    if line.starts_with(['.', '\'']) { format!("\\&{line}") } else { line }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn examples_keep_their_lines() {
        let help = "Examples:\n  a --b   What it does\n  c | d '.'\n\nExit codes: 0 done, 1 not.";
        let command = clap::Command::new("x").after_help(help);
        let expected = ".SH \"EXAMPLES\"\n.nf\n  a \\-\\-b   What it does\n  c | d '.'\n.fi\n.SH \"EXIT STATUS\"\n.nf\n0 done, 1 not.\n.fi\n";
        assert_eq!(verbatim(&command), expected);
        assert_eq!(roff(".b \\"), "\\&.b \\e");
    }
}
