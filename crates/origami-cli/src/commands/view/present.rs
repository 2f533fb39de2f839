//! A build with the feature `view`.

use std::net::{Ipv4Addr, TcpListener};
use std::path::Path;
use std::sync::Arc;

use origami::{CreasePattern, Material, Model};

use super::computer::Chosen;
use super::secret::secret;
use super::server::{First, Server};
use super::{browser, server};
use crate::args::ViewArgs;
use crate::console;
use crate::exit::{Exit, Failure};
use crate::files::{Input, Reading};

/// Listens until it is stopped.
///
/// # Errors
/// That the pattern is wrong, the backend not there, or the port taken.
pub(in crate::commands) fn run(args: &ViewArgs) -> Result<Exit, Failure> {
    let reading = Reading::new(&args.reading)?;
    let first = args.file.as_deref().map(|path| first(path, &reading)).transpose()?;
    let computer = Chosen::new(args.backend, args.adapter.as_deref())?;
    // Nobody but this machine is listened to.
    let at = |error| format!("--port {}: {error}; expected one that is free, or 0", args.port);
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, args.port)).map_err(at)?;
    let port = listener.local_addr().map_err(at)?.port();
    let server = Server { secret: secret()?, first, reading: reading.of_a_page(), computer };
    let address = format!("http://127.0.0.1:{port}/{}/", server.secret);
    console::print_text(&format!("{address}\nCtrl-C ends it.\n"))?;
    if !args.no_open {
        browser::open(&address);
    }
    server::serve(&listener, &Arc::new(server));
    Ok(Exit::Done)
}

/// The file that the page opens at once. What is wrong with it is told here rather than there.
fn first(path: &Path, reading: &Reading) -> Result<First, Failure> {
    let input = Input::new(path, reading);
    let told = |error| input.describe(&error);
    let (bytes, opened) = input.bytes().map_err(told)?;
    let frame = opened.document.pattern_frame().map_err(told)?;
    let pattern = CreasePattern::from_document(&opened.document, frame).map_err(told)?;
    Model::new(&pattern, &Material::default()).map_err(told)?;
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    Ok(First { name: if name == "-" { "stdin".to_owned() } else { name }, bytes })
}
