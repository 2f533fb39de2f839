//! What the figures were taken on.

use std::error::Error;
use std::fs::{read_to_string, write};
use std::process::Command;

use origami::gpu::{AdapterSummary, adapters};
use serde_json::{Value, json};

use crate::place::Place;
use crate::section::Ended;

/// The file that describes the machine.
pub(crate) const FILE: &str = "machine.json";

/// Writes it.
///
/// # Errors
/// If it cannot be written.
pub(crate) fn describe(place: &Place) -> Result<Ended, Box<dyn Error>> {
    let machine = json!({
        "adapter": adapter(place.gpu.adapter()),
        "adapters": adapters().iter().map(adapter).collect::<Vec<_>>(),
        "processor": after(&read("/proc/cpuinfo"), "model name"),
        "threads": std::thread::available_parallelism().map_or(1, usize::from),
        "memory": after(&read("/proc/meminfo"), "MemTotal"),
        "system": read("/proc/version").trim(),
        // How many programs wanted a processor, in the mean of the last 1, 5 and 15 minutes.
        "load": read("/proc/loadavg").trim(),
        "nvidia": said("nvidia-smi", &["--query-gpu=name,driver_version,memory.total,clocks.max.sm,clocks.max.mem", "--format=csv"]),
    });
    let text = serde_json::to_string_pretty(&machine)? + "\n";
    println!("{text}");
    write(place.folder.join(FILE), text)?;
    Ok(Ended::Whole)
}

fn adapter(summary: &AdapterSummary) -> Value {
    let limits = summary.limits;
    json!({
        "name": summary.name,
        "kind": summary.kind.to_string(),
        "backend": summary.backend,
        "driver": summary.driver,
        "storage_buffers_per_stage": limits.storage_buffers_per_stage,
        "invocations_per_workgroup": limits.invocations_per_workgroup,
        "workgroup_storage": limits.workgroup_storage,
        "storage_binding": limits.storage_binding,
        "buffer": limits.buffer,
        "unfit": summary.lacks.map(|lack| lack.to_string()),
    })
}

/// What a file of the system says; nothing where there is no such file.
fn read(path: &str) -> String {
    read_to_string(path).unwrap_or_default()
}

/// What a program of the machine says; nothing where there is none.
fn said(program: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program).args(arguments).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// What follows `name :` in the first line that begins so.
fn after(text: &str, name: &str) -> Option<String> {
    let (_, value) = text.lines().find(|line| line.starts_with(name))?.split_once(':')?;
    Some(value.trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_value_of_the_first_line_of_a_name_is_taken() {
        let text = "processor\t: 0\nmodel name\t: Any 1000: fast\nmodel name\t: other\n";
        assert_eq!(after(text, "model name").as_deref(), Some("Any 1000: fast"));
        assert_eq!(after(text, "flags"), None);
    }
}
