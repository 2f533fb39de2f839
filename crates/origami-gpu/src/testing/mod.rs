//! An adapter for tests, and what the tests of the kernels have in common.

pub(crate) mod bench;
pub(crate) mod cases;
pub(crate) mod layers;
pub(crate) mod magnitudes;
pub(crate) mod sheets;
pub(crate) mod steps;
pub(crate) mod variants;

use std::io::Write;
use std::sync::OnceLock;

use crate::{AdapterChoice, Gpu};

/// The adapter that `ORIGAMI_ADAPTER` names or else the best there is, opened once. A test that gets none has nothing to
/// do; one line says so, whatever the number of such tests. Where `ORIGAMI_REQUIRE_GPU` is set it fails instead.
pub(crate) fn gpu() -> Option<Gpu> {
    static SHARED: OnceLock<Option<Gpu>> = OnceLock::new();
    let opened = SHARED.get_or_init(|| match Gpu::open(&AdapterChoice::from_env()) {
        Ok(gpu) => Some(gpu),
        Err(error) => {
            // Past the harness, which shows nothing of tests that pass, and in one piece.
            let line = format!("\ntests on a GPU are skipped: {error}\n");
            let _ = std::io::stderr().write_all(line.as_bytes());
            None
        }
    });
    let required = std::env::var_os("ORIGAMI_REQUIRE_GPU").is_some();
    assert!(opened.is_some() || !required, "ORIGAMI_REQUIRE_GPU is set and there is no adapter");
    opened.clone()
}
