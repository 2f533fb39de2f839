"""Structures: the numbers of MERLIN and of the command line, and gradients by differences."""

import csv
import json
import pickle

import numpy as np
import pytest

import origami_sim as origami

pytestmark = pytest.mark.skipif("analysis" not in origami.features, reason="needs the feature analysis")

# Limit loads of MERLIN's and MERLIN2's own examples (examples/analysis/README says whose).
LIMITS = {"kresling": [0.432297769, -0.102125919], "miura-pop-through": [2.311783656, -1.751595094]}


@pytest.fixture()
def structure(patterns):
    def read(name):
        folder = patterns.parent / "analysis"
        job = json.loads((folder / f"{name}.json").read_text())
        return origami.Structure(origami.Pattern.read(folder / f"{name}.fold"), job)

    return read


@pytest.fixture(scope="module")
def saddle():
    """A folded Miura sheet that is held and pulled, with an equilibrium, and a result with its derivative."""
    model = origami.Model(origami.Pattern.generate("miura", columns=3, rows=3))
    folded = origami.relax(model, 60, tolerance=1e-9)
    supports = [{"on": {"vertices": [0]}, "fixed": "xyz"}, {"on": {"vertices": [3]}, "fixed": "yz"}, {"on": {"vertices": [12]}, "fixed": "z"}]
    loads = [{"on": {"vertices": [15]}, "force": [0.01, 0.02, -0.03]}]
    structure = origami.Structure(model, {"supports": supports, "loads": loads, "rest": "target"})
    structure = structure.replace(rest_angles=0.6 * structure.rest_angles)
    at = structure.equilibrium(folded, load_factor=1.0)
    wanted = np.random.default_rng(7).normal(size=at.positions.shape)
    return structure, at, lambda at: float(np.sum(wanted * at.positions)), wanted


@pytest.mark.parametrize("name", LIMITS)
def test_limit_loads_are_those_published(structure, name):
    path = structure(name).path()
    limits = path["load_factor"][np.array(path["event"]) == "limit"]
    np.testing.assert_allclose(limits[:2], LIMITS[name], atol=1e-8)
    assert path["ended"] == "reached"
    points, nodes, _ = path["positions"].shape
    assert points == len(path["load_factor"]) == len(path["event"]) and nodes == len(structure(name).vertices)
    assert path["fold_angles"].shape == (points, len(structure(name).rest_angles))
    # Loads that are dead: energy is work but for the trapezoidal rule.
    np.testing.assert_allclose(path["energy"] - path["energy"][0], path["work"], atol=0.02 * path["energy"].max())


def test_a_barrier_is_that_of_a_saddle(structure):
    states = structure("miura-pop-through").path()["equilibria"]
    assert [state["index"] for state in states] == [0, 1, 0]
    assert states[0]["barrier"] == pytest.approx(2.185070, abs=1e-6)


def test_a_path_is_that_of_the_command_line(cli, structure, patterns, tmp_path):
    folder = patterns.parent / "analysis"
    cli("analyse", "path", folder / "kresling.fold", folder / "kresling.json", "-o", tmp_path)
    with open(tmp_path / "curve.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    path = structure("kresling").path()
    np.testing.assert_array_equal(path["load_factor"], [float(row["load_factor"]) for row in rows])
    np.testing.assert_array_equal(path["negative"], [int(row["negative"]) for row in rows])


@pytest.mark.parametrize("name", ["rest_angles", "hinge_stiffnesses", "rest_lengths", "rigidities"])
def test_gradients_are_differences(saddle, name):
    structure, at, result, by_positions = saddle
    gradient = structure.gradient(at, by_positions)[name]
    numbers = getattr(structure, name)
    assert gradient.shape == numbers.shape
    for k in np.random.default_rng(1).choice(len(numbers), 5, replace=False):
        step = 1e-5 * max(abs(numbers[k]), 0.1)
        moved = [np.where(np.arange(len(numbers)) == k, numbers + side * step, numbers) for side in (1, -1)]
        far, near = (result(structure.replace(**{name: numbers}).equilibrium(at)) for numbers in moved)
        assert (far - near) / (2 * step) == pytest.approx(gradient[k], abs=1e-5 * np.abs(gradient).max())


def test_the_gradient_by_the_load_factor_is_a_difference(saddle):
    structure, at, result, by_positions = saddle
    far, near = (result(structure.equilibrium(at, load_factor=1 + side)) for side in (1e-4, -1e-4))
    slope = structure.gradient(at, by_positions)["load_factor"]
    assert (far - near) / 2e-4 == pytest.approx(slope, rel=1e-5)


def test_first_answers_vibrations_and_buckling(saddle, structure):
    held, at, _, _ = saddle
    answer = held.stiffness(at)
    # The equilibrium a little further along the load.
    further = held.equilibrium(at, load_factor=1 + 1e-5)
    moves = (further.positions - at.positions) / 1e-5
    np.testing.assert_allclose(answer["displacements"], moves, atol=1e-3 * np.abs(moves).max())
    assert answer["compliance"] == pytest.approx(np.dot([0.01, 0.02, -0.03], answer["displacements"][15]))
    # What acts is held in balance.
    np.testing.assert_allclose(answer["reactions"].sum(axis=0), [-0.01, -0.02, 0.03], atol=1e-9)
    modes = held.modes(at, 4)
    assert modes["shape"].shape == (4, len(held.vertices), 3) and (np.diff(modes["eigenvalue"]) >= 0).all()
    assert modes["eigenvalue"][0] > 0 and modes["frequency_hz"] is None and len(modes["kind"]) == 4
    buckling = structure("yoshimura").buckling(2)
    assert buckling["load_factor"].shape == (2,) and abs(buckling["load_factor"][0]) <= abs(buckling["load_factor"][1])


def test_structures_and_configurations_pickle(saddle):
    structure, at, _, by_positions = saddle
    again, there = pickle.loads(pickle.dumps((structure, at)))
    np.testing.assert_array_equal(again.rest_angles, structure.rest_angles)
    np.testing.assert_array_equal(there.positions, at.positions)
    ours, theirs = structure.gradient(at, by_positions), again.gradient(there, by_positions)
    np.testing.assert_array_equal(ours["rest_angles"], theirs["rest_angles"])


def test_bad_jobs_name_the_key(bird):
    with pytest.raises(origami.PatternError) as caught:
        origami.Structure(bird, {"supports": [{"on": {"vertices": [99]}, "fixed": "xyz"}]})
    assert "supports[0].on" in caught.value.place
    with pytest.raises(origami.OrigamiError, match="supprts"):
        origami.Structure(bird, {"supprts": []})
    with pytest.raises(origami.Refused, match="6 rigid motions"):
        origami.Structure(bird, {}).stiffness()
    structure = origami.Structure(bird, {})
    with pytest.raises(origami.Refused) as caught:
        structure.replace(rest_angles=[0.0])
    assert caught.value.setting == "rest_angles"
    with pytest.raises(origami.Refused, match="rest_length"):
        structure.replace(rest_lengths=-structure.rest_lengths)
    with pytest.raises(origami.Refused, match="positions"):
        structure.equilibrium(origami.Configuration(np.zeros((2, 3)), []))
