"""FOLD dicts as text."""

import json


def dumps(fold):
    """A FOLD dict as JSON; NumPy arrays and numbers in it are taken for what they hold."""
    return json.dumps(fold, default=_plain)


def _plain(value):
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} in a FOLD dict; expected what JSON has, or arrays")
