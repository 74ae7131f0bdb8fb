#!/usr/bin/env python3
"""Compares what rc_solve uses of the C header with the header: result_fields.def names every member of rc_result, with its
kind, and the sources compile against the header without a warning.

drift.py HEADER FOLDER CC [--self-test]
"""
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / 'bindings'))
from drift import Header  # noqa: E402

NOT_IN_INFO = {'struct_size', 'p', 'gap', 'reserved'}


def problems(header_text, folder, cc):
    members = {name: kind for name, kind in Header(header_text).structs['rc_result'] if name not in NOT_IN_INFO}
    fields = (folder / 'result_fields.def').read_text()
    named = {name: what for what, name in re.findall(r'^(NUMBER|TEXT)\((\w+)\)', fields, re.M)}
    wanted = {name: 'TEXT' if kind.startswith('char[') else 'NUMBER' for name, kind in members.items()}
    found = [f'{name}: header {wanted.get(name)}, rc_solve {named.get(name)}' for name in sorted(wanted.keys() | named.keys())
             if wanted.get(name) != named.get(name)]
    with tempfile.TemporaryDirectory() as scratch:
        public = pathlib.Path(scratch) / 'roughcontact'
        public.mkdir()
        (public / 'roughcontact.h').write_text(header_text)
        run = subprocess.run([cc, '-std=c99', '-Wall', '-Wextra', '-Wconversion', '-Wno-sign-conversion', '-Werror',
                              '-fsyntax-only', '-I', scratch, str(folder / 'request.c')], capture_output=True, text=True)
    return found + ([run.stderr.splitlines()[0]] if run.returncode else [])


CHANGES = {
    'member of the result added': ('} rc_result;', 'int64_t more;\n} rc_result;'),
    'member of the result removed': ('double energy;', ''),
    'member of the result renamed': ('double left_out;', 'double omitted;'),
    'text becomes a number': ('char kernel[32];', 'double kernel;'),
    'constant renamed': ('RC_BOUNDARY_PERIODIC = 2', 'RC_BOUNDARY_REPEATED = 2'),
    'function renamed': ('rc_options_parse(', 'rc_options_read('),
    'argument added': ('const char *key, int64_t value', 'const char *key, int64_t value, int32_t x'),
    'member of the step renamed': ('double target;', 'double aim;'),
}


def main():
    header, folder, cc = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
    text = header.read_text()
    if '--self-test' in sys.argv:
        missed = []
        for name, (old, new) in CHANGES.items():
            assert old in text, f'the header no longer has "{old}"'
            if not problems(text.replace(old, new, 1), folder, cc):
                missed.append(f'not noticed: {name}')
        print(f'{len(CHANGES) - len(missed)} of {len(CHANGES)} changes noticed')
        found = missed
    else:
        found = problems(text, folder, cc)
    print('\n'.join(found) or 'no difference')
    return 1 if found else 0


sys.exit(main())
