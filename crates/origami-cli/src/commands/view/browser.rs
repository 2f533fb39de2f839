//! The user's browser.

use std::process::{Command, Stdio};

/// Opens an address, where there is something to open it with: the address was printed, so that nothing is lost where there
/// is not.
pub(super) fn open(address: &str) {
    let (program, before): (&str, &[&str]) = if cfg!(target_os = "macos") {
        ("open", &[])
    } else if cfg!(windows) {
        ("cmd", &["/c", "start", ""])
    } else {
        ("xdg-open", &[])
    };
    let started = Command::new(program)
        .args(before)
        .arg(address)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
    if let Ok(mut child) = started {
        // It is not left behind as a process that nobody has waited for.
        std::thread::spawn(move || child.wait());
    }
}
