//! Error against run time and force evaluations: every solver on every scene, held against the equilibrium itself.

mod claims;
mod closed;
mod omissions;
mod reference;
mod runs;
mod scenes;
mod tables;
mod text;
mod trail;
mod transient;

use crate::options::Deadline;
use crate::{Options, Part, Study, StudyError, Watch};

use claims::Claims;
use runs::{Run, is_for_gpu, methods};
use scenes::{Scene, scenes};
use trail::On;

/// Runs the study: for each scene each solver's error along its way; closed forms; the order of the time integration; what
/// `converged` is worth; what leaving things out saves. A user's own patterns are studied without what needs no pattern.
///
/// # Errors
/// Where a pattern makes no model.
pub fn study(options: &Options, watch: &mut dyn Watch) -> Result<Study, StudyError> {
    let deadline = Deadline::after(options.time_limit);
    let scenes = scenes(options)?;
    let methods: Vec<_> = scenes.iter().map(|scene| methods(scene, options.quick)).collect();
    let shipped = options.patterns.is_empty();
    let on_gpu = methods.iter().flatten().filter(|method| is_for_gpu(method, &options.gpu)).count();
    // Each scene's claims and reference beside its methods; transients and omissions.
    let others = if shipped { closed::SCENES + 2 } else { 0 };
    watch.begins(methods.iter().map(Vec::len).sum::<usize>() + on_gpu + 2 * scenes.len() + others);

    let mut found = Found { runs: Vec::new(), references: Vec::new(), claims: Claims::new(), left_out: Vec::new() };
    for (scene, methods) in scenes.iter().zip(&methods) {
        found.scene(scene, methods, options, deadline, watch);
    }

    let mut parts = text::introduction(&found, options);
    parts.extend(text::runs(&found, options));
    if shipped {
        let closed = closed::run(|what| watch.ran(what))?;
        parts.extend(text::closed_forms(closed));
        let transient = transient::run(options.quick)?;
        watch.ran("transients");
        parts.extend(text::transient(transient));
    }
    parts.extend(text::claims(&found.claims));
    if shipped {
        parts.extend(text::omissions(omissions::run(options.quick)?));
        watch.ran("omissions");
    }
    Ok(Study { name: "accuracy", title: "Accuracy: error against run time".into(), parts })
}

/// What has been found so far.
struct Found {
    runs: Vec<Run>,
    references: Vec<(Scene, Option<reference::Equilibrium>)>,
    claims: Claims,
    /// What there was no time for.
    left_out: Vec<String>,
}

impl Found {
    fn scene(
        &mut self,
        scene: &Scene,
        methods: &[runs::Method],
        options: &Options,
        deadline: Deadline,
        watch: &mut dyn Watch,
    ) {
        let reference = if deadline.passed() { None } else { reference::of(scene) };
        watch.ran(&format!("{}: reference", scene.title()));
        for method in methods {
            let gpu = is_for_gpu(method, &options.gpu).then_some(On::Gpu(&options.gpu));
            for on in [Some(On::Cpu), gpu].into_iter().flatten() {
                let what = format!("{}: {}", scene.title(), method.name);
                match &reference {
                    Some(reference) if !deadline.passed() => {
                        self.runs.push(runs::run(scene, method, on, reference, deadline));
                    }
                    _ => self.left_out.push(what.clone()),
                }
                watch.ran(&what);
            }
        }
        if let Some(reference) = &reference {
            if deadline.passed() {
                self.left_out.push(format!("{}: claims", scene.title()));
            } else {
                self.claims.add(scene, reference);
            }
        }
        watch.ran(&format!("{}: claims", scene.title()));
        self.references.push((scene.clone(), reference));
    }

    /// The runs of one scene.
    fn of<'a>(&'a self, scene: &'a Scene) -> impl Iterator<Item = &'a Run> {
        let same =
            |run: &&Run| run.scene == scene.name && run.percent == scene.percent && run.jump == (scene.ramp == 0);
        self.runs.iter().filter(same)
    }
}

/// A paragraph.
fn text(paragraph: impl Into<String>) -> Part {
    Part::Text(paragraph.into())
}

fn heading(words: &str) -> Part {
    Part::Heading(words.into())
}
