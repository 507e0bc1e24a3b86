#!/usr/bin/env python3
"""Runs the program's measuring commands on a small mesh and draws what they wrote: plot_test.py GEOLLOYD."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = ""
SCRIPT = Path(__file__).parents[2] / "bench" / "plot.py"
PNG = b"\x89PNG\r\n\x1a\n"


def run(*command: str | Path) -> subprocess.CompletedProcess:
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)


class Plots(unittest.TestCase):
    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.mesh = self.folder / "torus.ply"
        self.assertEqual(run(PROGRAM, "generate", "torus", "-t", "500", "-o", self.mesh).returncode, 0)

    def measure(self, command: str, *options: str) -> list[Path]:
        """The pictures that a command drew."""
        done = run(PROGRAM, command, self.mesh, "-o", self.folder, *options)
        if "matplotlib is missing" in done.stderr:
            self.skipTest("matplotlib is missing")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        pictures = [Path(line) for line in done.stdout.splitlines() if line.endswith(".png")]
        for picture in pictures:
            data = picture.read_bytes()
            self.assertTrue(data.startswith(PNG) and len(data) > 20_000, picture)
        return pictures

    def names(self, pictures: list[Path]) -> list[str]:
        return [picture.name for picture in pictures]

    def test_compare(self) -> None:
        pictures = self.measure("compare", "-k", "5", "--threads", "1,2,3", "--turns", "1")
        self.assertEqual(self.names(pictures), ["compare.png", "compare-dark.png"])

    def test_profile_without_greedy_phase(self) -> None:
        pictures = self.measure("profile", "-k", "5", "--greedy", "off")
        self.assertEqual(self.names(pictures), ["profile.png", "profile-dark.png"])

    def test_batch_with_a_ladder(self) -> None:
        pictures = self.measure("batch", "-k", "2..8", "--batches", "1", "--graphs", "vertex,mixed")
        self.assertEqual(self.names(pictures), ["batch.png", "batch-dark.png", "batch-ladder.png",
                                                "batch-ladder-dark.png"])

    def test_remesh(self) -> None:
        report = self.folder / "remesh.json"
        done = run(PROGRAM, "remesh", self.mesh, "--vertices", "100", "-o", self.folder / "remesh.ply", "--report",
                   report)
        self.assertEqual(done.returncode, 0, done.stderr)
        drawn = run(sys.executable, SCRIPT, report)
        if drawn.returncode == 3:
            self.skipTest("matplotlib is missing")
        self.assertEqual((drawn.returncode, drawn.stderr), (0, ""))
        for name in ("remesh.png", "remesh-dark.png"):
            self.assertGreater((self.folder / name).stat().st_size, 20_000)
        result = json.loads(report.read_text())
        self.assert_refused(json.dumps({**result, "trace": []}), "nothing to draw")

    def assert_refused(self, text: str, complaint: str) -> None:
        path = self.folder / "bad.json"
        path.write_text(text)
        done = run(sys.executable, SCRIPT, path)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn(complaint, done.stderr)

    def test_refuses_what_is_no_result(self) -> None:
        self.assertEqual(run(sys.executable, SCRIPT, self.folder / "none.json").returncode, 2)
        self.assert_refused("{", "is not JSON")
        self.assert_refused("[]", "not an object")
        self.assert_refused('{"command": "compare"}', "program is missing")
        run(PROGRAM, "compare", self.mesh, "-k", "5", "--turns", "1", "-o", self.folder, "--no-plot")
        result = json.loads((self.folder / "compare.json").read_text())
        self.assert_refused(json.dumps({**result, "runs": []}), "nothing to draw")
        result["runs"][0]["seconds"]["median"] = "long"
        self.assert_refused(json.dumps(result), "runs[0].seconds.median")


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
