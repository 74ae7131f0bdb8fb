#!/usr/bin/env python3
"""calls.py SOURCE LIBRARY: calls every function of the headers with each pointer null, and with each sized struct of a wrong size. It has
to say so with RC_ERR_ARGUMENT; what may be null is listed here. Each call has a process of its own. Exits with 77 without pycparser
(Debian: python3-pycparser) or what the Python package needs."""
import ctypes
import os
import pathlib
import sys

source, os.environ['ROUGHCONTACT_LIBRARY'] = pathlib.Path(sys.argv[1]), sys.argv[2]
sys.path[:0] = [str(source / 'scripts'), str(source / 'bindings/python')]
try:
    import c_interface
    from roughcontact import _library, _structs
    from roughcontact._constants import RC_BOUNDARY_FREE, RC_ERR_ARGUMENT
except ImportError as missing:
    if missing.name not in ('pycparser', 'numpy'):
        raise
    print(f'skipped: {missing}')
    sys.exit(77)

HEADERS = {  # of each library, and its function that has the message
    'roughcontact': ('roughcontact history derivatives direct product analysis law registry ranks', 'rc_last_error'),
    'roughcontact-surface': ('surface', 'rc_surface_last_error'),
    'roughcontact-formats': ('formats', 'rc_surface_read_last_error'),
    'roughcontact-request': ('request budget', 'rc_request_last_error'),
    'roughcontact-flow': ('flow', 'rc_flow_last_error'),
}
# Arguments that may be null, of all functions or of these.
MAY_BE_NULL = {
    'config': '', 'context': '', 'options': '', 'mask': '', 'user': '', 'flag': '',
    'major': '', 'minor': '', 'patch': '', 'abi': '',  # rc_version
    'w': '', 'result': 'rc_greedy rc_polonsky_keer rc_nnls rc_gp rc_admm rc_cmr', 'inner': '',
    'index': 'rc_contact_points', 'p': 'rc_contact_points rc_law_pressures', 'slope': '', 'energy': '',
    'lower': 'rc_conductance rc_punch_stiffness', 'upper': 'rc_conductance rc_punch_stiffness',
    'path': 'rc_law_open', 'request': 'rc_request_remark_count', 'q': '', 'psd': '', 'modes': '',
    'spec': 'rc_surface_read rc_surface_read_memory', 'name': 'rc_surface_read_memory', 'out_mask': '',
    'plugin_path': 'rc_context_create', 'log_user': '', 'time': 'rc_contact_creep', 'spikes': '', 'largest': '', 'missing': '',
    'budget': 'rc_budget_quantity_count rc_budget_source_count',
}
MAY_NOT = 'rc_options_copy rc_contact_set_options rc_request_options'  # be without options
TEXTS = {'key': b'tol', 'solver': b'nnls', 'inner': b'nnls', 'backend': b'dense', 'kernel': b'love', 'name': b'nm', 'text': b'0.01'}
NUMBERS = {'tol': 0.01, 'rank': 0, 'index': 0}
HANDLES = {}
# The exchange of a single rank.
GATHER = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ctypes.c_int64), ctypes.c_void_p)
MOVE = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(ctypes.c_int64), ctypes.c_void_p, ctypes.c_void_p)
ALONE = {
    'gather': GATHER(lambda user, mine, size, every: ctypes.memmove(every, mine, size[0]) and None),
    'transpose': MOVE(lambda user, mine, size, into, received: ctypes.memmove(into, mine, size[0]) and None),
    'shift': MOVE(lambda *_: None),
}


def may_be_null(function, argument):
    if argument == 'options' and function in MAY_NOT.split() or argument not in MAY_BE_NULL:
        return False
    return not MAY_BE_NULL[argument] or function in MAY_BE_NULL[argument].split()


class Call:
    """A function with arguments that are not null: zeros but for what makes a small problem."""

    def __init__(self, function, declared, known):
        self.function, self.declared, self.known = function, declared, known
        self.kept = []
        self.arguments = [self.argument(name, kind) for name, kind in declared.arguments]

    def argument(self, name, kind):
        struct = self.known.get(kind.base)
        if kind.base in ('rc_array', 'rc_const_array') and not kind.stars:
            array = getattr(_structs, kind.base)()
            array.data = self.keep(ctypes.create_string_buffer(4096))
            return array
        if isinstance(struct, c_interface.Struct) and kind.stars == 1:
            return ctypes.c_void_p(self.keep(made(kind.base, (struct, self.known))))
        if self.known.get(kind.base) is not None and not kind.stars:
            return ctypes.c_void_p(None)  # a callback
        if kind.stars == 1 and kind.base in HANDLES:
            return ctypes.c_void_p(HANDLES[kind.base])
        if kind.base == 'char' and kind.stars == 1:
            return ctypes.c_char_p(TEXTS.get(name, b'nothing'))
        if kind.stars:
            room = (ctypes.c_int64 * (1 << 13))(4 if name in ('nx', 'ny') else 0)
            return ctypes.c_void_p(self.keep(room))
        value = NUMBERS.get(name, 1)
        return ctypes.c_double(value) if kind.base == 'double' else ctypes.c_int64(value)

    def keep(self, value):
        self.kept.append(value)
        return ctypes.addressof(value)

    def pointers(self):
        return [i for i, (_, kind) in enumerate(self.declared.arguments) if kind.stars or kind.base in ('rc_array', 'rc_const_array')]


def made(name, declared):
    """A struct with the values of its INIT macro, or zeros but for the size if Python does not have it."""
    if not hasattr(_structs, name):
        size, at = c_interface.layout(*declared)
        return (ctypes.c_int64 * (size // 8))(size if 'struct_size' in at else 0)
    struct = getattr(_structs, name)()
    if name == 'rc_exchange':
        for function, alone in ALONE.items():
            setattr(struct, function, ctypes.cast(alone, dict(struct._fields_)[function]))
    if name == 'rc_system':
        struct.nx = struct.ny = 2
        struct.hx = struct.hy = struct.modulus = 1
        struct.boundary = RC_BOUNDARY_FREE
    return struct


def in_process(call, message):
    """(status, message) of a call in a process of its own; what ended it instead."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            status = call.function(*call.arguments) or 0
            os.write(write, f'{status}:{(message() or b"").decode()}'.encode()[:4000])
        finally:
            os._exit(0)
    os.close(write)
    with os.fdopen(read, 'rb') as pipe:
        said = pipe.read().decode()
    end = os.waitpid(child, 0)[1]
    status, _, text = said.partition(':')
    return (int(status), text) if end == 0 and status else (None, f'ended by {end}')


def handle(function, *arguments):
    out = ctypes.c_void_p()
    if function(*arguments, ctypes.byref(out)) != 0:
        sys.exit(f'{function.__name__} makes no handle for the test')
    return out.value


def main():
    core = ctypes.CDLL(sys.argv[2])
    system = made('rc_system', None)
    HANDLES.update(
        rc_context=handle(core.rc_context_create, 0, None, None, None),
        rc_options=handle(core.rc_options_create, None),
        rc_contact=handle(core.rc_contact_create, ctypes.byref(system), None),
        rc_product=handle(core.rc_product_create, ctypes.byref(system), None),
        rc_law=handle(core.rc_law_load, bytes(source / 'tests/data/laws/version-1-convex.law')),
    )
    wrong, calls, known, seen = [], 0, None, set()
    for name, (headers, message) in HEADERS.items():
        library = ctypes.CDLL(str(pathlib.Path(sys.argv[2]).with_name(f'lib{name}.so')))
        last_error = library[message]
        last_error.restype = ctypes.c_char_p
        found = c_interface.read([f'roughcontact/{each}.h' for each in headers.split()], source / 'include', 'cc', known)
        if known is None:
            known = found
        for function in found.functions.keys() - seen:
            seen.add(function)
            for argument, value, outcome in of_function(library[function], found.functions[function], found.known, last_error):
                calls += 1
                status, said = outcome
                if value is None and may_be_null(function, argument):
                    good = status is not None
                else:
                    good = status == RC_ERR_ARGUMENT and ('null' if value is None else 'struct_size') in said
                if not good and found.functions[function].result.base == 'rc_status' or status is None:
                    wrong.append(f"{function}: {argument} {'null' if value is None else f'of struct_size {value}'}: {status} {said}")
    print('\n'.join(wrong) or f'{len(seen)} functions, {calls} calls')
    sys.exit(bool(wrong))


def of_function(called, declared, known, last_error):
    """(argument, size or None, outcome) of each call that is wrong in one argument."""
    called.restype = ctypes.c_int
    for place in Call(called, declared, known).pointers():
        argument, kind = declared.arguments[place]
        struct = known.get(kind.base)
        sized = isinstance(struct, c_interface.Struct) and kind.stars and struct.members[:1] and struct.members[0][0] == 'struct_size'
        for value in (None, 0, c_interface.struct_size(struct, known) - 1, -1) if sized else (None,):
            call = Call(called, declared, known)
            if value is not None:
                ctypes.c_size_t.from_address(call.arguments[place].value).value = value
            elif kind.stars:
                call.arguments[place] = None
            else:
                call.arguments[place].data = None
            yield argument, value, in_process(call, last_error)


main()
