"""What can go wrong. Every exception names the place, as text and as attributes.

Files that cannot be read raise Python's own `OSError`, such as `FileNotFoundError`.
"""


class OrigamiError(Exception):
    """What all have in common.

    Every attribute is there in every exception, and None where it does not apply:

    code: which kind of error it is, such as `wrong-length`; the same from one release to the next.
    place: where it is, as a person reads it, such as `edges_vertices[17]`.
    frame, key, index: the same for a key of a FOLD file: the frame (0 is the key frame), the key, the entry.
    line, column: the same in a text, counted from 1.
    source: where an edge was written in a file of another format than FOLD, such as `line 12`.
    vertices, creases, triangles, setting: the same for parts of a sheet, and for an argument.
    problem, expected: what is there, and what would have been accepted.
    percent: how far a sheet was to be folded.
    vertex, step, quantity, value, last_good: see `Diverged`.
    """

    _NAMES = (
        "code",
        "place",
        "frame",
        "key",
        "index",
        "line",
        "column",
        "source",
        "vertices",
        "creases",
        "triangles",
        "setting",
        "problem",
        "expected",
        "percent",
        "vertex",
        "step",
        "quantity",
        "value",
        "last_good",
    )

    def __init__(self, message, **details):
        super().__init__(message)
        for name in self._NAMES:
            setattr(self, name, details.get(name))

    def __reduce__(self):
        details = {name: value for name in self._NAMES if (value := getattr(self, name)) is not None}
        return _again, (type(self), str(self), details)


class PatternError(OrigamiError, ValueError):
    """A file or an array that is no crease pattern."""


class Refused(OrigamiError, ValueError):
    """A setting or an argument that cannot be: nothing was done."""


class Diverged(OrigamiError, ArithmeticError):
    """The sheet left all bounds.

    vertex, step: the first vertex that did, and when.
    quantity, value: `position` (distance from the centre) or `move` (way in one step), and its size in radii.
    last_good: positions of the last state that was in bounds by far, of shape (vertices, 3), in the pattern's unit.
    """


class BackendError(OrigamiError, RuntimeError):
    """What computes gave up: a GPU was lost, or memory does not hold what is asked for."""


def _again(kind, message, details):
    return kind(message, **details)
