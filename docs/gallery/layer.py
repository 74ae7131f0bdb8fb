# %% [markdown]
# # A layer, as a function in Python
#
# An elastic layer of thickness t is bonded to a half-space of another material. Under a wave of pressure with wave number q its
# deflection is f(q t) times that of the half-space (Burmister 1945; O'Sullivan & King 1988). The function goes to
# `Context.add_kernel`. A ball is pressed in with the same approach; a is the radius of contact on the bare half-space.

# %%
import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc


def compliance(ratio, thickness, nu1=0.3, nu2=0.3):
    """E* of the half-space times the deflection by a wave of unit pressure; ratio: E* of the layer over that of the half-space."""
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
