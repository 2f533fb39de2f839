"""A sweep on a cluster of Dask; here one of two processes of this machine. Rows are in `rows.csv` as they come: what is
killed goes on where it was when it is started again."""

from distributed import Client, LocalCluster

import origami_sim as origami

if __name__ == "__main__":
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        table = origami.sweep(
            origami.Pattern.generate("bird-base"),
            percent=range(0, 101, 5),
            k_fold=[0.1, 0.7, 7.0],
            output="rows.csv",
            resume=True,
            client=client,
            progress=lambda done, count: print(f"{done} of {count}", end="\r"),
        )
    stiffest = table["k_fold"] == 7.0
    print(f"strain at most {table['strain_max'].max():.2%}, of the stiffest {table['strain_max'][stiffest].max():.2%}")
