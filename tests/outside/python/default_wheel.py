"""default_wheel.py SOURCE: the installed wheel `roughcontact` without roughcontact-gpl runs README's program, histories, laws and files;
what needs a library under the GPL names the distribution that has it."""

import pathlib
import re
import subprocess
import sys
import tempfile

import numpy as np

import roughcontact as rc

readme = pathlib.Path(sys.argv[1], "README.md").read_text(encoding="utf-8")
program, printed = re.search(r"```python\n(.*?)```\n\n```sh\n.*?```\n\n```text\n(.*?)```", readme, re.S).groups()
ran = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
assert ran.stdout == printed, ran

surface = rc.example()
assert {each.name for each in rc.backends()} == {"callback", "dense", "fft"}
history = rc.history(surface, E=3e9, nu=0.4, pressure=[1e6, 2e6], stiffness=True)
assert len(history) == 2 and all(history.stiffness > 0)
assert rc.law(surface, modulus=3e9, pressure=(1e6, 10e6), tol=1e-2).slope(5e-8) > 0
with tempfile.TemporaryDirectory() as folder:
    surface.save(f"{folder}/map.gsf")
    assert np.array_equal(rc.read(f"{folder}/map.gsf").heights, surface.heights)

try:  # what needs a library under the GPL; test_library.py has the other calls
    raise SystemExit(f"this needs no roughcontact-gpl: {rc.surface.noise((4, 4))}")
except rc.LibraryNotFoundError as absent:
    assert "pip install roughcontact-gpl" in str(absent), absent
print("README's program runs by the default wheel; what it lacks is named")
