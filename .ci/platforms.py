#!/usr/bin/env python3
"""Checks that code asks which system it is compiled for in the folders of src/platform and tests/support alone, which CMake chooses:
no preprocessor line elsewhere names a system, but for the one in the public header that says how functions are exported."""
import pathlib
import re
import sys

SYSTEM = re.compile(r'_WIN(32|64)|__MINGW|_MSC_VER|__CYGWIN__|__linux|__unix|__APPLE__|__FreeBSD__|__ANDROID__|__GLIBC__')
FOLDERS = ('src', 'include', 'backends', 'formats', 'surface', 'flow', 'mpi', 'tools', 'bindings', 'examples', 'integrations', 'bench', 'fuzz', 'tests')
ALLOWED = ('include/roughcontact/roughcontact.h',)


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else '.')
    lines, found = 0, []
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob('*')):
            if not re.search(r'\.(c|cpp|cu|h|hpp|inc|def|in)$', file.name):
                continue
            name = str(file.relative_to(root))
            for number, line in enumerate(file.read_text().splitlines(), 1):
                if not re.match(r'\s*#\s*(if|elif|ifdef|ifndef|elifdef)\b', line):
                    continue
                lines += 1
                if SYSTEM.search(line) and name not in ALLOWED:
                    found.append(f'{name}:{number}: {line.strip()}; give src/platform what differs')
    print('\n'.join(found) or f'{lines} conditions of the preprocessor, none asks for the system')
    return 1 if found or not lines else 0


sys.exit(main())
