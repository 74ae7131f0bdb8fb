"""test_four_c.py PROGRAM INTEGRATION FOLDER: a law and the file of integrations/4c, as a user places them; then the program, which calls
them as 4C does."""

import pathlib
import shutil
import subprocess
import sys

import roughcontact as rc

program, integration, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
folder.mkdir(exist_ok=True)
surface = rc.surface.spectral((48, 48), pitch=1e-6, rms_height=2e-7, hurst=0.8, seed=1)
rc.law(surface, modulus=115e9, boundary="periodic", pressure=(1e6, 5e8), tolerance=1e-2).save(folder / "steel.law")
shutil.copyfile(integration / "rough_law.py", folder / "steel.py")
sys.exit(subprocess.run([program, str(folder)], check=False).returncode)
