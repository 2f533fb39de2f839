//! `origami info`: as much of a file as can be told, and why not more.

mod check;
mod facts;
mod flat;
mod text;

use crate::args::InfoArgs;
use crate::console;
use crate::exit::{Exit, Failure};
use crate::files::{Input, Reading};

use facts::Facts;
use origami::Material;

/// Tells what is in a file.
pub(super) fn run(args: &InfoArgs) -> Result<Exit, Failure> {
    let input = Input::new(&args.input, &Reading::new(&args.reading)?);
    let facts = Facts::gather(&input, args, &args.material.material(Material::default()));
    if args.json {
        let mut text = serde_json::to_vec_pretty(&facts).map_err(|error| error.to_string())?;
        text.push(b'\n');
        console::print(&text)?;
    } else {
        console::print_text(&text::of(&facts))?;
    }
    match facts.error {
        None => Ok(Exit::Done),
        Some(error) => {
            console::error(&error);
            Ok(Exit::BadInput)
        }
    }
}
