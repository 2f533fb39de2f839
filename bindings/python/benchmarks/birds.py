"""What Dask costs: the same sheets by `origami sweep` on two threads, and by Dask on one worker and on two.

`python birds.py PROGRAM [SHEETS]`, where PROGRAM is the command `origami` of a release build.
"""

import subprocess
import sys
import tempfile
import time
from pathlib import Path

from distributed import Client, LocalCluster

import origami_sim as origami

ROUNDS = 5


def seconds(call):
    begun = time.perf_counter()
    call()
    return time.perf_counter() - begun


def main(program, sheets=10_000):
    bird = origami.Pattern.generate("bird-base")
    percents, seeds = [float(percent) for percent in range(1, 101)], sheets // 100
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        pattern = folder / "bird.fold"
        subprocess.run([program, "pattern", "bird-base", "-o", pattern], check=True)
        lists = ["--percent", ",".join(f"{percent:.0f}" for percent in percents), "--seeds", str(seeds)]
        command = [program, "sweep", pattern, *lists, "--threads", "2", "--backend", "cpu", "-q", "-o", folder / "theirs"]
        times = {"origami sweep, two threads": [], "Dask, one worker": [], "Dask, two workers": []}
        for round in range(ROUNDS):
            times["origami sweep, two threads"].append(seconds(lambda: subprocess.run(command, check=True)))
            for workers, name in [(1, "Dask, one worker"), (2, "Dask, two workers")]:
                with (
                    LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster,
                    Client(cluster) as client,
                ):
                    # A worker imports the package once.
                    client.run(__import__, "origami_sim")
                    output = folder / f"{workers}.csv"
                    run = lambda: origami.sweep(bird, percents, seeds=seeds, client=client, output=output)
                    times[name].append(seconds(run))
                assert output.read_bytes() == (folder / "theirs" / "sweep.csv").read_bytes(), "not the same rows"
    for name, all in times.items():
        print(f"{name}: {min(all):.2f} s ({', '.join(f'{time:.2f}' for time in all)})")
    theirs, one, two = (min(all) for all in times.values())
    print(f"two workers are {one / two:.2f} times one, and take {two / theirs:.2f} of `origami sweep`")


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:]))
