"""The compiled programs: products and transforms that are timed, the textbook method. See native/."""
import ctypes as C
import functools
import os

import numpy as np
import roughcontact

from case import Failure

DOUBLES = C.POINTER(C.c_double)
LOOK = C.CFUNCTYPE(C.c_int, C.c_int64, DOUBLES, C.c_double, C.c_double)
TYPES = {bool: C.c_int64, int: C.c_int64, float: C.c_double, np.float64: C.c_double, str: os.fsencode,
         np.ndarray: lambda array: array.ctypes.data_as(C.c_void_p)}


@functools.lru_cache(None)
def _library():
    roughcontact.raw.contact_library()  # the module needs it
    return C.CDLL(os.environ['RC_BENCH_NATIVE'])


def _call(name, *arguments):
    """Numbers, texts and arrays as C takes them; others are for ctypes."""
    function = getattr(_library(), 'bench_' + name)
    function.restype = C.c_char_p
    failed = function(*(TYPES.get(type(each), lambda same: same)(each) for each in arguments))
    if failed and name != 'build':
        raise Failure(failed.decode())
    return failed


def _seconds(name, *arguments):
    seconds = C.c_double()
    _call(name, *arguments, C.byref(seconds))
    return seconds.value


def build():
    """(compiler, flags, FFTW)"""
    return _call('build').decode().split('\n')


def time_products(system, gap, approach, backend='auto', threads=1, budget=0.3, single=False, want=0):
    """(seconds of a product over the trial set of a gap and an approach, the product). want: how many values it has, 0: none are asked for."""
    struct, _ = system.struct()
    y = np.empty(want)
    return _seconds('time_products', C.byref(struct), gap, approach, backend, threads, float(budget), single, y if want else None), y


def time_passes(points, share, budget, count):
    """(seconds, bytes) of each of `count` passes. points: unknowns; share: the part of them that is in contact."""
    seconds, moved = np.empty(count), np.empty(count)
    _call('time_passes', points, float(share), float(budget), seconds, moved)
    return seconds, moved


class PaddedProduct:
    """The product by one transform of the grid padded to 2n x 2n."""

    def __init__(self, n, threads, measure, limit, single):
        self.handle = C.c_void_p()
        _call('padded_create', n, threads, measure, float(limit), single, C.byref(self.handle))

    def time(self, x, budget):
        """(seconds, y)"""
        y = np.empty_like(x)
        return _seconds('padded_time', self.handle, x.size, x, float(budget), y), y


def polonsky_keer(gap, load_control, target, threads, planning_limit, wisdom, look, most=100000):
    """look(products, pressures, residual, seconds) goes on as long as it returns true. Returns seconds of set-up and of planning."""
    times = (C.c_double * 2)()

    def call(products, p, residual, spent):
        return int(bool(look(products, np.ctypeslib.as_array(p, gap.shape), residual, spent)))

    _call('polonsky_keer', len(gap), gap, load_control, float(target), threads, most, float(planning_limit), wisdom, times, LOOK(call))
    return tuple(times)
