"""Makes a wheel of this package: CMake builds the module, and what is installed is zipped (PEP 517).

Nothing is fetched: tools/install-dependencies --python installs what is needed. The build stays in the
project's build/python, so the next one is faster.
"""
import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parent.parent


def version():
    return re.search(r"project\(geolloyd VERSION ([\d.]+)", (PROJECT / "CMakeLists.txt").read_text())[1]


def metadata():
    # The fields that pyproject.toml has as name = "value".
    fields = dict(re.findall(r'^(\S+) = "(.*)"$', (HERE / "pyproject.toml").read_text(), re.M))
    return (f"Metadata-Version: 2.1\nName: geolloyd\nVersion: {version()}\nSummary: {fields['description']}\n"
            f"Requires-Python: {fields['requires-python']}\nRequires-Dist: numpy\nLicense: MIT\n"
            f"Description-Content-Type: text/markdown\n\n{(HERE / 'README.md').read_text()}")


def build(prefix):
    """Installs the package into the folder."""
    folder = PROJECT / "build" / "python"
    configure = ["cmake", "-S", PROJECT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                 "-DCMAKE_UNITY_BUILD=ON", "-DGEOLLOYD_BUILD_PYTHON=ON", "-DGEOLLOYD_BUILD_TESTS=OFF",
                 "-DGEOLLOYD_BUILD_BENCH=OFF", f"-DPython3_EXECUTABLE={sys.executable}", "-DGEOLLOYD_PYTHON_DIR=."]
    subprocess.run(configure, check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "_core"], check=True)
    subprocess.run(["cmake", "--install", folder, "--component", "python", "--prefix", prefix, "--strip"], check=True)


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    return f"{python}-{python}-{platform}"


def record_line(name, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    facts = f"geolloyd-{version()}.dist-info"
    contents = {}
    with tempfile.TemporaryDirectory() as prefix:
        build(prefix)
        for path in sorted(pathlib.Path(prefix).rglob("*")):
            if path.is_file():
                contents[path.relative_to(prefix).as_posix()] = path.read_bytes()
    contents[f"{facts}/METADATA"] = metadata().encode()
    contents[f"{facts}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: geolloyd\nRoot-Is-Purelib: false\nTag: {tag()}\n".encode()
    record = "".join(record_line(name, content) for name, content in contents.items())
    contents[f"{facts}/RECORD"] = f"{record}{facts}/RECORD,,\n".encode()
    name = f"geolloyd-{version()}-{tag()}.whl"
    with zipfile.ZipFile(os.path.join(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in contents.items():
            wheel.writestr(path, content)
    return name


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("geolloyd is built from a clone of its repository: pip install ./tools/python")
