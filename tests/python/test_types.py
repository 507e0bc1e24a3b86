"""Types of the package, as mypy finds them that checks a script."""
import pathlib
import subprocess
import sys

import pytest

import geolloyd

pytest.importorskip("mypy", reason="no mypy to check the stubs: Debian's package mypy")

PACKAGE = pathlib.Path(geolloyd.__file__).parent


def mypy(folder, *arguments):
    return subprocess.run([sys.executable, "-m", "mypy", "--follow-imports=silent", "--ignore-missing-imports",
                           "--cache-dir", str(folder / "cache"), *map(str, arguments)],
                          cwd=folder, env={"MYPYPATH": str(PACKAGE.parent), "PATH": "/usr/bin:/bin"},
                          capture_output=True, text=True)


def test_of_a_script(tmp_path):
    (tmp_path / "right.py").write_text(
        "import geolloyd\nmesh = geolloyd.generate('torus', 500)\n"
        "found = geolloyd.relax(mesh, 20)\nenergy: float = found.energy\ngeolloyd.write('t.ply', found.dual())\n")
    (tmp_path / "wrong.py").write_text(
        "import geolloyd\nmesh = geolloyd.generate('torus', 500)\n"
        "geolloyd.relax(mesh, 20, grph='vertex')\nname: str = geolloyd.relax(mesh, 20).energy\n")
    right = mypy(tmp_path, "right.py")
    assert right.returncode == 0, right.stdout + right.stderr
    wrong = mypy(tmp_path, "wrong.py")
    assert "wrong.py:3:" in wrong.stdout and "wrong.py:4:" in wrong.stdout, wrong.stdout + wrong.stderr
