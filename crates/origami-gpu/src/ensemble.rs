//! Many sheets at once: instances whose springs lie in the same places pass through one buffer set.

use std::ops::ControlFlow;

use origami_core::model::Model;
use origami_core::solve::{Failed, Folded, Instance, Progress};

use crate::device::Gpu;
use crate::engine::{Engine, most_instances, uniform};
use crate::error::GpuError;
use crate::method::Method;
use crate::outcome::backend;
use crate::outside::Outside;
use crate::purpose::Purpose;
use crate::sheet_arrays::{SheetArrays, same_springs};
use crate::stream::Asked;

/// Nodes of all sheets that are on the GPU at once, beyond which more of them make nothing faster: several for each thread
/// that a GPU has, in some 0.6 GB. An estimate; `./on-a-gpu` measures ensembles.
const NODES_AT_ONCE: usize = 1 << 20;

/// Runs all instances; each result goes to `take` as soon as there is one.
pub(crate) fn fold_each(
    gpu: &Gpu,
    method: Method<'_>,
    purpose: Purpose,
    instances: &[Instance<'_>],
    observe: &(dyn Fn(usize, Progress) -> ControlFlow<()> + Sync),
    take: &(dyn Fn(usize, Result<Folded, Failed>) -> ControlFlow<()> + Sync),
) {
    let most =
        |arrays: &SheetArrays| most_instances(gpu, arrays, purpose).min(NODES_AT_ONCE / arrays.nodes.max(1)).max(1);
    let _ = in_runs(gpu, method, purpose, (instances, observe, take), most);
}

/// Instances, who watches them and who takes what they come to.
pub(crate) type Given<'a> = (
    &'a [Instance<'a>],
    &'a (dyn Fn(usize, Progress) -> ControlFlow<()> + Sync),
    &'a (dyn Fn(usize, Result<Folded, Failed>) -> ControlFlow<()> + Sync),
);

/// The same with at most as many instances at once as `most` says of their arrays.
pub(crate) fn in_runs(
    gpu: &Gpu,
    method: Method<'_>,
    purpose: Purpose,
    (instances, observe, take): Given<'_>,
    most: impl Fn(&SheetArrays) -> usize,
) -> ControlFlow<()> {
    let mut sound = Vec::with_capacity(instances.len());
    for (i, instance) in instances.iter().enumerate() {
        // Who is refused does not take the others along.
        match method.check(instance) {
            Err(refusal) => take(i, Err(Failed::refused(refusal, &instance.start)))?,
            Ok(()) => sound.push(i),
        }
    }
    for group in groups(instances, &sound) {
        let models = different(group.iter().map(|i| instances[*i].model));
        let outside = Outside::of(group.iter().map(|i| &instances[*i].scene));
        let arrays = SheetArrays::with_outside(models[0], &outside);
        let at_once = group.len().min(most(&arrays)).max(1);
        match fitting(at_once, |at_once| Engine::of_arrays(gpu, &arrays, uniform(&models), purpose, at_once)) {
            Ok(engine) => {
                let own: Vec<&Instance<'_>> = group.iter().map(|i| &instances[*i]).collect();
                let mut goes_on = ControlFlow::Continue(());
                let asked = Asked {
                    instances: &own,
                    observe: &mut |i, progress| observe(group[i], progress),
                    take: &mut |i, result| {
                        goes_on = take(group[i], result);
                        goes_on
                    },
                };
                method.run(&engine, asked);
                goes_on?;
            }
            Err(error) => {
                group.iter().try_for_each(|i| take(*i, Err(backend(error.clone(), &instances[*i].start, 0))))?;
            }
        }
    }
    ControlFlow::Continue(())
}

/// What `make` makes for so many, or for half as many where memory does not suffice, and so on.
fn fitting<T>(most: usize, mut make: impl FnMut(usize) -> Result<T, GpuError>) -> Result<T, GpuError> {
    let mut count = most;
    loop {
        match make(count) {
            Err(GpuError::OutOfMemory(_)) if count > 1 => count /= 2,
            made => return made,
        }
    }
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

/// Those of the instances that can share one set of arrays, by their indices.
fn groups(instances: &[Instance<'_>], of: &[usize]) -> Vec<Vec<usize>> {
    let mut groups: Vec<(&Model, Vec<usize>)> = Vec::new();
    for i in of.iter().copied() {
        let instance = &instances[i];
        let same = |known: &Model| std::ptr::eq(known, instance.model) || same_springs(known, instance.model);
        match groups.iter_mut().find(|(known, _)| same(known)) {
            Some((_, group)) => group.push(i),
            None => groups.push((instance.model, vec![i])),
        }
    }
    groups.into_iter().map(|(_, group)| group).collect()
}

#[cfg(test)]
mod tests {
    use origami_core::generate::BirdBase;
    use origami_core::pattern::CreasePattern;
    use origami_core::{Dynamics, Material, Relax, Solver, State};

    use super::*;
    use crate::method::GpuMethod;
    use crate::purpose::Dispatch;
    use crate::testing::gpu;
    use origami_core::scene::Scene;
    use origami_core::solve::unwatched;

    fn bird() -> CreasePattern {
        BirdBase::default().pattern().expect("a pattern")
    }

    fn instance(model: &Model, percent: f64) -> Instance<'_> {
        Instance { model, start: State::perturbed(model, 1e-3, percent.to_bits()), scene: Scene::percent(percent) }
    }

    fn states(results: Vec<Result<Folded, Failed>>) -> Vec<State> {
        results.into_iter().map(|folded| folded.expect("it holds").state).collect()
    }

    /// With a limit so small that an engine has to run several times, the last time with fewer.
    fn same_in_runs<S: GpuMethod + Clone>(gpu: &Gpu, method: &S, dispatch: Dispatch) {
        let model = Model::new(&bird(), &Material::default()).expect("a model");
        let instances: Vec<Instance<'_>> = (0..7).map(|i| instance(&model, 10.0 * f64::from(i))).collect();
        let purpose = method.method().purpose(dispatch, [&model].into_iter());
        let reported = std::sync::Mutex::new(vec![0; instances.len()]);
        let in_runs_of = |most: usize| {
            let reported = |i: usize, _| {
                reported.lock().expect("no panic")[i] += 1;
                ControlFlow::Continue(())
            };
            let results: Vec<_> = instances.iter().map(|_| std::sync::OnceLock::new()).collect();
            let take = |i: usize, result| {
                results[i].set(result).expect("each comes once");
                ControlFlow::Continue(())
            };
            assert!(in_runs(gpu, method.method(), purpose, (&instances, &reported, &take), |_| most).is_continue());
            states(results.into_iter().map(|result| result.into_inner().expect("each comes")).collect())
        };
        let at_once = in_runs_of(100);
        assert_eq!(in_runs_of(3), at_once);
        assert_eq!(in_runs_of(1), at_once);
        assert!(
            reported.lock().expect("no panic").iter().all(|reported| *reported >= 3),
            "each is reported by its own index"
        );
        let one_by_one = gpu.with(method.clone()).dispatch(dispatch);
        for (instance, state) in instances.iter().zip(&at_once) {
            let folded = one_by_one.fold(&model, &instance.start, &instance.scene, &mut unwatched).expect("it holds");
            assert_eq!(&folded.state, state, "{:?}", instance.scene.targets);
        }
        assert!(at_once.windows(2).all(|pair| pair[0] != pair[1]), "each has its own");
    }

    #[test]
    fn fewer_go_at_once_where_memory_does_not_suffice() {
        let details = || crate::Details("full".to_owned());
        let room_for = |room: usize, most: usize| {
            fitting(most, |count| if count <= room { Ok(count) } else { Err(GpuError::OutOfMemory(details())) })
        };
        assert_eq!(room_for(100, 70), Ok(70));
        assert_eq!(room_for(100, 1000), Ok(62));
        assert_eq!(room_for(0, 1000), Err(GpuError::OutOfMemory(details())), "not even one");
        let mut tries = 0;
        let lost = fitting(64, |_| {
            tries += 1;
            Err::<(), _>(GpuError::Lost("gone".to_owned()))
        });
        assert_eq!((lost.is_err(), tries), (true, 1), "nothing else is tried again");
    }

    #[test]
    fn many_runs_give_what_one_gives() {
        let Some(gpu) = gpu() else { return };
        for dispatch in [Dispatch::Passes, Dispatch::Workgroup] {
            same_in_runs(&gpu, &Relax { steps: Some(120), ramp: Some(50), ..Relax::default() }, dispatch);
            same_in_runs(&gpu, &Dynamics { steps: Some(120), ..Dynamics::default() }, dispatch);
        }
    }

    #[test]
    fn only_models_with_the_same_springs_share_buffers() {
        let plain = Material::default();
        let material = [
            plain,
            Material { k_fold: 3.0, ..plain },
            Material { k_fold: 0.0, ..plain },
            Material { k_face: 0.0, ..plain },
        ];
        let mut models = Model::of_each(&bird(), &material).expect("models");
        // The same sheet with springs of its own.
        let inner = bird().edges.iter().position(|edge| edge.fold_angle.is_some()).expect("a crease");
        let own = |change: &dyn Fn(&mut CreasePattern)| {
            let mut pattern = bird();
            change(&mut pattern);
            Model::new(&pattern, &plain).expect("a model")
        };
        models.push(own(&|p| p.edges[inner].k_crease = Some(5.0)));
        models.push(own(&|p| p.edges[inner].ea = Some(50.0)));
        models.push(own(&|p| p.fixed.push(origami_core::ids::VertexId(0))));
        models.push(own(&|_| {}));
        let instances: Vec<Instance<'_>> = models.iter().map(|model| instance(model, 50.0)).collect();
        assert_eq!(
            groups(&instances, &[0, 1, 2, 3, 4, 5, 6, 7]),
            [vec![0, 1, 7], vec![2], vec![3], vec![4], vec![5], vec![6]]
        );
    }

    #[test]
    fn own_springs_are_shared_by_materials() {
        let mut pattern = bird();
        pattern.edges.iter_mut().step_by(2).for_each(|edge| edge.k_crease = Some(0.7));
        pattern.edges.iter_mut().step_by(3).for_each(|edge| edge.ea = Some(20.0));
        let plain = Material::default();
        let materials = [plain, Material { k_fold: 2.0, k_facet: 1.0, ea: 40.0, ..plain }];
        let models = Model::of_each(&pattern, &materials).expect("models");
        let instances: Vec<Instance<'_>> = models.iter().map(|model| instance(model, 50.0)).collect();
        assert_eq!(groups(&instances, &[0, 1]), [vec![0, 1]], "their own happen to be the first material's");
        let Some(gpu) = gpu() else { return };
        let method = Dynamics { steps: Some(60), ..Dynamics::default() };
        let states = states(gpu.with(method.clone()).fold_all(&instances, &|_, _| ControlFlow::Continue(())));
        for (instance, state) in instances.iter().zip(states) {
            let cpu = method.fold(instance.model, &instance.start, &instance.scene, &mut unwatched).expect("it holds");
            let far = crate::testing::cases::farthest(&cpu.state.positions, &state.positions);
            assert!(far < 1e-6, "{far} radii apart");
        }
    }
}
