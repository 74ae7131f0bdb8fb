# %% [markdown]
# # A coated half-space
#
# A ball is pressed onto an elastic layer of thickness t that is bonded to a half-space of another material, always by the same
# approach; a is the radius of contact on the bare half-space.

# %%
import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc


n, pitch = 256, 1 / 16  # a = 1, the periods are 16
x = (np.arange(n) - n / 2) * pitch
ball = -(x[:, None] ** 2 + x**2) / (2 * 10)
how = dict(pitch=pitch, modulus=1, approach=0.1, boundary="periodic")
bare = rc.solve(ball, **how)


def press(ratio, thickness):  # ratio: E* of the layer over that of the half-space
    layer = {"layer.thickness": thickness, "layer.modulus": ratio}
    return rc.solve(ball, kernel="layer", options=layer, **how)


# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.8))
thicknesses = np.geomspace(0.01, 10, 13)
for ratio, style in ((10, "o-"), (2, "s--"), (0.5, "^:"), (0.1, "D-.")):
    loads = [press(ratio, t).load / bare.load for t in thicknesses]
    left.loglog(thicknesses, loads, style, markersize=4, label=f"E₁*/E₂* = {ratio}")
left.set(xlabel="thickness / a", ylabel="load / load on the bare half-space")
left.legend()
for name, result, style in (
    ("bare", bare, "-"),
    ("10 times stiffer layer, t = a", press(10, 1), "--"),
    ("10 times softer layer, t = a", press(0.1, 1), ":"),
):
    right.plot(x, result.pressure[n // 2] / bare.pressure.max(), style, label=name)
right.set(xlabel="x / a", ylabel="pressure / largest of the bare half-space", xlim=(-2, 2), ylim=(0, 7.5))
right.legend(loc="upper right")
figure.tight_layout()
