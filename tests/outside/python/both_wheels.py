"""both_wheels.py: roughcontact and roughcontact-gpl, installed in one environment, are one package with one libroughcontact."""

import importlib.metadata
import pathlib

import roughcontact as rc

package = pathlib.Path(rc.__file__).parent
assert pathlib.Path(rc.library_file()).parent == package / "lib", rc.library_file()
for name in ("roughcontact", "roughcontact-gpl"):
    assert importlib.metadata.version(name) == rc.__version__ == ".".join(map(str, rc.version()))
assert "GPL" not in importlib.metadata.metadata("roughcontact")["License-Expression"]
assert importlib.metadata.metadata("roughcontact-gpl")["License-Expression"] == "GPL-3.0-or-later"
names = {each.name: each.origin for each in rc.backends()}
assert {"dense", "fft", "split", "cholmod"} <= names.keys(), names
assert all(origin == "built-in" or origin.startswith(str(package)) for origin in names.values()), names
rc.surface.noise((4, 4)), rc.formats(), rc.flow([[1, 1]], pitch=1, viscosity=1, pressure_drop=1)
OURS = ("fftw", "gsl", "cholmod", "zip", "pugixml", "roughcontact.")
with open("/proc/self/maps") as maps:
    loaded = {line.split()[-1] for line in maps if any(f"lib{name}" in line for name in OURS)}
assert loaded and sum("libroughcontact." in file for file in loaded) == 1, loaded
if list(package.parent.glob("roughcontact_gpl.libs")):  # a wheel for other machines, which brings its libraries
    assert all(file.startswith(str(package.parent)) for file in loaded), loaded
assert (package / "py.typed").exists() and not list(package.rglob("*.h")) and not list(package.rglob("*.a"))
for file in package.rglob("*.so*"):
    assert b"/tmp/" not in file.read_bytes(), f"{file} names a temporary folder"
print("installed, with", ", ".join(names))
