"""The same numbers as the command line, to the last bit."""

import json
import re
from pathlib import Path

import numpy as np
import pytest

import origami_sim as origami

OTHER = {"input", "outputs", "seconds"}


@pytest.mark.parametrize("name", ["bird-base", "miura", "crane", "kresling"])
def test_a_fold_is_that_of_the_command_line(cli, patterns, tmp_path, name):
    path = patterns / f"{name}.fold"
    cli("fold", path, "--percent", 70, "--backend", "cpu", "-o", tmp_path / "folded.fold", "--report", tmp_path / "report.json")
    report = json.loads((tmp_path / "report.json").read_text())
    folded = origami.relax(origami.Pattern.read(path), 70)
    ours = folded.report()
    assert list(ours) == list(report)
    for key in report.keys() - OTHER:
        assert ours[key] == report[key], key
    assert ours["input"] == str(path) and ours["seconds"].keys() == report["seconds"].keys()
    fold = json.loads((tmp_path / "folded.fold").read_text())
    assert folded.to_fold() == fold
    np.testing.assert_array_equal(folded.positions, fold["vertices_coords"])


def test_the_report_has_the_keys_of_its_document(folded):
    text = (Path(__file__).resolve().parents[3] / "docs" / "REPORT.md").read_text()
    table = text.split("All others have these:")[1].split("The keys from `percent`")[0]
    named = re.findall(r"^\| `(\w+)` \|", table, re.M)
    # Only with `--frames`, after a divergence, in a sequence, with `--check`, `--contact` and `--backwards`.
    elsewhere = ("frames", "diverged", "step", "crossings", "contact", "backwards")
    assert {key for key in named if key not in elsewhere} == folded.report().keys()


def test_a_sweep_is_that_of_the_command_line(cli, patterns, tmp_path):
    path = patterns / "bird-base.fold"
    lists = ["--percent", "0,30.5,90", "--k-fold", "0,0.7,7", "--perturbation", "0,0.01", "--seeds", "2"]
    cli("sweep", path, *lists, "--backend", "cpu", "-o", tmp_path / "theirs")
    ours = tmp_path / "ours.csv"
    table = origami.sweep(
        origami.Pattern.read(path),
        [0, 30.5, 90],
        k_fold=[0, 0.7, 7],
        perturbation=[0, 0.01],
        seeds=2,
        output=ours,
        batch_seconds=0.02,
    )
    assert ours.read_bytes() == (tmp_path / "theirs" / "sweep.csv").read_bytes()
    rows = json.loads((tmp_path / "theirs" / "sweep.json").read_text())["instances"]
    assert len(table["index"]) == len(rows) == 36
    np.testing.assert_array_equal(table["strain_max"], [row["strain"]["max"] for row in rows])
    np.testing.assert_array_equal(table["stop"], [row["stop"] for row in rows])


def test_what_diverges_has_a_row_as_on_the_command_line(cli, patterns, tmp_path):
    path = patterns / "bird-base.fold"
    options = ["--solver", "dynamics", "--time-step", "10", "--percent", "30,60"]
    cli("sweep", path, *options, "--backend", "cpu", "-o", tmp_path / "theirs", check=False)
    table = origami.sweep(
        origami.Pattern.read(path), [30, 60], solver=origami.Dynamics(time_step=10.0), output=tmp_path / "ours.csv"
    )
    assert (tmp_path / "ours.csv").read_bytes() == (tmp_path / "theirs" / "sweep.csv").read_bytes()
    assert set(table["stop"]) == {"diverged"} and np.isnan(table["strain_max"]).all()
