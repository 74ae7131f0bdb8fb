"""Scenes of the comparison of speed with accuracy: surfaces that grids of several cell sizes show, of unit width and modulus; what is known of
their contacts, by theory and by certified solutions, and errors against that."""
import functools
import math
import os
from dataclasses import dataclass, replace
from typing import Callable, Optional

import numpy as np
import roughcontact as rc

import native
from contact import share_in_contact, solve, unit_square
from surfaces import Hertz, below_highest, block_means, coordinates, midpoint_surface, paraboloid_gap, self_affine_gap

HEIGHT = 0.01  # of waves, and the depth of the punch
CAPACITY = 0.36679  # of the unit square (Read 1997)
MEASURED = {  # title, and file below the folder of measured surfaces
    'afm_film': ('AFM, film', 'measured/afm_film_10um.gsf'), 'afm_selfaffine': ('AFM, self-affine', 'measured/afm_selfaffine_10um.gsf'),
    'afm_patch': ('AFM, one hill', 'measured/afm_patch_10um.gsf'), 'confocal_lay': ('confocal, machined', 'measured/confocal_lay_1275um.gsf'),
    'fv_rubber': ('focus variation, rubber', 'measured-lgpl/fv_rubber_2mm.gsf')}
RANDOM = {'self-affine': 'self-affine', **{f'rmd-0.{digit}': f'midpoint, H = 0.{digit}' for digit in (3, 5, 7, 9)}}  # by seeds
TITLES = {'hertz': 'Hertz', 'wave': 'one wave', 'waves': 'two waves, flat', 'punch': 'square punch', **RANDOM,
          **{name: title for name, (title, _) in MEASURED.items()}}
NAMES = tuple(TITLES)


@dataclass(frozen=True)
class Truth:
    """target: approach, or load in load control. pressure: on a grid, or by points a side where theory has it."""
    load: float
    area: float
    pressure: object = None
    target: float = 0.0

    def on(self, n):
        return replace(self, pressure=block_means(self.pressure, n))

    def errors(self, result):
        """Relative errors: of load and contact area, and of the pressures in the L2 norm, on the same grid."""
        off = np.linalg.norm(result.pressure - self.pressure) / np.linalg.norm(self.pressure)
        return {'load_error': abs(result.load / self.load - 1), 'area_error': abs(result.contact_area / self.area - 1),
                'pressure_error': float(off)}


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
    return Truth(sphere.load, sphere.area, sphere.pressure, sphere.approach)


def wave(contact):
    """One wave of height 2 HEIGHT: Westergaard (1939) in the form of Johnson (1985), 13.2. The approach, measured between mean planes,
    follows from dd/dp = 2/(pi E*) ln(1/s), the field of a periodic row of flat strips, and p = pi E* height s^2."""
    s = math.sin(math.pi * contact / 2)
    load = math.pi * HEIGHT * s * s

    def pressure(n):
        x, y = coordinates(n)
        square = np.maximum(0, s * s - np.sin(math.pi * x)**2) + 0 * y
        return 2 * load / (s * s) * np.cos(math.pi * x) * np.sqrt(square)
    return Truth(load, contact, pressure, HEIGHT * s * s * (1 - 2 * math.log(s)))


def two_waves(n):
    x, y = (2 * math.pi * (np.arange(n) + 0.5) / n for _ in range(2))
    return np.cos(x)[None, :] * np.cos(y)[:, None]


def waves(_):
    """Pressed flat by 1.2 times the load that it takes: Johnson, Greenwood & Higginson (1985)."""
    amplitude = math.sqrt(2) * math.pi * HEIGHT
    load = 1.2 * amplitude
    return Truth(load, 1, lambda n: load + amplitude * two_waves(n), load)


def measured(file):
    """The largest square of a power of two points, from the middle."""
    heights, (hx, hy) = native.read_surface(file)
    ny, nx = heights.shape
    side = 1 << (min(nx, ny).bit_length() - 1)
    left, top = (nx - side) // 2, (ny - side) // 2
    gap = below_highest(heights[top:top + side, left:left + side] / (side * hx))
    return GridScene(functools.partial(block_means, gap), n=side // 4, aspect=hy / hx)


# Of n points a side, a power of two.
MADE = {
    'hertz': lambda n, seed: GridScene(paraboloid_gap, most_contact=0.5, known=hertz),  # the disc has to fit into the square
    'wave': lambda n, seed: GridScene(lambda m: HEIGHT * (1 - np.cos(2 * math.pi * coordinates(m)[0])) + 0 * coordinates(m)[1],
                                      boundary='periodic', known=wave),
    # Flat, the approach no longer tells the load.
    'waves': lambda n, seed: GridScene(lambda m: HEIGHT * (1 - two_waves(m)), boundary='periodic', control='load', full=True, known=waves),
    # A flat square punch that covers the grid: load = pi E* depth C.
    'punch': lambda n, seed: GridScene(lambda m: np.zeros((m, m)), full=True, known=lambda _: Truth(math.pi * CAPACITY * HEIGHT, 1, None, HEIGHT)),
    'self-affine': lambda n, seed: GridScene(lambda m: self_affine_gap(m, seed, cut_off=n / 8))}


def make_scene(name, n, folder, seed=1):
    """(scene or None, why it is not there). n: of the scenes that are not measured. folder: where measured surfaces lie."""
    if name in MEASURED:
        file = os.path.join(folder, MEASURED[name][1])
        if not folder or not os.path.exists(file):
            return None, f'{file} is not there' if folder else 'no folder of measured surfaces is given (--surfaces)'
        scene = measured(file)
    elif name in MADE:
        scene = MADE[name](n, seed)
    else:  # heights are made on the finest grid; the others have means over blocks of its cells
        hurst, levels = float(name.split('-')[1]), (4 * n).bit_length() - 1
        scene = GridScene(lambda m: block_means(below_highest(midpoint_surface(levels, hurst, seed)), m))
    return replace(scene, name=name, n=scene.n or n), ''


def search_approach(scene, contact, threads):
    """At which a share of the cells of the scene's grid is in contact, to 2 %, by loose solves."""
    gap = scene.gap(scene.n)
    with rc.Contact(scene.system(scene.n), options={'tol': 1e-3, 'threads': threads}) as solver:
        def share_at(approach):
            return share_in_contact(solver.solve(gap=gap, check=False, want_pressure=False, **{scene.control: approach}))

        low, high = gap.min(), gap.mean()
        while share_at(high) < contact:
            low, high = high, high + 2 * (high - low)
        for _ in range(30):
            middle = (low + high) / 2
            share = share_at(middle)
            if abs(share / contact - 1) < 0.02:
                return middle
            low, high = (middle, high) if share < contact else (low, middle)
    return (low + high) / 2


def solve_certified(scene, target, n, tol, threads):
    """(truth, result) of the certified solution on n x n cells."""
    result = solve(scene.system(n), scene.gap(n), {'tol': tol, 'threads': threads}, **{scene.control: target})
    return Truth(result.load, result.contact_area, result.pressure, target), result


def best_truth(scene, contact, target, threads):
    """(truth, source): what theory knows of the contact, completed by the solution on the finest grid, with pressures there."""
    known = scene.known and scene.known(contact)
    if known and known.pressure:
        return replace(known, pressure=known.pressure(4 * scene.n)), 'analytic'
    solved, _ = solve_certified(scene, target, 4 * scene.n, 1e-10, threads)
    return (replace(known, pressure=solved.pressure), 'analytic load') if known else (solved, 'finest grid')
