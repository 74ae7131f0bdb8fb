"""Products of cold solves, on the finest grid alone, by size, contact area, boundary and control. One thread or many: the counts are the same."""
import sys

from case import checked, in_child
from contact import certified, find_load, share_in_contact, solve, unit_square
from options import ALL_THREADS, CONTROLS, listed, one_of, percent, question, side
from scaling import SLOPE, light_load
from store import Store
from surfaces import self_affine_gap
from tables import show

LARGEST_SEARCH = 1024  # points a side up to which the load for a contact area is searched; beyond it is that of this grid


def measure(request, n, boundary, area):
    """Products of both controls, the approach that which the load leads to."""
    options = {'threads': request.threads, 'bounds': 0}
    searched = self_affine_gap(min(n, LARGEST_SEARCH), request.seed, rms_slope=SLOPE)
    load = find_load(unit_square(len(searched), boundary), searched, area, light_load(area), 6, options).load
    gap, rows, target = self_affine_gap(n, request.seed, rms_slope=SLOPE), [], load
    for control in ('load', 'approach'):
        result = certified(solve(unit_square(n, boundary), gap, {**options, 'tol': request.tol}, want_pressure=False, **{control: target}))
        target = result.approach
        rows.append({'control': control, 'products': result.products, 'iterations': result.iterations, 'solver': result.solver,
                     'backend': result.backend, 'percent_found': 100 * share_in_contact(result)})
    return rows


def run(request):
    store, asked = Store(request.json, 'counts', request.threads), [(n, b, c) for n in request.sizes for b in request.boundaries for c in request.controls]
    for n in request.sizes:
        for boundary, percents in ((b, p) for b in request.boundaries for p in request.percents):
            for row in checked(in_child(lambda n=n, b=boundary, p=percents: measure(request, n, b, p / 100))):
                store.put('counts', {'n': n, 'boundary': boundary, 'control': row['control'], 'percent': percents, 'tol': request.tol}, row)
            print(f'{n}^2, {boundary}, {percents:g} %', file=sys.stderr)
    rows = []
    for n, boundary, control in asked:
        same = {row['percent']: row for row in store.rows('counts', n=n, boundary=boundary, control=control, tol=request.tol)}
        rows.append({'n': n, 'boundary': boundary, 'control': control, **{f'p{k}': same[p]['products'] for k, p in enumerate(request.percents)}})
    print(f'Products of cold solves to a certified {request.tol:g}, that of the certificate included, those on coarser grids not; by contact area')
    show('grid={n}²; boundary; control; ' + '; '.join(f'{p:g} %={{p{k}}}' for k, p in enumerate(request.percents)), rows)


question('counts', 'products of cold solves by size, contact area, boundary and control', run, {
    'sizes': (listed(side), [512, 1024, 2048, 4096], 'points per side'),
    'percents': (listed(percent), [0.1, 1, 10, 40], 'contact areas in percent of the grid, about'),
    'boundaries': (listed(one_of('free', 'periodic')), ['free', 'periodic'], 'free, periodic'),
    'controls': (listed(CONTROLS), ['approach', 'load'], 'approach, load'), 'seed': (int, 1, 'of the surface'),
    'tol': (float, 1e-8, 'certified tolerance'), **ALL_THREADS}, {'sizes': [128], 'percents': [1, 10]}, '128^2, two areas')
