"""Errors are exceptions with their place as attributes."""

import pickle

import numpy as np
import pytest

import origami_sim as origami


def test_a_missing_file_is_pythons_own_error(tmp_path):
    with pytest.raises(FileNotFoundError) as raised:
        origami.Pattern.read(tmp_path / "nothing.fold")
    assert raised.value.filename == str(tmp_path / "nothing.fold")


def test_text_that_is_no_json_has_line_and_column():
    with pytest.raises(origami.PatternError) as raised:
        origami.Pattern.from_bytes(b'{"file_spec": 1.2,\n  "vertices_coords": [[0, 0], [1, x]]}', "broken.fold")
    error = raised.value
    assert (error.line, error.code) == (2, "not-json")
    assert isinstance(error.column, int) and "line 2" in str(error)


def test_a_key_is_named_with_its_index():
    fold = {
        "vertices_coords": [[0, 0], [1, 0], [1, 1]],
        "edges_vertices": [[0, 1], [1, 2], [2, 7]],
        "edges_assignment": ["B", "B", "B"],
    }
    with pytest.raises(origami.PatternError) as raised:
        origami.Pattern.from_fold(fold)
    error = raised.value
    assert (error.key, error.index, error.frame) == ("edges_vertices", 2, None)
    assert error.place.startswith("edges_vertices[2]") and error.expected and error.line is None


def test_settings_are_refused_by_name(bird):
    cases = [
        (dict(tolerance=-1.0), "tolerance"),
        (dict(tolerance="small"), "tolerance"),
        (dict(max_steps=-1), "max_steps"),
        (dict(perturbation=2.0), "perturbation"),
        (dict(precision="f16"), "precision"),
        (dict(threads=0), "threads"),
        (dict(hold="table"), "hold"),
        (dict(supports={999: None}), "supports"),
        (dict(loads={0: (1.0, np.nan, 0.0)}), "loads"),
    ]
    for settings, name in cases:
        with pytest.raises(origami.Refused) as raised:
            origami.relax(bird, 50, **settings)
        assert raised.value.setting == name and raised.value.expected
    with pytest.raises(origami.Refused, match="material ea"):
        origami.Model(bird, origami.Material(ea=0.0))
    with pytest.raises(origami.Refused, match="finite percentage"):
        origami.relax(bird, np.inf)
    with pytest.raises(TypeError, match="tolerances"):
        origami.relax(bird, tolerances=1e-3)
    with pytest.raises(origami.Refused, match="a Model, or a Pattern"):
        origami.relax("bird-base.fold")
    with pytest.raises(origami.Refused, match="nothing holds the sheet"):
        origami.relax(bird, 50, loads={0: (0.0, 0.0, 1.0)})


def test_a_divergence_tells_where_and_hands_back_the_last_good_state(bird):
    with pytest.raises(origami.Diverged) as raised:
        origami.dynamics(bird, 90, time_step=10.0)
    error = raised.value
    assert error.quantity in ("position", "move") and error.step > 0
    assert 0 <= error.vertex < len(bird.vertices)
    assert error.last_good.shape == bird.vertices.shape and np.isfinite(error.last_good).all()
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is origami.Diverged and str(again) == str(error) and again.step == error.step
    np.testing.assert_array_equal(again.last_good, error.last_good)


def test_a_path_tells_how_far_it_was_to_go(bird):
    with pytest.raises(origami.Diverged) as raised:
        origami.Dynamics(time_step=10.0, steps=200).path(bird, [0.0, 60.0])
    assert raised.value.percent == 60.0


def test_all_attributes_are_always_there():
    error = origami.OrigamiError("nothing is known")
    assert error.place is None and error.last_good is None and str(error) == "nothing is known"
