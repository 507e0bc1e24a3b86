"""Arrays that nobody should pass: each is a ValueError with one line that names it, or is understood."""
import numpy as np
import pytest

import geolloyd

V = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]])
F = np.array([[0, 1, 2], [0, 2, 3]])


def with_entry(array, index, value):
    changed = array.astype(np.result_type(array, type(value)))
    changed[index] = value
    return changed


@pytest.mark.parametrize("vertices, faces, named", [
    ([], [], "vertices: shape"),
    (np.empty((0, 3)), np.empty((0, 3), int), "no triangles"),
    (V, np.empty((0, 3), int), "no triangles"),
    (np.empty((0, 3)), F, "triangle 0"),
    (V[:, :2], F, "vertices: shape"),
    (V.ravel(), F, "vertices: shape"),
    (V[None], F, "vertices: shape"),
    (V, F.ravel(), "faces: shape"),
    (V, np.c_[F, F[:, 0]], "faces: shape"),
    (V, None, "faces: missing"),
    (None, F, "vertices"),
    (with_entry(V, (2, 1), np.nan), F, "vertex 2"),
    (with_entry(V, (2, 1), -np.inf), F, "vertex 2"),
    (with_entry(V, (2, 1), 1e300), F, "vertex 2"),
    (with_entry(V, (2, 1), 1j), F, "vertices: complex"),
    (V.astype(object), F, "vertices: object"),
    (V.astype(str), F, "vertices: "),
    ([[0, 0, 0], [1, 0]], F, "vertices"),
    (V, with_entry(F, (1, 1), -1), "triangle 1: names vertex -1"),
    (V, with_entry(F, (1, 1), 4), "triangle 1: names vertex 4"),
    (V, with_entry(F, (1, 1), 2**32), "triangle 1"),
    (V, with_entry(F, (1, 1), 2**63 - 1), "triangle 1"),
    (V, with_entry(F, (1, 1), -2**63), "triangle 1"),
    (V, np.where(F == 3, np.uint64(2**64 - 1), F.astype(np.uint64)), "triangle 1"),
    (V, F + 0.5, "faces: float64"),
    (V, with_entry(F, (1, 1), np.nan), "faces: float64"),
    (V, with_entry(F, (1, 1), 1e300), "faces: float64"),
    (V, F.astype(object), "faces: object"),
    (V, F.astype(bool), "faces: bool"),
    (V, F.astype("M8[s]"), "faces: "),
])
@pytest.mark.parametrize("call", [
    lambda v, f: geolloyd.remesh(v, f, 10),
    lambda v, f: geolloyd.relax(v, f, 1),
    lambda v, f: geolloyd.voronoi(v, f, [0]),
    lambda v, f: geolloyd.distances(v, f, [0]),
    lambda v, f: geolloyd.seeds(v, f, 1),
    lambda v, f: geolloyd.ground_truth(v, f, [0]),
    lambda v, f: geolloyd.closest_points(v, f, [[0, 0, 0]]),
    lambda v, f: geolloyd.quality(V, F, original=(v, f)),
], ids="remesh relax voronoi distances seeds ground_truth closest_points quality".split())
def test_a_mesh_that_is_none(call, vertices, faces, named):
    with pytest.raises(ValueError) as refused:
        call(vertices, faces)
    assert named in str(refused.value) and "\n" not in str(refused.value)


@pytest.mark.parametrize("call, named", [
    (lambda: geolloyd.remesh(V, F), "how fine"),
    (lambda: geolloyd.remesh(V, F, 10, tolerance=1), "how fine"),
    (lambda: geolloyd.remesh(V, F, 3), "count"),
    (lambda: geolloyd.remesh(V, F, -1), "count"),
    (lambda: geolloyd.remesh(V, F, 2**40), "count"),
    (lambda: geolloyd.remesh(V, F, 1e1), "count"),
    (lambda: geolloyd.remesh(V, F, True), "count"),
    (lambda: geolloyd.remesh(V, F, edge_length=0), "edge_length"),
    (lambda: geolloyd.remesh(V, F, edge_length="long"), "edge_length"),
    (lambda: geolloyd.remesh(V, F, edge_length=[1, 1]), "edge_lengths"),
    (lambda: geolloyd.remesh(V, F, edge_length=[1, 1, 0, 1]), "vertex 2"),
    (lambda: geolloyd.remesh(V, F, tolerance=np.nan), "tolerance"),
    (lambda: geolloyd.remesh(V, F, 10, density=[1, np.nan, 1, 1]), "densities"),
    (lambda: geolloyd.remesh(V, F, 10, density=[[1, 1, 1, 1]]), "density: shape"),
    (lambda: geolloyd.remesh(V, F, 10, adapt=3), "adapt"),
    (lambda: geolloyd.remesh(V, F, 10, adapt=np.nan), "adapt"),
    (lambda: geolloyd.remesh(V, F, 10, adapt=1, equal_error=True), "equal_error"),
    (lambda: geolloyd.remesh(V, F, 10, growth=1), "growth"),
    (lambda: geolloyd.remesh(V, F, 10, field="wind"), "field"),
    (lambda: geolloyd.remesh(V, F, 10, field=np.ones((3, 8))), "field"),
    (lambda: geolloyd.remesh(V, F, 10, field=np.full((4, 8), np.nan)), "field"),
    (lambda: geolloyd.remesh(V, F, 10, features="some"), "features"),
    (lambda: geolloyd.remesh(V, F, 10, features=200), "crease_angle"),
    (lambda: geolloyd.remesh(V, F, 10, features=np.nan), "crease_angle"),
    (lambda: geolloyd.remesh(V, F, 10, feature_edges=[[1, 3]]), "feature edge 1 3"),
    (lambda: geolloyd.remesh(V, F, 10, feature_edges=[[1, -3]]), "feature_edges[0]"),
    (lambda: geolloyd.remesh(V, F, 10, labels=[1]), "groups"),
    (lambda: geolloyd.remesh(V, F, 10, fixed=[4]), "4"),
    (lambda: geolloyd.remesh(V, F, 10, fixed=[-1]), "fixed[0]"),
    (lambda: geolloyd.remesh(V, F, 10, fixed=[2**40]), "fixed[0]"),
    (lambda: geolloyd.remesh(V, F, 10, threads=-1), "threads"),
    (lambda: geolloyd.remesh(V, F, 10, threads=10**6), "threads"),
    (lambda: geolloyd.remesh(V, F, 10, progress=3), "progress"),
    (lambda: geolloyd.relax(V, F), "seeds"),
    (lambda: geolloyd.relax(V, F, 0), "seeds"),
    (lambda: geolloyd.relax(V, F, 5), "seeds"),
    (lambda: geolloyd.relax(V, F, []), "seeds"),
    (lambda: geolloyd.relax(V, F, [1, 1]), "first_seeds[1]"),
    (lambda: geolloyd.relax(V, F, [-1]), "seeds[0]"),
    (lambda: geolloyd.relax(V, F, [2**33]), "seeds[0]"),
    (lambda: geolloyd.relax(V, F, [[1]]), "seeds: shape"),
    (lambda: geolloyd.relax(V, F, "two"), "seeds"),
    (lambda: geolloyd.relax(V, F, 1, graph="tree"), "graph: 'tree': give one of vertex,"),
    (lambda: geolloyd.relax(V, F, 1, norm=2), "norm"),
    (lambda: geolloyd.relax(V, F, 1, norm="linf", averaging="metric"), ""),
    (lambda: geolloyd.relax(V, F, 1, max_macrosteps=-1), "max_macrosteps"),
    (lambda: geolloyd.relax(V, F, 1, random_seed=-1), "random_seed"),
    (lambda: geolloyd.distances(V, F), "sources"),
    (lambda: geolloyd.distances(V, F, []), "seeds"),
    (lambda: geolloyd.closest_points(V, F, [[0, np.nan, 0]]), "vertex 0"),
    (lambda: geolloyd.closest_points(V, F, [[0, 0]]), "points: shape"),
    (lambda: geolloyd.quality(V, F, original=(V, F), samples=0), "samples"),
    (lambda: geolloyd.generate("pyramid", 10), "shape: 'pyramid'"),
    (lambda: geolloyd.generate("cube", 0), "triangles"),
    (lambda: geolloyd.generate("cube", 10**12), ""),
])
def test_a_call_that_makes_no_sense(call, named):
    with pytest.raises(ValueError) as refused:
        call()
    assert named in str(refused.value) and "\n" not in str(refused.value)


def test_files_that_are_not_there_or_unknown(tmp_path):
    with pytest.raises(OSError, match="missing.ply"):
        geolloyd.read(tmp_path / "missing.ply")
    with pytest.raises(ValueError, match="mesh.docx"):
        geolloyd.write(tmp_path / "mesh.docx", V, F)
    with pytest.raises(OSError):
        geolloyd.write(tmp_path / "no" / "folder.ply", V, F)
    (tmp_path / "bad.ply").write_text("ply\nnonsense")
    with pytest.raises(ValueError, match="bad.ply"):
        geolloyd.read(tmp_path / "bad.ply")
    for values in ({"a b": [1, 2, 3, 4]}, {"heat": [1, 2, 3]}, {"heat": np.array(list("abcd"))},
                   {"heat": np.full(4, 2**40)}, {"heat": np.ones((4, 2))}):
        with pytest.raises(ValueError):
            geolloyd.write(tmp_path / "mesh.ply", V, F, **values)
    assert not (tmp_path / "mesh.ply").exists()


ORDERS = {
    "fortran": np.asfortranarray,
    "reversed": lambda a: a[::-1].copy()[::-1],
    "every second": lambda a: np.repeat(a, 2, axis=0)[::2],
    "columns of a wider one": lambda a: np.c_[a, a][:, :3],
    "other byte order": lambda a: a.astype(a.dtype.newbyteorder()),
    "list": lambda a: a.tolist(),
    "tuple": lambda a: tuple(map(tuple, a)),
    "masked": np.ma.masked_array,
}


@pytest.mark.parametrize("order", ORDERS.values(), ids=ORDERS)
def test_any_order(torus, order):
    expected = geolloyd.relax(torus, 10).fingerprint
    assert geolloyd.relax(order(torus.vertices), order(torus.faces), 10).fingerprint == expected


def test_unaligned(torus):
    raw = np.empty(torus.vertices.nbytes + 1, np.uint8)[1:]
    vertices = raw.view(np.float64).reshape(-1, 3)
    vertices[:] = torus.vertices
    assert geolloyd.relax(vertices, torus.faces, 10).fingerprint == geolloyd.relax(torus, 10).fingerprint


@pytest.mark.parametrize("kind", ["i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f2", "f4", "f8", "g"])
def test_any_type(kind):
    expected = geolloyd.relax(V, F, [0]).fingerprint
    assert geolloyd.relax(V.astype(kind), F.astype(kind), np.zeros(1, kind)).fingerprint == expected


def test_inputs_are_never_changed(torus):
    vertices, faces = torus.vertices.copy(), torus.faces.astype(np.int64)
    for array in (vertices, faces):
        array.flags.writeable = False
    geolloyd.remesh(vertices, faces, 100)
    geolloyd.relax(vertices, faces, 10).dual()
    assert (vertices == torus.vertices).all() and (faces == torus.faces).all()
