//! Completions and the manual page, both made from the definition of the command line.

use clap_complete::Shell;

use crate::args;
use crate::console;
use crate::exit::{Exit, Failure};

/// A completion script.
pub(super) fn completions(shell: Shell) -> Result<Exit, Failure> {
    let mut text = Vec::new();
    clap_complete::generate(shell, &mut args::definition(), "origami", &mut text);
    console::print(&text)?;
    Ok(Exit::Done)
}

/// The manual page, with a part for each command.
pub(super) fn man() -> Result<Exit, Failure> {
    let mut definition = args::definition();
    definition.build();
    let mut text = Vec::new();
    clap_mangen::Man::new(definition.clone()).render(&mut text)?;
    for command in definition.get_subcommands() {
        let page = clap_mangen::Man::new(command.clone());
        page.render_name_section(&mut text)?;
        page.render_synopsis_section(&mut text)?;
        page.render_description_section(&mut text)?;
        page.render_options_section(&mut text)?;
        page.render_extra_section(&mut text)?;
    }
    console::print(&text)?;
    Ok(Exit::Done)
}
