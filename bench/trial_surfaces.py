"""Surfaces that mislead whoever looks at coarser grids alone: for the trial of option accuracy."""
import math

import numpy as np
import roughcontact as rc

from surfaces import self_affine_gap


class Draw(np.random.RandomState):
    def power_of_ten(self, low, high):
        return 10**self.uniform(low, high)

    def integer(self, low, high):
        """low and high included."""
        return self.randint(low, high + 1)

    def chance(self, share, shape=None):
        return self.random_sample(shape) < share


class Heights:
    """On n x n cells of the unit square; x and y from the middle, columns and rows. approach 0: a part of the mean gap."""

    def __init__(self, n):
        self.n, self.cell, self.approach, self.shape = n, 1 / n, 0.0, (n, n)
        self.column, self.row = np.arange(n)[None, :], np.arange(n)[:, None]
        self.x, self.y = (self.column + 0.5) * self.cell - 0.5, (self.row + 0.5) * self.cell - 0.5
        self.r2, self.z = self.x * self.x + self.y * self.y, np.zeros((n, n))

    def along(self, angle):
        return self.x * math.cos(angle) + self.y * math.sin(angle)


def roughen(h, draw, rms, hurst, roll_off, cut_off):
    """Adds a rough surface of this rms height."""
    rough = self_affine_gap(h.n, draw.integer(1, 1000000), hurst, roll_off, cut_off)
    h.z += rms / math.sqrt(np.mean(rough**2)) * rough


def sphere(h, draw, least=-3, most=-1.5):
    h.z -= h.r2 / 2
    h.approach = draw.power_of_ten(least, most)


def outer_pins(h, draw):
    """Single points outside the contact, which block means hide."""
    share, height = draw.power_of_ten(-4, -2.3), draw.uniform(0, 0.6)
    pins = (h.r2 > 0.02) & draw.chance(share, h.shape)
    h.z = np.where(pins, draw.uniform(-height, 0, h.shape), -8 * h.r2) * h.cell
    h.approach = draw.uniform(0.3, 4) * h.cell


def two_spheres(h, draw):
    apart, radius, lower = draw.uniform(0.15, 0.3), draw.power_of_ten(-1.5, 0), draw.uniform(0, 0.02)
    h.z = np.maximum(-((h.x + apart)**2 + h.y**2) / 2, -((h.x - apart)**2 + (h.y - 0.1)**2) / (2 * radius) - lower)
    h.approach = draw.power_of_ten(-3, -1.7)


def scratched_sphere(h, draw):
    sphere(h, draw)
    for _ in range(draw.integer(1, 11)):
        angle, at, width = draw.uniform(0, math.pi), draw.uniform(-0.15, 0.15), draw.uniform(0.5, 2) * h.cell
        h.z[np.abs(h.along(angle) - at) < width] -= draw.power_of_ten(-4, -2)


def cone(h, draw):
    h.z = -draw.power_of_ten(-1, 0) * np.hypot(h.x, h.y)


def pillars(h, draw):
    side = draw.integer(1, 8)
    for _ in range(draw.integer(3, 60)):
        left, low = draw.integer(0, h.n - side - 1), draw.integer(0, h.n - side - 1)
        h.z[low:low + side, left:left + side] = draw.uniform(0.005, 0.02)


def dimples(h, draw):
    bend, depth, apart = draw.uniform(0, 0.05), draw.power_of_ten(-4, -1.5), draw.integer(3, 20)
    r = np.hypot(h.column % apart - apart / 2, h.row % apart - apart / 2)
    h.z = -bend * h.r2 - np.where(r < draw.uniform(0.2, 0.45) * apart, depth, 0)


def needles(h, draw):
    roughen(h, draw, 0.003, 0.8, 4, 8)
    h.z += np.where(draw.chance(draw.power_of_ten(-4, -2), h.shape), draw.uniform(0, 0.03, h.shape), 0)


def steps(h, draw):
    count, angle = draw.uniform(2, 30), draw.uniform(0, math.pi)
    h.z = 0.02 * np.floor(h.along(angle) * count) / count - 0.02 * h.r2


def grating(h, draw):
    period, depth, bend = draw.integer(2, 16), draw.power_of_ten(-4, -1.5), draw.uniform(0, 0.05)
    h.z = np.where(h.column % period < max(1, period // 2), 0, -depth) - bend * h.r2


def pits(h, draw):
    bend, share, depth = draw.power_of_ten(-1, 0) / 2, draw.power_of_ten(-3, -0.5), draw.power_of_ten(-4, -2)
    h.z = -bend * h.r2 - depth * draw.chance(share, h.shape)


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
    h.z[np.abs(np.hypot(h.x, h.y) - draw.uniform(0.2, 0.45)) < 0.7 * h.cell] = -draw.power_of_ten(-4, -2)


def wires(h, draw):
    """One cell wide beside a ridge."""
    h.z = -0.05 * np.abs(h.x) + 0 * h.y
    for _ in range(draw.integer(1, 10)):
        h.z[:, draw.integer(0, h.n - 1)] = -draw.power_of_ten(-4, -2)
    h.approach = draw.power_of_ten(-3, -1.7)


def raised_edge(h, draw):
    """A flat punch whose edge stands up by one cell."""
    half, edge = draw.uniform(0.1, 0.4), draw.power_of_ten(-4, -2)
    r = np.maximum(np.abs(h.x), np.abs(h.y))
    h.z = np.where(np.abs(r - half) < 0.6 * h.cell, edge, np.where(r < half, 0, -0.05))
    h.approach = draw.power_of_ten(-3, -1.7)


def dust(h, draw):
    """Grains of one cell on a plane, a few of them high."""
    grains = 0.0005 + 0.001 * ((1 - draw.random_sample(h.shape))**(-1 / 1.5) - 1)
    h.z = np.where(draw.chance(draw.power_of_ten(-4, -2.5), h.shape), np.minimum(0.05, grains), 0)
    h.approach = draw.power_of_ten(-3, -2)


def bed_of_pins(h, draw):
    """Just below the approach, all outside the contact of the coarser grids."""
    sphere(h, draw, -2.7, -1.8)
    apart, top = draw.integer(2, 8), -draw.uniform(0.3, 1.2) * h.approach
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
    h.z -= draw.power_of_ten(-4, -2) * draw.random_sample(h.shape)**draw.uniform(0.3, 6)


def cylinder(h, draw):
    h.z = -h.along(draw.uniform(0, math.pi))**2 / 2
    h.approach = draw.power_of_ten(-3, -1.5)


def dipoles(h, draw):
    """Needles in pairs with pits beside them, so that the means of blocks show neither."""
    sphere(h, draw, -3, -1.7)
    share, size = draw.power_of_ten(-4, -2), draw.uniform(0.2, 3) * h.approach
    needles = 2 * np.flatnonzero(draw.chance(share, h.z.size // 2))
    h.z.flat[needles] += size
    h.z.flat[needles + 1] -= size


def shortest_waves(h, draw):
    """Waves of two and three cells, which alias on coarser grids."""
    sphere(h, draw)
    size, kx, ky = draw.power_of_ten(-4.5, -2.5), draw.uniform(1.8, 3.1), draw.uniform(0, 3.1)
    h.z += size * np.cos(kx * h.column + ky * h.row)


KINDS = {'sphere-outer-pins': outer_pins, 'two-spheres': two_spheres, 'scratched-sphere': scratched_sphere, 'cone': cone, 'pillars': pillars,
    'dimples': dimples, 'needles': needles, 'steps': steps, 'grating': grating, 'pits': pits,
    'waves-self-affine': lambda h, draw: roughen(h, draw, 0.01, draw.uniform(0.3, 1), draw.uniform(1, 6), draw.uniform(6, h.n / 2)),
    'long-waves': lambda h, draw: roughen(h, draw, 0.01, 1, 1, 3),
    'to-single-cells': lambda h, draw: roughen(h, draw, 0.01, draw.uniform(0.3, 0.9), 1, h.n / 2),
    'rough-sphere': rough_sphere, 'smooth-sphere': lambda h, draw: sphere(h, draw, -3, -1.3), 'checkerboard': checkerboard, 'rim': rim,
    'wires': wires, 'raised-edge': raised_edge, 'dust': dust, 'bed-of-pins': bed_of_pins, 'rough-saddle': rough_saddle, 'terraces': terraces,
    'noisy-sphere': noisy_sphere, 'cylinder': cylinder, 'dipoles': dipoles, 'shortest-waves': shortest_waves}


def left_out(shape, draw, parts):
    """A mask without a tenth of the points, or without whole parts."""
    if not parts:
        return 1 - draw.chance(0.1, shape).astype(np.uint8)
    mask = np.ones(shape, np.uint8)
    for _ in range(6):
        low, left = (draw.integer(0, side - 5) for side in shape)
        mask[low:low + draw.integer(2, 30), left:left + draw.integer(2, 30)] = 0
    return mask


def make_surface(name, n, seed):
    """(system, gap, approach, mask) of about n points a side, of unit width and modulus. The seed draws the shape and the approach, and for
    some seeds an odd size, a rectangle, elongated cells, single points or whole parts that do not count, a period."""
    draw = Draw(seed * 1009 + list(KINDS).index(name))
    h = Heights(draw.integer(4 * n // 5, 6 * n // 5) if seed % 2 == 0 else n)
    KINDS[name](h, draw)
    gap, approach, boundary, hx, hy = h.z.max() - h.z, h.approach, 'free', h.cell, h.cell
    if approach == 0:
        boundary = 'periodic' if draw.chance(0.4) else 'free'
        approach = gap.mean() * draw.power_of_ten(-1, -0.25 if boundary == 'periodic' else 0)
    if seed % 5 == 3:
        hy *= draw.power_of_ten(-1.3, 1.3)
    if seed % 5 == 4 and boundary == 'free':
        gap = gap[:h.n // draw.integer(2, 4)]
    mask = left_out(gap.shape, draw, seed % 7 == 6) if seed % 7 >= 5 else None
    return rc.HalfSpace(gap.shape, pitch=(hx, hy), modulus=1, boundary=boundary), np.ascontiguousarray(gap), approach, mask
