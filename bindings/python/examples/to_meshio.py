"""A folded sheet with its strain as a file for ParaView, by meshio: `python to_meshio.py bird.vtu`."""

import sys

import meshio

import origami_sim as origami

folded = origami.relax(origami.Pattern.generate("bird-base"), 90)
meshio.write_points_cells(
    sys.argv[1],
    folded.positions,
    [("triangle", folded.model.triangles)],
    point_data={"strain": folded.vertex_strains},
    cell_data={"face": [folded.model.face_of_triangle]},
)
