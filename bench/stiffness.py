"""Products that the stiffness, its interval and gradients take beside those of the contact, the residual that the stiffness' solve
reached, and the width of the interval."""
import sys

import numpy as np

import roughcontact as rc

from case import in_child
from contact import certified, find_load, share_in_contact, unit_square
from options import ALL_THREADS, CONTROLS, listed, one_of, percent, question, side
from scaling import light_load
from store import Store
from surfaces import self_affine_gap
from tables import show

PATCH = 64  # points a side of a warm step, as an element of a larger model has them


def measure(n, boundary, control, area, request):
    """Of a cold step; on a patch, of one after a step with a thousandth less load or depth."""
    system, gap, said = unit_square(n, boundary), self_affine_gap(n, request.seed), []
    found = find_load(system, gap, area, light_load(area), 4, {'threads': request.threads})
    target, depth = (found.load, found.load) if control == 'load' else (found.approach, found.approach - gap.min())
    context = rc.Context(log=lambda _, text: said.append(text))  # the library logs the residual
    options = {'threads': request.threads, 'tol': request.tol, **({'solver': 'haar-cg', 'backend': 'fft'} if n == PATCH else {})}
    products, residual, gradients = [], [], []
    for stiffness in (0, 1, 2):
        with rc.Contact(system, options={**options, 'stiffness': stiffness}, context=context) as contact:
            for k in range(2 if n == PATCH else 1):
                said.clear()
                result = certified(contact.solve(undeformed_gap=gap, want_pressure=False, **{control: target + 1e-3 * k * depth}))
            products.append(result.products)
            residual += said[:1]
            if stiffness == 0:
                by = np.random.default_rng(request.seed).standard_normal((2, *gap.shape))
                gradients = [contact.gradient().products, contact.gradient(*by).products]
    extra, more = products[1] - products[0], products[2] - products[1]
    width = (result.stiffness_upper - result.stiffness_lower) / result.stiffness
    return {'found': 100 * share_in_contact(result), 'contact': products[0], 'stiffness': extra, 'ratio': extra / products[0],
            'interval': more, 'width': 100 * width, 'load': gradients[0], 'load_ratio': gradients[0] / products[0],
            'gradient': gradients[1], 'gradient_ratio': gradients[1] / products[0], 'backend': result.backend,
            **({'residual': float(residual[0].split()[-1])} if residual else {})}  # none where a matrix is factored


def run(request):
    store, rows = Store(request.json, 'stiffness', request.threads), []
    for n in [PATCH, *request.sizes]:
        for case in ((b, c, a) for a in request.percents for b in request.boundaries for c in request.controls):
            row = in_child(lambda n=n, case=case: measure(n, case[0], case[1], case[2] / 100, request))
            names = dict(zip(('boundary', 'control', 'percent'), case))
            rows.append({'n': n, 'step': 'warm' if n == PATCH else 'cold', **names, **row})
            print(n, *case, file=sys.stderr)
    store.save(stiffness=rows)
    print(f'Products of a step certified to {request.tol:g}; of its stiffness to the residual that is told, and of the interval, with '
          'its width in percent of the stiffness; of gradients: of load or approach, and of a function of all pressures and gaps')
    show('n; step; %={percent}; found %={found:.2f}; boundary; control; backend; contact; stiffness; ratio={ratio:.2f}; '
         'residual={residual:.0e}; interval; width %={width:.1e}; load; ratio={load_ratio:.2f}; gradient; '
         'ratio={gradient_ratio:.2f}', rows)


question('stiffness', 'products of stiffness and gradients beside those of the contact', run, {
    'sizes': (listed(side), [512, 1024, 2048], 'points per side of cold solves'),
    'percents': (listed(percent), [1, 10, 40], 'contact areas in percent of the grid, about'),
    'boundaries': (listed(one_of('free', 'periodic')), ['free', 'periodic'], 'free, periodic'),
    'controls': (listed(CONTROLS), ['approach', 'load'], 'approach, load'), 'seed': (int, 1, 'of the surfaces'),
    'tol': (float, 1e-8, 'certified tolerance'), **ALL_THREADS}, {'sizes': [128], 'percents': [10]}, '128^2, 10 %%')
