"""One pattern, or several, folded in many ways: on the threads of this machine, or on the workers of an engine."""

import hashlib
import json
import os
import pickle
import time
import uuid
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, ThreadPoolExecutor, wait

from . import _native, _work
from ._batches import Batches
from ._rows import Rows
from .errors import OrigamiError
from .settings import Material, Relax


def sweep(
    patterns,
    percent=100.0,
    *,
    solver=None,
    ea=Material.ea,
    k_fold=Material.k_fold,
    k_facet=Material.k_facet,
    k_face=Material.k_face,
    zeta=Material.zeta,
    perturbation=None,
    seeds=1,
    output=None,
    resume=False,
    client=None,
    workers=None,
    batch_seconds=1.0,
    retries=3,
    progress=None,
):
    """Folds every combination of what is given as a list, and measures it: a dict of columns, each a NumPy array.

    The columns and their order are those of `origami sweep` (docs/REPORT.md), and so is every bit; `pandas.DataFrame` and
    `polars.DataFrame` take the dict as it is.

    patterns: a `Pattern`, or a list of them; then a last column `pattern` has the place in the list.
    percent: how far to fold, as a percentage of the pattern's fold angles; a number or a list. Varies fastest.
    solver: a `Relax`, `Dynamics` or `Newton`. Default: `Relax()`. Each sheet is folded by one thread.
    ea, k_fold, k_facet, k_face, zeta: the material (see `Material`); numbers or lists.
    perturbation: how far each vertex is moved at the start, as a share of its shortest beam; a number or a list.
        Default: that of `Relax`, and none for `Dynamics`.
    seeds: in how many directions each perturbation is taken. Default 1.
    output: a CSV file that grows row by row, in the order in which rows come; when all are there it is sorted, and the
        same bytes as `origami sweep` writes. Default: no file.
    resume: whether to go on with the rows that `output` has; all that they depend on must be the same. Default: no.
    client: who folds: a `distributed.Client`, or any `concurrent.futures.Executor` whose workers can import this package.
        Default: threads of this process.
    workers: how many sheets are folded at once. Default: as many as the client has threads, or this machine processors.
    batch_seconds: about how long one batch of sheets takes. Longer: fewer messages; shorter: less is lost with a worker
        that dies, and nobody waits for the last. Default 1.
    retries: how often a batch that failed is tried again. Default 3.
    progress: called with (rows that are there, rows that will be) whenever some have come.

    Raises `Refused` before any work. What ends it early (Ctrl-C, an executor that broke) leaves all rows that have come
    in `output`.
    """
    several = not isinstance(patterns, _native.Pattern)
    solver = Relax() if solver is None else solver
    perturbation = None if perturbation is None else _list(perturbation)
    asked = (_list(percent), perturbation, seeds, *(_list(numbers) for numbers in (ea, k_fold, k_facet, k_face, zeta)))
    patterns = list(patterns) if several else [patterns]
    plans = [_native.Plan(pattern, solver, asked, place if several else None) for place, pattern in enumerate(patterns)]
    count = sum(len(plan) for plan in plans)
    key = None if output is None else _key(patterns, solver, asked)
    with Rows(output, _native.header(several), count, key, resume) as rows:
        batches = Batches([len(plan) for plan in plans], rows.missing(), batch_seconds)
        with _Threads(workers, plans) if client is None else _Others(client, workers, plans) as crew:
            _run(crew, batches, rows, retries, progress)
        return _native.columns(rows.finish(), several)


def _run(crew, batches, rows, retries, progress):
    """Hands out batches until all rows are there."""
    flying = {}
    while batches or flying:
        while batches and len(flying) < 2 * crew.size():
            part = batches.take(crew.size())
            flying[crew.submit(part)] = part
        # Not for ever: Python looks for Ctrl-C in between, on every system.
        for future in wait(flying, timeout=0.2, return_when=FIRST_COMPLETED).done:
            part = flying.pop(future)
            try:
                answer = future.result()
            except (OrigamiError, BrokenExecutor):
                # They would fail again, or cannot be tried again.
                raise
            except Exception as error:
                part.tries += 1
                if part.tries > retries:
                    error.add_note(f"sheets {part.first} to {part.first + part.count - 1} failed {part.tries} times")
                    raise
                batches.put_back(part)
                continue
            if answer is None:
                flying[crew.submit(part, with_plan=True)] = part
                continue
            text, seconds = answer
            batches.measured(part.count, seconds)
            rows.add(text.splitlines(keepends=True))
            if progress is not None:
                progress(len(rows), rows.count)


class _Threads:
    """Threads of this process: the plans are here, and a batch can be stopped while it runs."""

    def __init__(self, workers, plans):
        self._workers = workers or os.cpu_count() or 1
        self._plans = plans
        self._stop = _native.Stop()
        self._executor = ThreadPoolExecutor(self._workers)

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        if kind is not None:
            self._stop.set()
        self._executor.shutdown(cancel_futures=True)

    def size(self):
        """How many batches are folded at once."""
        return self._workers

    def submit(self, part):
        """A future of the rows of a part."""
        return self._executor.submit(_work.fold, self._plans[part.plan], part.first, part.count, self._stop)


class _Others:
    """Workers of another engine. Dask's client has an executor too, which sends lost batches to other workers."""

    def __init__(self, client, workers, plans):
        self._dask = client if hasattr(client, "get_executor") else None
        self._executor = client.get_executor(pure=False) if self._dask else client
        self._workers = workers
        self._plans = plans
        self._pickled = {}
        self._token = uuid.uuid4().hex
        self._futures = set()
        self._asked = None

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        for future in list(self._futures):
            future.cancel()

    def size(self):
        """How many batches are folded at once: workers may come and go."""
        if self._workers is not None:
            return self._workers
        if self._dask is None:
            return getattr(self._executor, "_max_workers", None) or os.cpu_count() or 1
        now = time.monotonic()
        if self._asked is None or now - self._asked[0] > 1.0:
            self._asked = now, max(1, sum(self._dask.nthreads().values()))
        return self._asked[1]

    def submit(self, part, with_plan=False):
        """A future of the rows of a part; of None where the worker does not have the plan yet."""
        plan = self._plan(part.plan) if with_plan else None
        future = self._executor.submit(_work.fold_sent, (self._token, part.plan), plan, part.first, part.count)
        self._futures.add(future)
        future.add_done_callback(self._futures.discard)
        return future

    def _plan(self, place):
        if place not in self._pickled:
            # Of several patterns one comes after the other.
            self._pickled = {place: pickle.dumps(self._plans[place])}
        return self._pickled[place]


def _list(numbers):
    """A number or anything that NumPy makes a list of numbers of, as floats."""
    if isinstance(numbers, (int, float)):
        return [float(numbers)]
    return [float(number) for number in numbers]


def _key(patterns, solver, asked):
    """What rows depend on, as a word that no other sweep has."""
    digest = hashlib.sha256(repr((_native.__version__, solver, asked)).encode())
    for pattern in patterns:
        digest.update(json.dumps(pattern.to_fold()).encode())
    return digest.hexdigest()
