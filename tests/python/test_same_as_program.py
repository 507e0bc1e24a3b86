"""Results are those of the program: same fingerprints, same meshes."""
import numpy as np
import pytest

import geolloyd


def test_version(program):
    assert program.run("--version").split()[1] == geolloyd.__version__


@pytest.fixture
def scan(program, creature):
    program.run("generate", "creature", "-t", 6000, "-o", "scan.ply")
    found = geolloyd.read(program.folder / "scan.ply")
    assert (found.vertices == creature.vertices).all() and (found.faces == creature.faces).all()
    return found


@pytest.mark.parametrize("options, words", [
    (["-n", 300], {"count": 300}),
    (["--edge-length", 0.1], {"edge_length": 0.1}),
    (["-n", 200, "--vfield", "curvature"], {"count": 200, "field": "curvature"}),
    (["-n", 200, "--adapt", 1, "--growth", 1.3], {"count": 200, "adapt": 1, "growth": 1.3}),
    (["-n", 200, "--equal-error"], {"count": 200, "equal_error": True}),
    (["-n", 200, "--features", 30, "--no-fit"], {"count": 200, "features": 30, "fit": False}),
    (["--tolerance", 0.25], {"tolerance": 0.25}),
])
def test_remesh(program, scan, options, words):
    program.run("remesh", "scan.ply", *options, "-o", "r.ply", "--report", "r.json", "--map", "map.csv")
    report = program.report("r.json")
    found = geolloyd.remesh(scan, **words)
    assert found.fingerprint == report["fingerprint"]
    expected = geolloyd.read(program.folder / "r.ply")
    assert (found.vertices == expected.vertices).all() and (found.faces == expected.faces).all()
    assert found.report["trials"] == report["trials"]
    places = np.loadtxt(program.folder / "map.csv", delimiter=",", skiprows=1)
    assert (found.triangle == places[:, 1]).all()
    assert np.allclose(found.barycentric, places[:, 2:], atol=1e-12)


def test_remesh_with_files(program, scan):
    lengths = 0.1 + 0.05 * scan.vertices[:, 2] ** 2
    fixed = [5, 100, 1000]
    np.savetxt(program.folder / "lengths.txt", lengths, fmt="%.17g")
    np.savetxt(program.folder / "fixed.txt", fixed, fmt="%d")
    program.run("remesh", "scan.ply", "--sizing", "lengths.txt", "--fixed", "fixed.txt", "-o", "r.ply", "--report", "r.json")
    found = geolloyd.remesh(scan, edge_length=lengths, fixed=fixed)
    assert found.fingerprint == program.report("r.json")["fingerprint"]
    assert {tuple(p) for p in scan.vertices[fixed]} <= {tuple(p) for p in found.vertices}


@pytest.mark.parametrize("options, words", [
    ([], {}),
    (["--graph", "mixed", "--init", "random", "--random-seed", 7], {"graph": "mixed", "init": "random", "random_seed": 7}),
    (["--vfield", "curvature", "--graph", "vertex-far"], {"field": "curvature", "graph": "vertex-far"}),
    (["--vfield", "cross", "--norm", "manhattan"], {"field": "cross", "norm": "manhattan"}),
    (["--greedy", "extended", "--init", "farthest", "--max-greedy-steps", 2],
     {"greedy": "extended", "init": "farthest", "max_greedy_steps": 2}),
])
def test_relax(program, scan, options, words):
    program.run("relax", "scan.ply", "--seeds", 60, *options, "-o", "result")
    report = program.report("result/report.json")
    found = geolloyd.relax(scan, 60, **words)
    assert found.fingerprint == report["fingerprint"]
    assert found.energy == report["energy"]
    assert [step["energy"] for step in found.trace] == [step["energy"] for step in report["trace"]]
    if words.get("graph") == "mixed":
        return
    expected = geolloyd.read(program.folder / "result/dual.ply")
    dual = found.dual()
    assert (dual.vertices == expected.vertices).all() and (dual.faces == expected.faces).all()
    assert (dual.vertices == scan.vertices[dual.seeds]).all()


def test_self_intersections(program, scan):
    vertices, faces = scan
    both = np.concatenate([vertices, vertices + 0.1]), np.concatenate([faces, faces + len(vertices)])
    geolloyd.write(program.folder / "two.ply", *both)
    program.run("quality", "two.ply", "--issues", "i.csv")
    expected = np.loadtxt(program.folder / "i.csv", delimiter=",", skiprows=1, usecols=(1, 2), dtype=int)
    found = geolloyd.self_intersections(*both)
    assert len(found) > 100 and (found == expected).all()
    assert geolloyd.quality(*both)["self_intersections"] == len(found)


def test_quality(program, scan):
    remesh = geolloyd.remesh(scan, 300)
    geolloyd.write(program.folder / "r.ply", remesh)
    program.run("quality", "r.ply", "--original", "scan.ply", "--samples", 20000, "--certify", "-o", "q.json")
    expected = program.report("q.json")
    found = geolloyd.quality(remesh, original=scan, samples=20000, certify=True)
    assert found["quality"] == pytest.approx(expected["quality"])
    assert found["self_intersections"] == expected["self_intersections"] == remesh.report["self_intersections"]
    assert found["likeness"]["two_sided"]["hausdorff"] == pytest.approx(expected["likeness"]["two_sided"]["hausdorff"])
