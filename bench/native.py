"""What is compiled: products and transforms that are timed, the standard method, the readers of surface files. See native/."""
import ctypes as C
import os

import numpy as np

from case import Failure

DOUBLES, INTEGERS = C.POINTER(C.c_double), C.POINTER(C.c_int64)
LOOK = C.CFUNCTYPE(C.c_int, C.c_int64, DOUBLES, C.c_double, C.c_double)
_loaded = []


def _call(name, *arguments):
    if not _loaded:
        import roughcontact
        roughcontact.raw.contact_library()  # the module needs it
        _loaded.append(C.CDLL(os.environ['RC_BENCH_NATIVE']))
    function = getattr(_loaded[0], name)
    function.restype = C.c_char_p
    failed = function(*arguments)
    if failed and name != 'bench_build':
        raise Failure(failed.decode())
    return failed


def _pointer(array):
    return array.ctypes.data_as(C.c_void_p)


def build():
    """(commit, compiler, build type, flags, FFTW)"""
    return _call('bench_build').decode().split('\n')


def time_products(system, gap, approach, backend='auto', planning='', threads=1, budget=0.3, single=False, share=1.0, want=0):
    """Products over the trial set of a gap and an approach: {'best', 'median', 'first' [s], 'count', 'points', 'contacts', 'y'}.
    share: of the points that have pressure. want: how many values y has."""
    struct, _ = system.struct()
    times, counts, y = (C.c_double * 3)(), (C.c_int64 * 3)(), np.empty(want)
    _call('bench_time_products', C.byref(struct), _pointer(gap), C.c_double(approach), backend.encode(), planning.encode(),
          C.c_int(threads), C.c_double(budget), C.c_int(single), C.c_double(share), times, counts, _pointer(y) if want else None)
    return dict(zip(('best', 'median', 'first', 'count', 'points', 'contacts', 'y'), (*times, *counts, y)))


class PaddedProduct:
    """The product by one transform of the grid padded to 2n x 2n."""

    def __init__(self, n, threads, measure, limit, single):
        self.handle, planning = C.c_void_p(), C.c_double()
        _call('bench_padded_create', C.c_int64(n), C.c_int(threads), C.c_int(measure), C.c_double(limit), C.c_int(single),
              C.byref(self.handle), C.byref(planning))
        self.planning_seconds = planning.value

    def time(self, x, budget):
        """({'best', 'median'} [s], y)"""
        times, y = (C.c_double * 2)(), np.empty_like(x)
        _call('bench_padded_time', self.handle, C.c_int64(x.size), _pointer(x), C.c_double(budget), times, _pointer(y))
        return dict(zip(('best', 'median'), times)), y


def time_triad(n, threads, budget):
    seconds = C.c_double()
    _call('bench_time_triad', C.c_int64(n), C.c_int(threads), C.c_double(budget), C.byref(seconds))
    return seconds.value


def time_transform(length, repeats, threads, budget, single):
    seconds = C.c_double()
    _call('bench_time_transform', C.c_int64(length), C.c_int64(repeats), C.c_int(threads), C.c_double(budget), C.c_int(single),
          C.byref(seconds))
    return seconds.value


def polonsky_keer(gap, load_control, target, threads, planning_limit, wisdom, look, most=100000):
    """look(products, pressures, residual, seconds) goes on as long as it returns true. Returns seconds of set-up and of planning."""
    seconds = (C.c_double * 2)()

    def call(products, p, residual, spent):
        return int(bool(look(products, np.ctypeslib.as_array(p, gap.shape), residual, spent)))

    _call('bench_polonsky_keer', C.c_int64(gap.shape[0]), _pointer(gap), C.c_int(load_control), C.c_double(target), C.c_int(threads),
          C.c_int64(most), C.c_double(planning_limit), wisdom.encode(), seconds, LOOK(call))
    return tuple(seconds)


def read_surface(file):
    """(heights, (hx, hy)) in metres, of any format that the command reads."""
    shape, pitch, heights = (C.c_int64 * 2)(), (C.c_double * 2)(), DOUBLES()
    _call('bench_read_surface', os.fsencode(file), shape, pitch, C.byref(heights))
    found = np.ctypeslib.as_array(heights, (shape[1], shape[0])).copy()
    C.CDLL(None).free(heights)
    return found, tuple(pitch)
