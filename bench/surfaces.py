"""The surfaces that are pressed: gaps [n, n] over the unit square at the centres of cells, and heights of rough and textured ones."""
import math
import os
from dataclasses import dataclass

import numpy as np
import roughcontact as rc

import native
from contact import Scene

GOLDEN = 0x9e3779b97f4a7c15
WORD = (1 << 64) - 1


def mixed(z):
    """The output function of splitmix64 (Steele, Lea & Flood 2014): the same numbers everywhere."""
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xbf58476d1ce4e5b9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94d049bb133111eb)
    return z ^ (z >> np.uint64(31))


def uniform(state, count):
    """The first numbers of splitmix64 from this state, uniform on (0, 1)."""
    steps = np.arange(1, count + 1, dtype=np.uint64) * np.uint64(GOLDEN) + np.uint64(state & WORD)
    return np.ldexp((mixed(steps) >> np.uint64(11)) + 0.5, -53)


def phases(seed, kx, ky):
    wave = (kx.astype(np.uint64) << np.uint64(32)) ^ (ky & 0xffffffff).astype(np.uint64)
    z = mixed(np.array([(seed + GOLDEN) & WORD], np.uint64)) ^ wave
    return 2 * math.pi * np.ldexp((mixed(z + np.uint64(GOLDEN)) >> np.uint64(11)).astype(float), -53)


def self_affine_gap(n, seed=1, hurst=0.8, roll_off=4, cut_off=0, rms_slope=0.1):
    """About a mean plane at 0: random phases, power ~ |k|^-2(1+H) between roll_off and cut_off waves a side, flat below, none above;
    cut_off 0: a shortest wave of 8 cells. Every wave's phase depends on the seed and its wave vector alone: a finer grid samples the
    same surface where cut_off is the same, and adds shorter waves to it where it grows with n."""
    cut_off = cut_off or n / 8
    longest = int(cut_off)
    ky, kx = np.arange(-longest, longest + 1)[:, None], np.arange(longest + 1)[None, :]
    k = np.hypot(kx, ky)
    amplitude = np.where((k <= cut_off) & ((kx > 0) | (ky > 0)), np.maximum(k, max(roll_off, 1e-300))**-(1 + hurst), 0)
    square_slope = 2 * np.sum((2 * math.pi * k * amplitude)**2)
    phase = phases(seed, kx, ky) + math.pi * (kx + ky) / n  # half a cell further: the centre of the first cell
    spectrum = np.zeros((n, longest + 1), complex)
    spectrum[ky[:, 0] % n] = amplitude * np.exp(1j * phase)
    positive = np.arange(1, longest + 1)
    spectrum[-positive, 0] = spectrum[positive, 0].conj()
    del k, amplitude, phase
    heights = np.fft.irfft(np.fft.ifft(spectrum, axis=0), n, axis=1)
    heights *= rms_slope / math.sqrt(square_slope) * n * n
    return heights


def coordinates(n):
    """(x [1, n], y [n, 1]) from the middle of the square."""
    x = (np.arange(n) + 0.5) / n - 0.5
    return x[None, :], x[:, None]


def paraboloid_gap(n):
    """Radius of curvature 1."""
    x, y = coordinates(n)
    return (x * x + y * y) / 2


class Hertz:
    """The paraboloid's contact of this radius."""

    def __init__(self, radius):
        self.radius, self.approach, self.load, self.area = radius, radius**2, 4 / 3 * radius**3, math.pi * radius**2

    def pressure(self, n):
        return 2 / math.pi * np.sqrt(np.maximum(0, self.radius**2 - 2 * paraboloid_gap(n)))


def below_highest(heights):
    return heights.max() - heights


def midpoint_surface(levels, hurst, seed):
    """Random midpoint displacement as in Bemporad & Paggi (2015): 2^levels points a side."""
    return rc.surface.rmd(levels, hurst=hurst, seed=seed).heights


def block_means(values, n):
    ratio = values.shape[0] // n
    return values if ratio == 1 else values.reshape(n, ratio, n, ratio).mean(axis=(1, 3))


@dataclass(frozen=True)
class SurfaceClass:
    """Surfaces whose spectrum is a power law, and others. Waves a side; 0: none."""
    name: str
    hurst: float = 0.7
    roll_off: float = 0
    low: float = 0    # the band's longest and shortest wave
    high: float = 0
    period: float = 0  # of pyramids, in cells
    noise: bool = False

    def heights(self, n, seed):
        if self.noise:
            return rc.surface.noise((n, n), pitch=1 / n, seed=seed).heights
        if self.period:  # of unequal heights, as etched
            pyramids = rc.surface.pyramids((n, n), pitch=1 / n, height=1, period=(self.period / n,) * 2)
            return pyramids.heights + 0.1 * SurfaceClass('slow', high=8).heights(n, seed)
        waves = {name: 2 * math.pi * value for name, value in (('q_low', self.low), ('q_rolloff', self.roll_off), ('q_high', self.high))}
        return rc.surface.spectral((n, n), pitch=1 / n, hurst=self.hurst, rms_height=1, seed=seed, **waves).heights


CLASSES = (SurfaceClass('power law'), SurfaceClass('roll-off at 8 waves', roll_off=8), SurfaceClass('roll-off at 16 waves', roll_off=16),
           SurfaceClass('roll-off at 48 waves', roll_off=48), SurfaceClass('band of 40 to 80 waves', low=40, high=80),
           SurfaceClass('pyramids of 21.3 cells', period=64 / 3), SurfaceClass('pyramids of 5.3 cells', period=16 / 3),
           SurfaceClass('white noise', noise=True))


def measured_scene(file):
    """A surface file, approach half of the height of the highest point above the mean."""
    heights, pitch = native.read_surface(file)
    gap = below_highest(heights)
    return Scene(os.path.splitext(os.path.basename(file))[0], gap, gap.mean() / 2, pitch)


def asperity_band(n, seed):
    """The gap of the band of waves that ASPHER's authors press: 12 waves a side up to a third of a wave per cell, rms height 0.02."""
    return below_highest(0.02 * SurfaceClass('rough', hurst=0.8, low=12, high=0.33 * n).heights(n, seed))


def rough_scene(levels, seed, hurst=0.7):
    gap = below_highest(midpoint_surface(levels, hurst, seed))
    return Scene('rough', gap, gap.mean() / 2)


def example_one(side, spacing, seed, kernel='love'):
    """Bemporad & Paggi (2015), Example 1: side x side unit cells, every one a candidate, compenetrations uniform on (0, 1). Spacing 2: a
    masked cell between each two."""
    width = spacing * (side - 1) + 1
    gap, mask = np.full((width, width), 2.0), None
    gap[::spacing, ::spacing] = 1 - uniform(seed * 0x2545f4914f6cdd1d + 1, side * side).reshape(side, side)
    if spacing > 1:
        mask = np.zeros((width, width), np.uint8)
        mask[::spacing, ::spacing] = 1
    return Scene('example 1', gap, 1.0, mask=mask, kernel=kernel)


def hertz_scene(n):
    """A paraboloid pressed in over a contact radius of about a third of n cells."""
    x = np.arange(n) - 0.5 * (n - 1)
    return Scene('Hertz', (x[None, :]**2 + x[:, None]**2) / (2 * n), n / 9)


def influence(kernel, side, spacing=1):
    """The matrix of side x side cells whose centres are `spacing` cells apart, for contact modulus 1."""
    width = spacing * (side - 1) + 1
    table = rc.kernel_coefficients(kernel, (width, width), 1)[::spacing, ::spacing]
    y, x = np.divmod(np.arange(side * side), side)
    return table[np.abs(y[:, None] - y), np.abs(x[:, None] - x)]


def tied_scene(n):
    """Points with p = 0 and gap = 0: which of them are in contact is undefined, the pressures are not."""
    numbers = iter(uniform(1, 4 * n * n).tolist())
    p = np.array([0.5 + next(numbers) if next(numbers) < 0.4 else 0 for _ in range(n * n)])
    u = influence('love', n) @ p
    for i in range(n * n):  # a third of the points without pressure touch all the same
        if p[i] == 0 and next(numbers) < 2 / 3:
            u[i] -= 0.1 + next(numbers)
    return Scene('ties', (u.max() - u).reshape(n, n), u.max())


def strained_scenes(n):
    """Well-posed problems that strain double precision: near-full contact, one point, spikes, offsets, flatness, aspect, kernel."""
    rough = rough_scene(math.ceil(math.log2(n)), 3)
    highest, gap = rough.gap.max(), rough.gap
    spike = gap + 1e3 * highest
    spike.flat[gap.size // 2 + 5] = 0
    return [rough.but(name='rough, kernel eq9', kernel='eq9'),
            rough.but(name='nearly every point in contact', approach=40 * highest),
            rough.but(name='one point touches', approach=0.5 * np.sort(gap, axis=None)[1]),
            rough.but(name='a spike of 1e3 times the roughness', gap=spike, approach=1e3 * highest + rough.approach),
            rough.but(name='heights around 1e6 times the roughness', gap=gap + 1e6 * highest, approach=1e6 * highest + rough.approach),
            rough.but(name='flat but for 1e-9 of the approach', gap=gap * 1e-9 / highest, approach=1),
            rough.but(name='cells 100 times as long as wide', pitch=(100.0, 1.0))]
