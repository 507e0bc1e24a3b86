"""What users pass, as arrays that the module takes: float64 and int64, in C order."""
import numpy as np

_MOST_IDS = 2**31 - 1  # results are int32


def _array(name, value):
    try:
        array = np.asarray(value)
    except Exception as error:  # ragged lists, among others
        raise ValueError(f"{name}: no array of numbers: {error}") from None
    if array.dtype.kind not in "biuf":
        raise ValueError(f"{name}: {array.dtype}: give real numbers")
    return array


def numbers(name, value, *shape):
    """float64 of this shape; None stands for any length."""
    array = _array(name, value)
    _check_shape(name, array, shape)
    return np.ascontiguousarray(array, dtype=np.float64)


def ids(name, value, *shape):
    """int64 of this shape. Floating-point numbers must be whole."""
    array = _array(name, value)
    if array.size == 0 and array.ndim == 1 and len(shape) == 2:
        array = array.reshape(0, shape[1])  # [] has no second axis
    _check_shape(name, array, shape)
    if array.dtype.kind == "b":
        raise ValueError(f"{name}: bool: give ids; numpy.flatnonzero makes them of a mask")
    if array.dtype.kind == "f":
        if not (np.isfinite(array).all() and (array == np.floor(array)).all() and (abs(array) < 2**62).all()):
            raise ValueError(f"{name}: {array.dtype} with numbers that are not whole: give ids")
    elif array.dtype == np.uint64:
        array = np.minimum(array, np.uint64(2**63 - 1))  # too large in any case
    return np.ascontiguousarray(array, dtype=np.int64)


def _check_shape(name, array, shape):
    fits = array.ndim == len(shape) and all(s in (None, n) for s, n in zip(shape, array.shape))
    if not fits:
        wanted = "(" + ", ".join("n" if s is None else str(s) for s in shape) + ("," if len(shape) == 1 else "") + ")"
        raise ValueError(f"{name}: shape {array.shape}: give {wanted}")


def is_mesh(value):
    return not isinstance(value, np.ndarray) and any(hasattr(value, name) for name in ("vertices", "points"))


def _faces_of(mesh):
    if not hasattr(mesh, "points"):  # trimesh and ours have faces, Open3D has triangles
        return mesh.faces if hasattr(mesh, "faces") else getattr(mesh, "triangles", None)
    faces = np.asarray(getattr(mesh, "faces", ()))  # PyVista: count, ids, count, ids, ...
    if faces.ndim == 2:
        return faces
    if faces.ndim == 1 and faces.size % 4 == 0 and (faces[::4] == 3).all():
        return faces.reshape(-1, 4)[:, 1:]
    raise ValueError("mesh: has polygons that are no triangles: triangulate() it first")


def mesh_arrays(vertices, faces, name=""):
    """Vertices (n, 3) float64 and faces (m, 3) int64."""
    if faces is None and is_mesh(vertices):
        mesh = vertices
        vertices = mesh.points if hasattr(mesh, "points") else mesh.vertices
        faces = _faces_of(mesh)
    if faces is None:
        raise ValueError(f"{name}faces: missing: give vertices and faces, or a mesh that has both")
    vertices = numbers(f"{name}vertices", vertices, None, 3)
    faces = ids(f"{name}faces", faces, None, 3)
    if len(vertices) + len(faces) > _MOST_IDS:
        raise ValueError(f"{name}mesh: more than {_MOST_IDS} vertices and triangles: int32 cannot count them")
    return vertices, faces


def mesh_and(vertices, faces, third):
    """The same, and the argument after them: where a mesh comes first, it is the second one."""
    if is_mesh(vertices) and third is None:
        faces, third = None, faces
    return (*mesh_arrays(vertices, faces), third)


def whole(name, value, least=0, most=2**63 - 1):
    """An int in this range."""
    try:
        number = value.__index__()
    except AttributeError:
        raise ValueError(f"{name}: {value!r}: give a whole number") from None
    if isinstance(value, (bool, np.bool_)) or not least <= number <= most:
        raise ValueError(f"{name}: {value!r}: give a whole number from {least}" +
                         (f" to {most}" if most < 2**63 - 1 else ""))
    return number


def number(name, value):
    """A float; the library knows its range."""
    try:
        return float(value)
    except (TypeError, ValueError):
        raise ValueError(f"{name}: {value!r}: give a number") from None


def positive(name, value):
    """A finite float above 0."""
    found = number(name, value)
    if not (found > 0 and np.isfinite(found)):
        raise ValueError(f"{name}: {value!r}: give a number above 0")
    return found


def threads(value):
    return whole("threads", value, 0, 1024)


def callback(value):
    if value is not None and not callable(value):
        raise ValueError(f"progress: {value!r}: give a function")
    return value


def word(name, value):
    if not isinstance(value, str):
        raise ValueError(f"{name}: {value!r}: give a word")
    return value
