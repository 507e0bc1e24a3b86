"""Reads a result file and checks that everything a picture needs is there."""

import json
import math
from pathlib import Path

NUMBER = (int, float)
POSITIVE = range(1, 2**63)
TEXT_OR_NULL = (str, type(None))
RANGE = {"min": NUMBER, "median": NUMBER, "max": NUMBER}
AVERAGE = {"min": NUMBER, "avg": NUMBER, "max": NUMBER}

KERNELS = {
    "free_search": "free search",
    "locked_search": "locked search",
    "subtree_sums": "subtree sums",
    "scoring": "scoring",
    "movement": "movement",
    "gathering": "gathering",
    "other": "other",
}
GREEDY_MODES = ["off", "standard", "extended"]
GRAPHS = ["vertex", "vertex-dense", "triangle", "triangle-dense", "mixed", "vertex-far"]

COMMON = {
    "program": str,
    "machine": {"processor": str, "threads": POSITIVE},
    "options": {},
    "interrupted": bool,
}
MESH = {"file": str, "triangles": int}
SINGLE = {"graph": str, "seeds": POSITIVE, "seeds_file": TEXT_OR_NULL}
KERNEL_SECONDS = {kernel: NUMBER for kernel in KERNELS}
SHAPES = {
    "compare": {
        "mesh": MESH,
        "options": SINGLE,
        "runs": [{
            "engine": ["reference", "parallel"], "frontier": TEXT_OR_NULL, "backend": TEXT_OR_NULL, "threads": POSITIVE,
            "turns": POSITIVE, "seconds": RANGE, "node_visits_per_second": NUMBER, "speedup": (*NUMBER, type(None)),
            "equal": bool,
        }],
    },
    "profile": {
        "mesh": MESH,
        "options": SINGLE,
        "profiles": [{
            "engine": ["reference", "parallel"], "frontier": TEXT_OR_NULL, "backend": TEXT_OR_NULL, "threads": POSITIVE,
            "fingerprint": str,
            "phases": [{"phase": ["greedy", "precise"], "seconds": NUMBER, "kernel_seconds": KERNEL_SECONDS}],
            "steps": [{"phase": ["greedy", "precise"], "active_regions": int, "energy": NUMBER, "seconds": NUMBER}],
        }],
    },
    "batch": {
        "mesh": MESH,
        "options": {"engine": str, "threads": POSITIVE},
        "rows": [{
            "graph": GRAPHS, "seeds": POSITIVE, "greedy": GREEDY_MODES, "macrostep_skip": bool, "microstep_skip": bool,
            "batches": int, "converged": int, "seconds": AVERAGE, "greedy_steps": AVERAGE, "macrosteps": AVERAGE,
            "microsteps": AVERAGE, "energy": AVERAGE,
        }],
    },
    "remesh": {
        "input": {**MESH, "area": NUMBER},
        "options": {"vertices": POSITIVE, "threads": POSITIVE},
        "trace": [{"sites": POSITIVE, "mesh_vertices": POSITIVE, "energy": NUMBER, "seconds": NUMBER}],
    },
}


class ResultError(Exception):
    """What is wrong with a result file, in one line."""


def check_value(value: object, kinds: type | tuple[type, ...], where: str) -> None:
    """Refuses a value of another kind, a truth value for a number, and numbers that are not finite or negative."""
    kinds = kinds if isinstance(kinds, tuple) else (kinds,)
    if not isinstance(value, kinds) or (isinstance(value, bool) and bool not in kinds):
        wanted = " or ".join("null" if kind is type(None) else kind.__name__ for kind in kinds)
        raise ResultError(f"{where} is not {wanted}")
    if isinstance(value, NUMBER) and not (math.isfinite(value) and value >= 0):
        raise ResultError(f"{where} is {value}")


def check(value: object, shape: object, where: str) -> None:
    """Compares a value with a shape: keys of an object, the shape of a list's items, what to choose from, types."""
    if isinstance(shape, dict):
        if not isinstance(value, dict):
            raise ResultError(f"{where or 'the file'} is not an object")
        for key, inner in shape.items():
            path = f"{where}.{key}" if where else key
            if key not in value:
                raise ResultError(f"{path} is missing")
            check(value[key], inner, path)
    elif isinstance(shape, list) and isinstance(shape[0], str):
        if value not in shape:
            raise ResultError(f"{where} is none of {', '.join(shape)}")
    elif isinstance(shape, list):
        if not isinstance(value, list):
            raise ResultError(f"{where} is not a list")
        for index, item in enumerate(value):
            check(item, shape[0], f"{where}[{index}]")
    elif isinstance(shape, range):
        if type(value) is not int or value not in shape:
            raise ResultError(f"{where} is not a positive integer")
    else:
        check_value(value, shape, where)


def something_to_draw(result: dict) -> bool:
    """Whether any run came to its end."""
    if result["command"] == "profile":
        return any(profile["phases"] or profile["steps"] for profile in result["profiles"])
    return bool(result[{"compare": "runs", "batch": "rows", "remesh": "trace"}[result["command"]]])


def load(path: Path) -> dict:
    """The result in a file, checked."""
    try:
        result = json.loads(path.read_text(encoding="utf-8"))
    except (ValueError, RecursionError) as error:
        raise ResultError("is not JSON: " + str(error).partition("\n")[0]) from None
    check(result, {"command": list(SHAPES)}, "")
    check(result, COMMON, "")
    check(result, SHAPES[result["command"]], "")
    if not something_to_draw(result):
        raise ResultError("nothing to draw: it holds no finished run")
    return result
