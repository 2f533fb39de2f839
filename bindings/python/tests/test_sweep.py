"""Sweeps: on threads, on processes, on executors that misbehave."""

import _thread
import contextlib
import csv
import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor

import numpy as np
import pytest

import origami_sim as origami
from origami_sim._batches import Batches

PERCENTS = [10.0 * i for i in range(10)]
GRID = dict(k_fold=[0.5, 0.7], seeds=2)
COUNT = 40


def same(one, other):
    assert one.keys() == other.keys()
    for name, column in one.items():
        np.testing.assert_array_equal(column, other[name], err_msg=name)


@pytest.fixture(scope="module")
def table(bird):
    return origami.sweep(bird, PERCENTS, **GRID)


def test_rows_are_those_of_single_folds(bird, table):
    assert all(len(column) == COUNT for column in table.values())
    np.testing.assert_array_equal(table["index"], np.arange(COUNT))
    for row in (0, 7, 13, 39):
        folded = origami.relax(
            origami.Model(bird, origami.Material(k_fold=table["k_fold"][row])), table["percent"][row]
        )
        if table["seed"][row] == 0:
            assert table["strain_mean"][row] == folded.strain["mean"] and table["steps"][row] == folded.steps
        else:
            assert table["strain_mean"][row] != folded.strain["mean"], "another seed begins elsewhere"
    assert table["converged"].all() and set(table["stop"]) == {"converged"}
    assert table["converged"].dtype == bool and table["steps"].dtype == np.int64


def test_several_patterns_have_a_column(bird):
    miura = origami.Pattern.generate("miura")
    table = origami.sweep([bird, miura], [30, 60], batch_seconds=0.01)
    np.testing.assert_array_equal(table["pattern"], [0, 0, 1, 1])
    np.testing.assert_array_equal(table["index"], range(4))
    assert table["strain_max"][3] == origami.relax(miura, 60).strain["max"]


def test_threads_make_no_difference(bird, table):
    same(origami.sweep(bird, PERCENTS, workers=1, **GRID), table)


def test_processes_make_no_difference(bird, table):
    with ProcessPoolExecutor(2) as pool:
        same(origami.sweep(bird, PERCENTS, client=pool, batch_seconds=0.02, **GRID), table)


def test_parquet_keeps_every_bit(table, tmp_path):
    polars = pytest.importorskip("polars")
    frame = polars.DataFrame(table)
    frame.write_parquet(tmp_path / "rows.parquet")
    again = polars.read_parquet(tmp_path / "rows.parquet")
    assert again.columns == list(table)
    for name, column in table.items():
        np.testing.assert_array_equal(again[name].to_numpy(), column)


def test_a_table_is_what_pandas_takes(table):
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(table)
    assert frame.shape == (COUNT, 32) and frame.groupby("percent").size().eq(4).all()


class Unsteady(Executor):
    """Runs what it is given at once, and fails at every third task."""

    _max_workers = 1

    def __init__(self):
        self.tasks = 0
        self.sent = []

    def submit(self, call, *arguments):
        self.tasks += 1
        future = Future()
        if self.tasks % 3 == 0:
            future.set_exception(ConnectionError("the worker is gone"))
        else:
            self.sent.append(arguments[1])
            future.set_result(call(*arguments))
        return future


def test_what_fails_is_tried_again(bird, table):
    executor = Unsteady()
    same(origami.sweep(bird, PERCENTS, client=executor, batch_seconds=0.0, **GRID), table)
    assert executor.tasks > COUNT
    assert sum(plan is not None for plan in executor.sent) == 1, "the pattern is sent once"


def test_what_fails_again_and_again_is_told(bird):
    class Broken(Unsteady):
        def submit(self, call, *arguments):
            self.tasks += 1
            future = Future()
            future.set_exception(ConnectionError("no worker"))
            return future

    broken = Broken()
    with pytest.raises(ConnectionError, match="no worker") as raised:
        origami.sweep(bird, PERCENTS, client=broken, retries=2)
    assert "failed 3 times" in raised.value.__notes__[0]


def test_batches_are_adaptive():
    batches = Batches([1000], [(0, 1000)], 1.0)
    part = batches.take(2)
    assert part.count == 1, "nothing is known yet"
    batches.measured(1, 0.01)
    assert batches.take(2).count == 100
    batches.put_back(part)
    assert batches.take(2) is part, "first what failed"
    counts = []
    while batches:
        counts.append(batches.take(2).count)
    assert sum(counts) == 1000 - 101 and counts[0] == 100
    assert max(counts[-5:]) <= 100 / 8 + 1, "nobody waits long for the last"
    holes = Batches([3, 3], [(1, 4), (5, 6)], 1.0)
    found = []
    while holes:
        part = holes.take(1)
        found.append((part.plan, part.first))
    assert found == [(0, 1), (0, 2), (1, 0), (1, 2)]


def test_rows_are_in_the_file_as_they_come_and_a_sweep_goes_on(bird, table, tmp_path):
    path = tmp_path / "rows.csv"
    seen = []

    def stop_at_ten(done, count):
        assert count == COUNT
        lines = path.read_text().splitlines()
        seen.append((len(lines) - 1, done))
        if done >= 10:
            raise InterruptedError("enough")

    with pytest.raises(InterruptedError):
        origami.sweep(bird, PERCENTS, output=path, workers=1, batch_seconds=0.0, progress=stop_at_ten, **GRID)
    assert all(rows == done for rows, done in seen) and len(seen) >= 10
    # A row that was cut off in the middle is made again.
    kept = path.read_bytes()
    path.write_bytes(kept + kept.splitlines()[1][:30])
    made = []
    same(
        origami.sweep(
            bird, PERCENTS, output=path, resume=True, progress=lambda done, _: made.append(done), **GRID
        ),
        table,
    )
    assert made[0] > 10 and made[-1] == COUNT
    whole = path.read_bytes()
    origami.sweep(bird, PERCENTS, output=path, **GRID)
    assert path.read_bytes() == whole and sorted(os.listdir(tmp_path)) == ["rows.csv", "rows.csv.json"]


def test_a_sweep_goes_on_only_with_what_it_was_made_of(bird, tmp_path):
    path = tmp_path / "rows.csv"
    origami.sweep(bird, [10, 20], output=path)
    for other in (dict(percent=[10, 30]), dict(solver=origami.Relax(tolerance=1e-3)), dict(patterns=origami.Pattern.generate("miura"))):
        with pytest.raises(origami.Refused, match="resume"):
            origami.sweep(**{"patterns": bird, "percent": [10, 20], **other}, output=path, resume=True)


def test_ctrl_c_ends_a_sweep(bird):
    slow = origami.Dynamics(steps=2**40, max_steps=2**40)
    threading.Timer(0.5, _thread.interrupt_main).start()
    begun = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        origami.sweep(bird, [10, 20], solver=slow)
    assert time.perf_counter() - begun < 5


def test_what_makes_no_sense_is_refused_before_any_work(bird):
    cases = [
        (dict(percent=[1.0, np.nan]), r"percent\[1\]"),
        (dict(percent=[]), "no sheet"),
        (dict(ea=[0.0]), "material ea"),
        (dict(perturbation=3), r"perturbation\[0\]"),
        (dict(seeds=10**9), "too many"),
    ]
    for given, message in cases:
        with pytest.raises(origami.Refused, match=message):
            origami.sweep(bird, **given)


SCRIPT = """
import sys, origami_sim as origami
bird = origami.Pattern.generate("bird-base")
origami.sweep(bird, [0.5 * i for i in range(200)], seeds=10, output=sys.argv[1], resume=True, batch_seconds=0.05)
"""


def test_a_killed_program_loses_no_finished_row(tmp_path):
    path = tmp_path / "rows.csv"

    def rows():
        return path.read_bytes().count(b"\r\n") - 1 if path.exists() else 0

    program = subprocess.Popen([sys.executable, "-c", SCRIPT, str(path)])
    while rows() < 50:
        assert program.poll() is None
        time.sleep(0.01)
    program.send_signal(signal.SIGKILL)
    program.wait()
    before = {row["index"]: row for row in csv.DictReader(path.open(newline="")) if None not in row.values()}
    assert 50 <= len(before) < 2000
    subprocess.run([sys.executable, "-c", SCRIPT, str(path)], check=True)
    after = list(csv.DictReader(path.open(newline="")))
    assert [int(row["index"]) for row in after] == list(range(2000))
    # A row that was killed in the middle of its last number may look whole.
    assert sum(after[int(index)] != row for index, row in before.items()) <= 1


def test_an_executor_that_breaks_is_told(bird, tmp_path):
    path = tmp_path / "rows.csv"
    with ProcessPoolExecutor(2) as pool:

        def kill(done, _):
            # It is told of more rows while the first that was killed is being noticed.
            if done >= 5:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(next(iter(pool._processes)), signal.SIGKILL)

        with pytest.raises(BrokenExecutor):
            origami.sweep(bird, PERCENTS, seeds=50, output=path, client=pool, batch_seconds=0.01, progress=kill)
    assert path.read_bytes().count(b"\r\n") - 1 >= 5
    table = origami.sweep(bird, PERCENTS, seeds=50, output=path, resume=True)
    np.testing.assert_array_equal(table["index"], np.arange(500))
