//! Many sheets in one run: instances whose springs lie at the same places share one buffer set.

use origami_core::model::Model;
use origami_core::solve::{Failed, Folded, Instance, Progress};

use crate::device::Gpu;
use crate::engine::{Engine, Purpose, most_instances};
use crate::scene::same_springs;
use crate::solver::{Method, backend};

/// Runs all instances; results in their order.
pub(crate) fn fold_all<S: Method>(
    gpu: &Gpu,
    method: &S,
    purpose: Purpose,
    instances: &[Instance<'_>],
    observe: &(dyn Fn(usize, Progress) + Sync),
) -> Vec<Result<Folded, Failed>> {
    let mut results: Vec<Option<Result<Folded, Failed>>> = instances.iter().map(|_| None).collect();
    for group in groups(instances) {
        let models = different(group.iter().map(|i| instances[*i].model));
        let most = most_instances(gpu, &models, purpose.motion);
        let mut engine = Engine::new(gpu, &models, purpose, group.len().min(most));
        for part in group.chunks(most) {
            let own: Vec<Instance<'_>> = part.iter().map(|i| instances[*i].clone()).collect();
            let came_to = match &mut engine {
                Ok(engine) => method.run(engine, &own, &mut |place, progress| observe(part[place], progress)),
                Err(error) => own.iter().map(|i| Err(backend(error.clone(), &i.start, 0))).collect(),
            };
            for (i, result) in part.iter().zip(came_to) {
                results[*i] = Some(result);
            }
        }
    }
    results.into_iter().flatten().collect()
}

/// The models, each once.
fn different<'m>(models: impl Iterator<Item = &'m Model>) -> Vec<&'m Model> {
    let mut different: Vec<&Model> = Vec::new();
    for model in models {
        if !different.iter().any(|known| std::ptr::eq(*known, model)) {
            different.push(model);
        }
    }
    different
}

/// Places of instances that can share a scene.
fn groups(instances: &[Instance<'_>]) -> Vec<Vec<usize>> {
    let mut groups: Vec<(&Model, Vec<usize>)> = Vec::new();
    for (i, instance) in instances.iter().enumerate() {
        let same = |known: &Model| std::ptr::eq(known, instance.model) || same_springs(known, instance.model);
        match groups.iter_mut().find(|(known, _)| same(known)) {
            Some((_, group)) => group.push(i),
            None => groups.push((instance.model, vec![i])),
        }
    }
    groups.into_iter().map(|(_, group)| group).collect()
}
