# %% [markdown]
# # Edges that are free, or repeat
#
# The same rough map under the same mean pressure: as a piece of a large surface (periodic), and as all there is (free). A free
# map is a punch: pressures rise towards its edges, because the half-space around it is not loaded.

# %%
import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc

n = 128
surface = rc.surface.spectral(
    (n, n), pitch=0.5e-6, rms_slope=0.08, hurst=0.8, q_rolloff=2 * np.pi / 8e-6, q_high=2 * np.pi / 2e-6, seed=6
)
answers = {
    boundary: rc.solve(surface.heights, pitch=0.5e-6, modulus=70e9, pressure=1.5e9, boundary=boundary)
    for boundary in ("periodic", "free")
}

# %%
figure, axes = plt.subplots(1, 3, figsize=(12, 3.7), gridspec_kw={"width_ratios": (1, 1, 1.1)})
side = n * 0.5
for ax, (boundary, result) in zip(axes, answers.items()):
    shown = np.ma.masked_equal(result.pressure, 0) / 1e9
    image = ax.imshow(shown, cmap="inferno", vmin=0, vmax=12, extent=(0, side, side, 0), interpolation="nearest")
    ax.set_facecolor("0.25")
    ax.set(
        title=f"{boundary}: {result.contacts / result.points:.1%} touch,\napproach {result.approach * 1e6:.2f} µm",
        xlabel="x [µm]",
        ylabel="y [µm]",
    )
    bands = result.pressure.mean(axis=0).reshape(16, -1).mean(axis=1)
    axes[2].step(np.arange(17) * side / 16, np.r_[bands, bands[-1]] / 1e9, where="post", label=boundary)
figure.colorbar(image, ax=axes[1], label="pressure [GPa]")
axes[2].set(xlabel="x [µm]", ylabel="pressure, mean over strips [GPa]", ylim=(0, None))
axes[2].legend()
figure.tight_layout()
