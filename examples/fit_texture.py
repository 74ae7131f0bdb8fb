"""Dimples in a sphere, fitted to a wanted curve of load against approach; and what uncertain heights do to the load.

fit_texture.py [--points 64] [--iterations 80] [--picture FILE]      needs SciPy; the picture Matplotlib

The sphere is to start softer and to grow stiffer than Hertz's: F ~ d^2. Each of 9 x 9 dimples has a depth and a width. A step
of the fit presses the sphere to eight approaches, and takes the derivatives of the eight loads by all heights from one
linear solve each.
"""

import argparse

import numpy as np
from scipy.optimize import minimize

import roughcontact as rc

SIDE, RADIUS, MODULUS = 0.5e-3, 5e-3, 70e9  # m, m, Pa
DEEPEST = 4e-6  # largest approach, m
DIMPLES, EXPONENT, STEPS = 9, 2.0, 8
DEPTH = 1e-6  # unit of the depths, m


class Texture:
    """Undeformed gap of the sphere with dimples, from depths and widths."""

    def __init__(self, points):
        self.pitch = SIDE / points
        x = (np.arange(points) + 0.5) * self.pitch - SIDE / 2
        self.sphere = (x[:, None] ** 2 + x**2) / (2 * RADIUS)
        spacing = 0.65 * SIDE / DIMPLES
        centres = (np.arange(DIMPLES) - (DIMPLES - 1) / 2) * spacing
        self.distance = (x[:, None] - centres) ** 2  # [points, DIMPLES] squared
        self.width = spacing  # unit of the widths
        self.start = np.concatenate([np.full(DIMPLES**2, 0.1), np.full(DIMPLES**2, 0.5)])
        self.bounds = [(0, 2)] * DIMPLES**2 + [(0.3, 1.0)] * DIMPLES**2

    def shapes(self, widths):
        """[DIMPLES^2, points, points] of depth 1"""
        square = self.distance[:, None, :, None] + self.distance[None, :, None, :]
        shape = np.exp(-square / (2 * (widths.reshape(DIMPLES, DIMPLES) * self.width) ** 2))
        return np.moveaxis(shape.reshape(*self.sphere.shape, -1), -1, 0), np.moveaxis(
            square.reshape(*self.sphere.shape, -1), -1, 0
        )

    def gap(self, parameters):
        depths, widths = np.split(parameters, 2)
        return self.sphere + DEPTH * np.tensordot(depths, self.shapes(widths)[0], 1)

    def by_parameters(self, parameters, by_gap):
        """The chain rule, from derivatives by the gap."""
        depths, widths = np.split(parameters, 2)
        shapes, squares = self.shapes(widths)
        by_width = depths[:, None, None] * shapes * squares / (widths[:, None, None] ** 3 * self.width**2)
        return DEPTH * np.concatenate([np.tensordot(each, by_gap, 2) for each in (shapes, by_width)])


def pressed(contact, gap, approaches):
    """Loads, and derivatives of each by the gap."""
    loads, by_gap = [], []
    for k, approach in enumerate(approaches):
        surface = {"undeformed_gap": gap} if k == 0 else {}
        loads.append(contact.solve(approach=approach, want_pressure=False, **surface).load)
        by_gap.append(contact.gradient().gap)
    return np.array(loads), by_gap


def fit(texture, approaches, wanted, iterations):
    """(parameters, misfits): the misfit is the rms of the loads' errors over the largest wanted load."""
    misfits = []
    system = rc.HalfSpace(texture.sphere.shape, pitch=texture.pitch, modulus=MODULUS, boundary="free")
    with rc.Contact(system, options={"tol": 1e-7}) as contact:

        def objective(parameters):
            loads, by_gap = pressed(contact, texture.gap(parameters), approaches)
            off = (loads - wanted) / wanted[-1]
            slope = sum(2 / STEPS / wanted[-1] * error * each for error, each in zip(off, by_gap))
            misfits.append(np.sqrt(np.mean(off**2)))
            return np.mean(off**2), texture.by_parameters(parameters, slope)

        settings = {"maxiter": iterations, "ftol": 1e-12, "gtol": 1e-9}
        found = minimize(objective, texture.start, jac=True, method="L-BFGS-B", bounds=texture.bounds, options=settings)
    return found.x, misfits


def deviation(by_gap, pitch, sigma, length):
    """Standard deviation of the load, to first order, for heights of standard deviation sigma: independent of each other where length
    is 0, else with the correlation exp(-r^2 / (2 length^2))."""
    if length == 0:
        return sigma * np.linalg.norm(by_gap)
    n = 2 * by_gap.shape[0]  # so that opposite sides do not meet
    r = np.fft.fftfreq(n, 1 / n) * pitch
    spectrum = np.fft.rfft2(np.exp(-(r[:, None] ** 2 + r**2) / (2 * length**2)))
    spread = np.fft.irfft2(np.fft.rfft2(by_gap, (n, n)) * spectrum, (n, n))[: n // 2, : n // 2]
    return sigma * np.sqrt(np.sum(by_gap * spread))


def drawn(texture, gap, approach, sigma, length, samples, seed=1):
    """Standard deviation of the loads of random heights."""
    rng, (ny, nx) = np.random.default_rng(seed), gap.shape
    wave = [2 * np.pi * np.fft.fftfreq(2 * n, texture.pitch) for n in (ny, nx)]
    filtered = np.exp(-(wave[0][:, None] ** 2 + wave[1] ** 2) * length**2 / 4)  # the root of the correlation's spectrum
    filtered /= np.sqrt(np.mean(filtered**2))
    loads = []
    system = rc.HalfSpace(gap.shape, pitch=texture.pitch, modulus=MODULUS, boundary="free")
    with rc.Contact(system, options={"tol": 1e-7}) as contact:
        for _ in range(samples):
            noise = np.fft.ifft2(np.fft.fft2(rng.standard_normal(filtered.shape)) * filtered).real[:ny, :nx]
            loads.append(contact.solve(undeformed_gap=gap - sigma * noise, approach=approach, want_pressure=False).load)
    return np.std(loads)


def draw(file, texture, parameters, approaches, wanted, first, loads, by_gap, sigmas):
    import matplotlib

    matplotlib.use("agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 3, figsize=(9, 3), layout="constrained")
    for label, curve, style in (("wanted", wanted, "k--"), ("first texture", first, "C1-"), ("fitted", loads, "C0o-")):
        axes[0].plot(approaches * 1e6, curve, style, label=label, markersize=4)
    axes[0].fill_between(approaches * 1e6, loads - 2 * sigmas, loads + 2 * sigmas, color="C0", alpha=0.3, label="2 std. dev.")
    axes[0].set(xlabel="approach [um]", ylabel="load [N]")
    axes[0].legend()
    extent = 2 * [-SIDE / 2 * 1e6, SIDE / 2 * 1e6]
    maps = (1e6 * (texture.gap(parameters) - texture.sphere), "depth of the dimples [um]", "viridis"), (
        -1e-6 * by_gap[-1],
        "dF/dz [N/um per point]",
        "magma",
    )
    for each, (values, title, colours) in zip(axes[1:], maps):
        figure.colorbar(each.imshow(values, origin="lower", extent=extent, cmap=colours), ax=each, shrink=0.8)
        each.set(title=title, xlabel="x [um]")
    figure.savefig(file, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=64, help="a side of the grid, 16 to 256")
    parser.add_argument("--iterations", type=int, default=80, help="of L-BFGS-B, at most")
    parser.add_argument("--picture", help="a file for it")
    given = parser.parse_args()

    texture = Texture(given.points)
    approaches = DEEPEST * np.arange(1, STEPS + 1) / STEPS
    system = rc.HalfSpace(texture.sphere.shape, pitch=texture.pitch, modulus=MODULUS, boundary="free")
    hertz = rc.solve(undeformed_gap=texture.sphere, system=system, approach=DEEPEST).load
    wanted = 0.9 * hertz * (approaches / DEEPEST) ** EXPONENT
    parameters, misfits = fit(texture, approaches, wanted, given.iterations)
    print(f"misfit {100 * misfits[0]:.2f} % of the largest load, after {len(misfits)} evaluations {100 * min(misfits):.3f} %")

    gap = texture.gap(parameters)
    with rc.Contact(system, options={"tol": 1e-8}) as contact:
        first, _ = pressed(contact, texture.gap(texture.start), approaches)
        loads, by_gap = pressed(contact, gap, approaches)
    sigma = 10e-9  # m
    for name, length in (("independent of each other", 0), ("correlated over 100 um", 100e-6)):
        linear = deviation(by_gap[-1], texture.pitch, sigma, length)
        sampled = drawn(texture, gap, DEEPEST, sigma, length, 100)
        print(
            f"heights known to 10 nm, {name}: load {loads[-1]:.2f} N, standard deviation {linear:.4f} N, of 100 samples {sampled:.4f} N"
        )
    if given.picture:
        sigmas = np.array([deviation(each, texture.pitch, sigma, 100e-6) for each in by_gap])
        draw(given.picture, texture, parameters, approaches, wanted, first, loads, by_gap, sigmas)


if __name__ == "__main__":
    main()
