"""Time, products and memory of cold solves against the number of points, the contact area and the control."""
import math
import sys

import numpy as np

import native
from case import available_memory, checked, in_child, interpreter_memory, limit_growth, peak_memory, resident_memory
from contact import OK, find_load, share_in_contact, time_solve, unit_square
from options import ALL_THREADS, CONTROLS, listed, one_of, percent, question, side
from samples import chosen, groups, slope, solved, total_seconds
from store import Store
from surfaces import self_affine_gap
from tables import show

LARGEST_SEARCH = 2048   # points a side up to which the load for a contact area is searched
LARGEST_PROFILE = 4096  # and up to which products are timed by themselves
GROWING = range(512, 4097)  # grids whose products are counted
SPARSE = 0.01  # contact below which no array of pressures over all points is asked for: rc_contact_points has them
SLOPE = 0.1  # rms, of the surface
COLUMNS = ('grid={n}²{mark}; contact [%]={area_found:%.3g}; control; solver, backend={solver}, {backend}; set-up [s]={setup_seconds:s}; '
           'solve [s]={solve_seconds:s}; CPU [s]={cpu_seconds:s}; iterations; products; product [ms]={product_seconds_best:m.3g}; '
           'bytes/point={bytes_per_point:.0f}; in all={bytes_per_point_in_all:.0f}; candidates; modelled; contacts; residual={residual:err}')
GROWTH = 'contact [%]={area_wanted:%.3g}; control; grids={from}² to {to}²; products={least} to {most}; growth=N^{exponent:.2f}'


def certified_rows(document, **values):
    """Cold solves with these values of their keys, by growing size."""
    wanted = {'tol': 1e-8, 'precision': 'mixed', **values}
    return sorted(chosen(solved(document.get('solves', [])), **wanted), key=lambda row: row['n'])


def growth_of(rows):
    """Products of each area and control, and the exponent of the side by which they grow."""
    found = []
    for (area, control), same in groups(rows, 'area_wanted', 'control').items():
        counts = [(row['n'], row['products']) for row in same if row['n'] in GROWING]
        if len({n for n, _ in counts}) > 1:
            products = [count for _, count in counts]
            found.append({'area_wanted': area, 'control': control, 'from': counts[0][0], 'to': counts[-1][0], 'least': min(products),
                          'most': max(products), 'exponent': slope(counts)})
    return found


def options_of(request):
    options = {'threads': request.threads, 'tol': request.tol}
    return options if request.precision == 'mixed' else {**options, 'fft.precision': request.precision}


def light_load(area):
    """Bush, Gibson & Thomas (1975): area = sqrt(2 pi) p / (E* rms slope) at light loads."""
    return area / math.sqrt(2 * math.pi) * SLOPE


def measure_solve(request, area, gap, control, target, interpreter):
    """A cold solve, its peak memory, then the product on the same trial set. interpreter: memory that is not the library's [bytes]."""
    system, points = unit_square(len(gap)), gap.size
    pressure = np.zeros_like(gap) if area >= SPARSE else None
    before = resident_memory()
    result, row = time_solve(system, gap, options_of(request), request.budget, control, target, pressure)
    peak = max(peak_memory(), before)
    row.update(area_found=share_in_contact(result), bytes_per_point=(peak - before) / points, bytes_per_point_in_all=(peak - interpreter) / points)
    if len(gap) <= LARGEST_PROFILE and row['status'] == OK:
        row['product_seconds_best'], _ = native.time_products(system, np.asarray(gap, float), result.approach, result.backend, request.threads,
                                                              request.budget / 4)
    return row


class Scaling:
    def __init__(self, request):
        self.request, self.store = request, Store(request.json, 'scaling', request.threads)
        self.settings = {'tol': request.tol, 'precision': request.precision, 'threads': request.threads, 'seed': request.seed}
        self.real = np.float32 if request.precision == 'single' else float  # of the gap and the pressures
        self.areas = [value / 100 for value in request.percents]
        self.interpreter, self.kept = interpreter_memory(), np.empty(0)

    def gap(self, n):
        if len(self.kept) != n:
            self.kept = np.empty(0)
            self.kept = self_affine_gap(n, self.request.seed, rms_slope=SLOPE).astype(self.real)
        return self.kept

    def load_for(self, n, area, approach):
        """The load for an area, and for approach control the approach under it. Found once, on a grid that is not too fine, and kept
        with the results: no measurement."""
        if n > LARGEST_SEARCH and not approach:
            return self.load_for(LARGEST_SEARCH, area, False)
        key = {'n': n, 'area_wanted': area, 'seed': self.request.seed}
        known = self.store.find('loads', key)
        if known:
            return known
        if n > LARGEST_SEARCH:
            guess = self.load_for(LARGEST_SEARCH, area, False)['load']
        else:  # a coarser grid's answer is better than the theory's
            coarser = [row for row in self.store.rows('loads', area_wanted=area, seed=self.request.seed) if row['n'] < n]
            guess = max(coarser, key=lambda row: row['n'])['load'] if coarser else light_load(area)
        gap, most = self.gap(n), 1 if n > LARGEST_SEARCH else 6

        def work():
            found = find_load(unit_square(n), gap, area, guess, most, options_of(self.request))
            return {'load': found.load, 'approach': found.approach}
        return self.store.put('loads', key, checked(in_child(work)))

    def needed(self, n, area, control):
        """Bytes of a solve that takes as much a point as the finest grid so far, its gap included; at least a gap of doubles and an
        in-place transform of it."""
        known = [row for row in self.store.rows('solves', area_wanted=area, control=control, **self.settings) if 'error' not in row]
        return max(16 * n * n, max(known, key=lambda row: row['n'])['bytes_per_point_in_all'] * n * n if known else 0)

    def measure(self, n, area, control):
        """What became of it."""
        key = {'n': n, 'area_wanted': area, 'control': control, **self.settings}
        if self.store.known('solves', key):
            return 'measured before'
        available, least = available_memory() + self.kept.nbytes, self.needed(n, area, control)
        if least > available:
            return f'left out: it needs about {least / 1e9:.1f} GB, {available / 1e9:.1f} GB are there'
        target, gap = self.load_for(n, area, control == 'approach')[control], self.gap(n)

        def work():
            if 100 * n * n > available:
                limit_growth(available_memory())
            return measure_solve(self.request, area, gap, control, target, self.interpreter)

        row = self.store.put('solves', key, in_child(work))
        return row.get('error') or (f'{total_seconds(row):.3g} s, {row["products"]} products, '
                                    f'{row["bytes_per_point"]:.0f} bytes/point')

    def run(self):
        for n, area, control in ((n, area, control) for n in self.request.sizes for area in self.areas for control in self.request.controls):
            print(f'{n}^2, {100 * area:g} %, {control} control: {self.measure(n, area, control)}', file=sys.stderr)
        rows = sorted(self.store.rows('solves', **self.settings), key=lambda row: row['n'])
        print(f'Cold solves to a certified tolerance of {self.request.tol:g}, precision {self.request.precision}, {self.request.threads} threads')
        show(COLUMNS, [{**row, 'mark': ''} for row in rows])
        self.store.save()


question('scaling', 'time, products and memory against grid size and contact area', lambda request: Scaling(request).run(), {
    'sizes': (listed(side), [128, 256, 512, 1024, 2048], 'points per side'),
    'percents': (listed(percent), [1, 10, 40], 'contact areas in percent of the grid'),
    'controls': (listed(CONTROLS), ['approach', 'load'], 'approach, load'),
    'seed': (int, 1, 'of the surface'), 'tol': (float, 1e-8, 'certified tolerance'),
    'precision': (one_of('mixed', 'single'), 'mixed', 'of products: option fft.precision'), **ALL_THREADS,
    'budget': (float, 2, 'seconds for repeats of each solve')},
    {'sizes': [128, 256, 512], 'budget': 0.2}, 'up to 512^2, few repeats')
