"""bare.py FILE.x3p BACKEND...: what packaging/bare.sh runs in a bare system. Each library of the wheel is loaded and used, and each backend."""

import importlib.metadata
import pathlib
import sys

import numpy as np

import roughcontact as rc

package = pathlib.Path(rc.__file__).parent
assert pathlib.Path(rc.library_file()).parent == package / "lib", rc.library_file()

surface = rc.surface.spectral((64, 64), pitch=1e-6, rms_height=1e-7, seed=2)  # by GSL
loads = []
for backend in sys.argv[2:]:  # FFTW, SuiteSparse
    solver = "nnls" if backend == "cholmod" else "auto"
    result = rc.solve(surface.heights, pitch=1e-6, boundary="free", E=70e9, nu=0.33, approach=5e-8, backend=backend, solver=solver)
    assert result.certified and result.backend == backend, result
    loads.append(result.load)
assert np.ptp(loads) < 1e-6 * loads[0], loads

read = rc.read(sys.argv[1], format="x3p")  # by libzip and pugixml
assert read.heights.size > 1 and np.isfinite(read.heights).any(), read
history = rc.history(surface, modulus=78e9, pressure=[1e6, 2e6])
assert len(history) == 2 and "img" in result._repr_html_()
licences = {}
for name in ("roughcontact", "roughcontact-gpl"):
    licences[name] = {file.name for file in importlib.metadata.files(name) or () if "licenses" in file.parts}
assert {"LICENSE", "libeigen3-dev"} <= licences["roughcontact"] and "GPL-3" not in licences["roughcontact"], licences
assert {"libgsl27", "libfftw3-double3", "GPL-3"} <= licences["roughcontact-gpl"], licences
print(f"load {result.load:.4f} N by", ", ".join(sorted(each.name for each in rc.backends())), f"- {sum(map(len, licences.values()))} texts of licences")
