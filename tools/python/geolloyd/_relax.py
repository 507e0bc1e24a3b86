"""relax(), and what it is made of."""
from __future__ import annotations

from typing import Any, Callable, Dict, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _arrays, _core
from ._results import Tessellation, TessellationProgress

_NO_LIMIT = 2**32 - 1


def _options(seeds: Any, init: str, random_seed: int, graph: str, norm: str, averaging: str,
             field: Union[str, ArrayLike, None], threads: int) -> Dict[str, Any]:
    if seeds is None:
        raise ValueError("seeds: how many? Give a number, their ids, or their positions")
    is_count = np.ndim(seeds) == 0
    by_position = np.ndim(seeds) == 2
    of_surface = field if isinstance(field, str) else ""
    if of_surface not in ("", "curvature", "cross"):
        raise ValueError(f"field: '{field}': give \"curvature\", \"cross\", or (n, 8) numbers")
    if not is_count and np.size(seeds) == 0:
        raise ValueError("seeds: none: give at least one")
    return {
        "count": _arrays.whole("seeds", seeds, 1, 2**31 - 1) if is_count else 0,
        "seeds": None if is_count or by_position else _arrays.ids("seeds", seeds, None),
        "positions": _arrays.numbers("seeds", seeds, None, 3) if by_position else None,
        "init": _arrays.word("init", init),
        "random_seed": _arrays.whole("random_seed", random_seed),
        "graph": _arrays.word("graph", graph),
        "norm": _arrays.word("norm", norm),
        "averaging": _arrays.word("averaging", averaging),
        "field": None if field is None or of_surface else _arrays.numbers("field", field, None, 8),
        "surface_field": of_surface,
        "threads": _arrays.threads(threads),
    }


def _limit(name: str, value: Optional[int]) -> int:
    return _NO_LIMIT if value is None else _arrays.whole(name, value, 0, _NO_LIMIT)


def relax(vertices: Any, faces: Optional[ArrayLike] = None, seeds: Union[int, ArrayLike, None] = None, *,
          graph: str = "vertex", init: str = "auto", random_seed: int = 1, greedy: str = "auto",
          field: Union[str, ArrayLike, None] = None, norm: str = "geodesic", averaging: str = "auto",
          improvement_rounds: int = 0, max_greedy_steps: Optional[int] = None, max_macrosteps: Optional[int] = None,
          progress: Optional[Callable[[TessellationProgress], Any]] = None, threads: int = 0) -> Tessellation:
    """Moves seeds to the centroids of their regions until none moves: a centroidal Voronoi tessellation.

    Parameters
    ----------
    vertices : (n, 3) numbers, or a mesh of trimesh, PyVista, Open3D or read(); then faces are left out
    faces : (m, 3) ids
    seeds : how many, at least one per component of the mesh; or the first ones: (k,) ids, or (k, 3) positions,
        such as the vertices of another mesh, for the nearest ids. Those nearest to the same id are one seed
    graph : "vertex", "vertex-dense", "vertex-far", "triangle", "triangle-dense" or "mixed": what ids are of,
        and which of them are neighbours
    init : how the first seeds are chosen: "auto", "farthest", "kmeans++", "random-area", "random", "surface",
        "coarse"
    random_seed : varies what is chosen at random
    greedy : the greedy phase: "auto", "off", "standard", "extended"
    field : metric: "curvature", "cross", or (n, 8) numbers per vertex: two magnitudes, then tangent and
        bitangent. None: isotropic
    norm : "geodesic", "manhattan" or "linf"
    averaging : of the field along an edge: "auto", "metric" or "pairwise"
    improvement_rounds : how often to leave the local minimum for a lower one
    max_greedy_steps, max_macrosteps : limits of both phases
    progress : is called now and then with a TessellationProgress; what returns False ends the work with the
        best state met
    threads : 0: as many as this process may use. They never change a result

    Returns
    -------
    Tessellation : its dual() is a remesh
    """
    vertices, faces, seeds = _arrays.mesh_and(vertices, faces, seeds)
    options = _options(seeds, init, random_seed, graph, norm, averaging, field, threads)
    watch = _arrays.callback(progress)
    words, made = _core.relax(
        vertices, faces, options, greedy=_arrays.word("greedy", greedy),
        max_greedy_steps=_limit("max_greedy_steps", max_greedy_steps),
        max_macrosteps=_limit("max_macrosteps", max_macrosteps),
        improvement_rounds=_arrays.whole("improvement_rounds", improvement_rounds, 0, _NO_LIMIT),
        progress=watch and (lambda *figures: watch(TessellationProgress(*figures))))
    return Tessellation(**words, _made=made)


def voronoi(vertices: Any, faces: Optional[ArrayLike] = None, seeds: Optional[ArrayLike] = None, *,
            graph: str = "vertex", field: Union[str, ArrayLike, None] = None, norm: str = "geodesic",
            averaging: str = "auto", threads: int = 0) -> Tessellation:
    """The regions of these seeds as they are: the Voronoi diagram of the graph. Arguments are those of relax()."""
    vertices, faces, seeds = _arrays.mesh_and(vertices, faces, seeds)
    return relax(vertices, faces, seeds, graph=graph, field=field, norm=norm, averaging=averaging, greedy="off",
                 max_greedy_steps=0, max_macrosteps=0, threads=threads)


def distances(vertices: Any, faces: Optional[ArrayLike] = None, sources: Optional[ArrayLike] = None, *,
              graph: str = "vertex", field: Union[str, ArrayLike, None] = None, norm: str = "geodesic",
              averaging: str = "auto", threads: int = 0) -> np.ndarray:
    """Per id the distance along the graph to the nearest of the sources: float64, in units of the mesh.

    Infinite where no source is in the same component. ``sources`` are ids, the other arguments those of relax().
    """
    vertices, faces, sources = _arrays.mesh_and(vertices, faces, sources)
    if sources is None:
        raise ValueError("sources: from where? Give ids")
    sources = np.unique(_arrays.ids("sources", np.atleast_1d(np.asarray(sources)), None))
    options = _options(sources, "auto", 1, graph, norm, averaging, field, threads)
    return _core.distances(vertices, faces, options)


def seeds(vertices: Any, faces: Optional[ArrayLike] = None, count: Optional[int] = None, *, init: str = "auto",
          random_seed: int = 1, graph: str = "vertex", field: Union[str, ArrayLike, None] = None,
          norm: str = "geodesic", averaging: str = "auto", threads: int = 0) -> np.ndarray:
    """The first seeds that relax() goes out from: (count,) int32 ids. Arguments are those of relax()."""
    vertices, faces, count = _arrays.mesh_and(vertices, faces, count)
    count = _arrays.whole("count", count, 1, 2**31 - 1)
    return _core.first_seeds(vertices, faces, _options(count, init, random_seed, graph, norm, averaging, field, threads))
