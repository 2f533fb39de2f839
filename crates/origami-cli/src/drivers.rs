//! What the libraries of GPU drivers tell standard error of themselves.

use crate::args::{BackendName, Cli, Command};

/// Mesa's layer that puts the adapter of a display first complains where there is no display. It stays out where this is
/// set.
const STAY_OUT: &str = "NODEVICE_SELECT";
/// What it misses.
const MISSED: &str = "XDG_RUNTIME_DIR";

/// Where a GPU is asked for and a library would complain of an environment without a display, the program starts itself
/// again in one that the library does not mind: no variable is set in a process that runs. Nothing happens else, nor where
/// that fails.
pub(crate) fn hush(cli: &Cli) {
    let unset = |name| std::env::var_os(name).is_none();
    if cfg!(all(target_os = "linux", feature = "gpu")) && asks_for_gpu(cli) && unset(MISSED) && unset(STAY_OUT) {
        start_again();
    }
}

/// Whether drivers will be loaded, as far as the command line tells; `auto` loads them only where there is hardware.
fn asks_for_gpu(cli: &Cli) -> bool {
    let asked = |backend: BackendName, adapter: &Option<String>| match backend {
        BackendName::Gpu => true,
        BackendName::Auto => adapter.is_some() || crate::backend::may_have_hardware(),
        BackendName::Cpu => false,
    };
    match &cli.command {
        Command::Fold(args) => asked(args.solving.backend, &args.solving.adapter),
        Command::Sweep(args) => asked(args.solving.backend, &args.solving.adapter),
        Command::Render(args) => args.backend == BackendName::Gpu,
        Command::View(args) => args.backend == BackendName::Gpu,
        Command::Study(args) => args.asks_for_gpu(),
        Command::Adapters(_) => true,
        _ => false,
    }
}

#[cfg(unix)]
fn start_again() {
    use std::os::unix::process::CommandExt;

    let mut arguments = std::env::args_os();
    let name = arguments.next();
    if let (Ok(program), Some(name)) = (std::env::current_exe(), name) {
        // Comes back only where it could not.
        let _ = std::process::Command::new(program).arg0(name).args(arguments).env(STAY_OUT, "1").exec();
    }
}

#[cfg(not(unix))]
fn start_again() {}
