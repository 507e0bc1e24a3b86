"""The examples run, and draw what they say."""
import pathlib
import subprocess
import sys

import pytest

EXAMPLES = pathlib.Path(__file__).parents[2] / "tools/python/examples"


def test_tour(tmp_path):
    pytest.importorskip("matplotlib", reason="tools/install-dependencies --python installs python3-matplotlib")
    done = subprocess.run([sys.executable, EXAMPLES / "tour.py", tmp_path, "3000"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "600 vertices" in done.stdout and "120 regions" in done.stdout
    pictures = sorted(path.name for path in tmp_path.iterdir())
    assert pictures == ["distances.png", "energy.png", "regions.png", "remesh.png"]
    assert all(path.read_bytes()[:4] == b"\x89PNG" and path.stat().st_size > 10_000 for path in tmp_path.iterdir())
