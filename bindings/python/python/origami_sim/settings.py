"""Settings of materials and solvers. They are plain data: compare, copy (`dataclasses.replace`) and pickle them."""

from dataclasses import dataclass, field
from typing import ClassVar, Literal


@dataclass(frozen=True, kw_only=True)
class Material:
    """What the paper is made of. All numbers hold for a sheet scaled to radius 1, with vertices of mass 1.

    ea: axial rigidity of the beams, a force. Higher: less strain, slower convergence. Greater than 0.
    k_fold: stiffness of mountain and valley creases, a moment per radian and per unit of length. Higher: creases come
        nearer to their targets, at the price of strain. 0 leaves them out.
    k_facet: the same of facet creases. Higher: flatter facets. 0 leaves them out.
    k_face: stiffness of the corner angles of triangles, a moment per radian. Higher: less shear. 0 leaves them out.
    zeta: damping ratio of the beams; only `Dynamics` has damping. Higher: vibration dies sooner. At least 0.
    collapse: how strongly triangles resist losing the last fifth of their area, as a share of the stiffest crease.
        Higher: they keep more of it. 0 leaves them without, as in the paper.
    """

    ea: float = 20.0
    k_fold: float = 0.7
    k_facet: float = 0.7
    k_face: float = 0.2
    zeta: float = 0.45
    collapse: float = 0.03


class _Solver:
    """What all solvers can do."""

    def fold(
        self,
        sheet,
        percent=100.0,
        *,
        targets=None,
        start=None,
        supports=None,
        loads=None,
        hold=None,
        gpu=None,
        progress=None,
    ):
        """Folds a sheet; see `origami_sim.relax`, which has the same arguments."""
        from . import _native

        return _native.fold(
            self,
            sheet,
            percent,
            targets=targets,
            start=start,
            supports=supports,
            loads=loads,
            hold=hold,
            gpu=gpu,
            progress=progress,
        )

    def path(self, sheet, percents, *, hold=None, gpu=None, progress=None):
        """Folds a sheet to each of `percents` in turn, every one from the state before it: a list of `Folded`.

        Folding depends on its path; an animation shows it. A `Diverged` has the percentage that it was on its way to.
        """
        from . import _native

        return _native.fold_path(self, sheet, percents, hold=hold, gpu=gpu, progress=progress)


@dataclass(frozen=True, kw_only=True)
class Softening:
    """How soft a sheet is while the target angles of `Relax` rise; nothing of it is left when they are up.

    beams: the most axial rigidity that a beam has, over the stiffest crease. Lower: fewer creases fold to the wrong
        side, more steps afterwards. Greater than 0.
    corner_angles: stiffness of the corner angles, as a share of the material's. Lower: as of beams. At least 0.
    wrong_side: what pulls a crease towards flat that is folded to the other side than its target, in units of its
        stiffness. Higher: it turns back sooner. At least 0.
    """

    beams: float = 0.85
    corner_angles: float = 0.3
    wrong_side: float = 10.0


@dataclass(frozen=True, kw_only=True)
class Relax(_Solver):
    """Relaxation: the folded state, without the motion that leads to it.

    tolerance: distance from the equilibrium at which it stops, in radii. Smaller: more steps.
    ramp: steps over which the target angles rise; 0 is a jump. Longer: fewer tangled states, more steps.
        None: as the size of the sheet asks for, 400 for small ones.
    max_steps: steps after which it gives up, all attempts together.
    steps: run exactly so many steps instead, in one attempt. None: until it has converged.
    retry: whether a state with lost creases, a crushed triangle or out of bounds is folded again in other ways.
    softening: how soft the sheet is on the way. None: as stiff as its material.
    perturbation: how far each vertex is moved at the start, as a share of its shortest beam, from 0 to 1. Larger:
        saddles are left sooner; 0: none.
    saddle_search: products with the stiffness that look for a way down from where the sheet has settled, as a share of the
        steps before. More: saddles are found more often; 0: none.
    near: sides shorter than this share of their mean join their ends to a cluster that moves as one. Larger: more of them;
        0: none.
    hand_over: ramps at the final targets after which Newton's method takes over from a sheet that crawls. Smaller: earlier;
        None: never.
    precision: the numbers in which the processor computes: `f64`, or `mixed` for speed with a tolerance of 1e-6 or more.
    threads: threads that share the steps of a large sheet. None: as many as there are processors.
    """

    name: ClassVar[str] = "relax"

    tolerance: float = 1e-4
    ramp: int | None = None
    max_steps: int = 100_000
    steps: int | None = None
    retry: bool = True
    softening: Softening | None = Softening()
    perturbation: float = 1e-2
    saddle_search: float = 0.1
    near: float = 0.4
    hand_over: int | None = 4
    precision: Literal["f64", "mixed"] = "f64"
    threads: int | None = None


@dataclass(frozen=True, kw_only=True)
class Dynamics(_Solver):
    """The paper's motion: damped springs on vertices of mass 1. For the folded state take `Relax`, which is faster.

    time_step: length of a step: `paper`, `safe`, or a number in the model's unit of time. Shorter: more steps hold.
    integrator: `euler` or `verlet`.
    ramp: steps over which the target angles rise; 0: they jump. Longer: gentler.
    tolerance, max_steps, steps, precision, threads: as of `Relax`.
    """

    name: ClassVar[str] = "dynamics"

    time_step: Literal["paper", "safe"] | float = "paper"
    integrator: Literal["euler", "verlet"] = "euler"
    ramp: int = 0
    tolerance: float = 1e-4
    max_steps: int = 100_000
    steps: int | None = None
    precision: Literal["f64", "mixed"] = "f64"
    threads: int | None = None


@dataclass(frozen=True, kw_only=True)
class Newton(_Solver):
    """Newton's method with exact second derivatives: equilibria to a residual of 1e-10, the reference for the others.

    residual: largest force on a vertex at which it stops, in the model's unit of force. Smaller: nearer.
    relax: what goes ahead to the neighbourhood of the equilibrium. None: nothing, the targets rise in increments.
    increments: without `relax`, how many of them at first. More: safer, slower.
    perturbation: without `relax`, as `Relax.perturbation`.
    max_factorisations: factorisations after which it gives up.
    max_steps: steps after which it gives up, those of `relax` included. None: no limit but that of `relax` for its own.
    """

    name: ClassVar[str] = "newton"

    residual: float = 1e-10
    relax: Relax | None = field(default_factory=Relax)
    increments: int = 10
    perturbation: float = 1e-2
    max_factorisations: int = 2000
    max_steps: int | None = None
