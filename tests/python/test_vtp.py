"""VTP files, read back by VTK itself."""
import numpy as np
import pytest

import geolloyd

pytest.importorskip("vtkmodules", reason="no vtkmodules to read VTP files back: Debian's python3-vtk9 has them")
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader  # noqa: E402


class Vtp:
    """What VTK finds in a file: arrays of points and cells by name, as numpy has them."""

    def __init__(self, path):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(path))
        reader.Update()
        assert reader.GetErrorCode() == 0
        data = reader.GetOutput()
        self.vertices = vtk_to_numpy(data.GetPoints().GetData())
        polygons = data.GetPolys()
        assert (np.diff(vtk_to_numpy(polygons.GetOffsetsArray())) == 3).all()
        self.faces = vtk_to_numpy(polygons.GetConnectivityArray()).reshape(-1, 3)
        self.of_points, self.of_cells = (
            {part.GetArrayName(i): vtk_to_numpy(part.GetArray(i)) for i in range(part.GetNumberOfArrays())}
            for part in (data.GetPointData(), data.GetCellData()))

    def has_shape_of(self, mesh):
        return np.array_equal(self.vertices, mesh.vertices) and np.array_equal(self.faces, mesh.faces)


def test_values_of_write(tmp_path, torus):
    found = geolloyd.relax(torus, 20)
    area = np.arange(len(torus.faces), dtype=np.float32)
    geolloyd.write(tmp_path / "t.vtp", torus.vertices, torus.faces, region=found.region, distance=found.distance, area=area)
    vtp = Vtp(tmp_path / "t.vtp")
    assert vtp.has_shape_of(torus)
    assert list(vtp.of_points) == ["region", "distance"] and list(vtp.of_cells) == ["area"]
    assert vtp.of_points["region"].dtype == np.int32 and np.array_equal(vtp.of_points["region"], found.region)
    assert vtp.of_points["distance"].dtype == np.float64 and np.array_equal(vtp.of_points["distance"], found.distance)
    assert vtp.of_cells["area"].dtype == np.float32 and np.array_equal(vtp.of_cells["area"], area)


def test_columns_of_write(tmp_path, torus):
    color = np.zeros((len(torus.vertices), 3), np.uint8)
    color[:, 1] = 200
    geolloyd.write(tmp_path / "t.vtp", torus, color=color)
    vtp = Vtp(tmp_path / "t.vtp")
    assert list(vtp.of_points) == ["red", "green", "blue"] and (vtp.of_points["green"] == 200).all()


@pytest.mark.parametrize("graph", ["vertex", "triangle", "mixed"])
def test_regions_and_distances_of_relax(program, torus, graph):
    geolloyd.write(program.folder / "scan.ply", torus, distance=np.ones(len(torus.vertices)))
    program.run("relax", "scan.ply", "-k", 20, "--graph", graph, "-o", "out", "--vtp", "regions.vtp")
    vtp = Vtp(program.folder / "regions.vtp")
    assert vtp.has_shape_of(torus)
    assert (vtp.of_points["input_distance" if "region" in vtp.of_points else "distance"] == 1).all()
    found = geolloyd.relax(geolloyd.read(program.folder / "scan.ply"), 20, graph=graph)
    parts = [part for part in (vtp.of_points, vtp.of_cells) if "region" in part]
    assert len(parts) == (2 if graph == "mixed" else 1)
    assert np.array_equal(np.concatenate([part["region"] for part in parts]), found.region)
    assert np.array_equal(np.concatenate([part["distance"] for part in parts]), found.distance)


def test_vertices_without_a_region(program):
    vertices = [[0, 0, 0], [9, 9, 9], [1, 0, 0], [0, 1, 0]]
    geolloyd.write(program.folder / "scan.obj", vertices, [[0, 2, 3]])
    program.run("relax", "scan.obj", "-k", 1, "-o", "out", "--vtp", "regions.vtp")
    vtp = Vtp(program.folder / "regions.vtp")
    assert list(vtp.of_points["region"]) == [0, -1, 0, 0]
    assert list(np.isnan(vtp.of_points["distance"])) == [False, True, False, False]
