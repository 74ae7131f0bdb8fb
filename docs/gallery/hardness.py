# %% [markdown]
# # A hardness
#
# The same surface under the same load, elastic and with three hardnesses H. The plasticity index E* h'/H says how much of it
# yields. Where the pressure has reached H (red) the load goes to other summits, and the area grows.

# %%
import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc

slope = 0.1
surface = rc.surface.spectral(
    (256, 256), pitch=1 / 8, rms_slope=slope, hurst=0.8, q_rolloff=2 * np.pi / 8, q_high=2 * np.pi, seed=1
)
hardness = {"elastic": None} | {f"E* h'/H = {index}": slope / index for index in (1, 2, 5)}
answers = {name: rc.solve(surface, modulus=1, pressure=0.05 * slope, hardness=H) for name, H in hardness.items()}

# %%
figure, axes = plt.subplots(2, 2, figsize=(8, 7), sharex=True, sharey=True, layout="constrained")
for ax, (name, result) in zip(axes.flat, answers.items()):
    pressed = np.ma.masked_equal(result.pressure, 0)
    yields = np.ma.masked_less(result.pressure, (hardness[name] or np.inf) * (1 - 1e-6))
    extent = (0, 32, 32, 0)
    image = ax.imshow(pressed / pressed.max(), cmap="Blues", vmin=-0.3, vmax=1, extent=extent, interpolation="nearest")
    ax.imshow(yields / yields, cmap="Reds", vmin=0, vmax=1.3, extent=extent, interpolation="nearest")
    ax.set(
        title=f"{name}\n{result.contacts / result.points:.1%} touches, {result.capped / max(result.contacts, 1):.0%} of it yields",
        xlabel="x / shortest wavelength",
    )
bar = figure.colorbar(image, ax=axes, label="pressure / largest pressure (red: at the hardness)", shrink=0.85)
bar.ax.set_ylim(0, 1)
