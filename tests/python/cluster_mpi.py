"""`mpirun -n 3 python3 -m mpi4py.futures cluster_mpi.py MESHES OUTPUT`: remeshes on the ranks of MPI."""
import json
import pathlib
import sys

from mpi4py.futures import MPIPoolExecutor

import geolloyd

if __name__ == "__main__":
    meshes, output = sys.argv[1:]
    with MPIPoolExecutor() as executor:
        rows = geolloyd.remesh_many(meshes, output, executor=executor, count=60)
    assert all(row["error"] is None for row in rows), rows
    print(json.dumps({"fingerprints": {pathlib.Path(row["input"]).name: row["fingerprint"] for row in rows}}))
