"""What the tests of the Python package share."""
import json
import os
import subprocess

import pytest

import geolloyd


class Program:
    """The program geolloyd, in a folder of the test."""

    def __init__(self, folder):
        self.folder = folder

    def run(self, *arguments):
        program = os.environ["GEOLLOYD_PROGRAM"]
        done = subprocess.run([program, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def report(self, name):
        return json.loads((self.folder / name).read_text())


@pytest.fixture
def program(tmp_path):
    return Program(tmp_path)


@pytest.fixture(scope="session")
def creature():
    return geolloyd.generate("creature", 6000)


@pytest.fixture(scope="session")
def torus():
    return geolloyd.generate("torus", 2000)
