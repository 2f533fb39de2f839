"""A sheet that is stepped and steered."""

import pickle

import numpy as np
import pytest

import origami_sim as origami


@pytest.mark.parametrize("solver", [origami.Dynamics(), origami.Relax()])
def test_steps_are_those_of_the_solver(bird, solver):
    sheet = origami.Simulation(bird, solver, percent=60)
    report = sheet.step(500)
    assert report["steps"] == 500 == sheet.report()["steps"]
    if isinstance(solver, origami.Dynamics):
        run = origami.dynamics(bird, 60, steps=500, hold="none")
        np.testing.assert_array_equal(sheet.positions, run.positions)
    report = sheet.settle()
    assert report["settled"] and report["ramp"] == 1
    folded = sheet.finish()
    assert folded.converged and folded.percent == 60
    np.testing.assert_array_equal(folded.positions, sheet.positions)


def test_pieces_are_the_same_as_one_go(bird):
    one, many = (origami.Simulation(bird, percent=60) for _ in range(2))
    one.step(3000)
    for _ in range(30):
        many.step(100)
    np.testing.assert_array_equal(one.positions, many.positions)


def test_pins_hold_and_move(bird):
    sheet = origami.Simulation(bird)
    corner, centre = 0, 4
    sheet.pin(corner)
    sheet.pin(centre)
    assert sheet.pins == [corner, centre]
    place = sheet.positions[corner] + [0, 0, 0.1 * bird.size]
    sheet.move_pin(corner, place)
    sheet.step(200)
    np.testing.assert_allclose(sheet.positions[corner], place, atol=1e-12)
    vertices, forces = sheet.reactions
    assert set(vertices) == {corner, centre} and np.abs(forces).max() > 0
    sheet.unpin(corner)
    sheet.step(200)
    assert not np.allclose(sheet.positions[corner], place)
    with pytest.raises(origami.Refused, match="expected one of 4"):
        sheet.move_pin(corner, place)
    with pytest.raises(origami.Refused, match="vertex 99"):
        sheet.pin(99)


def test_targets_and_loads_steer(bird):
    sheet = origami.Simulation(bird, origami.Relax())
    assert sheet.percent is None
    sheet.percent = 30
    assert sheet.percent == 30 and sheet.settle()["settled"]
    angles = sheet.crease_angles
    sheet.set_targets(angles)
    assert sheet.percent is None
    sheet.pin(0)
    sheet.set_loads({8: (0.0, 0.0, 1e-3)})
    before = sheet.positions
    sheet.settle()
    assert sheet.positions[8, 2] > before[8, 2]
    with pytest.raises(origami.Refused, match="three finite numbers"):
        sheet.set_loads({8: (0.0, 1.0)})


@pytest.mark.parametrize("solver", [origami.Dynamics(integrator="verlet"), origami.Relax()])
def test_a_pickled_simulation_goes_on_bit_for_bit(bird, solver):
    sheet = origami.Simulation(bird, solver, percent=60)
    sheet.pin(0)
    sheet.step(150)
    other = pickle.loads(pickle.dumps(sheet))
    assert other.pins == [0] and other.report()["steps"] == 150
    sheet.step(400)
    other.step(400)
    np.testing.assert_array_equal(sheet.positions, other.positions)
    other.unpin(0)
    other.step(400)
    assert not np.array_equal(other.positions[0], sheet.positions[0]), "it is let go"


def test_single_precision_for_viewers(bird):
    sheet = origami.Simulation(bird, percent=60)
    sheet.step(100)
    positions = sheet.node_positions_f32()
    assert positions.dtype == np.float32
    np.testing.assert_allclose(positions, sheet.positions, atol=1e-5 * bird.size)
