"""The rows that compare this library with itself alone, on one thread, each with its goal: processor time of a dense solve over its
products, small grids, Gauss points, batches, histories. Products by size: `counts`. Mapped grids and their memory: `mapped`. Peers: `peers`."""
import sys

import numpy as np
import roughcontact as rc

import native
from case import checked, cpu_seconds, in_child
from contact import certified, find_load, unit_square
from histories import ROUGH
from limits import ColdSolve
from options import listed, one_of, question, ranged, side
from samples import median
from scaling import SLOPE, light_load
from store import Store
from surfaces import below_highest, self_affine_gap
from tables import show

DOUBLE = 3  # products of a solve that are in double precision: two residuals and the certificate's
GAUSS = 64
TITLES = ('dense', 'small', 'gauss', 'batch', 'history')
UNMEASURED = ('Not measured here: products by size (counts), mapped grids and memory (mapped, scaling), other programs (peers). Times are processor '
              'times of one thread, the least of several runs; other work on the machine still lengthens them.')


def least(call, repeats):
    """Least processor time of a call [s]."""
    found = []
    for _ in range(repeats):
        before = cpu_seconds()
        call()
        found.append(cpu_seconds() - before)
    return min(found)


def dense(request):
    for n in request.sizes:
        def work(n=n):
            solve = ColdSolve(n, 10, 1e-8)
            solve.seconds(1)
            cpu = least(lambda: solve.seconds(1), request.repeats)
            single, double = (native.time_products(unit_square(n), solve.gap, solve.result.approach, 'fft', single=kind)['best'] for kind in (True, False))
            products = solve.result.applications
            return {'value': cpu / (single * (products - DOUBLE) + double * DOUBLE), 'more': f'{1e3 * cpu:.0f} ms, {products} products'}
        yield {'row': f'dense {n}², 10 %: solve over its products', 'goal': '1.5', **checked(in_child(work))}


def small(request):
    for n, goal in ((32, '0.5'), (64, '1.2'), (128, '5')):
        def work(n=n):
            solve = ColdSolve(n, 10, 1e-8)
            first = least(lambda: solve.seconds(1), 1)
            return [1e3 * first, 1e3 * least(lambda: solve.seconds(1), request.repeats)]
        runs = [checked(in_child(work)) for _ in range(request.repeats)]
        second = median([run[1] for run in runs])
        yield {'row': f'{n}², 10 %: second solve [ms]', 'goal': goal, 'value': second, 'more': f'first {median([run[0] for run in runs]):.2f} ms'}


def gauss(request):
    """Trials a thousandth of the load or depth apart, as a finite element program asks for them; the call from Python included."""
    gap = self_affine_gap(GAUSS, rms_slope=SLOPE)
    for percent, goal in ((1, '25'), (10, '120')):
        load = find_load(unit_square(GAUSS), gap, percent / 100, light_load(percent / 100), 6, {'threads': 1}).load
        for control in ('displacement', 'load'):
            with rc.Contact(unit_square(GAUSS), options={'threads': 1, 'tol': 1e-8, 'bounds': 0}) as contact:
                result = certified(contact.solve(undeformed_gap=gap, load=load))
                target, change = (load, 1e-3 * load) if control == 'load' else (result.approach, 1e-3 * (result.approach - gap.min()))
                counts = []

                def trials():
                    for k in range(request.trials):
                        counts.append(contact.solve(want_pressure=False, **{control: target + change * (k % 20)}).applications)
                seconds = least(trials, request.repeats) / request.trials
            yield {'row': f'Gauss point {GAUSS}², {percent} %, {control}: next trial [us]', 'goal': goal, 'value': 1e6 * seconds,
                   'more': f'{np.mean(counts):.1f} products'}


def batch(request):
    gaps = np.stack([below_highest(ROUGH.heights(128, seed)) for seed in range(1, request.surfaces + 1)])
    targets = 0.5 * gaps.mean(axis=(1, 2))[:, None] * np.arange(1, 11) / 10
    options = {'threads': 1, 'tol': 1e-8, 'solver': 'haar-cg', 'backend': 'fft'}
    found = []
    cpu = least(lambda: found.append(rc.batch(undeformed_gap=gaps, system=unit_square(128), options=options, displacement=targets)), request.repeats)
    products = int(np.maximum(found[0].applications, 0).sum()) / targets.size
    yield {'row': 'batch 128², 10 steps: solves per CPU second', 'goal': '2000', 'value': targets.size / cpu, 'more': f'{products:.1f} products a solve'}


def history(request):
    for n in request.histories:
        gap = self_affine_gap(n, rms_slope=SLOPE)
        gap -= gap.min()
        for boundary, control in ((b, c) for b in ('free', 'periodic') for c in ('displacement', 'load')):
            targets = gap.mean() / 2 * np.arange(1, 21) / 20

            def steps(warm, targets, control):
                counts, before = [], cpu_seconds()
                with rc.Contact(unit_square(n, boundary), options={'threads': 1, 'tol': 1e-8, 'bounds': 0}) as contact:
                    for k, target in enumerate(targets):
                        result = certified(contact.solve(undeformed_gap=None if warm and k else gap, warm_start=warm, want_pressure=False,
                                                         **{control: target}))
                        counts.append(result.applications)
                        if not warm:
                            contact.reset()
                return counts, cpu_seconds() - before, result.load

            if control == 'load':
                targets = steps(True, targets[-1:], 'displacement')[2] * np.arange(1, 21) / 20
            (cold, cold_cpu, _), (warm, warm_cpu, _) = steps(False, targets, control), steps(True, targets, control)
            yield {'row': f'history of 20 steps, {n}², {boundary}, {control}: warm over cold products', 'goal': '0.5', 'value': sum(warm) / sum(cold),
                   'more': f'CPU {warm_cpu / cold_cpu:.2f}; {sum(w > c for w, c in zip(warm, cold))} steps take more, {max(w - c for w, c in zip(warm, cold))} at most'}


def run(request):
    store, rows = Store(request.json, 'rows', 1), []
    for name in request.rows:
        for row in globals()[name](request):
            rows.append(row)
            print(row['row'], file=sys.stderr)
    store.save(rows=rows)
    show('row; measured={value:.3g}; goal; more', rows)
    print(UNMEASURED)


question('rows', 'what compares this library with itself alone, each row with its goal', run, {
    'rows': (listed(one_of(*TITLES)), list(TITLES), 'which'), 'sizes': (listed(side), [1024, 2048, 4096], 'points per side of dense solves'),
    'histories': (listed(side), [256, 512, 1024], 'points per side of histories'), 'surfaces': (ranged(int, 1, 1000), 40, 'of the batch'),
    'trials': (ranged(int, 1, 100000), 200, 'of a Gauss point in a row'), 'repeats': (ranged(int, 1, 1000), 5, 'runs of which the least counts')},
    {'sizes': [128], 'histories': [64], 'surfaces': 4, 'trials': 20, 'repeats': 1}, 'small sizes, one run each')
