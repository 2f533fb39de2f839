"""Folding in one call."""

from .settings import Dynamics, Newton, Relax

_WHERE = ("targets", "start", "supports", "loads", "hold", "gpu", "progress")


def relax(sheet, percent=100.0, **options):
    """Folds a sheet to its equilibrium: a `Folded`.

    sheet: a `Model`, or a `Pattern`, which is then made of the default `Material`.
    percent: how far, as a percentage of the pattern's fold angles: 0 flat, negative the other way. Default 100.

    Options of the scene:

    targets: an angle for each crease of the model in place of `percent`, of shape (creases,), in radians.
    start: a `Folded` of the same sheet to begin with. Default: the sheet at rest.
    supports: vertices that are held: {vertex: None, where it is, or (x, y, z), in the pattern's unit}.
    loads: dead loads: {vertex: (fx, fy, fz)}, in the model's unit of force.
    hold: what keeps its place in the result: `sheet`, `none` or the number of a face. Default: the sheet, and none where
        supports or loads hold it.
    gpu: a `Gpu` to compute on (of a build with the feature). Default: the processor.
    progress: called now and then with (step, ramp, distance); what it raises ends the fold.

    All others are settings of `Relax`: `relax(sheet, 90, tolerance=1e-6)`.

    Raises `Refused` before any work, `Diverged` where the sheet leaves all bounds. Ctrl-C ends it.
    """
    return _fold(Relax, sheet, percent, options)


def dynamics(sheet, percent=100.0, **options):
    """The same through the motion of the paper; settings are those of `Dynamics`."""
    return _fold(Dynamics, sheet, percent, options)


def newton(sheet, percent=100.0, **options):
    """The same to the equilibrium itself; settings are those of `Newton`. Needs a build with the feature `newton`."""
    return _fold(Newton, sheet, percent, options)


def _fold(solver, sheet, percent, options):
    scene = {name: options.pop(name) for name in _WHERE if name in options}
    return solver(**options).fold(sheet, percent, **scene)
