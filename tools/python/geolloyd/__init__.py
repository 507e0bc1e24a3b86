"""Geodesic centroidal Voronoi tessellations of large triangle meshes, and remeshes of them.

    import geolloyd
    mesh = geolloyd.read("scan.ply")                  # or mesh of trimesh, PyVista, Open3D
    remesh = geolloyd.remesh(mesh, 2048)
    geolloyd.write("remesh.ply", remesh)

Meshes are vertices (n, 3) and faces (m, 3), or any object that has them. Numbers of any type and order are
taken and never changed; results are float64 and int32. Ids count from 0. Lengths, areas and energies are in
the units of the mesh. Results have the same bits on every machine, with any number of threads; they are
those of the program geolloyd.

What cannot be used is a ValueError that says what, where and what to do; files raise OSError, too little
memory MemoryError. Other threads of Python run meanwhile, and several may call at once. Ctrl-C works.
"""
from ._core import version as __version__
from ._files import generate, read, write
from ._measures import closest_points, ground_truth, quality, self_intersections
from ._remesh import remesh
from ._results import GroundTruth, Mesh, Remesh, RemeshProgress, Tessellation, TessellationProgress
from ._relax import distances, relax, seeds, voronoi
from .many import remesh_many

__all__ = [
    "remesh", "relax", "voronoi", "distances", "seeds", "ground_truth", "quality", "self_intersections", "closest_points", "read",
    "write", "generate", "remesh_many", "Mesh", "Remesh", "Tessellation", "GroundTruth", "RemeshProgress", "TessellationProgress",
]
