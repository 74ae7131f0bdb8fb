"""Surfaces that mislead whoever looks at coarser grids alone: for the trial of option accuracy."""
import math
import random
from dataclasses import dataclass

import numpy as np
import roughcontact as rc

from surfaces import self_affine_gap


class Draw(random.Random):
    def power_of_ten(self, low, high):
        return 10**self.uniform(low, high)

    def chance(self, share):
        return self.random() < share


class Heights:
    """On n x n cells of the unit square; x and y from the middle, columns and rows. approach 0: a part of the mean gap."""

    def __init__(self, n):
        self.n, self.cell, self.approach = n, 1 / n, 0.0
        self.column, self.row = np.arange(n)[None, :], np.arange(n)[:, None]
        self.x, self.y = (self.column + 0.5) * self.cell - 0.5, (self.row + 0.5) * self.cell - 0.5
        self.r2, self.z = self.x * self.x + self.y * self.y, np.zeros((n, n))

    def along(self, angle):
        return self.x * math.cos(angle) + self.y * math.sin(angle)

    def each(self, value):
        """value(flat index) in the order of points, which is the order of what it draws."""
        return np.array([value(i) for i in range(self.n**2)]).reshape(self.n, self.n)

    def chosen(self, draw, share):
        return self.each(lambda _: draw.chance(share))


def roughen(h, draw, rms, hurst, roll_off, cut_off):
    """Adds a rough surface of this rms height."""
    rough = self_affine_gap(h.n, draw.randint(1, 1000000), hurst, roll_off, cut_off)
    h.z += rms / math.sqrt(np.mean(rough**2)) * rough


def sphere(h, draw, least=-3, most=-1.5):
    h.z -= h.r2 / 2
    h.approach = draw.power_of_ten(least, most)


def outer_pins(h, draw):
    """Single points outside the contact, which block means hide."""
    share, height = draw.power_of_ten(-4, -2.3), draw.uniform(0, 0.6)
    r2 = h.r2.ravel()
    h.z = h.each(lambda i: draw.uniform(-height, 0) * h.cell if r2[i] > 0.02 and draw.chance(share) else -8 * r2[i] * h.cell)
    h.approach = draw.uniform(0.3, 4) * h.cell


def two_spheres(h, draw):
    apart, radius, lower = draw.uniform(0.15, 0.3), draw.power_of_ten(-1.5, 0), draw.uniform(0, 0.02)
    h.z = np.maximum(-((h.x + apart)**2 + h.y**2) / 2, -((h.x - apart)**2 + (h.y - 0.1)**2) / (2 * radius) - lower)
    h.approach = draw.power_of_ten(-3, -1.7)


def scratched_sphere(h, draw):
    sphere(h, draw)
    for _ in range(draw.randint(1, 11)):
        angle, at, width = draw.uniform(0, math.pi), draw.uniform(-0.15, 0.15), draw.uniform(0.5, 2) * h.cell
        h.z[np.abs(h.along(angle) - at) < width] -= draw.power_of_ten(-4, -2)


def cone(h, draw):
    h.z = -draw.power_of_ten(-1, 0) * np.hypot(h.x, h.y)


def pillars(h, draw):
    side = draw.randint(1, 8)
    for _ in range(draw.randint(3, 60)):
        left, low = draw.randint(0, h.n - side - 1), draw.randint(0, h.n - side - 1)
        h.z[low:low + side, left:left + side] = draw.uniform(0.005, 0.02)


def dimples(h, draw):
    bend, depth, apart = draw.uniform(0, 0.05), draw.power_of_ten(-4, -1.5), draw.randint(3, 20)
    radius = draw.uniform(0.2, 0.45) * apart
    r = np.hypot(h.column % apart - apart / 2, h.row % apart - apart / 2)
    h.z = -bend * h.r2 - np.where(r < radius, depth, 0)


def needles(h, draw):
    roughen(h, draw, 0.003, 0.8, 4, 8)
    share = draw.power_of_ten(-4, -2)
    h.z += h.each(lambda _: draw.uniform(0, 0.03) if draw.chance(share) else 0.0)


def steps(h, draw):
    count, angle = draw.uniform(2, 30), draw.uniform(0, math.pi)
    h.z = 0.02 * np.floor(h.along(angle) * count) / count - 0.02 * h.r2


def grating(h, draw):
    period, depth, bend = draw.randint(2, 16), draw.power_of_ten(-4, -1.5), draw.uniform(0, 0.05)
    h.z = np.where(h.column % period < max(1, period // 2), 0, -depth) - bend * h.r2


def pits(h, draw):
    bend, share, depth = draw.power_of_ten(-1, 0) / 2, draw.power_of_ten(-3, -0.5), draw.power_of_ten(-4, -2)
    h.z = -bend * h.r2 - depth * h.chosen(draw, share)


def rough_sphere(h, draw):
    sphere(h, draw)
    roughen(h, draw, draw.power_of_ten(-4.5, -2.5), 0.8, 8, h.n / 2)


def checkerboard(h, draw):
    """Every second cell is lower: half of the contact that the means show."""
    sphere(h, draw)
    h.z[(h.column + h.row) % 2 == 1] -= draw.power_of_ten(-4, -2)


def rim(h, draw):
    """One cell wide around a sphere, hidden in the means of what lies lower beside it."""
    sphere(h, draw, -3, -1.7)
    radius, below = draw.uniform(0.2, 0.45), draw.power_of_ten(-4, -2)
    h.z[np.abs(np.hypot(h.x, h.y) - radius) < 0.7 * h.cell] = -below


def wires(h, draw):
    """One cell wide beside a ridge."""
    h.z = -0.05 * np.abs(h.x) + 0 * h.y
    for _ in range(draw.randint(1, 10)):
        at = draw.randint(0, h.n - 1)
        h.z[:, at] = -draw.power_of_ten(-4, -2)
    h.approach = draw.power_of_ten(-3, -1.7)


def raised_edge(h, draw):
    """A flat punch whose edge stands up by one cell."""
    half, edge = draw.uniform(0.1, 0.4), draw.power_of_ten(-4, -2)
    r = np.maximum(np.abs(h.x), np.abs(h.y))
    h.z = np.where(np.abs(r - half) < 0.6 * h.cell, edge, np.where(r < half, 0, -0.05))
    h.approach = draw.power_of_ten(-3, -1.7)


def dust(h, draw):
    """Grains of one cell on a plane, a few of them high."""
    share = draw.power_of_ten(-4, -2.5)
    h.z = h.each(lambda _: min(0.05, 0.0005 + 0.001 * ((draw.random() or 1e-300)**(-1 / 1.5) - 1)) if draw.chance(share) else 0.0)
    h.approach = draw.power_of_ten(-3, -2)


def bed_of_pins(h, draw):
    """Just below the approach, all outside the contact of the coarser grids."""
    sphere(h, draw, -2.7, -1.8)
    apart, top = draw.randint(2, 8), -draw.uniform(0.3, 1.2) * h.approach
    pins = (h.column % apart == 0) & (h.row % apart == 0) & (h.r2 > 2.5 * h.approach)
    h.z = np.where(pins, np.maximum(h.z, top), h.z)


def rough_saddle(h, draw):
    h.z = 0.02 * (h.x * h.x - h.y * h.y)
    roughen(h, draw, draw.power_of_ten(-4, -2.5), 0.8, 2, h.n / 2)


def terraces(h, draw):
    sphere(h, draw, -2.7, -1.5)
    step = draw.power_of_ten(-4, -3)
    h.z = np.trunc(h.z / step + np.copysign(0.5, h.z)) * step


def noisy_sphere(h, draw):
    """Noise of single cells, from even to a few deep ones."""
    sphere(h, draw)
    depth, skew = draw.power_of_ten(-4, -2), draw.uniform(0.3, 6)
    h.z -= depth * h.each(lambda _: draw.random())**skew


def cylinder(h, draw):
    h.z = -h.along(draw.uniform(0, math.pi))**2 / 2
    h.approach = draw.power_of_ten(-3, -1.5)


def dipoles(h, draw):
    """Needles in pairs with pits beside them, so that the means of blocks show neither."""
    sphere(h, draw, -3, -1.7)
    share, size = draw.power_of_ten(-4, -2), draw.uniform(0.2, 3) * h.approach
    for i in range(0, h.z.size - 1, 2):
        if draw.chance(share):
            h.z.flat[i] += size
            h.z.flat[i + 1] -= size


def shortest_waves(h, draw):
    """Waves of two and three cells, which alias on coarser grids."""
    sphere(h, draw)
    size, kx, ky = draw.power_of_ten(-4.5, -2.5), draw.uniform(1.8, 3.1), draw.uniform(0, 3.1)
    h.z += size * np.cos(kx * h.column + ky * h.row)


KINDS = {
    'sphere-outer-pins': outer_pins, 'two-spheres': two_spheres, 'scratched-sphere': scratched_sphere, 'cone': cone, 'pillars': pillars,
    'dimples': dimples, 'needles': needles, 'steps': steps, 'grating': grating, 'pits': pits,
    'waves-self-affine': lambda h, draw: roughen(h, draw, 0.01, draw.uniform(0.3, 1), draw.uniform(1, 6), draw.uniform(6, h.n / 2)),
    'long-waves': lambda h, draw: roughen(h, draw, 0.01, 1, 1, 3),
    'to-single-cells': lambda h, draw: roughen(h, draw, 0.01, draw.uniform(0.3, 0.9), 1, h.n / 2),
    'rough-sphere': rough_sphere, 'smooth-sphere': lambda h, draw: sphere(h, draw, -3, -1.3), 'checkerboard': checkerboard, 'rim': rim,
    'wires': wires, 'raised-edge': raised_edge, 'dust': dust, 'bed-of-pins': bed_of_pins, 'rough-saddle': rough_saddle, 'terraces': terraces,
    'noisy-sphere': noisy_sphere, 'cylinder': cylinder, 'dipoles': dipoles, 'shortest-waves': shortest_waves}


@dataclass(frozen=True)
class TrialSurface:
    system: rc.HalfSpace
    gap: np.ndarray
    mask: np.ndarray
    approach: float


def left_out(shape, draw, parts):
    """A mask without a tenth of the points, or without whole parts."""
    ny, nx = shape
    mask = np.ones(shape, np.uint8)
    if not parts:
        return np.array([not draw.chance(0.1) for _ in range(mask.size)], np.uint8).reshape(shape)
    for _ in range(6):
        left, low = draw.randint(0, nx - 5), draw.randint(0, ny - 5)
        right, high = min(nx, left + draw.randint(2, 30)), min(ny, low + draw.randint(2, 30))
        mask[low:high, left:right] = 0
    return mask


def make_surface(name, n, seed):
    """About n points a side, of unit width and modulus. The seed draws the shape and the approach, and for some seeds an odd size, a
    rectangle, elongated cells, single points or whole parts that do not count, a period."""
    draw = Draw(seed * 1009 + list(KINDS).index(name))
    h = Heights(draw.randint(4 * n // 5, 6 * n // 5) if seed % 2 == 0 else n)
    KINDS[name](h, draw)
    gap, approach, boundary, hx, hy = h.z.max() - h.z, h.approach, 'free', h.cell, h.cell
    if approach == 0:
        boundary = 'periodic' if draw.chance(0.4) else 'free'
        approach = gap.mean() * draw.power_of_ten(-1, -0.25 if boundary == 'periodic' else 0)
    if seed % 5 == 3:
        hy *= draw.power_of_ten(-1.3, 1.3)
    if seed % 5 == 4 and boundary == 'free':
        gap = gap[:h.n // draw.randint(2, 4)]
    mask = left_out(gap.shape, draw, seed % 7 == 6) if seed % 7 >= 5 else None
    return TrialSurface(rc.HalfSpace(gap.shape, pitch=(hx, hy), modulus=1, boundary=boundary), np.ascontiguousarray(gap), mask, approach)
