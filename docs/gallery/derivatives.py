# %% [markdown]
# # Which heights matter?
#
# A surface with dimples under a given approach. The gradient of the load by every height comes from one more linear solve; it is
# not 0 only where the bodies touch. Its product with a change of the surface predicts the new load without another solve: here
# the depth of the dimples changes.

# %%
import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc

n, pitch = 128, 1e-6
x = np.arange(n) * pitch
wave = np.cos(2 * np.pi * x[:, None] / 32e-6) * np.cos(2 * np.pi * x / 32e-6)
rough = rc.surface.spectral(
    (n, n), pitch=pitch, rms_height=0.05e-6, hurst=0.8, q_rolloff=2 * np.pi / 16e-6, q_high=2 * np.pi / 4e-6, seed=1
).heights


def gap(depth):
    return 0.5e-6 - rough + depth * (1 - wave) / 2  # counted from a fixed plane


system = rc.HalfSpace((n, n), pitch=pitch, modulus=70e9, boundary="periodic")
depth = 0.3e-6
with rc.Contact(system) as contact:
    result = contact.solve(undeformed_gap=gap(depth), approach=0.55e-6)
    gradient = contact.gradient()
slope = np.sum(gradient.gap * (1 - wave) / 2)  # d load / d depth

# %%
depths = np.linspace(0.27e-6, 0.33e-6, 9)
loads = [rc.solve(undeformed_gap=gap(d), system=system, approach=0.55e-6).load for d in depths]
figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.8))
image = left.imshow(np.ma.masked_equal(-gradient.gap, 0) / 1e3, cmap="magma", extent=(0, n, n, 0), interpolation="nearest")
left.set_facecolor("0.3")
left.set(xlabel="x [µm]", ylabel="y [µm]", title="derivative of the load by heights")
figure.colorbar(image, ax=left, label="mN/µm")
right.plot(depths * 1e6, loads, "o", label="solved")
right.plot(depths * 1e6, result.load + slope * (depths - depth), label="from the gradient at 0.3 µm")
right.set(xlabel="depth of the dimples [µm]", ylabel="load [N]")
right.legend()
figure.tight_layout()
