"""Which library is loaded, and what is said where there is none. Each in a Python of its own."""

import os
import shutil
import subprocess
import sys

import pytest

import roughcontact as rc
from roughcontact import _library


def python(code, folder, **environment):
    inherited = {name: value for name, value in os.environ.items() if name not in ("ROUGHCONTACT_LIBRARY", "RC_PLUGIN_PATH")}
    return subprocess.run(
        [sys.executable, "-c", code], cwd=folder, env={**inherited, **environment}, capture_output=True, text=True
    )


SHOW = "import roughcontact as rc; print(rc.library_file())"


def test_the_variable_comes_first(tmp_path):
    copy = tmp_path / "libroughcontact.so.0"
    shutil.copy(rc.library_file(), copy)
    ran = python(SHOW, tmp_path, ROUGHCONTACT_LIBRARY=str(copy))
    assert ran.stdout.strip() == str(copy), ran.stderr
    assert python(SHOW, tmp_path, ROUGHCONTACT_LIBRARY=copy.name).stdout.strip() == str(copy)  # here, not on the loader's path


def test_the_loader_finds_the_systems_by_its_name(tmp_path):
    inside = os.path.join(os.path.dirname(rc.__file__), "lib")
    shutil.copy(rc.library_file(), tmp_path / "libroughcontact.so.0")
    ran = python(SHOW, tmp_path, LD_LIBRARY_PATH=str(tmp_path))
    expected = inside if os.path.isdir(inside) else str(tmp_path)  # a wheel's own library comes before the system's
    assert os.path.dirname(ran.stdout.strip()) == expected, ran.stderr


def test_every_system_has_its_own_name_for_a_library():
    names = [_library._name_of("roughcontact-surface", system) for system in ("linux", "win32", "darwin")]
    assert names == ["libroughcontact-surface.so.0", "libroughcontact-surface-0.dll", "libroughcontact-surface.0.dylib"]


def _libc():
    with open("/proc/self/maps") as maps:
        return next(line.split()[-1] for line in maps if "/libc.so" in line or "/libc-" in line)


@pytest.mark.parametrize(
    "library, says",
    [
        ("/nowhere/lib.so", ("LibraryNotFoundError", "/nowhere/lib.so", "ROUGHCONTACT_LIBRARY")),
        (_libc(), ("has no function rc_", "install both from one source")),
    ],
)
def test_a_file_that_is_no_library_of_ours(library, says, tmp_path):
    code = "import roughcontact as rc\ntry: rc.version()\nexcept ImportError as e: print(type(e).__name__, e)"
    ran = python(code, tmp_path, ROUGHCONTACT_LIBRARY=library)
    assert all(words in ran.stdout for words in says), ran


def test_solving_loads_neither_the_surface_library_nor_matplotlib(tmp_path):
    code = (
        "import roughcontact as rc, sys; rc.solve(undeformed_gap=[[0.0, 1.0]], pitch=1, modulus=1, boundary='free', approach=0.5); "
        "print('surface' in open('/proc/self/maps').read(), 'matplotlib' in sys.modules)"
    )
    ran = python(code, tmp_path, ROUGHCONTACT_LIBRARY=rc.library_file())
    assert ran.stdout.split() == ["False", "False"], ran.stderr


def test_a_default_wheel_names_the_distribution_that_has_the_rest(tmp_path):
    """The package as its wheel has it: no library under the GPL inside, none of the system's."""
    copy = tmp_path / "roughcontact"
    shutil.copytree(
        os.path.dirname(rc.__file__), copy, ignore=shutil.ignore_patterns("lib", "__pycache__", "library_folder.txt")
    )
    (copy / "lib").mkdir()
    for name in ("", "-formats", "-request"):
        file = f"libroughcontact{name}.so.0"
        shutil.copy(os.path.join(os.path.dirname(rc.library_file()), file), copy / "lib" / file)
    code = """import roughcontact as rc
print(rc.example())
for call in (lambda: rc.surface.noise((4, 4)), lambda: rc.flow([[1, 1]], pitch=1, viscosity=1, pressure_drop=1),
             lambda: rc.solve(rc.example(), E=1e9, nu=0.3, load=1e-3, backend="split")):
    try: call()
    except rc.RoughContactError as error: print(type(error).__name__, "pip install roughcontact-gpl" in str(error))
"""
    ran = python(code, tmp_path, PYTHONPATH=str(tmp_path), PYTHONDONTWRITEBYTECODE="1")
    said = ["LibraryNotFoundError True", "LibraryNotFoundError True", "NoBackendError True"]
    assert ran.stdout.splitlines()[1:] == said, ran.stdout + ran.stderr
