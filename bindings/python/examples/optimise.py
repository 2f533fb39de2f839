"""Which Miura sheet has a given width and depth once it is folded? Its angle and how far to fold it are what varies; the
derivatives are finite differences, for which the folds are made more exact than by default."""

import numpy as np
from scipy.optimize import least_squares

import origami_sim as origami

WIDTH, DEPTH = 3.2, 3.6


def extents(design):
    """Width and depth of the folded sheet."""
    gamma, percent = design
    pattern = origami.Pattern.generate("miura", columns=4, rows=4, gamma=gamma)
    folded = origami.relax(pattern, percent, tolerance=1e-9, hold="sheet")
    return np.ptp(folded.positions, axis=0)[:2]


found = least_squares(
    lambda design: extents(design) - (WIDTH, DEPTH), x0=(60.0, 60.0), bounds=((40, 20), (85, 95)), diff_step=1e-3, xtol=1e-6
)
gamma, percent = found.x
width, depth = extents(found.x)
print(f"gamma {gamma:.2f} degrees, folded to {percent:.1f} %: {width:.4f} wide and {depth:.4f} deep, {found.nfev} steps")
assert abs(width - WIDTH) < 1e-3 and abs(depth - DEPTH) < 1e-3
