# %% [markdown]
# # Rough contact area against load
#
# Five self-affine surfaces are pressed until nearly all of them touches. Pressures are given over E* times the rms slope h',
# where theories give one curve for all surfaces: Persson (2001) A/A0 = erf(√2 p/(E* h')), Bush, Gibson & Thomas (1975) A/A0 =
# √(2π) p/(E* h') at light loads.

# %%
import math

import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc

pressures = np.geomspace(0.005, 1.5, 16)  # over E* h'
shares = []
for seed in range(5):
    surface = rc.surface.spectral(
        (256, 256), pitch=1, rms_slope=1, hurst=0.8, q_rolloff=2 * np.pi / 64, q_high=2 * np.pi / 8, seed=seed
    )
    path = rc.history(surface, modulus=1, pressure=pressures, keep_pressure=True, tol=1e-6)
    shares.append([rc.analysis.area(p, pitch=1, periodic=True).corrected_area / 256**2 for p in path.pressure])
shares = np.array(shares)

# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
persson = [math.erf(math.sqrt(2) * p) for p in pressures]
left.semilogx(pressures, persson, label="Persson")
left.semilogx(pressures, shares.T, ".", color="tab:red")
left.semilogx([], [], ".", color="tab:red", label="five surfaces")
left.set(xlabel="mean pressure / (E* h')", ylabel="share of the area in contact")
left.legend()
right.semilogx(pressures, persson / pressures, label="Persson")
right.semilogx(pressures, (shares / pressures).T, ".", color="tab:red")
right.axhline(math.sqrt(2 * np.pi), color="tab:green", label="Bush, Gibson & Thomas")
right.set(xlabel="mean pressure / (E* h')", ylabel="share / (p / (E* h'))", ylim=(0, 3))
right.legend()
figure.tight_layout()
