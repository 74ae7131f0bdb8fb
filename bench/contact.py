"""Calls of the library as the benchmarks make them, and what is recorded of them."""
import ctypes
import math
import re
import time
from dataclasses import dataclass, replace

import numpy as np
import roughcontact as rc
from roughcontact import raw
from roughcontact._arrays import given
from roughcontact._errors import error_for
from roughcontact.context import OptionSet
from roughcontact.result import result_from

from case import cpu_seconds, repeats

OK = 'RC_OK'


@dataclass(frozen=True)
class Scene:
    """A gap [ny, nx] pressed to an approach; contact modulus 1."""
    name: str
    gap: np.ndarray
    approach: float = 0.0
    pitch: tuple = (1.0, 1.0)
    kernel: str = 'love'
    mask: np.ndarray = None
    modulus: float = 1.0

    @property
    def system(self):
        return rc.HalfSpace(self.gap.shape, pitch=self.pitch, modulus=self.modulus, boundary='free')

    def but(self, **changes):
        return replace(self, **changes)


def unit_square(n, boundary='free', aspect=1.0):
    """n x n cells of the unit square, contact modulus 1."""
    return rc.HalfSpace((n, n), pitch=(1 / n, aspect / n), modulus=1, boundary=boundary)


def status_of(result):
    return 'RC_' + result.status.name


def solve(system, gap, options, **more):
    """A cold solve; its status says how it ended. more: approach or load, mask, start, want_pressure."""
    with rc.Contact(system, options=options) as contact:
        return contact.solve(undeformed_gap=gap, check=False, borrow=True, **more)


def press(scene, options, start=None):
    """(result, processor time of the whole call [s])"""
    before = cpu_seconds()
    found = solve(scene.system, scene.gap, {'kernel': scene.kernel, **options}, approach=scene.approach, mask=scene.mask, start=start)
    return found, cpu_seconds() - before


def certified(result):
    if status_of(result) != OK:
        raise rc.NotCertifiedError(f'{status_of(result)}: {result.message}')
    return result


def share_in_contact(result):
    return result.contacts / result.points


def find_load(system, gap, area, load, most, options):
    """The last of at most so many loose solves in load control that bring a share `area` of the points into contact, to 3 %. load: a guess."""
    exponent, last = 1, None  # exponent: d log load / d log area
    with rc.Contact(system, options={**options, 'tol': 1e-3}) as contact:
        for k in range(most):
            result = contact.solve(load=load, undeformed_gap=None if k else gap, check=False, want_pressure=False)
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
    return result


def runs(solver, backend, system, load=False):
    return rc.supported(solver, backend, system, load=load)[0] == rc.Status.OK


def names(components):
    return [each.name for each in components()]


def difference(a, b):
    """Largest |a - b| over largest |b|."""
    largest = np.abs(b).max()
    return float(np.abs(a - b).max() / (largest if largest > 0 else 1))


def record_of(result):
    same = 'solver', 'backend', 'candidates', 'modelled', 'contacts', 'iterations', 'products', 'residual'
    return {'status': status_of(result), **{key: getattr(result, key) for key in same}, 'solve_seconds': result.seconds}


def cold_call(system, gap, options, control, target, pressure=None):
    """(result, seconds of the whole call, its processor time) of one cold solve by the C functions themselves. Arrays of doubles or floats."""
    struct, _ = system.struct()
    library, handle, step, answer = raw.contact_library(), ctypes.c_void_p(), raw.rc_step(), raw.rc_result()
    step.control, step.target, step.borrow = (raw.RC_CONTROL_LOAD if control == 'load' else raw.RC_CONTROL_APPROACH), target, 1
    given(step, undeformed_gap=gap)
    given(answer, p=pressure)
    with OptionSet(options, None) as chosen:
        begun, cpu = time.perf_counter(), cpu_seconds()
        status = library.rc_contact_create(struct, chosen, handle)
        if status >= 0:
            status = library.rc_contact_solve(handle, step, answer)
            library.rc_contact_destroy(handle)
        seconds, cpu = time.perf_counter() - begun, cpu_seconds() - cpu
    if status < 0:
        raise error_for(status, library.rc_last_error().decode())
    return result_from(answer, '', None, pressure, None), seconds, cpu


def time_solve(system, gap, options, budget, control, target, pressure=None):
    """(result, record) of the fastest of several cold solves; set-up is what the whole call took besides the solve."""
    found = repeats(lambda: cold_call(system, gap, options, control, target, pressure), budget)
    result, seconds, cpu = min(found, key=lambda each: each[1])
    return result, {**record_of(result), 'setup_seconds': max(0.0, seconds - result.seconds), 'cpu_seconds': cpu}


FILTERS = ('subsample', 'mean', 'max')  # what a coarse point takes from its four heights


def cascade_options(kind='subsample', radius=2.0, levels=0, *, area='side', backend='fft', inner='polonsky-keer', certified):
    """radius: h of the area of influence, which counts sides (Algorithm 6) or diagonals (the text) of coarse cells. levels: grids, the given
    one included; 0: down to 16 points a side. certified 0: as published, without a look at the points that were left out."""
    return {'solver': 'cmr', 'backend': backend, 'cmr.inner': inner, 'cmr.area': area, 'cmr.radius': radius, 'cmr.levels': levels,
            'cmr.filter': kind, 'cmr.certified': certified}


@dataclass(frozen=True)
class CascadeNote:
    """What a certified cascade says of itself: points of the last trial set, candidates, rounds, points that were added."""
    kept: int = 0
    all: int = 0
    rounds: int = 0
    added: int = 0

    @property
    def share(self):
        return self.kept / self.all if self.all else 1

    @property
    def share_at_first(self):
        """n_p / n of the paper: before anything was added."""
        return (self.kept - self.added) / self.all if self.all else 1


def cascade_note(text):
    found = re.search(r'trial set (\d+) of (\d+) after (\d+) rounds(?:, (\d+) points added)?', text)
    return CascadeNote(*(int(number or 0) for number in found.groups())) if found else CascadeNote()


def cascade_verdict(scene, halvings):
    """How well the library says that a cascade can see the surface."""
    advice = rc.surface.cmr_advice(-scene.gap, halvings, scene.approach, pitch=scene.pitch)
    return {'trustworthy': int(advice.trustworthy), 'unresolved': advice.unresolved}
