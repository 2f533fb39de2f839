//! `origami adapters`: the GPUs that there are.

use crate::args::AdaptersArgs;
use crate::backend;
use crate::console;
use crate::exit::{Exit, Failure};
use crate::numbers::bytes;
use crate::report::AdapterDetails;

/// Lists them.
pub(super) fn run(args: &AdaptersArgs) -> Result<Exit, Failure> {
    let adapters = backend::adapters()?;
    let text = if args.json {
        let mut text = serde_json::to_string_pretty(&adapters).map_err(|error| error.to_string())?;
        text.push('\n');
        text
    } else if adapters.is_empty() {
        format!("{}\n", backend::none())
    } else {
        table(&adapters)
    };
    if args.json {
        console::print(text.as_bytes())?;
    } else {
        console::print_text(&text)?;
    }
    Ok(Exit::Done)
}

const HEADS: [&str; 7] = ["kind", "backend", "name", "buffer", "bindings", "workgroup", "driver"];

fn table(adapters: &[AdapterDetails]) -> String {
    let mut rows = vec![HEADS.map(str::to_owned)];
    rows.extend(adapters.iter().map(|details| {
        let adapter = &details.adapter;
        [
            adapter.kind.clone(),
            adapter.backend.to_owned(),
            adapter.name.clone(),
            bytes(details.buffer),
            format!("{} x {}", details.storage_buffers_per_stage, bytes(details.storage_binding)),
            format!("{}, {}", details.invocations_per_workgroup, bytes(details.workgroup_storage.into())),
            adapter.driver.clone(),
        ]
    }));
    let widths: [usize; 7] =
        std::array::from_fn(|column| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0));
    let mut text = String::new();
    for (i, row) in rows.iter().enumerate() {
        let cells: Vec<String> = row.iter().zip(widths).map(|(cell, width)| format!("{cell:width$}")).collect();
        text += cells.join("  ").trim_end();
        text.push('\n');
        if let Some(why) = i.checked_sub(1).and_then(|i| adapters[i].unfit.as_ref()) {
            text += &format!("{:widths$}  cannot be used: {why}\n", "", widths = widths[0]);
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::Adapter;

    fn details(name: &str, kind: &str, unfit: Option<&str>) -> AdapterDetails {
        let (name, kind, driver) = (name.to_owned(), kind.to_owned(), "a driver 1.2".to_owned());
        AdapterDetails {
            adapter: Adapter { name, kind, driver, backend: "Vulkan" },
            storage_buffers_per_stage: 8,
            invocations_per_workgroup: 256,
            workgroup_storage: 16 << 10,
            storage_binding: 128 << 20,
            buffer: (2 << 30) - 1,
            unfit: unfit.map(str::to_owned),
        }
    }

    #[test]
    fn columns_stand_below_each_other() {
        let adapters = [details("long named card", "discrete", None), details("old", "software", Some("its x is 1"))];
        let expected = "\
kind      backend  name             buffer   bindings     workgroup    driver
discrete  Vulkan   long named card  2.0 GiB  8 x 128 MiB  256, 16 KiB  a driver 1.2
software  Vulkan   old              2.0 GiB  8 x 128 MiB  256, 16 KiB  a driver 1.2
          cannot be used: its x is 1
";
        assert_eq!(table(&adapters), expected);
    }
}
