"""Dilute contacts: one product by backends "split" and "fft" in both precisions, and solves by default options and over the whole grid."""
import math
import sys

import numpy as np

import native
from case import Failure, checked, in_child, interpreter_memory, peak_memory
from contact import difference, time_solve, unit_square
from options import ALL_THREADS, CONTROLS, listed, question, ranged, side
from store import Store
from surfaces import Hertz, asperity_band, paraboloid_gap, self_affine_gap
from tables import show

TRIAL_POINTS = 4  # a contact: the trial set that a solver works on holds it and about three times as many points around it
ASPERITY_AREA = 0.001
LARGEST_SEARCH = 2048  # points a side up to which the load for a contact area is searched
SOLVES = ('surface={scene}; grid={n}²; contact [%]={auto[contact_percent]:.3g}; control; tol={tol:err}; auto={auto[solver]}, {auto[backend]}; '
          'auto [s]={auto[seconds]:s}; full grid [s]={fft[seconds]:s}; ratio={ratio:.1f}; products={auto[products]}; '
          'auto, peak [MB]={auto[peak_megabytes]:.0f}; full grid, peak [MB]={fft[peak_megabytes]:.0f}')
PRODUCTS = ('grid={n}²; contact [%]={contact_percent:.3g}; threads; fft [ms]={fft_ms:.3g}; split [ms]={split_ms:.3g}; ratio={ratio:.3g}; '
            'fft, single [ms]={fft_float_ms:.3g}; split, single [ms]={split_float_ms:.3g}; ratio={float_ratio:.3g}; difference={difference:err}')


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


class Solves:
    def __init__(self, request):
        self.request, self.corrections, self.rows, self.interpreter = request, {}, [], interpreter_memory()

    def solve(self, gap, control, target, tol, **more):
        """No pressures are asked for: they alone would be an array over all points. The gap came with the process."""
        options = {'threads': self.request.threads, 'tol': tol, **({'fft.precision': 'single'} if tol >= 1e-4 else {}), **more}

        def work():
            result, row = time_solve(unit_square(len(gap)), gap, options, self.request.budget, control, target)
            return {**row, 'contact_percent': 100 * result.contacts / gap.size, 'seconds': row['setup_seconds'] + result.seconds,
                    'worst_kkt': result.residual, 'peak_megabytes': (peak_memory() - self.interpreter) / 1e6}
        return in_child(work)

    def targets(self, gap, area):
        """Load and approach from loose solves; on large grids with what the last smaller one taught. Bush, Gibson & Thomas (1975): area =
        sqrt(2 pi) p / (E* rms slope)."""
        n = len(gap)
        rms_slope = n * math.sqrt(2 * np.sum(np.diff(gap, axis=1)**2) / n**2)
        for k in range(4):
            load = self.corrections.setdefault(area, 1.0) * area * rms_slope / math.sqrt(2 * math.pi)
            found = checked(self.solve(gap, 'load', load, 1e-2))
            percent = found['contact_percent']
            if k == 3 or n > LARGEST_SEARCH or abs(percent / (100 * area) - 1) < 0.1:
                return load, found['displacement']
            self.corrections[area] *= min(max(100 * area / percent, 0.2), 5) if percent > 0 else 5

    def over_the_whole_grid(self, gap, approach, control, target, tol):
        """Backend fft works on the box of the points that may touch. A point in each corner that is a candidate by a millionth of the
        approach, and stays apart under the deflection there, makes this box the grid."""
        gap = gap.copy()
        gap[::len(gap) - 1, ::len(gap) - 1] = np.minimum(gap[::len(gap) - 1, ::len(gap) - 1], approach * (1 - 1e-6))
        return self.solve(gap, control, target, tol, backend='fft', solver='haar-cg')

    def press(self, name, gap, area, load, approach):
        n = len(gap)
        for control in self.request.controls:
            target = load if control == 'load' else approach
            for tol in self.request.tols:
                print(f'solving {name}, {n}^2, {100 * area:g} %, {control}, {tol:g}', file=sys.stderr)
                row = {'scene': name, 'n': n, 'area_wanted': area, 'control': control, 'tol': tol, 'threads': self.request.threads,
                       'auto': self.solve(gap, control, target, tol)}
                if n <= self.request.largest_full:
                    row['fft'] = self.over_the_whole_grid(gap, approach, control, target, tol)
                    if 'seconds' in row['auto'] and 'seconds' in row['fft']:
                        row['ratio'] = row['fft']['seconds'] / row['auto']['seconds']
                self.rows.append(row)

    def run(self):
        for n in self.request.sizes:
            gap = asperity_band(n, self.request.seed)
            for percent in self.request.contacts:
                self.press('rough', gap, percent / 100, *self.targets(gap, percent / 100))
            hertz = Hertz(math.sqrt(ASPERITY_AREA / math.pi))
            self.press('asperity', paraboloid_gap(n), ASPERITY_AREA, hertz.load, hertz.approach)
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
    show(SOLVES, store.document.get('solves', []))
    show(PRODUCTS, store.document.get('dilute', []))


question('dilute', 'dilute contacts: products by backends split and fft, and solves', run, {
    'sizes': (listed(side), [1024, 2048, 4096], 'points per side'),
    'contacts': (listed(ranged(float, 0.001, 25)), [0.04, 0.1, 1, 10], 'contact areas in percent of the grid'),
    **ALL_THREADS, 'seed': (int, 1, 'of the surface'),
    'budget': (float, 0.3, 'seconds for repeats of each product and solve'),
    'controls': (listed(CONTROLS), ['displacement', 'load'], 'displacement, load'),
    'tols': (listed(float), [1e-8, 1e-4], 'certified tolerances of the solves'),
    'largest_full': (int, 4096, 'points a side up to which solves go over the whole grid as well'),
    'large': (bool, False, '8192^2 and 16384^2 as well'), 'products_only': (bool, False, 'no solves'),
    'solves_only': (bool, False, 'no products')})
