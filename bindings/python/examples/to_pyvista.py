"""A folded sheet in a window of pyvista, coloured by strain: `python to_pyvista.py`."""

import numpy as np
import pyvista

import origami_sim as origami

folded = origami.relax(origami.Pattern.generate("bird-base"), 90)
# The layout of VTK: how many corners a face has, then the corners.
triangles = folded.model.triangles
faces = np.column_stack([np.full(len(triangles), 3), triangles])
mesh = pyvista.PolyData(folded.positions, faces.ravel())
mesh.point_data["strain"] = folded.vertex_strains
mesh.plot(scalars="strain", show_edges=True)
