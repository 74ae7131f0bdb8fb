"""A rough surface from Python: made, judged, pressed and looked at.

Runs from the top to the bottom (python3 docs/python_tour.py [FOLDER] writes the pictures) or cell by cell in an editor.
"""

# %% Make a surface: periodic, self-affine, 256 x 256 points of 0.5 um
import pathlib
import sys

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
modulus = 70e9  # E*, Pa
surface = rc.surface.spectral(
    (256, 256), pitch=0.5e-6, rms_height=0.1e-6, hurst=0.8, q_rolloff=2 * np.pi / 32e-6, q_high=2 * np.pi / 4e-6, seed=4
)


def save(figure, name):
    figure.tight_layout()
    figure.savefig(folder / f"python-{name}.png", dpi=70)
    plt.close(figure)


# %% What is it like?
statistics, law = rc.surface.analyze(surface), rc.surface.power_law(surface)
print(
    f"rms height {statistics.rms_height * 1e6:.3f} um, rms slope {statistics.rms_slope:.3f}, "
    f"H = {law.hurst:.2f} +- {law.hurst_error:.2f}"
)
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8))
rc.plot.heights(surface, ax=left)
rc.plot.spectrum(rc.surface.psd(surface), law, ax=right)
save(figure, "surface")

# %% Press it: by a mean pressure of a tenth of E* times the rms slope
area = surface.heights.size * 0.5e-6**2
load = 0.1 * modulus * statistics.rms_slope * area
result = rc.solve(surface, modulus=modulus, load=load)
print(result)
print(
    f"{result.contact_area / area:.1%} of the area touches, proven: between {result.area_lower / area:.1%} and "
    f"{result.area_upper / area:.1%}; corrected for the grid {result.corrected_area / area:.1%}"
)
figure, ax = plt.subplots(figsize=(4.6, 3.8))
rc.plot.pressure(result, ax=ax)
save(figure, "pressure")

# %% The patches it touches on
patches = result.find_patches()
print(
    f"{len(patches)} patches, half of the load on "
    f"{np.searchsorted(np.cumsum(np.sort(patches.load)[::-1]), load / 2) + 1} of them"
)
figure, ax = plt.subplots(figsize=(4.2, 3.8))
rc.plot.patches(result, patches, ax=ax)
save(figure, "patches")

# %% Pressures: their distribution begins at zero, where the contact ends
figure, ax = plt.subplots(figsize=(4.6, 3.4))
rc.plot.histogram(result.histogram(60), ax=ax)
save(figure, "histogram")

# %% Load it and let go again: elastic contact comes back the way it went
loads = load * np.array([0.01, 0.05, 0.1, 0.2, 0.4, 0.7, 1.0, 0.7, 0.4, 0.2, 0.1])
history = rc.history(surface, modulus=modulus, load=loads, stiffness=True)
print(f"{history.products.sum()} products with H for {history.completed} steps")
figure, ax = plt.subplots(figsize=(4.6, 3.4))
rc.plot.history(history, ax=ax)
save(figure, "history")

# %% Ten surfaces of the same kind, two at a time
same_kind = [
    rc.surface.spectral((128, 128), pitch=1e-6, rms_height=0.1e-6, hurst=0.8, q_rolloff=2 * np.pi / 32e-6, seed=k)
    for k in range(10)
]
study = rc.batch(same_kind, modulus=modulus, load=[load / 4, load], options={"threads": 2})
share = study.contact_area / area
print(f"contact area {share[:, 1].mean():.1%} +- {share[:, 1].std():.1%} at the full load")
