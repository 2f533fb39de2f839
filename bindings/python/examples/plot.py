"""Folds a file and plots it: `python plot.py ../../../examples/patterns/crane.fold 90 crane.png`."""

import sys

import matplotlib.pyplot as plt

import origami_sim as origami

path, percent, output = sys.argv[1:]
folded = origami.relax(origami.Pattern.read(path), float(percent))
axes = plt.figure().add_subplot(projection="3d")
axes.plot_trisurf(*folded.positions.T, triangles=folded.model.triangles, color="lightblue", edgecolor="black")
axes.set(aspect="equal", title=f"{percent} %, strain at most {folded.strain['max']:.2%}")
plt.savefig(output)
