"""Leaks: seconds of a leak with its proof over those of the contact of the same grid, the interval's width, and the package reynoldsflow on the same
gap where this Python has it. Periodic surfaces; along y, as reynoldsflow solves."""
import os
import time

import numpy as np
import roughcontact as rc

from case import in_child, peak_memory
from charts import Panels, axes, style
from contact import certified, find_load, unit_square
from options import ALL_THREADS, listed, percent, question, ranged, side
from scaling import light_load
from store import Store
from surfaces import self_affine_gap
from tables import show

COLUMNS = ('grid={n}²; tol={tol:.0e}; contact [%]={contact_percent:.3g}; contact [s]={contact_seconds:.3g}; leak [s]={seconds:.3g}; over the contact={solves:.1f}; '
           'width={width:.0e}; dropped cells [%]={dropped_percent:.2g}; peak [GB]={gigabytes:.2f}; reynoldsflow [s]={their_seconds:.3g}; '
           'over ours={times:.1f}; off by={off:.0e}')


def theirs(gap, n):
    """(seconds, conductivity) by reynoldsflow; NaN without it."""
    try:
        from reynoldsflow import transport
    except ImportError:
        return np.nan, np.nan
    transport.solve_fluid_problem(np.ones((16, 16)))  # compiles it
    begun = time.perf_counter()
    open_gap, _, flux = transport.solve_fluid_problem(gap)
    return time.perf_counter() - begun, transport.compute_total_flux(open_gap, flux, n)[0]


def leak(n, percents, tol, threads, repeats, compare):
    """A record of one grid."""
    gap, system, options = self_affine_gap(n, cut_off=n // 8), unit_square(n, 'periodic'), {'tol': tol, 'threads': threads}
    load = find_load(system, gap, percents / 100, light_load(percents / 100), 6, options).load
    pressing, leaking, found = [], [], None
    for _ in range(repeats):
        begun = time.perf_counter()
        with rc.Contact(system, options=options) as contact:
            result = certified(contact.solve(undeformed_gap=gap, load=load, want_gap=True))
        pressing.append(time.perf_counter() - begun)
        begun = time.perf_counter()
        found = result.leak(viscosity=1 / 12, pressure_drop=1, along='y')
        leaking.append(time.perf_counter() - begun)
    peak = peak_memory()
    gap = np.where(result.pressure > 0, 0, np.maximum(result.gap, 0))
    seconds, flow = theirs(gap, n) if compare else (np.nan, np.nan)
    return {'contact_percent': 100 * result.area_fraction, 'contact_seconds': min(pressing), 'seconds': min(leaking),
            'solves': min(leaking) / min(pressing), 'width': (found.upper - found.lower) / found.upper, 'dropped_percent': 100 * found.dropped,
            'gigabytes': peak / 1e9, 'their_seconds': seconds, 'times': seconds / min(leaking), 'off': abs(flow / found.flow - 1)}


def picture(rows, file):
    """The interval's width against seconds, a curve a grid."""
    drawing, curves, entries = Panels(560, 340, 1, 1), [], []
    for number, n in enumerate(sorted({row['n'] for row in rows})):
        points = [(row['contact_seconds'] + row['seconds'], row['width']) for row in rows if row['n'] == n]
        curves.append(drawing.curve(points, style(number)))
        entries.append((f'{n}²', style(number)))
    drawing.panel(0, 0, 'interval of the leak against time', axes('seconds of contact and leak', 'width over the flow', ('*', '*'), ('*', '*')), curves)
    drawing.draw(os.path.abspath(file), entries, 4)


def run(request):
    store = Store(request.json, 'leak', request.threads)
    for n in request.sizes:
        for tol in request.tols:
            key = {'n': n, 'percent_wanted': request.percent, 'tol': tol}
            store.put('leaks', key, in_child(lambda n=n, tol=tol: leak(n, request.percent, tol, request.threads, request.repeats,
                                                                                  n <= request.peer)))
    show(COLUMNS, store.rows('leaks'))
    if request.picture:
        picture([row for row in store.rows('leaks') if 'error' not in row], request.picture)


question('leak', 'leaks with their proof, against contacts and reynoldsflow', run, {
    'sizes': (listed(side), [512, 1024, 2048], 'points per side'), 'percent': (percent, 20.0, 'contact area'),
    'tols': (listed(ranged(float, 1e-14, 1)), [1e-8], 'of the contact'), 'repeats': (ranged(int, 1, 100), 3, 'runs of which the least counts'),
    'peer': (ranged(int, 0, 16384), 1024, 'points per side up to which reynoldsflow solves as well'),
    'picture': (str, '', 'file for a chart of width against seconds'), **ALL_THREADS},
    {'sizes': [64], 'repeats': 1}, '64^2, one run')
