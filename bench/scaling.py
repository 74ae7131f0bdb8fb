"""Time, products and memory of cold solves against the number of points, the contact area and the control. And dilute contacts: one product by
backends "split" and "fft" in both precisions, and solves by default options and over the whole grid."""
import math
import sys
import time

import numpy as np
import roughcontact as rc

import native
from case import available_memory, checked, in_child, interpreter_memory, limit_growth, peak_memory, resident_memory
from contact import OK, difference, find_load, share_in_contact, time_solve, unit_square
from options import ALL_THREADS, CONTROLS, NAMED, THREADS, listed, one_of, percent, question, ranged, side, threads
from samples import chosen, groups, slope, solved, total_seconds
from store import Store
from surfaces import Hertz, asperity_band, paraboloid_gap, self_affine_gap
from tables import show

LARGEST_SEARCH = 2048   # points a side up to which the load for a contact area is searched
LARGEST_PROFILE = 4096  # and up to which products are timed by themselves
GROWING = range(512, 4097)  # grids whose products are counted
SPARSE = 0.01  # contact below which no array of pressures over all points is asked for: rc_contact_points has them
SLOPE = 0.1  # rms, of the surface
COLUMNS = ('n; area={area_found:.4f}; control; solver; backend; set-up s={setup_seconds:.4f}; solve s={solve_seconds:.4f}; '
           'CPU s={cpu_seconds:.4f}; iterations; products; product s={product_seconds_best:.5f}; B/point={bytes_per_point:.0f}; '
           'in all={bytes_per_point_in_all:.0f}; candidates; modelled; contacts; primal={kkt_primal:.0e}; dual={kkt_dual:.0e}; '
           'compl.={kkt_complementarity:.0e}; load={kkt_control:.0e}; status')
GROWTH = 'contact [%]={area_wanted:%.3g}; control; grids={from}² to {to}²; products={least} to {most}; growth=N^{exponent:.2f}'


def certified_rows(document, **values):
    """Cold solves by everything that `auto` chooses, or with other values of their keys, by growing size."""
    wanted = {'tol': 1e-8, 'precision': 'mixed', 'solver_option': 'auto', 'backend_option': 'auto', **values}
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
    options = {'solver': request.solver, 'backend': request.backend, 'threads': request.threads, 'tol': request.tol}
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
    row.update(area_found=share_in_contact(result), peak_bytes=peak - interpreter, bytes_per_point=(peak - before) / points,
               bytes_per_point_in_all=(peak - interpreter) / points)
    if len(gap) <= LARGEST_PROFILE and row['status'] == OK:
        product = native.time_products(system, np.asarray(gap, float), result.approach, result.backend, threads=request.threads, budget=request.budget / 4)
        row.update(product_seconds_best=product['best'], product_seconds_median=product['median'], product_count=product['count'])
    return row


class Scaling:
    def __init__(self, request):
        self.request, self.store = request, Store(request.json, 'scaling', request.threads)
        self.settings = {'tol': request.tol, 'precision': request.precision, 'threads': request.threads, 'seed': request.seed,
                         'solver_option': request.solver, 'backend_option': request.backend}
        self.real = np.float32 if request.precision == 'single' else float  # of the gap and the pressures
        self.areas = [value / 100 for value in request.percents]
        self.begun, self.interpreter, self.kept = time.monotonic(), interpreter_memory(), np.empty(0)

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
        known = [row for row in self.store.rows('solves', area_wanted=area, control=control, **self.settings) if 'peak_bytes' in row]
        return max(16 * n * n, max(known, key=lambda row: row['n'])['bytes_per_point_in_all'] * n * n if known else 0)

    def measure(self, n, area, control):
        """What became of it; None where the time is up."""
        key = {'n': n, 'area_wanted': area, 'control': control, **self.settings}
        if self.store.known('solves', key):
            return 'measured before'
        if 0 < self.request.time_limit < time.monotonic() - self.begun:
            return None
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
            said = self.measure(n, area, control)
            print(f'{n}^2, {100 * area:g} %, {control} control: {said or "not begun, the time is up"}', file=sys.stderr)
            if not said:
                break
        rows = sorted(self.store.rows('solves', **self.settings), key=lambda row: row['n'])
        print(f'Cold solves to a certified tolerance of {self.request.tol:g}, precision {self.request.precision}, {self.request.threads} threads')
        show(COLUMNS, rows)
        growth = growth_of(solved(rows))
        if growth:
            print('Growth of the products, N points a side')
            show(GROWTH, growth)
        self.store.save(growth=growth)


def run(request):
    rc.effective_options(options_of(request))  # what the library refuses, it refuses before anything is measured
    Scaling(request).run()


TRIAL_POINTS = 4  # a contact: the trial set that a solver works on holds it and about three times as many points around it
ASPERITY_AREA = 0.001
DILUTE_SOLVES = ('surface={scene}; grid={n}²; contact [%]={auto[contact_percent]:.3g}; control; tol={tol:err}; auto={auto[solver]}, {auto[backend]}; '
          'auto [s]={auto[seconds]:s}; full grid [s]={fft[seconds]:s}; ratio={ratio:.1f}; products={auto[products]}; '
          'auto, peak [MB]={auto[peak_megabytes]:.0f}; full grid, peak [MB]={fft[peak_megabytes]:.0f}')
DILUTE_PRODUCTS = ('grid={n}²; contact [%]={contact_percent:.3g}; threads; fft [ms]={fft_ms:.3g}; split [ms]={split_ms:.3g}; ratio={ratio:.3g}; '
            'fft, single [ms]={fft_float_ms:.3g}; split, single [ms]={split_float_ms:.3g}; ratio={float_ratio:.3g}; difference={difference:err}')


def products_row(n, gap, approach, count, budget):
    def timed(backend, single):
        return native.time_products(unit_square(n), gap, approach, backend, threads=count, budget=budget, single=single,
                                    share=1 / TRIAL_POINTS, want=gap.size)

    fft, split, fft_float, split_float = (timed(backend, single) for single in (False, True) for backend in ('fft', 'split'))
    return {'n': n, 'contact_percent': 100 * split['contacts'] / n**2, 'contacts': split['contacts'], 'points': split['points'],
             'threads': count, 'fft_ms': 1e3 * fft['best'], 'split_ms': 1e3 * split['best'], 'ratio': fft['best'] / split['best'],
             'fft_first_ms': 1e3 * fft['first'], 'split_first_ms': 1e3 * split['first'], 'split_float_ms': 1e3 * split_float['best'],
             'fft_float_ms': 1e3 * fft_float['best'], 'float_ratio': fft_float['best'] / split_float['best'],
             'difference': difference(split['y'][:split['points']], fft['y'][:fft['points']])}


def dilute_products(request):
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


class DiluteSolves:
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
                return load, found['approach']
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


def dilute(request):
    store = Store(request.json, 'dilute', request.threads)
    request.sizes = request.sizes + ([8192, 16384] if request.large else [])
    if not request.solves_only:
        store.document['dilute'] = dilute_products(request)
    if not request.products_only:
        store.document['solves'] = DiluteSolves(request).run()
    store.save()
    print('Cold solves: auto, all options at their defaults; full grid, backend fft and haar-cg with a candidate in each corner, which keeps it\n'
          'from working on a box around the contact. ratio: seconds over those of auto, with set-up. peak: with the gap. Then products')
    show(DILUTE_SOLVES, store.document.get('solves', []))
    show(DILUTE_PRODUCTS, store.document.get('dilute', []))


question('dilute', 'dilute contacts: products by backends split and fft, and solves', dilute, {
    'sizes': (listed(side), [1024, 2048, 4096], 'points per side'),
    'contacts': (listed(ranged(float, 0.001, 25)), [0.04, 0.1, 1, 10], 'contact areas in percent of the grid'),
    'threads': (threads, THREADS, 'threads; products with one as well'), 'seed': (int, 1, 'of the surface'),
    'budget': (float, 0.3, 'seconds for repeats of each product and solve'),
    'controls': (listed(CONTROLS), ['approach', 'load'], 'approach, load'),
    'tols': (listed(float), [1e-8, 1e-4], 'certified tolerances of the solves'),
    'largest_full': (int, 4096, 'points a side up to which solves go over the whole grid as well'),
    'large': (bool, False, '8192^2 and 16384^2 as well'), 'products_only': (bool, False, 'no solves'), 'solves_only': (bool, False, 'no products')})


question('scaling', 'time, products and memory against grid size and contact area', run, {
    'sizes': (listed(side), [128, 256, 512, 1024, 2048], 'points per side'),
    'percents': (listed(percent), [1, 10, 40], 'contact areas in percent of the grid'),
    'controls': (listed(CONTROLS), ['approach', 'load'], 'approach, load'),
    'seed': (int, 1, 'of the surface'), 'tol': (float, 1e-8, 'certified tolerance'),
    'precision': (one_of('mixed', 'single'), 'mixed', 'of products: option fft.precision'), **NAMED, **ALL_THREADS,
    'budget': (float, 2, 'seconds for repeats of each solve'), 'time_limit': (float, 0, 'seconds after which no row begins; 0: none')},
    {'sizes': [128, 256, 512], 'budget': 0.2}, 'up to 512^2, few repeats')
