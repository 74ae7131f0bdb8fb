"""pressures.py HEIGHTS NX NY PITCH MODULUS APPROACH PRESSURES: reads raw doubles, presses, writes raw doubles."""
import sys

import numpy as np
import roughcontact as rc

heights, nx, ny, pitch, modulus, approach, pressures = sys.argv[1:]
z = np.fromfile(heights).reshape(int(ny), int(nx))
rc.solve(z, pitch=float(pitch), modulus=float(modulus), boundary="free", approach=float(approach)).pressure.tofile(pressures)
