"""What a million rows cost in pandas and polars: `python rows.py`. The rows are ten thousand birds a hundred times over."""

import tempfile
import time
from pathlib import Path

import pandas
import polars

import origami_sim as origami

TIMES = 100


def timed(what, call):
    begun = time.perf_counter()
    result = call()
    print(f"{what}: {time.perf_counter() - begun:.2f} s")
    return result


def main():
    with tempfile.TemporaryDirectory() as folder:
        once, many, parquet = (Path(folder) / name for name in ("once.csv", "many.csv", "many.parquet"))
        origami.sweep(origami.Pattern.generate("bird-base"), range(1, 101), seeds=100, output=once)
        header, *rows = once.read_text().splitlines()
        with open(many, "w") as file:
            print(header, file=file)
            for index in range(TIMES * len(rows)):
                print(index, rows[index % len(rows)].partition(",")[2], sep=",", file=file)
        print(f"{TIMES * len(rows)} rows, {many.stat().st_size / 1e6:.0f} MB")
        timed("pandas reads them", lambda: pandas.read_csv(many))
        frame = timed("polars reads them", lambda: polars.read_csv(many))
        timed("polars writes Parquet", lambda: frame.write_parquet(parquet))
        print(f"{parquet.stat().st_size / 1e6:.1f} MB")
        timed("and reads it", lambda: polars.read_parquet(parquet))


if __name__ == "__main__":
    main()
