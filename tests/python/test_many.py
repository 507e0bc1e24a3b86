"""remesh_many(): rows, manifests, executors, workers that die. With GEOLLOYD_LONG_TESTS on 200 meshes."""
import json
import multiprocessing
import os
import pathlib
import shutil
import subprocess
import sys
from concurrent.futures import BrokenExecutor, ProcessPoolExecutor, ThreadPoolExecutor

import pytest

import geolloyd
from geolloyd import many

COUNT = 200 if os.environ.get("GEOLLOYD_LONG_TESTS") else 12
SHAPES = ("creature", "plane", "icosphere", "cube", "torus", "cylinder")
HERE = pathlib.Path(__file__).parent


def spawned(workers=2):
    return ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"))


@pytest.fixture(scope="session")
def meshes(tmp_path_factory):
    folder = tmp_path_factory.mktemp("meshes")
    for i in range(COUNT):
        mesh = geolloyd.generate(SHAPES[i % 6], 300 + 40 * i, random_seed=i + 1)
        geolloyd.write(folder / f"mesh{i:03}.ply", mesh)
    return folder


@pytest.fixture(scope="session")
def expected(meshes, tmp_path_factory):
    rows = geolloyd.remesh_many(meshes, tmp_path_factory.mktemp("expected"), count=60)
    return fingerprints(rows)


def fingerprints(rows):
    assert [row["error"] for row in rows] == [None] * len(rows)
    return {pathlib.Path(row["input"]).name: row["fingerprint"] for row in rows}


def test_rows_and_files(meshes, expected, tmp_path):
    told = []
    rows = geolloyd.remesh_many(meshes, tmp_path / "out", count=60, progress=told.append)
    assert fingerprints(rows) == expected and len(rows) == COUNT
    assert [t.done for t in told] == list(range(1, COUNT + 1))
    sizes = [t.row["bytes"] for t in told]
    assert max(sizes) in sizes[:len(os.sched_getaffinity(0)) + 1]  # large ones first
    row = rows[3]
    mesh = geolloyd.read(row["input"])
    assert row["fingerprint"] == geolloyd.remesh(mesh, 60).fingerprint
    assert len(geolloyd.read(row["output"]).vertices) == row["vertices"] == 60
    lines = [json.loads(line) for line in (tmp_path / "out/manifest.jsonl").read_text().splitlines()]
    assert sorted(line["input"] for line in lines) == sorted(r["input"] for r in rows)


def test_same_as_the_program(program, meshes, expected):
    program.run("remesh-all", meshes, "-n", 60, "-o", "all")
    rows = program.report("all/remesh-all.json")["rows"]
    assert {pathlib.Path(row["input"]).name: row["fingerprint"] for row in rows} == expected


def test_a_further_call_does_what_is_missing(meshes, expected, tmp_path):
    inputs = tmp_path / "in"
    shutil.copytree(meshes, inputs)
    out = tmp_path / "out"

    def worked_on(**options):
        told = []
        geolloyd.remesh_many(inputs, out, progress=told.append, **options)
        return [pathlib.Path(t.row["input"]).name for t in told if t.row["seconds"] is not None]

    assert len(worked_on(count=60)) == COUNT
    assert worked_on(count=60) == []
    (out / "mesh004.ply").unlink()
    shutil.copy(inputs / "mesh001.ply", inputs / "mesh002.ply")
    os.utime(inputs / "mesh003.ply")  # another time, the same content: looked at, not remeshed
    before = (out / "mesh003.ply").stat().st_mtime_ns
    assert sorted(worked_on(count=60)) == ["mesh002.ply", "mesh003.ply", "mesh004.ply"]
    assert (out / "mesh003.ply").stat().st_mtime_ns == before
    with (out / "manifest.jsonl").open("a") as file:
        file.write('{"input": "cut o')  # by a kill
    assert worked_on(count=60) == []
    assert len(worked_on(count=61)) == COUNT


def test_one_bad_mesh_stops_nothing(meshes, tmp_path):
    inputs = [*sorted(meshes.iterdir())[:3], tmp_path / "missing.ply", tmp_path / "bad.ply"]
    inputs[-1].write_text("ply\nnonsense")
    rows = geolloyd.remesh_many(inputs, tmp_path / "out", count=60)
    assert [row["error"] is None for row in rows] == [True] * 3 + [False] * 2
    assert all(str(path) in row["error"] and "\n" not in row["error"] for path, row in zip(inputs[3:], rows[3:]))
    inputs[-1].write_bytes(inputs[0].read_bytes())
    rows = geolloyd.remesh_many(inputs, tmp_path / "out", count=60)  # tried again
    assert rows[4]["fingerprint"] == rows[0]["fingerprint"] and rows[3]["error"]


@pytest.mark.parametrize("words, named", [
    ({}, "how fine"), ({"count": 3}, "count"), ({"count": 60, "fixed": [1]}, "fixed"), ({"count": 60, "format": "docx"}, "docx"),
    ({"tolerance": -1}, "tolerance"), ({"count": 60, "threads": -1}, "threads"), ({"count": 60, "growth": 0.5}, "growth"),
])
def test_what_fails_for_every_mesh_is_refused_at_once(meshes, tmp_path, words, named):
    with pytest.raises(ValueError, match=named):
        geolloyd.remesh_many(meshes, tmp_path / "out", **words)
    assert not (tmp_path / "out").exists()


def test_folders(meshes, tmp_path):
    (tmp_path / "in").mkdir()
    with pytest.raises(ValueError, match="no meshes"):
        geolloyd.remesh_many(tmp_path / "in", tmp_path / "out", count=60)
    shutil.copy(meshes / "mesh001.ply", tmp_path / "in/one.PLY")
    (tmp_path / "in/notes.txt").write_text("of no mesh")
    (row,) = geolloyd.remesh_many(tmp_path / "in", tmp_path / "out", count=60)
    assert row["error"] is None and row["output"].endswith("one.ply")


def test_outputs_never_replace(meshes, tmp_path):
    with pytest.raises(ValueError, match="is an input"):
        geolloyd.remesh_many(meshes, meshes, count=60)
    with pytest.raises(ValueError, match="rename"):
        geolloyd.remesh_many([tmp_path / "a.ply", tmp_path / "a.obj"], tmp_path / "out", count=60)


@pytest.mark.parametrize("executor", [lambda: ThreadPoolExecutor(3), spawned], ids=["threads", "processes"])
def test_executors(executor, meshes, expected, tmp_path):
    with executor() as pool:
        assert fingerprints(geolloyd.remesh_many(meshes, tmp_path, count=60, executor=pool)) == expected


def test_processes_forked_from_one_that_has_threads(meshes, expected, tmp_path, torus):
    geolloyd.remesh(torus, 100, threads=4)
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("fork")) as pool:
        assert fingerprints(geolloyd.remesh_many(meshes, tmp_path, count=60, executor=pool)) == expected


def forked():
    return ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("fork"))


@pytest.fixture
def deadly(meshes, monkeypatch):
    """Workers that are forked from here die of one mesh."""
    deadly = "mesh005.ply"
    read = many.read
    monkeypatch.setattr(many, "read", lambda path: os._exit(9) if path.endswith(deadly) else read(path))
    return deadly


def test_a_worker_that_dies_costs_its_mesh_only(meshes, expected, tmp_path, deadly):
    rows = geolloyd.remesh_many(meshes, tmp_path, count=60, executor=forked)
    lost = {pathlib.Path(row["input"]).name: row["error"] for row in rows if row["error"]}
    assert list(lost) == [deadly] and "worker died" in lost[deadly]
    assert {**expected, deadly: None} == {pathlib.Path(row["input"]).name: row["fingerprint"] for row in rows}


def test_a_broken_executor_that_nobody_can_make_again(meshes, tmp_path, deadly):
    with forked() as pool, pytest.raises(BrokenExecutor, match="call again"):
        geolloyd.remesh_many(meshes, tmp_path, count=60, executor=pool)
    with ThreadPoolExecutor(1) as pool:  # what was done is not lost
        rows = geolloyd.remesh_many(sorted(meshes.iterdir())[:3], tmp_path, count=60, executor=pool)
    assert all(row["error"] is None for row in rows)


def test_ctrl_c_leaves_whole_files(meshes, tmp_path):
    code = f"""
import geolloyd, os, signal
def stop(progress):
    if progress.done == 2: os.kill(os.getpid(), signal.SIGINT)
try:
    geolloyd.remesh_many({str(meshes)!r}, {str(tmp_path)!r}, count=60, progress=stop)
except KeyboardInterrupt:
    print("interrupted")
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
    assert done.stdout == "interrupted\n", done.stderr
    lines = [json.loads(line) for line in (tmp_path / "manifest.jsonl").read_text().splitlines()]
    assert 2 <= len(lines) < COUNT
    assert all(len(geolloyd.read(line["output"]).vertices) == line["vertices"] for line in lines)


def run_script(command, *arguments):
    environment = {**os.environ, "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
                   "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_btl_vader_single_copy_mechanism": "none"}
    done = subprocess.run([*command, *map(str, arguments)], capture_output=True, text=True, timeout=500, env=environment)
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout.splitlines()[-1])


def test_dask_of_which_a_worker_is_killed(meshes, expected, tmp_path):
    pytest.importorskip("distributed", reason="tools/install-dependencies --python installs python3-distributed")
    found = run_script([sys.executable, HERE / "cluster_dask.py"], meshes, tmp_path)
    assert found["fingerprints"] == expected and found["killed"]


def test_mpi(meshes, expected, tmp_path):
    pytest.importorskip("mpi4py", reason="tools/install-dependencies --python installs python3-mpi4py")
    if not shutil.which("mpirun"):
        pytest.skip("there is no mpirun: tools/install-dependencies --python")
    command = ["mpirun", "-n", "3", sys.executable, "-m", "mpi4py.futures", HERE / "cluster_mpi.py"]
    found = run_script(command, meshes, tmp_path)
    assert found["fingerprints"] == expected
