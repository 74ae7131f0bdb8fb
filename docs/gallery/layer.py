# %% [markdown]
# # A layer, as a function in Python
#
# An elastic layer of thickness t, bonded to a half-space of another material. A wave of pressure with wave number q deflects it
# by f(q t) times what it deflects the half-space (Burmister 1945; O'Sullivan & King 1988). The function goes to
# `Context.add_kernel`. A ball is pressed in under the same approach; a is the radius of contact on the bare half-space.

# %%
import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc


def compliance(ratio, thickness, nu1=0.3, nu2=0.3):
    """E* of the half-space times what a wave of unit pressure deflects; ratio: E* of the layer over that of the half-space."""
    mu = ratio * (1 - nu1) / (1 - nu2)
    lam, kappa = 1 - 4 * (1 - nu1) / (1 + mu * (3 - 4 * nu2)), (mu - 1) / (mu + 3 - 4 * nu1)

    def symbol(qx, qy):
        q = np.maximum(np.hypot(qx, qy), 1e-300)
        s = q * thickness
        e = np.exp(-2 * s)
        f = (1 + 4 * kappa * s * e - lam * kappa * e**2) / (1 - (lam + kappa + 4 * kappa * s**2) * e + lam * kappa * e**2)
        return 2 / q * f / ratio

    return symbol


n, pitch = 256, 1 / 16  # a = 1, the periods are 16
x = (np.arange(n) - n / 2) * pitch
ball = -(x[:, None] ** 2 + x**2) / (2 * 10)
how = dict(pitch=pitch, modulus=1, approach=0.1, boundary="periodic")
bare = rc.solve(ball, **how)


def press(ratio, thickness):
    context = rc.Context()
    context.add_kernel("layer", compliance(ratio, thickness))
    return rc.solve(ball, kernel="layer", context=context, **how)


# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.8))
thicknesses = np.geomspace(0.01, 10, 13)
for ratio in (10, 2, 0.5, 0.1):
    left.loglog(thicknesses, [press(ratio, t).load / bare.load for t in thicknesses], ".-", label=f"E₁*/E₂* = {ratio}")
left.set(xlabel="thickness / a", ylabel="load / load on the bare half-space")
left.legend()
for name, result in (
    ("bare", bare),
    ("10 times stiffer layer, t = a", press(10, 1)),
    ("10 times softer layer, t = a", press(0.1, 1)),
):
    right.plot(x, result.pressure[n // 2] / bare.pressure.max(), label=name)
right.set(xlabel="x / a", ylabel="pressure / largest one, bare", xlim=(-2, 2), ylim=(0, 7.5))
right.legend(loc="upper right")
figure.tight_layout()
