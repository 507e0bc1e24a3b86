"""What the functions return."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Dict, Iterator, List, NamedTuple, Optional

import numpy as np

from . import _arrays


@dataclass(frozen=True, repr=False, eq=False)
class Mesh:
    """Triangles with shared vertices. ``vertices, faces = mesh`` takes both."""

    vertices: np.ndarray  #: (n, 3) float64
    faces: np.ndarray  #: (m, 3) int32, counter-clockwise seen from outside
    vertex_values: Dict[str, np.ndarray] = field(default_factory=dict)  #: by name, n rows each
    face_values: Dict[str, np.ndarray] = field(default_factory=dict)  #: by name, m rows each
    #: (m, 3) int32: the rows of vertex_values that the corners of faces have, where read() welded vertices with
    #: different values; else None: their own
    corner_values: Optional[np.ndarray] = None

    def __iter__(self) -> Iterator[np.ndarray]:
        return iter((self.vertices, self.faces))

    def __repr__(self) -> str:
        return f"{type(self).__name__}({len(self.vertices)} vertices, {len(self.faces)} faces)"


@dataclass(frozen=True, repr=False, eq=False)
class Remesh(Mesh):
    """A remesh, and the points of the input that its vertices stand for."""

    #: (n,) int32: the triangle of the input
    triangle: np.ndarray = field(default_factory=lambda: np.empty(0, np.int32))
    #: (n, 3) float64: weights of its corners
    barycentric: np.ndarray = field(default_factory=lambda: np.empty((0, 3)))
    #: (k, 2) int32: edges along the boundary's and other features; of a dual none
    feature_edges: np.ndarray = field(default_factory=lambda: np.empty((0, 2), np.int32))
    #: (n,) int32 ids of the input: of a dual its seeds; else None
    seeds: Optional[np.ndarray] = None
    #: figures, with the names that the reports of the program have
    report: Dict[str, Any] = field(default_factory=dict)

    @property
    def warnings(self) -> List[str]:
        """What is bad about it, a line each; empty where nothing is. Their kinds are in the report."""
        return [warning["text"] for warning in self.report.get("warnings", [])]

    @property
    def fingerprint(self) -> str:
        """A digest of the whole course, as the program's report has it. The same on every machine."""
        return self.report["fingerprint"]


@dataclass(frozen=True, repr=False, eq=False)
class Tessellation:
    """Regions of a mesh, each with its seed.

    "Per id" means per node of the graph, by the input's ids: vertices, or faces in a graph of triangles, or
    in the mixed graph first vertices, then faces.
    """

    region: np.ndarray  #: (ids,) int32; -1: a vertex of no face, or no seed near
    distance: np.ndarray  #: (ids,) float64: to the seed, along the graph; or inf
    parent: np.ndarray  #: (ids,) int32: the next id on the way to the seed, or -1
    seeds: np.ndarray  #: (regions,) int32 ids
    region_area: np.ndarray  #: (regions,) float64
    region_energy: np.ndarray  #: (regions,) float64: sum of mass * distance^2
    energy: float  #: of all regions; never more than initial_energy
    initial_energy: float
    fingerprint: str  #: a digest of the whole course, as the program's report has it
    end: str  #: why: "converged", "interrupted", "limit" or "recurred"
    trace: List[Dict[str, Any]]  #: a dict per step: phase, energy, seeds_moved, node_visits, seconds
    _made: Any

    @property
    def report(self) -> Dict[str, Any]:
        """The figures alone, with the names that the reports of the program have."""
        return {"fingerprint": self.fingerprint, "end": self.end, "interrupted": self.end == "interrupted",
                "regions": len(self.seeds), "energy_initial": self.initial_energy, "energy": self.energy,
                "trace": self.trace}

    def dual(self, *, manifold: bool = True, threads: int = 0) -> Remesh:
        """The remesh whose vertices are the seeds.

        Where regions do not meet as they should, seeds are added until the dual has the topology of the
        input, unless ``manifold`` is False.
        """
        vertices, faces, triangle, barycentric, seeds, report = self._made.dual(bool(manifold), _arrays.threads(threads))
        report["fingerprint"] = self.fingerprint
        return Remesh(vertices, faces, triangle=triangle, barycentric=barycentric, seeds=seeds, report=report)

    def ground_truth(self, *, threads: int = 0) -> "GroundTruth":
        """The regions by Euclidean distance to the same seeds, and how far these are from them."""
        return GroundTruth(**self._made.ground_truth(_arrays.threads(threads)))

    def __repr__(self) -> str:
        return f"Tessellation({len(self.seeds)} regions, energy {self.energy:.6g}, {self.end})"


@dataclass(frozen=True, repr=False, eq=False)
class GroundTruth:
    """What a tessellation is judged by: the partition by Euclidean distance to the same seeds."""

    region: np.ndarray  #: (ids,) int32: of the nearest seed
    centroid: np.ndarray  #: (regions, 3) float64: the point of the surface nearest to each region's centroid
    node_agreement: float  #: share of nodes that the graph puts into the same region
    area_agreement: float  #: the same by area
    mean_distance_in_radii: float  #: from seed to centroid, over the radius of a disc of the region's area
    energy: float  #: sum of mass * |node - seed|^2
    energy_ratio_hexagonal: float  #: over that of the hexagonal tiling of the plane
    graph_energy: float  #: the same sum, with the graph's regions
    graph_energy_ratio_hexagonal: float

    def __repr__(self) -> str:
        return f"GroundTruth({len(self.centroid)} regions, agreement {self.node_agreement:.4f})"


class RemeshProgress(NamedTuple):
    """Where a remesh stands. Vertices come in levels, each with about four times as many as the one before."""

    vertices: int  #: of this level
    wanted_vertices: int  #: of the last level
    iteration: int  #: within the level
    energy_ratio_hexagonal: float


class TessellationProgress(NamedTuple):
    """Where a relaxation stands."""

    phase: str  #: "greedy", "precise" or "improvement"
    step: int  #: counts from 1 in each phase
    seeds_moving: int
    energy: float  #: at the start of the step
