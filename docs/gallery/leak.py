# %% [markdown]
# # Does it leak?
#
# A rough seal is pressed until no path through its gap is left. Fluid flows through the gap g in proportion to g³ (Reynolds). The
# package reynoldsflow solves this along y for the gaps of the library. Bruggeman's effective medium estimates it from the
# distribution of the gaps alone, and closes when half of the area is in contact; the real gap closes near 0.41 (Wang & Müser 2020),
# with its last channel.

# %%
import matplotlib.pyplot as plt
import numpy as np
from reynoldsflow import transport

import roughcontact as rc

n = 256
surface = rc.surface.spectral(
    (n, n), pitch=1e-6, rms_slope=0.1, hurst=0.8, q_rolloff=2 * np.pi / 64e-6, q_high=2 * np.pi / 8e-6, fixed_amplitudes=True, seed=4
)
pressures = np.geomspace(0.01, 0.3, 12) * 0.1  # over E*


def bruggeman(gap):
    """The conductivity K at which the mean of (g³ - K)/(g³ + K) is 0."""
    k = gap.ravel() ** 3
    low, high = 1e-12 * k.max(), k.max()
    for _ in range(100):
        middle = np.sqrt(low * high)
        low, high = (middle, high) if ((k - middle) / (k + middle)).mean() > 0 else (low, middle)
    return middle


area, flow, estimate = [], [], []
with rc.Contact(rc.HalfSpace((n, n), pitch=1e-6, modulus=1, boundary="periodic"), tol=1e-6) as contact:
    for pressure in pressures:
        result = contact.solve(surface, load=pressure * (n * 1e-6) ** 2, want_gap=True)
        gap = np.where(result.pressure > 0, 0, np.maximum(result.gap, 0)) / surface.heights.std()
        open_gap, _, flux = transport.solve_fluid_problem(gap, boundary_mode="periodic")
        area.append(result.corrected_area / (n * 1e-6) ** 2)
        flow.append(0 if flux is None else transport.compute_total_flux(open_gap, flux, n, "periodic")[0])
        estimate.append(bruggeman(gap))
        if "y" in result.gap_crosses:
            last = gap

# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 4))
image = left.imshow(np.ma.masked_equal(last, 0), cmap="viridis", extent=(0, n, n, 0))
left.set_facecolor("0.2")
left.set(title="the last gap that crosses / rms height", xlabel="x [µm]", ylabel="y [µm]")
figure.colorbar(image, ax=left)
right.semilogy(area, np.where(np.array(flow) > 0, flow, np.nan), "o-", label="Reynolds, by reynoldsflow")
right.semilogy(area, np.where(np.array(estimate) > 1e-11, estimate, np.nan), "--", label="Bruggeman's effective medium")
right.axvline(0.415, color="0.6", label="0.415, Wang & Müser 2020")
right.set(xlabel="contact area / nominal area", ylabel="mean conductivity / (rms height)³", ylim=(1e-8, 30))
right.legend()
figure.tight_layout()
