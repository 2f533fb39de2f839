"""What a worker does: it keeps the plans that it was sent, and folds batches of them."""

import pickle
import time

_MOST = 8
_plans = {}


def keep(key, plan):
    """Keeps a plan for batches to come, in place of the oldest where there are many."""
    while len(_plans) >= _MOST:
        _plans.pop(next(iter(_plans)), None)
    _plans[key] = plan


def forget(key):
    """Keeps it no longer."""
    _plans.pop(key, None)


def fold_batch(key, plan, first, count, stop=None):
    """The rows of some sheets and how many seconds they took; None where this worker does not have the plan yet.

    plan: the plan, pickled, or None where the worker is thought to have it.
    """
    known = _plans.get(key)
    if known is None:
        if plan is None:
            return None
        known = pickle.loads(plan)
        keep(key, known)
    begun = time.perf_counter()
    lines = known.rows(first, count, stop)
    return lines, time.perf_counter() - begun
