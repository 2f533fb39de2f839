"""Patterns from files, arrays, dicts and generators."""

import json
import pickle

import numpy as np
import pytest

import origami_sim as origami

SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]
EDGES = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]]


def test_a_file_is_what_its_json_says(patterns):
    pattern = origami.Pattern.read(patterns / "bird-base.fold")
    fold = json.loads((patterns / "bird-base.fold").read_text())
    np.testing.assert_array_equal(pattern.vertices[:, :2], fold["vertices_coords"])
    np.testing.assert_array_equal(pattern.edges, fold["edges_vertices"])
    assert pattern.letters == "".join(fold["edges_assignment"])
    assert pattern.faces == fold["faces_vertices"]
    assert pattern.is_flat and pattern.size == np.ptp(pattern.vertices, axis=0).max()


def test_all_ways_lead_to_one_pattern(patterns, bird):
    fold = json.loads((patterns / "bird-base.fold").read_text())
    of_dict = origami.Pattern.from_fold(fold)
    angles = [np.nan if angle is None else angle for angle in fold["edges_foldAngle"]]
    of_arrays = origami.Pattern.from_arrays(
        np.array(fold["vertices_coords"]),
        np.array(fold["edges_vertices"]),
        fold["edges_assignment"],
        fold_angles=angles,
        faces=fold["faces_vertices"],
    )
    generated = origami.Pattern.generate("bird-base")
    for other in (of_dict, of_arrays, generated):
        np.testing.assert_array_equal(other.vertices, bird.vertices)
        np.testing.assert_array_equal(other.edges, bird.edges)
        np.testing.assert_array_equal(other.fold_angles, bird.fold_angles)
        assert other.faces == bird.faces
        np.testing.assert_array_equal(origami.relax(other, 60).positions, origami.relax(bird, 60).positions)


def test_dicts_may_hold_arrays():
    fold = {
        "vertices_coords": np.array(SQUARE, float),
        "edges_vertices": np.array(EDGES),
        "edges_assignment": list("BBBBV"),
    }
    assert len(origami.Pattern.from_fold(fold).faces) == 2
    with pytest.raises(TypeError, match="set in a FOLD dict"):
        origami.Pattern.from_fold({"vertices_coords": {1, 2}})


def test_other_formats_are_read(tmp_path):
    if "formats" not in origami.features:
        pytest.skip("a build without other formats")
    square = "".join(f"1 {a[0]} {a[1]} {b[0]} {b[1]}\n" for a, b in zip(SQUARE, SQUARE[1:] + SQUARE[:1]))
    path = tmp_path / "square.cp"
    path.write_text(square + "3 0 0 1 1\n")
    pattern = origami.Pattern.read(path)
    assert sorted(pattern.letters) == list("BBBBV")
    again = pickle.loads(pickle.dumps(pattern))
    assert again.warnings == pattern.warnings and again.letters == pattern.letters


def test_what_goes_out_comes_back(bird):
    again = origami.Pattern.from_fold(bird.to_fold())
    np.testing.assert_array_equal(again.vertices, bird.vertices)
    assert again.letters == bird.letters


def test_generators_are_named_with_their_parameters():
    names = origami.generators()
    parameters = {p["name"]: p["default"] for p in names["miura"]["parameters"]}
    assert parameters["columns"] > 0
    wide = origami.Pattern.generate("miura", columns=9, rows=2)
    assert len(wide.faces) == 18
    with pytest.raises(origami.OrigamiError, match="no-such-pattern"):
        origami.Pattern.generate("no-such-pattern")


def test_arrays_of_another_shape_are_refused():
    cases = [
        ({"vertices": np.zeros((4, 4))}, r"vertices: an array of shape \(4, 4\)"),
        ({"vertices": [[0, 0], [1, 0], [1, np.nan], [0, 1]]}, r"vertices\[2\]"),
        ({"edges": np.zeros((5, 3), int)}, r"edges: an array of shape \(5, 3\)"),
        ({"edges": [[0, 1], [1, 2], [2, 3], [3, 0], [0, -2]]}, r"edges\[4\]\[1\]: -2"),
        ({"edges": [[0, 1], [1, 2], [2, 3], [3, 0], [0, 9]]}, r"edges_vertices\[4\]"),
        ({"letters": "BBBB"}, "edges_assignment"),
        ({"fold_angles": [0, 0]}, "fold_angles: 2 numbers; expected one for each of the 5 edges"),
    ]
    given = {"vertices": SQUARE, "edges": EDGES, "letters": "BBBBV"}
    for change, message in cases:
        with pytest.raises(origami.OrigamiError, match=message):
            origami.Pattern.from_arrays(**{**given, **change})


def test_patterns_pickle(bird):
    for pattern in (bird, origami.Pattern.generate("miura"), origami.Pattern.from_arrays(SQUARE, EDGES, "BBBBM")):
        again = pickle.loads(pickle.dumps(pattern))
        np.testing.assert_array_equal(again.vertices, pattern.vertices)
        assert again.to_fold() == pattern.to_fold()
