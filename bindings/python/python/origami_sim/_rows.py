"""Rows as they come, and the file that has them."""

import json
import os
from pathlib import Path

from .errors import Refused

_END = "\r\n"


class Rows:
    """The rows of a sweep, by their place; where there is a path, in a file that has each as soon as it has come.

    Beside the file lies another, `.json` added to its name, that says what its rows depend on.
    """

    def __init__(self, path, header, count, key, resume):
        self.count = count
        self._header = header
        self._lines = {}
        self._path = None if path is None else Path(path)
        self._file = None
        if self._path is None:
            return
        self._about = self._path.with_name(self._path.name + ".json")
        if resume and self._path.exists():
            self._take(key)
        _write_whole(self._about, json.dumps({"key": key, "count": count}) + "\n")
        # What was cut off in the middle of a row is not taken; so the file is written anew.
        _write_whole(self._path, header + "".join(self._lines.values()))
        self._file = open(self._path, "a", encoding="ascii", newline="")

    def __len__(self):
        return len(self._lines)

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        if self._file is not None:
            self._file.close()

    def missing(self):
        """Pairs (first, end) of places that have no row yet, in order."""
        first = 0
        for place in sorted(self._lines):
            if first < place:
                yield first, place
            first = place + 1
        if first < self.count:
            yield first, self.count

    def add(self, lines):
        """Takes rows, each once."""
        new = {place: line for line in lines if (place := _place(line)) not in self._lines}
        self._lines.update(new)
        if self._file is not None:
            # In one piece, and handed to the system: a process that is killed loses nothing of it.
            self._file.write("".join(new.values()))
            self._file.flush()

    def finish(self):
        """All rows in their order; the file has them so too."""
        lines = [self._lines[place] for place in range(self.count)]
        if self._path is not None:
            self._file.close()
            _write_whole(self._path, self._header + "".join(lines))
        return lines

    def _take(self, key):
        """Takes the rows that are there."""
        try:
            known = json.loads(self._about.read_text(encoding="ascii")).get("key")
        except (OSError, ValueError):
            known = None
        if known != key:
            raise Refused(
                f"resume: the rows of {self._path} were made of another pattern, with other settings or by another "
                "version; expected the same, or resume=False",
                setting="resume",
            )
        text = self._path.read_bytes().decode("ascii", "replace")
        header, *lines = text.split(_END)
        if header + _END != self._header:
            raise Refused(f"resume: {self._path} has other columns; expected those of a sweep", setting="resume")
        # After the last end of a line there is nothing, or a row that was cut off.
        cells = self._header.count(",")
        for line in lines[:-1]:
            place = _place(line)
            if line.count(",") == cells and place is not None and place < self.count:
                self._lines[place] = line + _END


def _place(line):
    number = line.partition(",")[0]
    return int(number) if number.isdecimal() else None


def _write_whole(path, text):
    """Writes a file such that it is there whole or as it was."""
    unfinished = path.with_name(path.name + ".unfinished")
    with open(unfinished, "w", encoding="ascii", newline="") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
    os.replace(unfinished, path)
