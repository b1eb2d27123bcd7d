"""Makes a wheel of the package asos with CMake (PEP 517). Needs the standard library alone."""

from __future__ import annotations

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "release"  # of the preset `release`, which ./run uses, too


def version() -> str:
    """Return the version that CMakeLists.txt states."""
    found = re.search(r"project\(asos VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())
    if not found:
        raise RuntimeError("CMakeLists.txt states no version")
    return found.group(1)


def build_package() -> pathlib.Path:
    """Build the compiled module. Return the folder of the package."""
    # CMake asks Debian's Python for numpy, which the paths of pip's own environment would hide.
    clean = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "VIRTUAL_ENV"))}
    for step in (["--preset", "release"], ["--build", "--preset", "release", "-t", "asos_python"]):
        subprocess.run(["cmake", *step], cwd=ROOT, check=True, stdout=sys.stderr, env=clean)
    return BUILD / "python" / "asos"


def metadata() -> str:
    """Return the text of METADATA."""
    return (
        f"Metadata-Version: 2.1\nName: asos\nVersion: {version()}\n"
        "Summary: Antialiasing by adaptive supersampling in object space\n"
        "License: MIT\nRequires-Python: >=3.9\nRequires-Dist: numpy\n"
    )


def record_of(name: str, data: bytes) -> str:
    """Return a file's line of RECORD."""
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}\n"


def write_wheel(package: pathlib.Path, folder: pathlib.Path) -> str:
    """Write the wheel of a built package into a folder. Return the wheel's name."""
    compiled = list(package.glob("_asos.*.so"))
    if len(compiled) != 1:
        raise RuntimeError(f"{package} has no compiled module: are pybind11-dev and numpy missing?")
    abi = f"cp{sys.version_info.major}{sys.version_info.minor}"
    if abi.replace("cp", "cpython-") not in compiled[0].name:
        raise RuntimeError(f"{compiled[0].name} is for another Python: use Debian's python3")
    tag = f"{abi}-{abi}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"
    info = f"asos-{version()}.dist-info"
    files = {f"asos/{p.name}": p.read_bytes() for p in sorted(package.iterdir()) if p.is_file()}
    files[f"{info}/METADATA"] = metadata().encode()
    files[f"{info}/WHEEL"] = (
        f"Wheel-Version: 1.0\nGenerator: asos_build\nRoot-Is-Purelib: false\nTag: {tag}\n"
    ).encode()
    record = "".join(record_of(name, data) for name, data in files.items())
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    wheel = f"asos-{version()}-{tag}.whl"
    with zipfile.ZipFile(folder / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            archive.writestr(name, data)
    return wheel


# The hooks of PEP 517.
def prepare_metadata_for_build_wheel(metadata_directory, _config_settings=None):
    """Write METADATA, which needs no build."""
    info = pathlib.Path(metadata_directory, f"asos-{version()}.dist-info")
    info.mkdir()
    (info / "METADATA").write_text(metadata())
    return info.name


def build_wheel(wheel_directory, _config_settings=None, _metadata_directory=None):
    """Build the package and write its wheel."""
    return write_wheel(build_package(), pathlib.Path(wheel_directory))


def build_sdist(_sdist_directory, _config_settings=None):
    """Refuse: a clone of the project is its source distribution."""
    raise RuntimeError("clone the project instead of an sdist")


if __name__ == "__main__":
    # asos_build.py PACKAGE FOLDER: the wheel of a package that is built already.
    print(os.path.join(sys.argv[2], write_wheel(*map(pathlib.Path, sys.argv[1:3]))))
