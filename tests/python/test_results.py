"""Results against what is known of them."""
import numpy as np
import pytest

import geolloyd


def test_types_and_shapes(creature):
    found = geolloyd.remesh(creature, 200)
    assert found.vertices.dtype == np.float64 and found.vertices.shape == (200, 3)
    assert found.faces.dtype == np.int32 and found.faces.shape[1] == 3
    assert found.triangle.dtype == np.int32 and found.barycentric.dtype == np.float64
    assert found.report["is_manifold"] and found.report["has_input_topology"]
    tessellation = geolloyd.relax(creature, 50)
    for name, kind in (("region", np.int32), ("parent", np.int32), ("distance", np.float64)):
        array = getattr(tessellation, name)
        assert array.dtype == kind and array.shape == (len(creature.vertices),)
    vertices, faces = found  # as other programs return them
    assert vertices is found.vertices and faces is found.faces


def test_places_carry_values_over(creature):
    found = geolloyd.remesh(creature, 200, fit=False)
    carried = (creature.vertices[creature.faces[found.triangle]] * found.barycentric[:, :, None]).sum(1)
    assert np.allclose(carried, found.vertices, atol=1e-6)


def test_distances_of_a_plane():
    plane = geolloyd.generate("plane", 2000)
    found = geolloyd.distances(plane, [0], graph="vertex-far")
    straight = np.linalg.norm(plane.vertices - plane.vertices[0], axis=1)
    assert found[0] == 0 and (found >= straight * (1 - 1e-6)).all() and (found <= 1.1 * straight + 0.1).all()
    both = geolloyd.distances(plane, [0, 3])
    assert (both == np.minimum(geolloyd.distances(plane, 0), geolloyd.distances(plane, 3))).all()


def test_components_without_a_source_are_infinitely_far(torus):
    vertices = np.vstack([torus.vertices, torus.vertices + 5])
    faces = np.vstack([torus.faces, torus.faces + len(torus.vertices)])
    found = geolloyd.distances(vertices, faces, [0])
    assert np.isfinite(found).sum() == len(torus.vertices)
    with pytest.raises(ValueError, match="component"):
        geolloyd.voronoi(vertices, faces, [0])


def test_voronoi_keeps_seeds_and_relax_starts_from_them(torus):
    first = geolloyd.seeds(torus, 20)
    assert first.dtype == np.int32 and len(set(first)) == 20
    diagram = geolloyd.voronoi(torus, first)
    assert (diagram.seeds == first).all() and (diagram.region[first] == np.arange(20)).all()
    assert diagram.energy == diagram.initial_energy
    relaxed = geolloyd.relax(torus, first, greedy="off")
    assert relaxed.fingerprint == geolloyd.relax(torus, 20, greedy="off").fingerprint
    assert relaxed.energy < diagram.energy


def test_regions_are_trees(torus):
    found = geolloyd.relax(torus, 20)
    inner = np.flatnonzero(found.parent >= 0)
    assert len(inner) == len(torus.vertices) - 20
    assert (found.region[found.parent[inner]] == found.region[inner]).all()
    assert (found.distance[found.parent[inner]] < found.distance[inner]).all()
    assert np.isclose(found.region_energy.sum(), found.energy)


def test_seeds_by_position(torus):
    ids = geolloyd.seeds(torus, 20)
    places = torus.vertices[ids] + [0, 0, 1e-6]
    assert geolloyd.relax(torus, places).fingerprint == geolloyd.relax(torus, ids).fingerprint
    assert (geolloyd.voronoi(torus, np.concatenate([places, places])).seeds == ids).all()
    finer = geolloyd.voronoi(torus, geolloyd.generate("torus", 200).vertices, graph="triangle")
    assert len(finer.seeds) == len(geolloyd.generate("torus", 200).vertices)


@pytest.mark.parametrize("seeds", [[[0, 0]], [[0, 0, float("nan")]], [[0, 0, 1e200]], np.zeros((0, 3)), [[[0, 0, 0]]]])
def test_positions_that_are_none(torus, seeds):
    with pytest.raises(ValueError, match="seeds|first_positions"):
        geolloyd.relax(torus, seeds)


def test_ground_truth(torus):
    truth = geolloyd.ground_truth(torus, geolloyd.relax(torus, 20).seeds)
    assert truth.centroid.shape == (20, 3) and 0.8 < truth.node_agreement <= 1
    assert truth.energy <= truth.graph_energy


def test_closest_points_of_a_sphere():
    sphere = geolloyd.generate("icosphere", 20000)
    triangle, barycentric, distance = geolloyd.closest_points(sphere, [[2, 0, 0], [0, -0.5, 0]])
    assert triangle.shape == (2,) and np.allclose(barycentric.sum(1), 1)
    assert distance == pytest.approx([1, 0.5], abs=1e-2)


def test_features_and_labels():
    cube = geolloyd.generate("cube", 3000)
    kept = geolloyd.remesh(cube, 300)
    assert len(kept.feature_edges) > 0 and kept.report["feature_length"] == pytest.approx(12)
    smooth = geolloyd.remesh(cube, 300, features="off")
    assert len(smooth.feature_edges) == 0
    sides = np.sign(cube.vertices[cube.faces].mean(1)[:, 2] - cube.vertices[:, 2].mean()).astype(int)
    halved = geolloyd.remesh(cube, 300, features="off", labels=sides)
    assert halved.report["feature_length"] > 3.9


def test_values_of_files(tmp_path, torus):
    vertices, faces = torus
    color = np.arange(3 * len(vertices), dtype=np.uint8).reshape(-1, 3)
    geolloyd.write(tmp_path / "t.ply", vertices, faces, color=color, heat=vertices[:, 2], group=np.arange(len(faces)))
    found = geolloyd.read(tmp_path / "t.ply")
    assert (found.vertices == vertices).all() and (found.faces == faces).all()
    assert (found.vertex_values["color"] == color).all() and found.vertex_values["color"].dtype == np.uint8
    assert (found.vertex_values["heat"] == vertices[:, 2]).all()
    assert (found.face_values["group"] == np.arange(len(faces))).all()
    geolloyd.write(tmp_path / "again.ply", found)
    again = geolloyd.read(tmp_path / "again.ply")
    assert {name: value.tolist() for name, value in again.vertex_values.items()} == {
        name: value.tolist() for name, value in found.vertex_values.items()}


def test_split_vertices(tmp_path, torus):
    vertices, faces = torus
    split, apart = vertices[faces].reshape(-1, 3), np.arange(faces.size).reshape(-1, 3)
    heat = np.repeat(np.arange(len(faces), dtype=np.int32), 3)
    geolloyd.write(tmp_path / "split.ply", split, apart, heat=heat)
    welded = geolloyd.read(tmp_path / "split.ply")
    assert len(welded.vertices) == len(split) and len(np.unique(welded.faces)) == len(vertices)
    assert (welded.corner_values == apart).all() and (welded.vertex_values["heat"] == heat).all()
    geolloyd.write(tmp_path / "again.ply", welded)
    assert (geolloyd.read(tmp_path / "again.ply").corner_values == apart).all()
    left = geolloyd.read(tmp_path / "split.ply", weld=False)
    assert (left.faces == apart).all() and left.corner_values is None
    good = geolloyd.remesh(welded, 600)
    assert good.warnings == [] and len(good.vertices) == 600
    bad = geolloyd.remesh(left, 600)
    assert "split_vertices" in [w["kind"] for w in bad.report["warnings"]] and len(bad.warnings) > 1


def test_meshes_of_other_libraries(torus):
    class Trimesh:
        vertices, faces = torus
        triangles = torus.vertices[torus.faces]

    class PyVista:
        points = torus.vertices.astype(np.float32)
        faces = np.hstack([np.full((len(torus.faces), 1), 3), torus.faces]).ravel()

    class Open3D:
        vertices, triangles = list(torus.vertices), list(torus.faces)

    class Quads:
        points = torus.vertices
        faces = np.array([4, 0, 1, 2, 3, 4, 0, 1, 2, 3])

    expected = geolloyd.relax(*torus, 10).fingerprint
    assert [geolloyd.relax(mesh, 10).fingerprint for mesh in (Trimesh(), PyVista(), Open3D())] == 3 * [expected]
    with pytest.raises(ValueError, match="triangulate"):
        geolloyd.relax(Quads(), 10)
