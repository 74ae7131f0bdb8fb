# %% [markdown]
# # A hardness
#
# The same surface under the same load, elastic and with three hardnesses H. The plasticity index E* h'/H says how much of it
# yields. Where the pressure has reached H the load goes to other summits, and the area grows.

# %%
import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc

slope = 0.1
surface = rc.surface.spectral(
    (256, 256), pitch=1 / 8, rms_slope=slope, hurst=0.8, q_rolloff=2 * np.pi / 8, q_high=2 * np.pi, seed=1
)
answers = {"elastic": rc.solve(surface, modulus=1, pressure=0.05 * slope)}
for index in (1, 2, 5):
    answers[f"E* h'/H = {index}"] = rc.solve(surface, modulus=1, pressure=0.05 * slope, hardness=slope / index)

# %%
figure, axes = plt.subplots(2, 2, figsize=(8, 7), sharex=True, sharey=True, layout="constrained")
for ax, (name, result) in zip(axes.flat, answers.items()):
    shown = np.ma.masked_equal(result.pressure, 0) / slope
    image = ax.imshow(shown, cmap="inferno", vmin=0, vmax=1.5, extent=(0, 32, 32, 0), interpolation="nearest")
    ax.set_facecolor("0.25")
    ax.set(
        title=f"{name}\n{result.contacts / result.points:.1%} touches, {result.capped / max(result.contacts, 1):.0%} of it yields"
    )
figure.colorbar(image, ax=axes, label="pressure / (E* h')", shrink=0.85)
