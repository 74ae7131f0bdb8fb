# %% [markdown]
# # Free or periodic
#
# The same rough map under the same mean pressures: as a sample of a larger surface (periodic), and as a body that ends at the map's
# edges (free). A free map is a punch: pressures rise towards its edges, and its stiffness cannot exceed that of a flat square of its
# size.

# %%
import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc

n, pitch = 128, 0.5e-6
surface = rc.surface.spectral(
    (n, n), pitch=pitch, rms_slope=0.08, hurst=0.8, q_rolloff=2 * np.pi / 8e-6, q_high=2 * np.pi / 2e-6, seed=6
)
pressures = np.geomspace(3e7, 1.5e9, 9)
steps = {
    boundary: rc.history(
        surface, modulus=70e9, pressure=pressures, boundary=boundary, stiffness=True, keep_pressure=True, tol=1e-6
    )
    for boundary in ("periodic", "free")
}
punch = rc.solve(surface, modulus=70e9, pressure=pressures[0], boundary="free", stiffness=1).punch_stiffness

# %%
figure, axes = plt.subplots(1, 3, figsize=(9.5, 3.4), layout="constrained", gridspec_kw={"width_ratios": (1, 1, 1.1)})
side = n * pitch * 1e6
for ax, style, (boundary, found) in zip(axes, ("o-", "s--"), steps.items()):
    pressure = found.pressure[-1]
    image = ax.imshow(
        np.ma.masked_equal(pressure, 0) / 1e9, cmap="inferno", vmin=0, vmax=12, extent=(0, side, side, 0), interpolation="nearest"
    )
    ax.set_facecolor("0.25")
    ax.set(
        title=f"{boundary}: {np.mean(pressure > 0):.1%} touch,\napproach {found.approach[-1] * 1e6:.2f} µm", xlabel="x [µm]", ylabel="y [µm]"
    )
    axes[2].loglog(pressures / 1e6, found.stiffness / 1e6, style, markersize=4, label=boundary)
figure.colorbar(image, ax=axes[:2], label="pressure [GPa]", shrink=0.75)
free = steps["free"].stiffness
axes[2].loglog(pressures / 1e6, 1 / (1 / free - 1 / punch) / 1e6, "k+", label="free, without the punch")
axes[2].axhline(punch / 1e6, color="0.5", ls=":", label="flat square of this size")
axes[2].set(xlabel="mean pressure [MPa]", ylabel="stiffness dW/dd [MN/m]", ylim=(2, 5000))
axes[2].legend(fontsize="small", loc="upper left")
