"""Products that the stiffness takes beside those of the contact, and the residual that its solve reached."""
import re
import sys

import roughcontact as rc

from case import Failure, in_child
from contact import certified, share_in_contact, unit_square
from options import CONTROLS, THREADS, Question, listed, one_of, percent, side, threads
from scaling import light_load
from store import Store
from surfaces import self_affine_gap
from tables import show

PATCH = 64  # points a side of a warm step, as an element of a larger model has them


class Counted:
    """Contacts of one system with and without the stiffness. What the library logs of the latter tells the residual."""

    def __init__(self, n, boundary, request):
        said = []
        context, options = rc.Context(log=lambda _, text: said.append(text)), {'threads': request.threads, 'tol': request.tol, **({'solver': 'haar-cg', 'backend': 'fft'} if n == PATCH else {})}
        self.said, system = said, unit_square(n, boundary)
        self.plain, self.full = (rc.Contact(system, options={**options, 'stiffness': with_it}, context=context) for with_it in (0, 1))

    def step(self, **step):
        plain, full = (certified(contact.solve(want_pressure=False, **step)) for contact in (self.plain, self.full))
        found = re.findall(r'stiffness: residual (\S+)', ' '.join(self.said))
        if not found:
            raise Failure('the stiffness took no iteration')
        extra = full.applications - plain.applications
        return full, {'found_percent': 100 * share_in_contact(full), 'contact': plain.applications, 'stiffness': extra,
                      'ratio': extra / plain.applications, 'residual': float(found[-1]), 'backend': full.backend}


def pressed(n, boundary, control, area, request, warm):
    """A row: cold, or after a step with a thousandth less approach or load."""
    gap, load = self_affine_gap(n, request.seed), light_load(area)
    with rc.Contact(unit_square(n, boundary), options={'tol': 1e-2, 'threads': request.threads}) as loose:
        for _ in range(4):
            result = loose.solve(load=load, gap=gap, want_pressure=False, check=False)
            load *= min(max(area / max(share_in_contact(result), area / 4), 0.25), 4)
    target = result.load if control == 'load' else result.displacement
    counted = Counted(n, boundary, request)
    row = counted.step(gap=gap, **{control: target})[1]
    if warm:
        depth = target if control == 'load' else target - gap.min()
        row = counted.step(**{control: target + 1e-3 * depth})[1]
    return row


def run(request):
    store = Store(request.json, 'stiffness', request.threads)
    rows = []
    for n in [PATCH, *request.sizes]:
        for area in request.percents:
            for boundary in request.boundaries:
                for control in request.controls:
                    row = in_child(lambda n=n, area=area, boundary=boundary, control=control:
                                   pressed(n, boundary, control, area / 100, request, n == PATCH))
                    rows.append({'n': n, 'step': 'warm' if n == PATCH else 'cold', 'percent': area, 'boundary': boundary, 'control': control,
                                 **row})
                    print(f'{n}^2, {area:g} %, {boundary}, {control}', file=sys.stderr)
    store.document['stiffness'] = rows
    store.save()
    print(f'Products of a step certified to {request.tol:g}, and of its stiffness to the residual that is told')
    show('n; step; wanted %=percent; %=found_percent:.2f; boundary; control; backend; contact; stiffness; ratio:.2f; residual:.0e', rows)


QUESTION = Question('stiffness', 'products of the stiffness beside those of the contact', run, {
    'sizes': (listed(side), [512, 1024, 2048], 'points per side of cold solves'),
    'percents': (listed(percent), [1, 10, 40], 'contact areas in percent of the grid, about'),
    'boundaries': (listed(one_of('free', 'periodic')), ['free', 'periodic'], 'free, periodic'),
    'controls': (listed(CONTROLS), ['displacement', 'load'], 'displacement, load'), 'seed': (int, 1, 'of the surfaces'),
    'tol': (float, 1e-8, 'certified tolerance'), 'threads': (threads, THREADS, 'threads')},
    {'sizes': [128], 'percents': [10]}, '128^2, one contact area')
