# %% [markdown]
# # A ball, and Hertz's answer
#
# A ball of radius R is pressed into a half-space by d. Hertz (1882): the load is 4/3 E* √R d^1.5, the contact is a circle of
# radius a = √(R d), and the pressure in it is 2 E* a/(π R) √(1 - r²/a²). The picture has the pressures on a line through the
# middle, and the error of the load on finer and finer grids.

# %%
import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc

radius, modulus, approach = 1e-3, 100e9, 1e-6  # m, Pa, m
a = np.sqrt(radius * approach)
hertz = 4 / 3 * modulus * np.sqrt(radius) * approach**1.5


def press(n):
    pitch = 3 * a / n
    x = (np.arange(n) - (n - 1) / 2) * pitch
    ball = -(x[:, None] ** 2 + x**2) / (2 * radius)
    return x, rc.solve(ball, pitch=pitch, modulus=modulus, approach=approach, boundary="free")


# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
x, result = press(65)
r = np.linspace(-a, a, 400)
left.plot(r * 1e6, 2 * modulus * a / (np.pi * radius) * np.sqrt(1 - (r / a) ** 2) / 1e9, label="Hertz")
left.plot(x * 1e6, result.pressure[32] / 1e9, ".", label="65 cells a side")
left.set(xlabel="x [µm]", ylabel="pressure [GPa]", title=f"load {result.load:.4f} N, Hertz {hertz:.4f} N")
left.legend()

sizes = np.array([16, 32, 64, 128, 256, 512])
errors = [abs(press(n)[1].load / hertz - 1) for n in sizes]
right.loglog(sizes, errors, "o-")
right.set(xlabel="cells a side", ylabel="relative error of the load", title="on finer grids")
right.set_xticks(sizes, labels=map(str, sizes), minor=False)
right.minorticks_off()
figure.tight_layout()
