"""A folded sheet as a mesh of trimesh: `python to_trimesh.py bird.ply`."""

import sys

import trimesh

import origami_sim as origami

folded = origami.relax(origami.Pattern.generate("bird-base"), 90)
mesh = trimesh.Trimesh(folded.positions, folded.model.triangles, process=False)
mesh.export(sys.argv[1])
print(f"area {mesh.area:.4f} of {trimesh.Trimesh(folded.model.positions, folded.model.triangles).area:.4f} before")
