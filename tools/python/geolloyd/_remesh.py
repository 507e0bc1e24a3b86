"""remesh()."""
from __future__ import annotations

from typing import Any, Callable, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _arrays, _core
from ._results import Remesh, RemeshProgress


def remesh(vertices: Any, faces: Optional[ArrayLike] = None, count: Optional[int] = None, *,
           edge_length: Union[float, ArrayLike, None] = None, tolerance: Optional[float] = None,
           field: Union[str, ArrayLike, None] = None, features: Union[str, float] = "auto",
           small_features: bool = True,
           feature_edges: Optional[ArrayLike] = None, labels: Optional[ArrayLike] = None,
           density: Optional[ArrayLike] = None, adapt: float = 0, equal_error: bool = False, growth: float = 1.12,
           fixed: Optional[ArrayLike] = None, fit: bool = True,
           progress: Optional[Callable[[RemeshProgress], Any]] = None, threads: int = 0) -> Remesh:
    """The most regular remesh: its vertices move freely over the surface, and it keeps the surface's topology.

    Parameters
    ----------
    vertices : (n, 3) numbers, or a mesh of trimesh, PyVista, Open3D or read(); then faces are left out
    faces : (m, 3) ids. Any flaws are allowed: holes, non-manifold edges, faces without area
    count : number of vertices, at least 4; more only where the topology needs them
    edge_length : instead of count the mean length of edges; or one length per vertex of the input, which is
        scaled if count or tolerance is given, too
    tolerance : instead of count the largest distance to the input; searches the fewest vertices for it
    field : shape of the triangles: "curvature", or (n, 8) numbers per vertex: two magnitudes, then tangent
        and bitangent. None: equilateral
    features : sharp edges to keep: "auto", "off", or an angle in degrees
    small_features : shorter edges where holes and walls are smaller than edges; at most a third of the vertices
    feature_edges : (k, 2) ids of vertices: further edges to keep
    labels : (m,) whole numbers: borders between them are kept
    density : (n,) numbers above 0: lengths of edges are proportional to density^(-1/4)
    adapt : 0 to 2: lengths of edges are proportional to curvature^(-adapt/2)
    equal_error : lengths of edges by which the distance to the input is about the same everywhere
    growth : maximum ratio of the lengths of adjacent edges, where lengths vary
    fixed : (k,) ids of vertices to keep where they are
    fit : move vertices off the surface in the end, where that brings the faces closer
    progress : is called now and then with a RemeshProgress; what returns False ends the moving of vertices
    threads : 0: as many as this process may use. They never change a result

    Returns
    -------
    Remesh : vertices, faces, and per vertex the triangle and barycentric weights of the point of the input
        that it stands for. A value per vertex of the input becomes one of the remesh by
        ``(values[faces[remesh.triangle]] * remesh.barycentric).sum(1)``
    """
    vertices, faces, count = _arrays.mesh_and(vertices, faces, count)
    lengths = None
    if edge_length is not None and np.ndim(edge_length) > 0:
        lengths, edge_length = _arrays.numbers("edge_length", edge_length, None), None
    given = [value is not None for value in (count, edge_length, tolerance)]
    if sum(given) > 1 or (sum(given) == 0 and lengths is None):
        raise ValueError("how fine? Give one of count, edge_length and tolerance")
    by_curvature = isinstance(field, str)
    if by_curvature and field != "curvature":
        raise ValueError(f"field: '{field}': give \"curvature\", or (n, 8) numbers")
    is_angle = not isinstance(features, str)
    watch = _arrays.callback(progress)
    made = _core.remesh(
        vertices, faces, count=0 if count is None else _arrays.whole("count", count, 4, 2**31 - 1),
        edge_length=0 if edge_length is None else _arrays.positive("edge_length", edge_length),
        tolerance=0 if tolerance is None else _arrays.positive("tolerance", tolerance), lengths=lengths,
        densities=None if density is None else _arrays.numbers("density", density, None),
        adapt=_arrays.number("adapt", adapt), equal_error=bool(equal_error), growth=_arrays.number("growth", growth),
        field=None if field is None or by_curvature else _arrays.numbers("field", field, None, 8),
        by_curvature=by_curvature, creases="angle" if is_angle else features,
        crease_angle=_arrays.number("features", features) if is_angle else 40,
        small_features=bool(small_features),
        feature_edges=None if feature_edges is None else _arrays.ids("feature_edges", feature_edges, None, 2),
        groups=None if labels is None else _groups(labels),
        fixed=None if fixed is None else _arrays.ids("fixed", fixed, None), fit=bool(fit),
        progress=watch and (lambda *figures: watch(RemeshProgress(*figures))), threads=_arrays.threads(threads))
    vertices, faces, triangle, barycentric, edges, report = made
    return Remesh(vertices, faces, triangle=triangle, barycentric=barycentric, feature_edges=edges, report=report)


def _groups(labels: ArrayLike) -> np.ndarray:
    """Ids for whole numbers of any size and sign."""
    return np.unique(_arrays.ids("labels", labels, None), return_inverse=True)[1].astype(np.int64)
