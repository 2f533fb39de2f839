"""Rest angles of its creases for which a folded Miura sheet takes a saddle's shape: SciPy's L-BFGS on the adjoint, which
gives the derivatives by all creases for the price of one more solve."""

import numpy as np
from scipy.optimize import minimize

import origami_sim as origami

folded = origami.relax(origami.Pattern.generate("miura", columns=4, rows=4), 60)
# Held so that it cannot move as a whole, and without stress as it is folded.
supports = [
    {"on": {"vertices": [0]}, "fixed": "xyz"},
    {"on": {"vertices": [4]}, "fixed": "yz"},
    {"on": {"vertices": [20]}, "fixed": "z"},
]
structure = origami.Structure(folded.model, {"supports": supports})
drawn = structure.configuration(folded)
structure = structure.replace(positions=drawn.positions, rest_angles=drawn.fold_angles)
x, y, z = drawn.positions.T
saddle = np.stack([x, y, z + 0.2 * (x**2 - y**2)], axis=1)
at = drawn


def distance(rest_angles):
    """Half the squared distance of all nodes from the saddle, and its derivative by the rest angles."""
    global at
    bent = structure.replace(rest_angles=rest_angles)
    at = bent.equilibrium(at)
    apart = at.positions - saddle
    return 0.5 * np.sum(apart**2), bent.gradient(at, apart)["rest_angles"]


def rms(value):
    return np.sqrt(2 * value / len(saddle))


before, _ = distance(drawn.fold_angles)
found = minimize(distance, drawn.fold_angles, jac=True, method="L-BFGS-B", bounds=[(-3, 3)] * len(drawn.fold_angles))
print(f"{found.nfev} equilibria: {rms(found.fun):.4f} radii from the saddle, {rms(before):.4f} before")
assert found.success and rms(found.fun) < 0.6 * rms(before)
