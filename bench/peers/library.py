"""libroughcontact through ctypes: what the benchmark needs of <roughcontact/roughcontact.h>."""
import ctypes as C
import math
import os

import numpy as np

FREE, PERIODIC = 1, 2
DISPLACEMENT, LOAD = 1, 2
BOUNDARIES = {'free': FREE, 'periodic': PERIODIC}
CONTROLS = {'displacement': DISPLACEMENT, 'load': LOAD}
DOUBLES = C.POINTER(C.c_double)


class System(C.Structure):
    _fields_ = [('struct_size', C.c_size_t), ('op', C.c_int32), ('boundary', C.c_int32), ('nx', C.c_int64), ('ny', C.c_int64),
                ('hx', C.c_double), ('hy', C.c_double), ('modulus', C.c_double), ('dense', DOUBLES), ('dense_ld', C.c_int64),
                ('apply', C.c_void_p), ('user', C.c_void_p)]


class Step(C.Structure):
    _fields_ = [('struct_size', C.c_size_t), ('control', C.c_int32), ('warm_start', C.c_int32), ('target', C.c_double),
                ('gap', DOUBLES), ('p0', DOUBLES), ('mask', C.POINTER(C.c_uint8)), ('borrow', C.c_int32), ('reserved', C.c_int32)]


class Result(C.Structure):
    _fields_ = ([('struct_size', C.c_size_t), ('p', DOUBLES), ('gap', DOUBLES), ('status', C.c_int32), ('reserved', C.c_int32)] +
                [(name, C.c_int64) for name in ('iterations', 'applications', 'points', 'candidates', 'modelled', 'contacts')] +
                [(name, C.c_double) for name in ('load', 'displacement', 'mean_pressure', 'contact_area', 'energy', 'stiffness',
                                                 'kkt_primal', 'kkt_dual', 'kkt_complementarity', 'kkt_control', 'seconds',
                                                 'setup_seconds')] +
                [('solver', C.c_char * 32), ('backend', C.c_char * 32), ('kernel', C.c_char * 32), ('note', C.c_char * 160)])


class Failure(RuntimeError):
    pass


def pointer(array):
    assert array.dtype == np.float64 and array.flags.c_contiguous
    return array.ctypes.data_as(DOUBLES)


class Library:
    def __init__(self, build):
        self.file = os.path.realpath(os.path.join(build, 'lib', 'libroughcontact.so'))
        self.c = C.CDLL(self.file)
        for name, arguments in (('rc_options_create', [C.c_void_p, C.POINTER(C.c_void_p)]),
                                ('rc_options_parse', [C.c_void_p, C.c_char_p, C.c_char_p]),
                                ('rc_contact_create', [C.POINTER(System), C.c_void_p, C.POINTER(C.c_void_p)]),
                                ('rc_contact_solve', [C.c_void_p, C.POINTER(Step), C.POINTER(Result)]),
                                ('rc_contact_certify', [C.c_void_p, C.POINTER(Step), C.POINTER(Result)]),
                                ('rc_kernel_coefficients', [C.c_char_p, C.c_double, C.c_double, C.c_int64, C.c_int64, DOUBLES])):
            function = getattr(self.c, name)
            function.argtypes, function.restype = arguments, C.c_int32
        for name in ('rc_options_destroy', 'rc_contact_destroy'):
            getattr(self.c, name).argtypes = [C.c_void_p]
            getattr(self.c, name).restype = None
        self.c.rc_last_error.restype = C.c_char_p
        self.c.rc_status_name.restype = C.c_char_p
        self.c.rc_version.argtypes, self.c.rc_version.restype = [C.POINTER(C.c_int32)] * 4, None

    def version(self):
        numbers = [C.c_int32() for _ in range(4)]
        self.c.rc_version(*(C.byref(number) for number in numbers))
        return '.'.join(str(number.value) for number in numbers[:3])

    def check(self, status):
        if status < 0:
            raise Failure(self.c.rc_last_error().decode())
        return status

    def status_name(self, status):
        return self.c.rc_status_name(status).decode()

    def love(self, nx, ny, h):
        """Influence coefficients of unit pressure on square cells of side h, contact modulus 1."""
        out = np.empty((ny, nx))
        self.check(self.c.rc_kernel_coefficients(b'love', h, h, nx, ny, pointer(out)))
        return out


class Contact:
    """n x n cells on the unit square, contact modulus 1."""

    def __init__(self, library, n, boundary, **options):
        self.library, self.handle = library, C.c_void_p()
        keys = C.c_void_p()
        library.check(library.c.rc_options_create(None, C.byref(keys)))
        try:
            for key, value in options.items():
                library.check(library.c.rc_options_parse(keys, key.encode(), str(value).encode()))
            system = System(struct_size=C.sizeof(System), op=1, boundary=BOUNDARIES[boundary], nx=n, ny=n, hx=1 / n, hy=1 / n,
                            modulus=1.0)
            library.check(library.c.rc_contact_create(C.byref(system), keys, C.byref(self.handle)))
        finally:
            library.c.rc_options_destroy(keys)

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.library.c.rc_contact_destroy(self.handle)

    def _call(self, function, control, target, gap, pressure):
        step = Step(struct_size=C.sizeof(Step), control=CONTROLS[control], warm_start=0, target=target, gap=pointer(gap),
                    borrow=1)
        result = Result(struct_size=C.sizeof(Result), p=pointer(pressure))
        self.library.check(function(self.handle, C.byref(step), C.byref(result)))
        return result

    def solve(self, control, target, gap, pressure):
        return self._call(self.library.c.rc_contact_solve, control, target, gap, pressure)

    def certify(self, control, target, gap, pressure):
        return self._call(self.library.c.rc_contact_certify, control, target, gap, pressure)


def residual(result):
    """The certificate: the largest of the four residuals."""
    values = [result.kkt_primal, result.kkt_dual, result.kkt_complementarity, result.kkt_control]
    return math.inf if any(math.isnan(value) for value in values) else max(values)
