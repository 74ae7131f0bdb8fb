# %% [markdown]
# # Rubber: area against time, and the error of the time steps
#
# A rubber block is pressed on a rough surface. Under a constant load the contact spreads as the rubber creeps; at a constant approach
# the pressures relax as its modulus does, and that is exact on any surface. So the second picture has the error of the time steps
# alone: half the step, a quarter of the error.

# %%
import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc

surface = rc.surface.spectral(
    (128, 128), pitch=1e-6, rms_slope=0.2, hurst=0.8, q_rolloff=2 * np.pi / 32e-6, q_high=2 * np.pi / 4e-6, seed=3
)
terms = [(0.3, 0.1), (0.2, 10), (0.2, 1000)]  # of the modulus: 30 % of it relax in 0.1 s, 20 % in 10 s, 20 % in 1000 s
rubber = {"E": 30e6, "nu": 0.5, "relaxation": terms}


def modulus(time):
    return 1 - sum(ratio * (1 - np.exp(-time / tau)) for ratio, tau in terms)


# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.8))
times = np.concatenate([[0], np.geomspace(1e-3, 1e5, 49)])
for pressure in (0.1e6, 0.3e6, 1e6):
    history = rc.history(surface, **rubber, pressure=np.full(len(times), pressure), time=times)
    left.semilogx(times[1:], 100 * history.area_fraction[1:], label=f"{pressure / 1e6:g} MPa")
left.set(xlabel="time [s]", ylabel="in contact [%]")
left.legend()

# %%
counts = np.array((8, 16, 32, 64, 128, 256))
ways = {
    "1 s in equal steps": lambda n: np.linspace(0, 1, n + 1),
    "100 s in steps that grow": lambda n: np.r_[0, np.geomspace(1e-3, 100, n)],
}
approach = 0.3 * (surface.heights.max() - surface.heights.mean())
for (name, way), style in zip(ways.items(), ("o-", "s-")):
    errors = []
    for count in counts:
        times = way(count)
        load = rc.history(surface, **rubber, approach=np.full(len(times), approach), time=times).load
        errors.append(np.abs(load / load[0] - modulus(times)).max())
    right.loglog(counts, errors, style, label=name)
    print(f"{name}: errors of 8 to 256 steps: {' '.join(f'{error:.1e}' for error in errors)}")
right.loglog(counts, 0.5 / counts**2.0, "--", color="0.5", label="order 2")
right.set(xlabel="steps", ylabel="largest error of the load, over that at once")
right.legend()
figure.tight_layout()
