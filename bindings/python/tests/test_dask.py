"""Sweeps on a real cluster of two worker processes, on this machine."""

import os
import signal
import subprocess
import sys

import numpy as np
import pytest

import origami_sim as origami

distributed = pytest.importorskip("distributed")


@pytest.fixture()
def client():
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None, silence_logs=50
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        yield client


def test_a_cluster_makes_no_difference(client, bird, tmp_path):
    ours, theirs = tmp_path / "ours.csv", tmp_path / "theirs.csv"
    told = []
    origami.sweep(
        bird,
        [30, 60, 90],
        seeds=20,
        output=ours,
        client=client,
        batch_seconds=0.1,
        progress=lambda done, count: told.append((done, count)),
    )
    origami.sweep(bird, [30, 60, 90], seeds=20, output=theirs)
    assert ours.read_bytes() == theirs.read_bytes()
    assert told[-1] == (60, 60)


def test_a_killed_worker_loses_nothing_and_nothing_comes_twice(client, bird):
    workers = sorted(client.run(os.getpid).values())
    assert len(workers) == 2
    killed = []

    def kill_one(done, count):
        if not killed and done > count // 4:
            killed.append(workers[0])
            os.kill(workers[0], signal.SIGKILL)

    table = origami.sweep(bird, 90, seeds=400, client=client, batch_seconds=0.1, progress=kill_one)
    assert killed
    np.testing.assert_array_equal(table["index"], np.arange(400))
    alone = origami.sweep(bird, 90, seeds=400)
    np.testing.assert_array_equal(table["strain_max"], alone["strain_max"])


SWEEP = """
import sys
from pathlib import Path
from distributed import Client, LocalCluster
import origami_sim as origami

if __name__ == "__main__":
    output = Path(sys.argv[1])
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50) as cluster, Client(cluster) as client:
        bird = origami.Pattern.generate("bird-base")
        progress = lambda done, count: print(done, flush=True)
        origami.sweep(bird, 90, seeds=3000, client=client, batch_seconds=0.05, output=output, resume=True, progress=progress)
"""


def test_a_killed_client_loses_no_finished_row(tmp_path, bird):
    script, output = tmp_path / "sweep.py", tmp_path / "rows.csv"
    script.write_text(SWEEP)
    command = [sys.executable, script, output]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as killed:
        told = next(done for line in killed.stdout if (done := int(line)) > 200)
        killed.kill()
    there = output.read_text().splitlines()
    # The header besides.
    assert told < len(there) <= 3000
    finished = subprocess.run(command, check=True, capture_output=True, text=True)
    # It went on: nothing that was there is folded again.
    assert int(finished.stdout.split()[0]) >= len(there) - 2
    alone = tmp_path / "alone.csv"
    origami.sweep(bird, 90, seeds=3000, output=alone)
    assert output.read_bytes() == alone.read_bytes()
