"""Time, products and memory of cold solves against the number of points, the contact area and the control."""
import math
import sys
import time

import numpy as np
import roughcontact as rc

import native
from case import available_memory, checked, in_child, interpreter_memory, limit_growth, peak_memory, resident_memory
from contact import OK, share_in_contact, time_solve, unit_square
from options import CONTROLS, THREADS, Question, listed, one_of, percent, side, threads
from samples import slope
from store import Store
from surfaces import self_affine_gap
from tables import show

LARGEST_SEARCH = 2048   # points a side up to which the load for a contact area is searched
LARGEST_PROFILE = 4096  # and up to which products are timed by themselves
FIRST_OF_GROWTH = 512
SPARSE = 0.01  # contact below which no array of pressures over all points is asked for: rc_contact_points has them
SLOPE = 0.1  # rms, of the surface
COLUMNS = ('n; area=area_found:.4f; control; solver; backend; set-up s=setup_seconds:.4f; solve s=solve_seconds:.4f; '
           'CPU s=cpu_seconds:.4f; iterations; products; product s=product_seconds_best:.5f; B/point=bytes_per_point:.0f; '
           'in all=bytes_per_point_in_all:.0f; candidates; modelled; contacts; primal=kkt_primal:.0e; dual=kkt_dual:.0e; '
           'compl.=kkt_complementarity:.0e; load=kkt_control:.0e; status')


def options_of(request, tol):
    options = {'solver': request.solver, 'backend': request.backend, 'threads': request.threads, 'tol': tol}
    return options if request.precision == 'mixed' else {**options, 'fft.precision': request.precision}


def light_load(area):
    """Bush, Gibson & Thomas (1975): area = sqrt(2 pi) p / (E* rms slope) at light loads."""
    return area / math.sqrt(2 * math.pi) * SLOPE


def find_load(request, gap, area, guess, most_solves):
    """Load that brings a share `area` of the surface into contact, from load ~ area at first, and the approach under it. Solves
    loosely, in load control."""
    load, exponent, last = guess, 1, None  # exponent: d log load / d log area
    with rc.Contact(unit_square(len(gap)), options=options_of(request, 1e-3)) as contact:
        for k in range(most_solves):
            result = contact.solve(load=load, undeformed_gap=gap if k == 0 else None, check=False, want_pressure=False)
            found = share_in_contact(result)
            if found == 0:
                load *= 2
                continue
            if abs(found / area - 1) <= 0.03:
                break
            if last and found != last[0]:
                exponent = min(max(math.log(load / last[1]) / math.log(found / last[0]), 0.5), 3)
            last = found, load
            load *= (area / found)**exponent
    return {'load': result.load, 'displacement': result.approach}


def measure_solve(request, area, gap, control, target, interpreter):
    """A cold solve, its peak memory, then the product on the same trial set. interpreter: memory that is not the library's [bytes]."""
    system, points = unit_square(len(gap)), gap.size
    pressure = np.full(gap.shape, 0.0) if area >= SPARSE else None
    before = resident_memory()
    result, row = time_solve(system, gap, options_of(request, request.tol), request.budget, control, target, pressure)
    peak = max(peak_memory(), before)
    row.update(area_found=share_in_contact(result), peak_bytes=peak - interpreter, bytes_per_point=(peak - before) / points,
               bytes_per_point_in_all=(peak - interpreter) / points)
    if len(gap) <= LARGEST_PROFILE and row['status'] == OK:
        product = native.time_products(system, gap, result.approach, result.backend, threads=request.threads, budget=request.budget / 4)
        row.update(product_seconds_best=product['best'], product_seconds_median=product['median'], product_count=product['count'])
    return row


class Scaling:
    def __init__(self, request):
        self.request, self.store = request, Store(request.json, 'scaling', request.threads)
        self.settings = {'tol': request.tol, 'precision': request.precision, 'threads': request.threads, 'seed': request.seed,
                         'solver_option': request.solver, 'backend_option': request.backend}
        self.areas = [value / 100 for value in request.percents]
        self.begun, self.interpreter, self.kept = time.monotonic(), interpreter_memory(), np.empty(0)

    def gap(self, n):
        if len(self.kept) != n:
            self.kept = np.empty(0)
            self.kept = self_affine_gap(n, self.request.seed, rms_slope=SLOPE)
        return self.kept

    def load_for(self, n, area, approach):
        """The load for an area, and for displacement control the approach under it. Found once, on a grid that is not too fine, and kept
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
        return self.store.put('loads', key, checked(in_child(lambda: find_load(self.request, gap, area, guess, most))))

    def needed(self, n, area, control):
        """Bytes of a solve that takes as much a point as the finest grid so far, its gap included; at least the gap and an in-place
        transform of it."""
        known = [row for row in self.store.rows('solves', area_wanted=area, control=control, **self.settings) if 'peak_bytes' in row]
        return max(16 * n * n, max(known, key=lambda row: row['n'])['bytes_per_point_in_all'] * n * n if known else 0)

    def measure(self, n, area, control):
        """False where the time is up."""
        key = {'n': n, 'area_wanted': area, 'control': control, **self.settings}
        name = f'{n}^2, {100 * area:g} %, {control} control'

        def say(text):
            print(f'{name}: {text}', file=sys.stderr)

        if self.store.known('solves', key):
            say('measured before')
            return True
        if 0 < self.request.time_limit < time.monotonic() - self.begun:
            say('not begun, the time is up')
            return False
        available, least = available_memory() + self.kept.nbytes, self.needed(n, area, control)
        if least > available:
            say(f'left out: it needs about {least / 1e9:.1f} GB, {available / 1e9:.1f} GB are there')
            return True
        target, gap = self.load_for(n, area, control == 'displacement')[control], self.gap(n)

        def work():
            if 100 * n * n > available:
                limit_growth(available_memory())
            return measure_solve(self.request, area, gap, control, target, self.interpreter)

        row = self.store.put('solves', key, in_child(work))
        say(row['error'] if 'error' in row else f'{row["setup_seconds"] + row["solve_seconds"]:.3g} s, {row["products"]} products, '
            f'{row["bytes_per_point"]:.0f} bytes/point')
        return True

    def run(self):
        with_all = ((n, area, control) for n in self.request.sizes for area in self.areas for control in self.request.controls)
        all(self.measure(*each) for each in with_all)
        rows = sorted(self.store.rows('solves', **self.settings), key=lambda row: row['n'])
        print(f'Cold solves to a certified tolerance of {self.request.tol:g}, precision {self.request.precision}, {self.request.threads} threads')
        show(COLUMNS, rows)
        growth = []
        for area in self.areas:
            for control in self.request.controls:
                found = [(row['n'], row['products']) for row in rows if row['area_wanted'] == area and row['control'] == control and
                         row['n'] >= FIRST_OF_GROWTH and row.get('status') == OK]
                if len({n for n, _ in found}) > 1:
                    growth.append({**self.settings, 'area_wanted': area, 'control': control, 'from': FIRST_OF_GROWTH, 'exponent': slope(found)})
                    print(f'products at {100 * area:g} %, {control} control, from {FIRST_OF_GROWTH}^2 on: N^{growth[-1]["exponent"]:.2f}, '
                          'N points a side')
        self.store.document['growth'] = growth
        self.store.save()


def run(request):
    rc.effective_options(options_of(request, request.tol))  # what the library refuses, it refuses before anything is measured
    Scaling(request).run()


QUESTION = Question('scaling', 'time, products and memory against grid size and contact area', run, {
    'sizes': (listed(side), [128, 256, 512, 1024, 2048], 'points per side'),
    'percents': (listed(percent), [1, 10, 40], 'contact areas in percent of the grid'),
    'controls': (listed(CONTROLS), ['displacement', 'load'], 'displacement, load'),
    'seed': (int, 1, 'of the surface'), 'tol': (float, 1e-8, 'certified tolerance'),
    'precision': (one_of('mixed', 'single'), 'mixed', 'of products: option fft.precision'),
    'solver': (str, 'auto', 'by name, or auto'), 'backend': (str, 'auto', 'by name, or auto'), 'threads': (threads, THREADS, 'threads'),
    'budget': (float, 2, 'seconds for repeats of each solve'),
    'time_limit': (float, 0, 'seconds after which no row begins; 0: none')},
    {'sizes': [128, 256, 512], 'budget': 0.2}, 'up to 512^2, few repeats')
