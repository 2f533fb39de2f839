"""Folds origami crease patterns by the bar-and-hinge method of Ghassaei, Demaine and Gershenfeld (2018).

>>> import origami_sim as origami
>>> folded = origami.relax(origami.Pattern.generate("bird-base"), 90)
>>> folded.converged
True

`Pattern` is what a file says, `Model` the triangulated sheet with its springs, made of a pattern and a `Material`.
`relax` goes straight to the folded state, `dynamics` through the motion, `newton` to the equilibrium itself; each
returns a `Folded`. A `Simulation` can be stepped and steered. `sweep` folds a pattern in many ways, on one machine or on
many. A `Structure` is held, loaded and followed through snap-through, and has gradients.

Units: positions and places are in the pattern's unit of length, angles by edge in degrees as in FOLD files, angles by
crease in radians. Forces, energies and distances from the equilibrium are those of a sheet scaled to radius 1.
"""

from ._native import Folded, Model, Pattern, Simulation, __version__, features, generators
from .errors import BackendError, Diverged, OrigamiError, PatternError, Refused
from .measure import align, flat_folding
from .settings import Dynamics, Material, Newton, Relax, Softening
from .solve import dynamics, newton, relax
from .sweeps import sweep

if "analysis" in features:
    from .analysis import Configuration, Structure
if "gpu" in features:
    from ._native import Gpu, adapters

__all__ = [
    "BackendError",
    "Diverged",
    "Dynamics",
    "Folded",
    "Material",
    "Model",
    "Newton",
    "OrigamiError",
    "Pattern",
    "PatternError",
    "Refused",
    "Relax",
    "Simulation",
    "Softening",
    "__version__",
    "align",
    "dynamics",
    "features",
    "flat_folding",
    "generators",
    "newton",
    "relax",
    "sweep",
]
if "analysis" in features:
    __all__ += ["Configuration", "Structure"]
if "gpu" in features:
    __all__ += ["Gpu", "adapters"]
