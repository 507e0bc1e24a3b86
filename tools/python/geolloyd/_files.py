"""read(), write() and generate()."""
from __future__ import annotations

import os
from typing import Any, Dict, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _arrays, _core
from ._results import Mesh

# Values with several columns, and the names that files have for these.
_VECTORS = {"color": ("red", "green", "blue", "alpha"), "normal": ("nx", "ny", "nz"), "texture": ("s", "t")}


def read(path: Union[str, "os.PathLike[str]"], *, weld: bool = True) -> Mesh:
    """Reads a mesh file, with its values per vertex and per face.

    Polygons become triangles. Values have the names of the file, but colours are ``color`` with 3 or 4 columns,
    normals ``normal``, and places in a texture ``texture``.

    Many files have a vertex several times, once for each normal at it. ``weld``: faces name the first of those
    whose places are the same to the bit. All vertices stay, with their numbers and values.
    """
    vertices, faces, of_vertices, of_faces, corner_values = _core.read(os.fspath(path), bool(weld))
    return Mesh(vertices, faces, _joined(of_vertices), _joined(of_faces), corner_values)


def write(path: Union[str, "os.PathLike[str]"], vertices: Any, faces: Optional[ArrayLike] = None, *,
          face_values: Optional[Dict[str, ArrayLike]] = None, **values: ArrayLike) -> None:
    """Writes a mesh; the extension tells the format. The file appears whole or not at all.

    ``values`` are written by their names, as far as the format has room for them: per vertex where they are
    as long as the vertices, else per face; ``face_values`` are per face in any case. ``color``, ``normal`` and
    ``texture`` have columns. A result of read() brings its own values along.
    """
    own = vertices if isinstance(vertices, Mesh) else None
    vertices, faces = _arrays.mesh_arrays(vertices, faces)
    of_vertices: Dict[str, ArrayLike] = dict(own.vertex_values) if own else {}
    of_faces: Dict[str, ArrayLike] = dict(own.face_values) if own else {}
    of_faces.update(face_values or {})
    for name, value in values.items():
        (of_vertices if np.shape(value)[:1] == (len(vertices),) else of_faces)[name] = value
    corner_values = own.corner_values if own else None
    if corner_values is not None:
        corner_values = np.ascontiguousarray(corner_values, np.int64)
    _core.write(os.fspath(path), vertices, faces, _columns(of_vertices, len(vertices)), _columns(of_faces, len(faces)),
                corner_values)


def generate(shape: str, triangles: int = 1_000_000, *, random_seed: int = 1) -> Mesh:
    """A mesh to try things on: "creature", "plane", "icosphere", "cube", "torus" or "cylinder"."""
    return Mesh(*_core.generate(_arrays.word("shape", shape), _arrays.whole("triangles", triangles, 1),
                                _arrays.whole("random_seed", random_seed)))


def _joined(values: Dict[str, np.ndarray]) -> Dict[str, np.ndarray]:
    for name, parts in _VECTORS.items():
        names = [part for part in parts if part in values]
        if len(names) >= min(3, len(parts)) and len({values[part].dtype for part in names}) == 1:
            values[name] = np.stack([values.pop(part) for part in names], axis=1)
    return values


def _columns(values: Dict[str, ArrayLike], rows: int) -> Dict[str, np.ndarray]:
    """One array per name, of the number types that files have."""
    columns = {}
    for name, value in values.items():
        array = np.asarray(value)
        if array.dtype.kind not in "biuf":
            raise ValueError(f"{name}: {array.dtype}: give real numbers")
        if array.shape[:1] != (rows,) or array.ndim > 2:
            raise ValueError(f"{name}: shape {array.shape}: give {rows} rows, one per vertex or one per face")
        if array.ndim == 1:
            columns[name] = _stored(name, array)
            continue
        parts = _VECTORS.get(name, ())
        if not min(3, len(parts)) <= array.shape[1] <= len(parts) or not parts:
            raise ValueError(f"{name}: {array.shape[1]} columns: give one array per column, each with a name")
        columns.update((part, _stored(part, array[:, i])) for i, part in enumerate(parts[:array.shape[1]]))
    return columns


def _stored(name: str, array: np.ndarray) -> np.ndarray:
    kind, size = array.dtype.kind, array.dtype.itemsize
    if kind == "b":
        to: Any = np.uint8
    elif kind == "f":
        to = np.float32 if size <= 4 else np.float64
    elif size <= 4:
        to = array.dtype.newbyteorder("=")
    elif array.size == 0 or -2**31 <= array.min() and array.max() < 2**31:
        to = np.int32
    else:
        raise ValueError(f"{name}: whole numbers of more than 32 bits: no file format has them")
    return np.ascontiguousarray(array, dtype=to)
