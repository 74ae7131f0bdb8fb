# %% [markdown]
# # Does it leak?
#
# A rough seal is pressed until no path through its gap is left. The fluid flows from left to right in proportion to g³ (Reynolds):
# near closing all of it passes the critical constriction, the lowest gap on the best path, where the pressure falls. Each flow has an
# interval that is proven, thinner than the line. Bruggeman's effective medium estimates the flow from the distribution of the gaps
# alone, and closes when half of the area is in contact; large surfaces close near 0.42 (Dapp, Lücke, Persson & Müser 2012).

# %%
import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc

n = 256
surface = rc.surface.spectral(
    (n, n),
    pitch=1e-6,
    rms_slope=0.1,
    hurst=0.8,
    q_rolloff=2 * np.pi / 64e-6,
    q_high=2 * np.pi / 8e-6,
    fixed_amplitudes=True,
    seed=4,
)
system = {"modulus": 1.0, "boundary": "periodic"}
closes = rc.closing_pressure(surface, along="x", **system)
pressures = closes.lower * np.append(np.geomspace(0.03, 0.9, 10), [0.97, 0.99])


def bruggeman(gap):
    """The conductivity K at which the mean of (g³ - K)/(g³ + K) is 0."""
    k = gap.ravel() ** 3
    low, high = 1e-12 * k.max(), k.max()
    for _ in range(100):
        middle = np.sqrt(low * high)
        low, high = (middle, high) if ((k - middle) / (k + middle)).mean() > 0 else (low, middle)
    return middle


area, leaks, estimate, cube = [], [], [], surface.heights.std() ** 3
for pressure in pressures:
    result = rc.solve(surface, pressure=pressure, want_gap=True, **system)
    gap = np.where(result.pressure > 0, 0, np.maximum(result.gap, 0))
    leaks.append(result.leak(viscosity=1 / 12, pressure_drop=1, want_potential=True))  # the flow is then the conductivity
    area.append(result.corrected_area / (n * 1e-6) ** 2)
    estimate.append(bruggeman(gap) / cube)

# %%
last = leaks[-3]  # at 90 % of the closing pressure
shown = rc.solve(surface, pressure=pressures[-3], want_gap=True, **system)
gap = np.where(shown.pressure > 0, 0, np.maximum(shown.gap, 0))
slope_y, slope_x = np.gradient(np.where(np.isnan(last.potential), 0, last.potential))
flux_x, flux_y = -(gap**3) * slope_x, -(gap**3) * slope_y
figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 4))
image = left.imshow(last.potential, cmap="viridis", vmin=0, vmax=1, extent=(0, n, n, 0))
left.set_facecolor("0.2")
x = np.arange(n) + 0.5
left.streamplot(x, x, flux_x, flux_y, density=2.2, color="w", linewidth=0.5, arrowsize=0.6)
left.plot(last.constriction_x + 0.5, last.constriction_y + 0.5, "o", color="tab:red", fillstyle="none", markersize=12)
left.set(title="pressure of the fluid / drop, streamlines", xlabel="x [µm]", ylabel="y [µm]", xlim=(0, n), ylim=(n, 0))
figure.colorbar(image, ax=left)
right.semilogy(area, [leak.flow / cube for leak in leaks], "o-", label="flow")
right.fill_between(
    area, [leak.lower / cube for leak in leaks], [leak.upper / cube for leak in leaks], alpha=0.4, label="proven interval"
)
right.semilogy(area, np.where(np.array(estimate) > 1e-11, estimate, np.nan), "--", label="Bruggeman's effective medium")
right.axvline(closes.area_fraction, color="0.6", label="closed")
right.set(xlabel="contact area / nominal area", ylabel="mean conductivity / (rms height)³", ylim=(1e-10, 30))
right.legend()
figure.tight_layout()
