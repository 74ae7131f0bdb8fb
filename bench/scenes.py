"""Scenes of the comparison of speed with accuracy: surfaces that grids of several cell sizes show, of unit width and modulus."""
import functools
import math
import os
from dataclasses import dataclass, replace
from typing import Callable, Optional

import numpy as np

import native
from contact import unit_square
from surfaces import Hertz, below_highest, block_means, coordinates, midpoint_surface, paraboloid_gap, self_affine_gap

HEIGHT = 0.01  # of waves, and the depth of the punch
CAPACITY = 0.36679  # of the unit square (Read 1997)
MEASURED = {'afm_film': 'measured/afm_film_10um.gsf', 'afm_selfaffine': 'measured/afm_selfaffine_10um.gsf',
            'afm_patch': 'measured/afm_patch_10um.gsf', 'confocal_lay': 'measured/confocal_lay_1275um.gsf',
            'fv_rubber': 'measured-lgpl/fv_rubber_2mm.gsf'}  # below the folder of measured surfaces


@dataclass(frozen=True)
class Known:
    """What theory says of one contact. target: approach, or load in load control. pressure(n): where theory has it."""
    target: float
    load: float
    area: float
    pressure: Optional[Callable] = None


@dataclass(frozen=True)
class GridScene:
    """n: points a side of the grid that methods are compared on; the finest has 4n. gap(points a side). known(contact): None where the
    approach has to be searched and the finest grid is the truth. full: full contact alone."""
    gap: Callable
    name: str = ''
    n: int = 0
    boundary: str = 'free'
    control: str = 'displacement'
    aspect: float = 1.0
    most_contact: float = 1.0
    full: bool = False
    known: Optional[Callable] = None

    def system(self, points):
        return unit_square(points, self.boundary, self.aspect)


def hertz(contact):
    sphere = Hertz(math.sqrt(contact / math.pi))
    return Known(sphere.approach, sphere.load, sphere.area, sphere.pressure)


def wave(contact):
    """One wave of height 2 HEIGHT: Westergaard (1939) in the form of Johnson (1985), 13.2. The approach, measured between mean planes,
    follows from dd/dp = 2/(pi E*) ln(1/s), the field of a periodic row of flat strips, and p = pi E* height s^2."""
    s = math.sin(math.pi * contact / 2)
    load = math.pi * HEIGHT * s * s

    def pressure(n):
        x, y = coordinates(n)
        square = np.maximum(0, s * s - np.sin(math.pi * x)**2) + 0 * y
        return 2 * load / (s * s) * np.cos(math.pi * x) * np.sqrt(square)
    return Known(HEIGHT * s * s * (1 - 2 * math.log(s)), load, contact, pressure)


def two_waves(n):
    x, y = (2 * math.pi * (np.arange(n) + 0.5) / n for _ in range(2))
    return np.cos(x)[None, :] * np.cos(y)[:, None]


def waves(_):
    """Pressed flat by 1.2 times the load that it takes: Johnson, Greenwood & Higginson (1985)."""
    amplitude = math.sqrt(2) * math.pi * HEIGHT
    load = 1.2 * amplitude
    return Known(load, load, 1, lambda n: load + amplitude * two_waves(n))


def punch(_):
    """A flat square punch that covers the grid: load = pi E* depth C."""
    return Known(HEIGHT, math.pi * CAPACITY * HEIGHT, 1)


def measured(file):
    """The largest square of a power of two points, from the middle."""
    heights, (hx, hy) = native.read_surface(file)
    ny, nx = heights.shape
    side = 1 << (min(nx, ny).bit_length() - 1)
    left, top = (nx - side) // 2, (ny - side) // 2
    gap = below_highest(heights[top:top + side, left:left + side] / (side * hx))
    return GridScene(functools.partial(block_means, gap), n=side // 4, aspect=hy / hx)


RANDOM = ('self-affine', *(f'rmd-0.{digit}' for digit in (3, 5, 7, 9)))  # those that seeds make different
NAMES = ('hertz', 'wave', 'waves', 'punch', *RANDOM, *MEASURED)


def make_scene(name, n, folder, seed=1):
    """(scene or None, why it is not there). n: of the scenes that are not measured, a power of two. folder: where measured surfaces lie."""
    if name in MEASURED:
        file = os.path.join(folder, MEASURED[name])
        if not folder or not os.path.exists(file):
            return None, f'{file} is not there' if folder else 'no folder of measured surfaces is given (--surfaces)'
        scene = measured(file)
    elif name == 'hertz':
        scene = GridScene(paraboloid_gap, most_contact=0.5, known=hertz)  # the disc has to fit into the square
    elif name == 'wave':
        scene = GridScene(lambda points: HEIGHT * (1 - np.cos(2 * math.pi * coordinates(points)[0])) + 0 * coordinates(points)[1],
                          boundary='periodic', known=wave)
    elif name == 'waves':  # flat, the approach no longer tells the load
        scene = GridScene(lambda points: HEIGHT * (1 - two_waves(points)), boundary='periodic', control='load', full=True, known=waves)
    elif name == 'punch':
        scene = GridScene(lambda points: np.zeros((points, points)), full=True, known=punch)
    elif name == 'self-affine':
        scene = GridScene(lambda points: self_affine_gap(points, seed, cut_off=n / 8))
    else:  # heights are made on the finest grid; the others have means over blocks of its cells
        hurst, levels = float(name.split('-')[1]), (4 * n).bit_length() - 1
        scene = GridScene(lambda points: block_means(below_highest(midpoint_surface(levels, hurst, seed)), points))
    return replace(scene, name=name, n=scene.n or n), ''
