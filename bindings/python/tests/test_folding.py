"""Folding: against closed forms, and against itself."""

import _thread
import dataclasses
import pickle
import threading
import time

import numpy as np
import pytest

import origami_sim as origami
from origami_sim import _native


def test_a_single_crease_reaches_its_angle():
    pattern = origami.Pattern.generate("single-crease", angle=90)
    folded = origami.relax(pattern, 100, tolerance=1e-9)
    crease = pattern.letters.index("V")
    assert folded.fold_angles[crease] == pytest.approx(90, abs=1e-4)
    # The two halves lie in planes that stand on each other.
    one, two = (folded.positions[face] for face in pattern.faces)
    normals = [np.cross(face[1] - face[0], face[2] - face[0]) for face in (one, two)]
    assert abs(normals[0] @ normals[1]) < 1e-6 * np.linalg.norm(normals[0]) * np.linalg.norm(normals[1])


def test_measures_agree_with_numpy(folded):
    model = folded.model
    rest, now = model.positions, folded.positions
    lengths = [np.linalg.norm(x[model.beams[:, 1]] - x[model.beams[:, 0]], axis=1) for x in (rest, now)]
    strains = lengths[1] / lengths[0] - 1
    np.testing.assert_allclose(folded.beam_strains, strains, atol=1e-12)
    assert folded.strain["max"] == pytest.approx(abs(strains).max(), abs=1e-12)
    assert folded.strain["rms"] == pytest.approx(np.sqrt(np.mean(strains**2)), abs=1e-12)
    stiffness = model.material.ea / (lengths[0] / model.radius)
    energy = 0.5 * np.sum(stiffness * (lengths[1] - lengths[0]) ** 2) / model.radius**2
    assert folded.energy["beams"] == pytest.approx(energy, rel=1e-9)
    errors = np.degrees(abs(folded.crease_angles - folded.targets))
    assert folded.angle_error_deg["max"] == pytest.approx(errors.max())
    np.testing.assert_allclose(folded.targets, model.targets(90), rtol=1e-15)
    assert not np.allclose(folded.beam_strains, strains + 1e-6, atol=1e-12), "the comparison can fail"


def test_solvers_agree(bird):
    relaxed = origami.relax(bird, 60, tolerance=1e-6)
    moved = origami.dynamics(bird, 60, ramp=2000, tolerance=1e-6, max_steps=2_000_000, time_step="safe")
    largest, _, _ = origami.align(moved.positions, relaxed.positions)
    assert largest < 1e-4 * relaxed.model.radius
    if "newton" in origami.features:
        exact = origami.newton(bird, 60)
        assert exact.residual <= 1e-10 and exact.converged
        largest, _, moved = origami.align(exact.positions, relaxed.positions)
        assert largest < 1e-5 * relaxed.model.radius
        assert moved.shape == exact.positions.shape


def test_a_fold_goes_on_from_another(bird):
    half = origami.relax(bird, 45)
    on = origami.relax(half.model, 90, start=half)
    path = origami.Relax().path(half.model, [45, 90])
    assert [folded.percent for folded in path] == [45, 90] and on.converged
    np.testing.assert_array_equal(path[0].positions, half.positions)
    with pytest.raises(origami.Refused, match="start: a sheet of"):
        origami.relax(origami.Pattern.generate("miura"), 90, start=half)


def test_targets_of_ones_own(bird):
    model = origami.Model(bird)
    same = origami.relax(model, targets=model.targets(60))
    np.testing.assert_array_equal(same.positions, origami.relax(model, 60).positions)
    assert same.percent is None
    with pytest.raises(origami.Refused, match="targets: 3 numbers"):
        origami.relax(model, targets=[0, 0, 0])


def test_a_loaded_strip_rests_on_its_supports():
    pattern = origami.Pattern.generate("strip")
    held = {0: None, 1: None, len(pattern.vertices) - 1: None, len(pattern.vertices) - 2: None}
    middle = len(pattern.vertices) // 2
    folded = origami.relax(pattern, 0, supports=held, loads={middle: (0, 0, -1e-3)}, tolerance=1e-8)
    vertices, forces = folded.reactions
    assert sorted(vertices) == sorted(held)
    np.testing.assert_allclose(forces.sum(axis=0), [0, 0, 1e-3], atol=1e-8)
    np.testing.assert_allclose(folded.positions[list(held)], pattern.vertices[list(held)], atol=1e-12)


def test_what_holds_is_where_it_was(bird):
    folded = origami.relax(bird, 90, hold=3)
    face = bird.faces[3]
    np.testing.assert_allclose(folded.positions[face], bird.vertices[face], atol=2e-3 * bird.size)
    assert folded.report()["attitude"] == "face 3"
    free = origami.relax(bird, 90, hold="none")
    assert not np.array_equal(free.positions, folded.positions)
    with pytest.raises(origami.OrigamiError, match="face"):
        origami.relax(bird, 90, hold=1000)


def test_equal_input_gives_equal_bits(bird, folded):
    np.testing.assert_array_equal(origami.relax(bird, 90).positions, folded.positions)


def test_defaults_are_the_librarys():
    for name, own in _native.defaults().items():
        settings = dataclasses.asdict(getattr(origami, name)())
        for setting, value in own.items():
            ours = settings[setting]
            if setting == "relax":
                assert ours == {**value, "precision": value["precision"].lower()}
            elif isinstance(value, str):
                assert ours == value.lower()
            elif name == "Newton" and setting == "max_steps":
                assert ours is None and value == 2**64 - 1
            else:
                assert ours == value, f"{name}.{setting}"
        assert settings.keys() == own.keys()


def test_objects_pickle(folded):
    again = pickle.loads(pickle.dumps(folded))
    np.testing.assert_array_equal(again.positions, folded.positions)
    reports = [{**sheet.report(), "seconds": None} for sheet in (again, folded)]
    assert reports[0] == reports[1] and again.to_fold() == folded.to_fold()
    assert pickle.loads(pickle.dumps(folded.model)).material == origami.Material()
    for settings in (origami.Material(ea=5), origami.Relax(ramp=3), origami.Dynamics(), origami.Newton()):
        assert pickle.loads(pickle.dumps(settings)) == settings


def test_ctrl_c_ends_a_fold(bird):
    timer = threading.Timer(0.5, _thread.interrupt_main)
    timer.start()
    begun = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        origami.dynamics(bird, 90, steps=2**40, max_steps=2**40)
    assert time.perf_counter() - begun < 5


def test_others_run_while_it_computes():
    sheet = origami.Model(origami.Pattern.generate("miura", columns=20, rows=20))
    ticks = []
    done = threading.Event()

    def tick():
        while not done.wait(0.001):
            ticks.append(time.perf_counter())

    other = threading.Thread(target=tick)
    other.start()
    begun = time.perf_counter()
    origami.dynamics(sheet, 50, steps=3000, threads=1)
    took = time.perf_counter() - begun
    done.set()
    other.join()
    within = [tick for tick in ticks if begun < tick < begun + took]
    assert len(within) > 5, f"{len(within)} ticks in {took:.2f} s"


def test_progress_is_told_and_can_end_it(bird):
    told = []
    origami.dynamics(bird, 90, steps=300_000, max_steps=300_000, progress=lambda *now: told.append(now))
    steps = [step for step, _, _ in told]
    assert steps == sorted(steps) and steps and all(ramp == 1 for _, ramp, _ in told)

    def enough(*_):
        raise StopIteration("enough")

    with pytest.raises(StopIteration, match="enough"):
        origami.dynamics(bird, 90, steps=2**40, max_steps=2**40, progress=enough)


def test_flat_folding_is_told(bird):
    found = origami.flat_folding(bird)
    assert found["applies"] and found["faults"] == [] and found["closure"]["spread"] < 1e-9
    assert not origami.flat_folding(origami.Pattern.generate("single-crease", angle=90))["applies"]


def test_points_are_laid_upon_others():
    points = np.random.default_rng(1).normal(size=(20, 3))
    angle = 0.7
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    largest, rms, moved = origami.align(points, points @ turn.T + [1, 2, 3])
    assert largest < 1e-12 and rms <= largest
    np.testing.assert_allclose(moved, points @ turn.T + [1, 2, 3], atol=1e-12)
    assert origami.align(points, points * 1.1)[0] > 1e-3
    with pytest.raises(origami.Refused, match="20 points onto 19"):
        origami.align(points, points[1:])
