"""What a solve through Python takes more than the same calls of C: the least wall time of many, 64² points."""
from time import perf_counter

import numpy as np
import roughcontact as rc
from roughcontact import raw

from contact import unit_square
from options import question, ranged
from scaling import light_load
from store import Store
from surfaces import self_affine_gap
from tables import show

SIDE, SHARE = 64, 0.1
OPTIONS = {'threads': 1, 'tol': 1e-8}


def least(function, repeats):
    """Microseconds."""
    times = []
    for _ in range(repeats):
        before = perf_counter()
        function()
        times.append(perf_counter() - before)
    return 1e6 * min(times)


def run(request):
    gap, system, load = self_affine_gap(SIDE), unit_square(SIDE), light_load(SHARE)
    library, pressure = raw.contact_library(), np.zeros((SIDE, SIDE))
    step, result = raw.rc_step(), raw.rc_result()
    step.control, step.target = raw.RC_CONTROL_LOAD, load
    step.undeformed_gap.data, result.p.data = gap.ctypes.data, pressure.ctypes.data
    with rc.Contact(system, options=OPTIONS) as contact:
        contact.solve(undeformed_gap=gap, load=load)
        with contact._holding() as handle:
            c = least(lambda: library.rc_contact_solve(handle, step, result), request.repeats)
        python = least(lambda: contact.solve(undeformed_gap=gap, load=load), request.repeats)
    rows = [{'row': name, 'value': value} for name, value in
            (('rc_contact_solve', c), ('Contact.solve', python), ('Contact.solve more than C', python - c))]
    Store(request.json, 'overhead', 1).save(rows=rows)
    show('row; least wall time [µs]={value:.0f}', rows)


question('overhead', 'what Python adds to a warm solve of 64² points', run, {'repeats': (ranged(int, 1, 100000), 2000, 'solves')})
