# %% [markdown]
# # From a measured map to an answer
#
# A map as an instrument writes it: tilted, with missing points, in a file that does not say its pitch. It is read, levelled,
# filled, judged and pressed to three loads.

# %%
import pathlib
import tempfile

import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc

# What stands for the instrument.
made = rc.surface.spectral(
    (192, 192), pitch=0.2, rms_height=0.05, hurst=0.8, q_rolloff=2 * np.pi / 10, q_high=2 * np.pi / 1, seed=3
)
heights = made.heights + 0.02 * np.arange(192) * 0.2
heights[60:64, 100:130] = np.nan
file = pathlib.Path(tempfile.mkdtemp()) / "map.npy"
np.save(file, heights)

# %%
measured = rc.read(file, pitch=0.2, unit="um")
print(measured, measured.assumed)
level = measured.without("plane").filled()
statistics = rc.surface.analyze(level)
print(f"Sq {statistics.rms_height * 1e9:.1f} nm, rms slope {statistics.rms_slope:.3f}")

# %%
path = rc.history(level, boundary="periodic", E=3e9, nu=0.4, pressure=[2e6, 5e6, 10e6, 20e6, 40e6])
result = rc.solve(level, boundary="periodic", E=3e9, nu=0.4, pressure=20e6)
print(result)

figure, axes = plt.subplots(2, 2, figsize=(9.5, 7))
rc.plot.heights(level, ax=axes[0, 0])
rc.plot.pressure(result, ax=axes[0, 1])
rc.plot.history(path, ax=axes[1, 0])
rc.plot.histogram(result.histogram(60), ax=axes[1, 1])
figure.tight_layout()
