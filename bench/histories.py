"""Loading histories: warm starts against the same steps from zero, and many small contacts in one call, with one thread and with several."""
import sys
import time

import numpy as np
import roughcontact as rc

from case import Failure, cpu_seconds, in_child
from contact import OK, names, runs, status_of, unit_square
from options import ALL_THREADS, CONTROLS, THREADS, listed, question, ranged, threads
from store import Store
from surfaces import SurfaceClass, below_highest, midpoint_surface
from tables import show

COLUMNS = ('solver; backend; n; seed; cold products={cold_products}; warm products={warm_products}; warm/cold={ratio:.2f}; '
           'cold iterations={cold_iterations}; warm iterations={warm_iterations}; from step 2={ratio_later:.2f}; cold s={cold_seconds:.2f}; '
           'warm s={warm_seconds:.2f}; load difference={load_difference:.0e}; status')
SUMS = {'products': 'products', 'iterations': 'iterations', 'seconds': 'seconds'}


class History:
    """Increasing approaches, down to half of the height of the highest point above the mean, on a midpoint displacement surface."""

    def __init__(self, levels, hurst, seed, steps):
        self.n, self.gap = 1 << levels, below_highest(midpoint_surface(levels, hurst, seed))
        self.approaches = [self.gap.mean() / 2 * k / steps for k in range(1, steps + 1)]

    def run(self, options, warm):
        """[(result, processor time)] of the steps; the first that runs out of time is the last."""
        found = []
        with rc.Contact(unit_square(self.n), options=options) as contact:
            for k, approach in enumerate(self.approaches):
                before = cpu_seconds()
                result = contact.solve(approach=approach, undeformed_gap=None if warm and k else self.gap, warm_start=warm, want_pressure=False,
                                       check=False)
                found.append((result, cpu_seconds() - before))
                if status_of(result) == 'RC_STOP_TIME':
                    break  # the later steps are no shorter
                if not warm:
                    contact.reset()
        return found


def parts_of(variant, backend):
    """(solver, backend, options) of "solver+key=value+key=value@backend"."""
    name, _, other = variant.partition('@')
    solver, *settings = name.split('+')
    if not all('=' in each for each in settings):
        raise Failure(f'"{name}" has something that is not key=value')
    return solver, other or backend, dict(each.split('=', 1) for each in settings)


def measure(request, variant, seed):
    history = History(request.levels, 0.7, seed, request.steps)
    solver, backend, settings = parts_of(variant, request.backend)
    options = {'solver': solver, 'backend': backend, 'tol': request.tol, 'threads': request.threads, 'time_limit': request.time_limit,
               'max_iter': 100000, **settings, **({'dense.memory_limit': 16384} if backend == 'dense' else {})}
    both = {name: [result for result, _ in history.run(options, name == 'warm')] for name in ('cold', 'warm')}
    cold, warm = both.values()
    steps = [{'solver': variant, 'seed': seed, 'step': k + 1, 'contacts': c.contacts, 'candidates': c.candidates,
              'cold_products': c.products, 'warm_products': w.products, 'cold_seconds': c.seconds, 'warm_seconds': w.seconds,
              'cold_status': status_of(c), 'warm_status': status_of(w)} for k, (c, w) in enumerate(zip(cold, warm))]

    def ratio(first):
        below = sum(result.products for result in cold[first:])
        return sum(result.products for result in warm[first:]) / below if below else None

    sound = all(len(found) == request.steps and all(status_of(result) == OK for result in found) for found in (cold, warm))
    return {'solver': variant.partition('@')[0], 'backend': backend, 'n': history.n, 'seed': seed, 'tol': request.tol,
            **{f'{name}_{key}': sum(getattr(result, member) for result in found) for key, member in SUMS.items() for name, found in both.items()},
            'ratio': ratio(0), 'ratio_later': ratio(1), 'load_difference': max(abs(w.load / c.load - 1) for c, w in zip(cold, warm)),
            'status': OK if sound else status_of(max(cold[-1], warm[-1], key=lambda result: result.status)), 'steps': steps}


def run(request):
    store, totals, steps = Store(request.json, 'histories', request.threads), [], []
    variants = request.solvers  # by default the paper's method with the paper's matrix first
    if not variants:
        variants = (['nnls@dense'] if request.backend != 'dense' else []) + names(rc.solvers)
    for variant in variants:
        solver, backend, _ = parts_of(variant, request.backend)
        if not runs(solver, backend, unit_square(1 << request.levels)):
            continue
        for seed in request.seeds:
            print(f'{solver} on {backend}, seed {seed}', file=sys.stderr)
            row = in_child(lambda: measure(request, variant, seed))
            steps += row.pop('steps', [])
            totals.append({'solver': variant, **row})
    print(f'{request.steps} increasing steps, warm-started and from zero, each certified to {request.tol:g}')
    show(COLUMNS, totals)
    store.save(histories=totals, steps=steps)


BLOCK = 40  # surfaces that are in memory at a time; one thread and several take turns on them
BATCH = ('threads; surfaces; grid={n}²; steps; control; time [s]={seconds:s}; surfaces/s={surfaces_per_second:.1f}; '
           'solves/s={solves_per_second:.0f}; products; certified')
ROUGH = SurfaceClass('roll-off at 4 waves', hurst=0.8, roll_off=4)


class Total:
    """What one way of solving needed for all blocks."""

    def __init__(self, request, threads):
        self.request, self.threads = request, threads
        self.seconds = self.cpu = self.certified = self.products = 0
        self.status = OK

    def solve(self, gaps, control, targets):
        """Loads [surfaces, steps]."""
        options = {'solver': self.request.solver, 'backend': self.request.backend, 'tol': self.request.tol, 'threads': self.threads}
        begun, cpu = time.perf_counter(), cpu_seconds()
        found = rc.batch(undeformed_gap=gaps, system=unit_square(self.request.points), options=options, check=False, **{control: targets})
        self.seconds += time.perf_counter() - begun
        self.cpu += cpu_seconds() - cpu
        self.certified += found.certified
        self.products += int(np.maximum(found.products, 0).sum())
        self.status = 'RC_' + found.status.name if self.status == OK else self.status
        return found.load

    def row(self):
        request, solves = self.request, self.request.surfaces * self.request.steps
        same = {key: getattr(request, key) for key in ('steps', 'control', 'solver', 'backend', 'tol')}
        return {'threads': self.threads, 'surfaces': request.surfaces, 'n': request.points, **same, 'seconds': self.seconds,
                'cpu_seconds': self.cpu, 'surfaces_per_second': request.surfaces / self.seconds, 'solves_per_second': solves / self.seconds,
                'products': self.products, 'certified': self.certified, 'status': self.status}


def run_batch(request):
    store = Store(request.json, 'batch', request.threads)
    approaches, one, several = Total(request, request.threads), Total(request, 1), Total(request, request.threads)
    for first in range(0, request.surfaces, BLOCK):
        seeds = range(first + 1, min(first + BLOCK, request.surfaces) + 1)
        gaps = np.stack([below_highest(ROUGH.heights(request.points, seed)) for seed in seeds])
        # Increasing approaches up to half the mean gap, or the loads found there.
        targets = 0.5 * gaps.mean(axis=(1, 2))[:, None] * np.arange(1, request.steps + 1) / request.steps
        if request.control == 'load':
            targets = approaches.solve(gaps, 'approach', targets)
        order = [one, several] if first // BLOCK % 2 == 0 else [several, one]
        alone, shared = (total.solve(gaps, request.control, targets) for total in order)
        if alone.tobytes() != shared.tobytes():
            raise Failure('loads depend on the number of threads')
        print(f'{seeds[-1]} of {request.surfaces} surfaces', file=sys.stderr)
    rows, scaling, growth = [one.row(), several.row()], one.seconds / several.seconds, several.cpu / one.cpu
    store.save(batch=rows, scaling=scaling, cpu_growth=growth)
    show(BATCH, rows)
    print(f'\n{request.threads} threads: {scaling:g} times as fast as one, with {growth:g} of its CPU time')


question('batch', 'histories of many small contacts in one call, with one thread and with several', run_batch, {
    'surfaces': (ranged(int, 1, 1000000), 1000, 'contacts'), 'points': (ranged(int, 16, 4096), 128, 'points per side'),
    'steps': (ranged(int, 1, 1000), 10, 'of each history'), 'threads': (threads, THREADS, 'threads, against one'),
    'control': (CONTROLS, 'approach', 'approach, or load'), 'solver': (str, 'haar-cg', 'by name, or auto'),
    'backend': (str, 'fft', 'by name, or auto'), 'tol': (float, 1e-8, 'certified tolerance')}, {'surfaces': 40}, '40 surfaces')


question('histories', 'loading histories: warm starts against cold ones', run, {
    'levels': (ranged(int, 4, 13), 9, '2^levels points a side'), 'steps': (ranged(int, 2, 1000), 10, 'of increasing approach'),
    'seeds': (listed(int), [1], 'of the surfaces'),
    'solvers': (listed(str), [], 'name, name+key=value+..., either with @backend; every one, and nnls@dense'),
    'backend': (str, 'fft', 'by name'), 'tol': (float, 1e-8, 'certified tolerance'), **ALL_THREADS,
    'time_limit': (float, 120, 'seconds for one step; 0: none')})
