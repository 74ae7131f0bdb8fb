"""A loading history with warm starts against the same steps from zero."""
import sys

import roughcontact as rc

from case import Failure, cpu_seconds, in_child
from contact import OK, names, runs, status_of, unit_square
from options import THREADS, Question, listed, ranged, threads
from store import Store
from surfaces import below_highest, midpoint_surface
from tables import show


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
                result = contact.solve(displacement=approach, undeformed_gap=None if warm and k else self.gap, warm_start=warm, want_pressure=False,
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
    cold, warm = ([result for result, _ in history.run(options, start)] for start in (False, True))
    steps = [{'solver': variant, 'seed': seed, 'step': k + 1, 'contacts': c.contacts, 'candidates': c.candidates,
              'cold_products': c.applications, 'warm_products': w.applications, 'cold_seconds': c.seconds, 'warm_seconds': w.seconds,
              'cold_status': status_of(c), 'warm_status': status_of(w)} for k, (c, w) in enumerate(zip(cold, warm))]

    def total(results, key, first=0):
        return sum(getattr(result, key) for result in results[first:])

    sound = all(len(found) == request.steps and all(status_of(result) == OK for result in found) for found in (cold, warm))
    later = total(cold, 'applications', 1)
    return {'solver': variant.partition('@')[0], 'backend': backend, 'n': history.n, 'seed': seed, 'tol': request.tol,
            'cold_products': total(cold, 'applications'), 'warm_products': total(warm, 'applications'),
            'cold_iterations': total(cold, 'iterations'), 'warm_iterations': total(warm, 'iterations'),
            'ratio': total(warm, 'applications') / total(cold, 'applications'),
            'ratio_later': total(warm, 'applications', 1) / later if later else None, 'cold_seconds': total(cold, 'seconds'),
            'warm_seconds': total(warm, 'seconds'), 'load_difference': max(abs(w.load / c.load - 1) for c, w in zip(cold, warm)),
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
    show('solver; backend; n; seed; cold products=cold_products; warm products=warm_products; warm/cold=ratio:.2f; '
         'cold iterations=cold_iterations; warm iterations=warm_iterations; from step 2=ratio_later:.2f; cold s=cold_seconds:.2f; '
         'warm s=warm_seconds:.2f; load difference=load_difference:.0e; status', totals)
    store.document.update(histories=totals, steps=steps)
    store.save()


QUESTION = Question('histories', 'loading histories: warm starts against cold ones', run, {
    'levels': (ranged(int, 4, 13), 9, '2^levels points a side'), 'steps': (ranged(int, 2, 1000), 10, 'of increasing approach'),
    'seeds': (listed(int), [1], 'of the surfaces'),
    'solvers': (listed(str), [], 'name, name+key=value+..., either with @backend; every one, and nnls@dense'),
    'backend': (str, 'fft', 'by name'), 'tol': (float, 1e-8, 'certified tolerance'), 'threads': (threads, THREADS, 'threads'),
    'time_limit': (float, 120, 'seconds for one step; 0: none')})
