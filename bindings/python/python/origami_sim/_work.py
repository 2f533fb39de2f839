"""What a worker does: it keeps the plans that it was sent, and folds batches of them."""

import pickle
import time

# How many it keeps; those of one sweep come one after the other.
_MOST = 8
_plans = {}


def fold(plan, first, count, stop=None):
    """The rows of some sheets of a plan, as one text, and how many seconds they took."""
    begun = time.perf_counter()
    lines = plan.rows(first, count, stop)
    # One text costs who sends it and who takes it less than many.
    return "".join(lines), time.perf_counter() - begun


def fold_sent(key, pickled, first, count):
    """The same of a plan that this worker knows by a key; None where it does not.

    pickled: the plan, or None where the worker is thought to have it.
    """
    plan = _plans.get(key)
    if plan is None:
        if pickled is None:
            return None
        plan = pickle.loads(pickled)
        while len(_plans) >= _MOST:
            _plans.pop(next(iter(_plans)), None)
        _plans[key] = plan
    return fold(plan, first, count)
