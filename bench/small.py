"""Small contacts, in processor time of one thread: first and next cold solves, and next trials of a Gauss point, which are warm."""
from statistics import fmean

import numpy as np
import roughcontact as rc
from roughcontact import raw

from case import checked, cpu_seconds, in_child
from contact import certified, cold_call, find_load, unit_square
from options import listed, question, ranged, side
from scaling import SLOPE, light_load
from store import Store
from surfaces import self_affine_gap
from tables import show

GAUSS, LAW = 64, 128


def cold(n, count):
    """Milliseconds of a process' first solves, one after the other."""
    gap, pressure = self_affine_gap(n), np.zeros((n, n))
    calls = [cold_call(unit_square(n), gap, {'tol': 1e-8, 'threads': 1}, 'load', light_load(0.1), pressure) for _ in range(count)]
    return [1e3 * cpu for result, _, cpu in calls if certified(result)]


def trials(gap, share, control, request):
    """(least microseconds, products) of a trial by the C function itself, as a finite element program asks for it: a thousandth of the load or
    depth away from the last."""
    library, load = raw.contact_library(), find_load(unit_square(GAUSS), gap, share, light_load(share), 6, {'threads': 1}).load
    with rc.Contact(unit_square(GAUSS), options={'threads': 1, 'tol': 1e-8, 'bounds': 0}) as contact:
        result, seconds, counts, step, answer = certified(contact.solve(undeformed_gap=gap, load=load)), [], [], raw.rc_step(), raw.rc_result()
        target, change = (load, 1e-3 * load) if control == 'load' else (result.approach, 1e-3 * (result.approach - gap.min()))
        step.control = raw.RC_CONTROL_LOAD if control == 'load' else raw.RC_CONTROL_APPROACH
        with contact._holding() as handle:
            for _ in range(request.repeats):
                before = cpu_seconds()
                for k in range(request.trials):
                    step.target = target + change * (k % 20)
                    if library.rc_contact_solve(handle, step, answer) != 0:
                        raise RuntimeError(library.rc_last_error().decode())
                    counts.append(answer.products)
                seconds.append((cpu_seconds() - before) / request.trials)
    return 1e6 * min(seconds), fmean(counts)


def law(boundary, cold_ms):
    """(cost in cold solves of one thread, nodes solved) of the law of a 128^2 patch at its default tolerance, areas of some 1 to 30 %."""
    gap, system, costs = self_affine_gap(LAW), unit_square(LAW, boundary), []
    pressure = (light_load(0.01), light_load(0.3))  # on the unit square a load is a nominal pressure
    for _ in range(3):
        before = cpu_seconds()
        made = rc.law(undeformed_gap=gap, system=system, pressure=pressure, options={'threads': 1})
        costs.append(1e3 * (cpu_seconds() - before) / cold_ms)
    return min(costs), made.info['solves']


def run(request):
    rows, gap = [], self_affine_gap(GAUSS, rms_slope=SLOPE)
    for n in request.sizes:
        first, *others = checked(in_child(lambda n=n: cold(n, 1 + 10 * request.repeats)))
        rows += [{'row': f'{n}², 10 %: next solve [ms]', 'value': min(others)},
                 {'row': f'{n}², 10 %: first solve of a process over the next [ms]', 'value': first - min(others)}]
        if n == LAW:
            for boundary in ('free', 'periodic'):
                cost, solves = law(boundary, min(others))
                rows.append({'row': f'{n}², {boundary}: law of {solves} nodes over a cold solve', 'value': cost})
    for share, control in ((share, control) for share in (0.01, 0.1) for control in ('approach', 'load')):
        value, products = trials(gap, share, control, request)
        rows.append({'row': f'Gauss point {GAUSS}², {share:.0%}, {control}: next trial [µs], products {products:.1f}', 'value': value})
    Store(request.json, 'small', 1).save(rows=rows)
    show('row; least processor time={value:.3g}', rows)


question('small', 'small grids, and trials of a Gauss point', run, {
    'sizes': (listed(side), [32, 64, 128], 'points per side'), 'trials': (ranged(int, 1, 100000), 200, 'of a Gauss point in a row'),
    'repeats': (ranged(int, 1, 1000), 5, 'runs of which the least counts')}, {'sizes': [32], 'trials': 20, 'repeats': 1}, '32^2, one run')
