"""Dilute contacts: one product by backends "split" and "fft" in both precisions, and solves by default options and over the whole grid."""
import math
import sys

import numpy as np

import native
from case import Failure, checked, in_child, interpreter_memory, peak_memory
from contact import difference, time_solve, unit_square
from options import CONTROLS, THREADS, Question, listed, ranged, side, threads
from scaling_tables import dilute_table
from store import Store
from surfaces import Hertz, SurfaceClass, paraboloid_gap, self_affine_gap
from tables import show_table

TRIAL_POINTS = 4  # a contact: the trial set that a solver works on holds it and about three times as many points around it
RMS_HEIGHT, ASPERITY_AREA = 0.02, 0.001
LARGEST_SEARCH = 2048  # points a side up to which the load for a contact area is searched


def products_row(n, gap, approach, count, budget):
    def timed(backend, single=False):
        return native.time_products(unit_square(n), gap, approach, backend, threads=count, budget=budget, single=single,
                                    share=1 / TRIAL_POINTS, want=gap.size)

    fft, split, split_float = timed('fft'), timed('split'), timed('split', single=True)
    row = {'n': n, 'contact_percent': 100 * split['contacts'] / n**2, 'contacts': split['contacts'], 'points': split['points'],
           'threads': count, 'fft_ms': 1e3 * fft['best'], 'split_ms': 1e3 * split['best'], 'ratio': fft['best'] / split['best'],
           'fft_first_ms': 1e3 * fft['first'], 'split_first_ms': 1e3 * split['first'], 'split_float_ms': 1e3 * split_float['best'],
           'difference': difference(split['y'][:split['points']], fft['y'][:fft['points']])}
    try:
        fft_float = timed('fft', single=True)
        row.update(fft_float_ms=1e3 * fft_float['best'], float_ratio=fft_float['best'] / split_float['best'])
    except Failure:
        pass  # this library's fft has no products in single precision
    return row


def products(request):
    rows = []
    for n in request.sizes:
        gap = self_affine_gap(n, request.seed, roll_off=12, cut_off=n / 3)  # so that the contacts are all over the grid
        for contact in request.contacts:
            rank = int(min(gap.size * contact / 100 * TRIAL_POINTS, gap.size - 1))
            approach = np.partition(gap, rank, axis=None)[rank]
            for count in sorted({1, request.threads}):
                rows.append(products_row(n, gap, approach, count, request.budget))
                print(f'{n} points a side, {contact:g} %, {count} threads', file=sys.stderr)
    return rows


class Pressed:
    """A gap whose load and approach bring a share of it into contact."""

    def __init__(self, name, gap, load=0.0, approach=0.0):
        self.name, self.gap, self.load, self.approach = name, gap, load, approach


def rough(n, seed):
    """The band of waves that ASPHER's authors press."""
    heights = SurfaceClass('rough', hurst=0.8, low=12, high=0.33 * n).heights(n, seed)
    return Pressed('rough', RMS_HEIGHT * (heights.max() - heights))


def asperity(n):
    hertz = Hertz(math.sqrt(ASPERITY_AREA / math.pi))
    return Pressed('asperity', paraboloid_gap(n), hertz.load, hertz.approach)


class Solves:
    def __init__(self, request):
        self.request, self.corrections, self.rows, self.interpreter = request, {}, [], interpreter_memory()

    def options(self, tol, **more):
        single = {'fft.precision': 'single'} if tol >= 1e-4 else {}
        return {'threads': self.request.threads, 'tol': tol, **single, **more}

    def solve(self, gap, control, target, options):
        """No pressures are asked for: they alone would be an array over all points. The gap came with the process."""
        def work():
            result, row = time_solve(unit_square(len(gap)), gap, options, self.request.budget, control, target)
            return {**row, 'contact_percent': 100 * result.contacts / gap.size, 'seconds': row['setup_seconds'] + result.seconds,
                    'worst_kkt': result.residual, 'peak_megabytes': (peak_memory() - self.interpreter) / 1e6}
        return in_child(work)

    def find_load(self, scene, area):
        """From loose solves; on large grids with what the last smaller one taught. Bush, Gibson & Thomas (1975): area = sqrt(2 pi) p / (E*
        rms slope)."""
        n = len(scene.gap)
        rms_slope = n * math.sqrt(2 * np.sum(np.diff(scene.gap, axis=1)**2) / n**2)
        expected = area * rms_slope / math.sqrt(2 * math.pi)
        for k in range(4):
            correction = self.corrections.setdefault(area, 1.0)
            scene.load = correction * expected
            found = checked(self.solve(scene.gap, 'load', scene.load, self.options(1e-2)))
            scene.approach, percent = found['approach'], found['contact_percent']
            if k == 3 or n > LARGEST_SEARCH or abs(percent / (100 * area) - 1) < 0.1:
                return
            self.corrections[area] *= min(max(100 * area / percent, 0.2), 5) if percent > 0 else 5

    def over_the_whole_grid(self, scene, control, target, tol):
        """Backend fft works on the box of the points that may touch. A point in each corner that is a candidate by a millionth of the
        approach, and stays apart under the deflection there, makes this box the grid."""
        gap = scene.gap.copy()
        gap[::len(gap) - 1, ::len(gap) - 1] = np.minimum(gap[::len(gap) - 1, ::len(gap) - 1], scene.approach * (1 - 1e-6))
        return self.solve(gap, control, target, self.options(tol, backend='fft', solver='haar-cg'))

    def press(self, scene, area):
        n = len(scene.gap)
        for control in self.request.controls:
            target = scene.load if control == 'load' else scene.approach
            for tol in self.request.tols:
                print(f'solving {scene.name}, {n}^2, {100 * area:g} %, {control}, {tol:g}', file=sys.stderr)
                row = {'scene': scene.name, 'n': n, 'area_wanted': area, 'control': control, 'tol': tol, 'threads': self.request.threads,
                       'auto': self.solve(scene.gap, control, target, self.options(tol))}
                if n <= self.request.largest_full:
                    row['fft'] = self.over_the_whole_grid(scene, control, target, tol)
                    if 'seconds' in row['auto'] and 'seconds' in row['fft']:
                        row['ratio'] = row['fft']['seconds'] / row['auto']['seconds']
                self.rows.append(row)

    def run(self):
        for n in self.request.sizes:
            scene = rough(n, self.request.seed)
            for percent in self.request.contacts:
                self.find_load(scene, percent / 100)
                self.press(scene, percent / 100)
            self.press(asperity(n), ASPERITY_AREA)
        return self.rows


def run(request):
    store = Store(request.json, 'dilute', request.threads)
    request.sizes = request.sizes + ([8192, 16384] if request.large else [])
    if not request.solves_only:
        store.document['dilute'] = products(request)
    if not request.products_only:
        store.document['solves'] = Solves(request).run()
    store.save()
    print('Cold solves: auto, all options at their defaults; full grid, backend fft and haar-cg with a candidate in each corner, which keeps it\n'
          'from working on a box around the contact. ratio: seconds over those of auto, with set-up. peak: with the gap. Then products')
    for text in dilute_table(store.document).split('\n\n'):
        show_table(text)


QUESTION = Question('dilute', 'dilute contacts: products by backends split and fft, and solves', run, {
    'sizes': (listed(side), [1024, 2048, 4096], 'points per side'),
    'contacts': (listed(ranged(float, 0.001, 25)), [0.04, 0.1, 1, 10], 'contact areas in percent of the grid'),
    'threads': (threads, THREADS, 'threads; products with one as well'), 'seed': (int, 1, 'of the surface'),
    'budget': (float, 0.3, 'seconds for repeats of each product and solve'),
    'controls': (listed(CONTROLS), ['displacement', 'load'], 'displacement, load'),
    'tols': (listed(float), [1e-8, 1e-4], 'certified tolerances of the solves'),
    'largest_full': (int, 4096, 'points a side up to which solves go over the whole grid as well'),
    'large': (bool, False, '8192^2 and 16384^2 as well'), 'products_only': (bool, False, 'no solves'),
    'solves_only': (bool, False, 'no products')})
