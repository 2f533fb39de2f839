"""What a call costs, and that nothing is copied on the way to NumPy."""

import time
import tracemalloc

import numpy as np
import pytest

import origami_sim as origami


def test_positions_of_a_million_vertices_come_without_a_copy():
    # A square with a valley, and a million points beside it: they are read and handed out like any others.
    square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    points = np.random.default_rng(1).uniform(2, 3, (1_000_000, 2))
    edges = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]]
    folded = origami.relax(origami.Pattern.from_arrays(np.vstack([square, points]), edges, "BBBBV"), 90)
    tracemalloc.start()
    positions = folded.positions
    traced, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert positions.shape == (1_000_004, 3) and positions.flags.c_contiguous
    # NumPy traces what it allocates itself; here it has allocated nothing of the 24 MB.
    assert peak < 0.01 * positions.nbytes, f"{peak} bytes of {positions.nbytes}"
    assert not positions.flags.owndata, "the memory is the library's own"
    tracemalloc.start()
    copied = positions.copy()
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak >= copied.nbytes, "the comparison can fail"


def test_a_call_costs_less_than_20_microseconds():
    # A fold that does nothing: one step of two triangles.
    model = origami.Model(origami.Pattern.generate("single-crease"))
    one_step = origami.Relax(steps=1)

    def best(call, count=500):
        times = []
        for _ in range(20):
            begun = time.perf_counter()
            for _ in range(count):
                call()
            times.append((time.perf_counter() - begun) / count)
        return min(times)

    cost = best(lambda: one_step.fold(model, 90))
    print(f"a fold of one step: {1e6 * cost:.1f} microseconds")
    assert cost < 20e-6, f"{1e6 * cost:.1f} microseconds"


def test_arrays_have_the_documented_shapes(bird, folded):
    model = folded.model
    vertices, edges, faces = len(bird.vertices), len(bird.edges), len(bird.faces)
    assert bird.vertices.shape == folded.positions.shape == (vertices, 3)
    assert bird.edges.shape == (edges, 2) and len(bird.letters) == edges
    assert bird.fold_angles.shape == folded.fold_angles.shape == (edges,)
    assert len(bird.faces) == faces
    assert model.triangles.shape[1] == 3 and model.face_of_triangle.shape == model.triangles.shape[:1]
    assert model.triangles.max() < vertices and model.face_of_triangle.max() < faces
    creases = len(model.creases)
    assert model.crease_of_edge.shape == (edges,) and model.crease_of_edge.max() < creases
    assert folded.crease_angles.shape == folded.targets.shape == model.targets().shape == (creases,)
    assert folded.beam_strains.shape == model.beams.shape[:1] and folded.vertex_strains.shape == (vertices,)
    boundary = np.array([letter == "B" for letter in bird.letters])
    np.testing.assert_array_equal(np.isnan(bird.fold_angles), boundary)
    np.testing.assert_array_equal(np.isnan(folded.fold_angles), boundary)
    built = {line["what"]: line["count"] for line in model.inventory["built"]}
    assert built["beams"] == len(model.beams)
    on_edges = model.crease_of_edge >= 0
    ends = np.sort(model.creases[model.crease_of_edge[on_edges]], axis=1)
    np.testing.assert_array_equal(ends, np.sort(bird.edges[on_edges], axis=1))


def test_pictures_are_arrays(folded):
    if "render" not in origami.features:
        pytest.skip("a build without pictures")
    picture = folded.picture((200, 160))
    assert picture.shape == (160, 200, 4) and picture.dtype == np.uint8
    assert (picture[..., 3] == 255).all() and len(np.unique(picture.reshape(-1, 4), axis=0)) > 20
    clear = folded.picture((200, 160), transparent=True, camera="top")
    assert (clear[0, 0] == 0).all()
    strained = folded.picture((400, 300), map="strain", caption="strain")
    assert (strained[:3] == strained[0, 0]).all() and not np.array_equal(strained, folded.picture((400, 300)))
    with pytest.raises(origami.Refused, match="one of default, top, front, isometric"):
        folded.picture(camera="behind")
    with pytest.raises(origami.OrigamiError, match="0 x 0"):
        folded.picture((0, 0))
