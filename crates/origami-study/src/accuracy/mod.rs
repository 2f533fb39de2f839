//! Error against run time and force evaluations: every solver on every case, held against the equilibrium itself.

mod cases;
mod claims;
mod closed;
mod omissions;
mod reference;
mod runs;
mod tables;
mod text;
mod trail;
mod transient;

use crate::options::Deadline;
use crate::{Options, Part, Study, StudyError, Watch};

use cases::{Case, cases};
use claims::Claims;
use runs::{Run, is_for_gpu, methods};
use trail::On;

/// Runs the study: for each case each solver's error along its way; closed forms; the order of the time integration; what
/// `converged` is worth; what leaving things out saves. A user's own patterns are studied without what needs no pattern.
///
/// # Errors
/// Where a pattern makes no model.
pub fn study(options: &Options, watch: &mut dyn Watch) -> Result<Study, StudyError> {
    let deadline = Deadline::after(options.time_limit);
    let cases = cases(options)?;
    let methods: Vec<_> = cases.iter().map(|case| methods(case, options.quick)).collect();
    let shipped = options.patterns.is_empty();
    let on_gpu = methods.iter().flatten().filter(|method| is_for_gpu(method, &options.gpu)).count();
    // Each case's claims and reference beside its methods; transients and omissions.
    let others = if shipped { closed::CASES + 2 } else { 0 };
    watch.begins(methods.iter().map(Vec::len).sum::<usize>() + on_gpu + 2 * cases.len() + others);

    let mut found = Found { runs: Vec::new(), references: Vec::new(), claims: Claims::new(), left_out: Vec::new() };
    for (case, methods) in cases.iter().zip(&methods) {
        found.case(case, methods, options, deadline, watch);
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
    references: Vec<(Case, Option<reference::Equilibrium>)>,
    claims: Claims,
    /// What there was no time for.
    left_out: Vec<String>,
}

impl Found {
    fn case(
        &mut self,
        case: &Case,
        methods: &[runs::Method],
        options: &Options,
        deadline: Deadline,
        watch: &mut dyn Watch,
    ) {
        let reference = if deadline.passed() { None } else { reference::of(case) };
        watch.ran(&format!("{}: reference", case.title()));
        for method in methods {
            let gpu = is_for_gpu(method, &options.gpu).then_some(On::Gpu(&options.gpu));
            for on in [Some(On::Cpu), gpu].into_iter().flatten() {
                let what = format!("{}: {}", case.title(), method.name);
                match &reference {
                    Some(reference) if !deadline.passed() => {
                        self.runs.push(runs::run(case, method, on, reference, deadline));
                    }
                    _ => self.left_out.push(what.clone()),
                }
                watch.ran(&what);
            }
        }
        if let Some(reference) = &reference {
            if deadline.passed() {
                self.left_out.push(format!("{}: claims", case.title()));
            } else {
                self.claims.add(case, reference);
            }
        }
        watch.ran(&format!("{}: claims", case.title()));
        self.references.push((case.clone(), reference));
    }

    /// The runs of one case.
    fn of<'a>(&'a self, case: &'a Case) -> impl Iterator<Item = &'a Run> {
        let same = |run: &&Run| run.case == case.name && run.percent == case.percent && run.jump == (case.ramp == 0);
        self.runs.iter().filter(same)
    }
}

/// A paragraph of the study's document.
fn text(paragraph: impl Into<String>) -> Part {
    Part::Text(paragraph.into())
}

fn heading(words: &str) -> Part {
    Part::Heading(words.into())
}
