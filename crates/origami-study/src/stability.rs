//! What holds on stiff and extreme scenes.

use crate::{Options, Study, StudyError, Watch};

/// Runs the study.
///
/// # Errors
/// Where a pattern makes no model.
pub fn study(options: &Options, watch: &mut dyn Watch) -> Result<Study, StudyError> {
    let _ = (options, watch);
    Ok(Study { name: "stability", title: "Stability".into(), parts: Vec::new() })
}
