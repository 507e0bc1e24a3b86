#!/usr/bin/env python3
"""Draws results of geolloyd compare, profile and batch, and reports of remesh, for light pages and dark ones."""

import argparse
import importlib
import os
import sys
import warnings
from pathlib import Path

sys.dont_write_bytecode = True  # leaves nothing in the source tree

from plots.result import ResultError, load

BAD_RESULT, NO_MATPLOTLIB = 2, 3
SYSTEM_PYTHON = "/usr/bin/python3"  # for which the system's packages are


def stem_of(path: Path) -> Path:
    """The path of a result file without .json."""
    return path.with_suffix("") if path.suffix == ".json" else path


def use_matplotlib() -> bool:
    """Whether it is there; if only another Python has it, that one takes over."""
    try:
        import matplotlib
    except ImportError:
        if os.path.exists(SYSTEM_PYTHON) and not os.path.samefile(SYSTEM_PYTHON, sys.executable):
            os.execv(SYSTEM_PYTHON, [SYSTEM_PYTHON, *sys.argv])
        return False
    matplotlib.use("Agg")
    warnings.filterwarnings("ignore", message="Glyph .* missing")  # names of meshes in any script
    return True


def draw_all(result: dict, stem: Path) -> None:
    """Draws every picture of a result in both themes, and prints the files' names."""
    from plots.page import save
    from plots.theme import THEMES

    module = importlib.import_module(f"plots.{result['command']}_picture")
    for name, draw in module.pictures(result):
        for theme in THEMES:
            path = stem.with_name(stem.name + name + theme.suffix + ".png")
            with theme.applied():
                save(draw(result, theme), path)
            print(path, flush=True)


def main() -> int:
    """Reads the command line; returns the exit status."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("result", type=Path, metavar="RESULT.json", help="written by geolloyd compare, profile or batch, or the report of remesh")
    parser.add_argument("--output", type=Path, metavar="STEM",
                        help="writes STEM.png and STEM-dark.png (default: RESULT), of a batch with several seed counts "
                             "also STEM-ladder.png and STEM-ladder-dark.png")
    arguments = parser.parse_args()
    try:
        result = load(arguments.result)
    except (OSError, ResultError) as error:
        reason = error.strerror if isinstance(error, OSError) else error
        print(f"plot.py: {arguments.result}: {reason}", file=sys.stderr)
        return BAD_RESULT
    if not use_matplotlib():
        print("no picture: matplotlib is missing: apt-get install python3-matplotlib", file=sys.stderr)
        return NO_MATPLOTLIB
    stem = arguments.output or stem_of(arguments.result)
    try:
        draw_all(result, stem)
    except OSError as error:
        print(f"plot.py: cannot write to {stem.parent}: {error.strerror}", file=sys.stderr)
        return BAD_RESULT
    return 0


if __name__ == "__main__":
    sys.exit(main())
