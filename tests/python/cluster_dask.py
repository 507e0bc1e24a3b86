"""`cluster_dask.py MESHES OUTPUT`: remeshes on a local cluster of two workers, one of which is killed meanwhile."""
import json
import os
import pathlib
import signal
import sys

from distributed import Client, LocalCluster

import geolloyd


def main():
    meshes, output = sys.argv[1:]
    with LocalCluster(2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster, Client(cluster) as client:
        pids = list(client.run(os.getpid).values())
        killed = []

        def kill(progress):
            if progress.done == 3:
                os.kill(pids[0], signal.SIGKILL)
                killed.append(pids[0])

        rows = geolloyd.remesh_many(meshes, output, executor=client.get_executor(), count=60, progress=kill)
    assert all(row["error"] is None for row in rows), rows
    print(json.dumps({"killed": bool(killed), "fingerprints": {
        pathlib.Path(row["input"]).name: row["fingerprint"] for row in rows}}))


if __name__ == "__main__":
    main()
