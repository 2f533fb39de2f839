"""What is left of a sweep, handed out in parts that take about equally long."""

from collections import deque
from dataclasses import dataclass


@dataclass(eq=False)
class Part:
    """Some sheets of one plan, one after the other."""

    plan: int
    first: int
    count: int
    tries: int = 0


class Batches:
    """Parts yet to be folded.

    sizes: how many sheets each plan has.
    missing: pairs (first, end) of places in the whole sweep, in order, that are yet to be folded.
    seconds: about how long a part is to take.
    """

    def __init__(self, sizes, missing, seconds):
        self._left = deque(_by_plan(sizes, missing))
        self._count = sum(end - first for _, first, end in self._left)
        self._again = deque()
        self._seconds = seconds
        self._folded = [0, 0.0]

    def __bool__(self):
        return bool(self._left or self._again)

    def take(self, workers):
        """The next part, for one of so many workers; small where little is left, so that nobody waits for the last."""
        if self._again:
            return self._again.popleft()
        plan, first, end = self._left.popleft()
        count = min(end - first, self._size(workers))
        if first + count < end:
            self._left.appendleft((plan, first + count, end))
        self._count -= count
        return Part(plan, first, count)

    def put_back(self, part):
        """To be tried again, before all others."""
        self._again.append(part)

    def measured(self, count, seconds):
        """Takes note of how long so many sheets took."""
        self._folded[0] += count
        self._folded[1] += seconds

    def _size(self, workers):
        count, seconds = self._folded
        if count == 0:
            return 1
        whole = self._seconds * count / max(seconds, 1e-9)
        # Smaller ones at the end, but none so small that sending it takes longer than folding it.
        return max(1, int(min(whole, max(whole / 8, self._count / (2 * workers)))))


def _by_plan(sizes, missing):
    begin = 0
    ends = []
    for plan, size in enumerate(sizes):
        ends.append((plan, begin, begin + size))
        begin += size
    for first, end in missing:
        for plan, begin, until in ends:
            low, high = max(first, begin), min(end, until)
            if low < high:
                yield plan, low - begin, high - begin
