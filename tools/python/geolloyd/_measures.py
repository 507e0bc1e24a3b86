"""quality(), self_intersections(), ground_truth() and closest_points()."""
from __future__ import annotations

from typing import Any, Dict, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _arrays, _core
from ._results import GroundTruth
from ._relax import voronoi


def quality(vertices: Any, faces: Optional[ArrayLike] = None, *, original: Any = None, samples: int = 500_000,
            certify: bool = False, threads: int = 0) -> Dict[str, Any]:
    """The figures by which remeshes are compared, with the names that ``geolloyd quality`` has for them.

    ``quality`` has angles (degrees), triangle qualities and valences, ``topology`` components, Euler
    characteristic, boundary loops and flaws; ``self_intersections`` is the number of pairs of triangles that cross.
    With ``original``, a mesh or a pair of vertices and faces,
    ``likeness`` has ``remesh_to_original``, ``original_to_remesh`` and ``two_sided``: the mean, rms and largest
    (``hausdorff``) distance of so many samples on each of the two. With ``certify`` they have bounds of the
    Hausdorff distance, too, 1 % apart: ``hausdorff_lower`` and ``hausdorff_upper``.
    """
    vertices, faces = _arrays.mesh_arrays(vertices, faces)
    figures = _core.quality(vertices, faces, _arrays.threads(threads))
    if certify and original is None:
        raise ValueError("certify: the distance to which mesh? Give original, too")
    if original is not None:
        first, second = original if isinstance(original, (tuple, list)) and len(original) == 2 else (original, None)
        others = _arrays.mesh_arrays(first, second, "original: ")
        figures["likeness"] = _core.distance(vertices, faces, *others, _arrays.whole("samples", samples, 1, 10**9),
                                             bool(certify), _arrays.threads(threads))
    return figures


def self_intersections(vertices: Any, faces: Optional[ArrayLike] = None, *, threads: int = 0) -> np.ndarray:
    """The pairs of triangles (k, 2) int32 that have a point in common beside the corners, or the edge, that they share.

    Ascending, and exact. Corners in the very same place are shared, triangles without area are left out, and what
    merely touches counts.
    """
    vertices, faces = _arrays.mesh_arrays(vertices, faces)
    return _core.self_intersections(vertices, faces, _arrays.threads(threads))


def ground_truth(vertices: Any, faces: Optional[ArrayLike] = None, seeds: Optional[ArrayLike] = None, *,
                 graph: str = "vertex", field: Union[str, ArrayLike, None] = None, norm: str = "geodesic",
                 averaging: str = "auto", threads: int = 0) -> GroundTruth:
    """Judges seeds by Euclidean distance: which node is nearest to which, and how far the graph is from that."""
    vertices, faces, seeds = _arrays.mesh_and(vertices, faces, seeds)
    diagram = voronoi(vertices, faces, seeds, graph=graph, field=field, norm=norm, averaging=averaging, threads=threads)
    return diagram.ground_truth(threads=threads)


def closest_points(vertices: Any, faces: Optional[ArrayLike] = None, points: Optional[ArrayLike] = None, *,
                   threads: int = 0) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The points of a mesh that are closest to some points (k, 3).

    Returns their triangle (k,) int32, the weights of its corners (k, 3), and their distance (k,).
    """
    vertices, faces, points = _arrays.mesh_and(vertices, faces, points)
    if points is None:
        raise ValueError("points: missing: give (n, 3) numbers")
    points = _arrays.numbers("points", points, None, 3)
    triangle, barycentric = _core.closest_points(vertices, faces, points, _arrays.threads(threads))
    places = (vertices[faces[triangle]] * barycentric[:, :, None]).sum(1)
    return triangle, barycentric, np.linalg.norm(places - points, axis=1)
