#!/usr/bin/env python3
"""arrays.py INCLUDE CC: every array of the headers is an rc_const_array or an rc_array, but for the exceptions below, each for its
reason. Exits with 77 without pycparser (Debian: python3-pycparser)."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / 'scripts'))
try:
    from c_interface import SCALARS, read
except ImportError as missing:
    if missing.name != 'pycparser':
        raise
    print('skipped: pycparser is missing (Debian: python3-pycparser)')
    sys.exit(77)

# Headers, functions, members.
EXCEPTIONS = {
    'plugin.h': 'called in inner loops',
    'direct.h': "matrices in LAPACK's manner",
    'surface.h': "a library of its own, which fills the host's memory",
    'formats.h': "a library of its own, which fills the host's memory",
    'request.h': "a library of its own, which reads the host's memory",
    'rc_system.dense': 'a matrix with a leading dimension',
    'rc_law_slip': 'vectors of two components',
    'rc_law_slip_bounds': 'vectors of two components',
    'rc_kernel_coefficients': 'as kernels of plugins give these numbers',
}
NUMBERS = {'double', 'float', 'int8_t', 'uint8_t', 'int32_t', 'uint32_t', 'int64_t', 'uint64_t', 'rc_status'}
# Members of type void *: the caller's own, and the data of the two array types.
OPAQUE = {'user', 'log_user', 'rc_array.data', 'rc_const_array.data'}


def is_array(kind):
    return kind.stars > 0 and kind.base in NUMBERS | {'void'}


def wrong_places(found):
    """Pointers to numbers, in the order of the header; arguments of callbacks are the exception of the convention."""
    for struct in found.structs():
        for name, kind in struct.members:
            place = f'{struct.name}.{name}'
            if is_array(kind) and not {place, name} & OPAQUE:
                yield place
    for name, function in found.functions.items():
        for argument, kind in function.arguments:
            one = argument in SCALARS.get(name, '').split()
            if is_array(kind) and not one and argument not in OPAQUE and name != 'rc_file_write':  # bytes of a file
                yield f'{name}, {argument}'


include, cc = pathlib.Path(sys.argv[1]), sys.argv[2]
headers = sorted((path.name for path in (include / 'roughcontact').glob('*.h')), key=lambda name: (name == 'budget.h', name))  # it includes others
before, wrong, used = None, [], set()
for header in ['roughcontact.h', *(each for each in headers if each != 'roughcontact.h')]:
    found = read([f'roughcontact/{header}'], include, cc, before)
    before = found
    for place in wrong_places(found):
        reasons = {header, place, place.split(',')[0]} & EXCEPTIONS.keys()
        used |= reasons
        if not reasons:
            wrong.append(f'{header}: {place} is a pointer; take an rc_const_array or rc_array, or give a reason here')
for line in wrong:
    print(line)
print(f'{len(headers)} headers, {len(wrong)} pointers against the convention')
if EXCEPTIONS.keys() - used:
    sys.exit(f'these exceptions are of nothing: {", ".join(sorted(EXCEPTIONS.keys() - used))}')
sys.exit(1 if wrong else 0)
