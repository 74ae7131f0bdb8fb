#!/usr/bin/env python3
"""Compares the table of haar-cg's constants (constants.md beside the code) with the code: each number has one row, with its value."""
import pathlib
import re
import sys

TABLE = 'src/solvers/haar_cg/constants.md'
CODE = ('src/solvers/haar_cg', 'src/trees', 'src/core/start_terms.h')
LISTS = re.compile(r'constexpr (?:std::)?(?:u?int(?:\d+_t)?|size_t|float|double) (\w+ = [^;{}]*);|^  int (patience = \d+);', re.M)
FUNCTION = re.compile(r'^inline float (haar_least_top)\(.*\) \{ return ([^;]+); \}', re.M)
ENDIAN = {'left', 'right'}  # of tree_loops.inc: which half of a vector comes first


def constants(text):
    """Names and values of the constants of a file that are numbers."""
    for match in LISTS.finditer(text):
        for each in re.split(r',\s*(?=\w+ = )', match[1] or match[2]):
            yield each.split(' = ', 1)
    for match in FUNCTION.finditer(text):
        yield match.groups()


def in_code(root):
    found = {}
    for place in CODE:
        for file in [root / place, *(root / place).rglob('*')]:
            if file.suffix not in ('.h', '.cpp', '.inc'):
                continue
            for name, value in constants(file.read_text()):
                if re.search(r'(?<!\w)\d', value) and name not in ENDIAN:
                    found[str(file.relative_to(root / 'src')), name] = re.sub(r'(?<=\d)F\b', '', value)
    return found


def in_table(root):
    found = {}
    for line in (root / TABLE).read_text().splitlines():
        match = re.match(r'\| `(\w+)` \| `([^`]+)` \|[^|]*\|([^|]*)\|[^|]+\|[^|]+\|$', line)
        for file in match[3].split(',') if match else ():
            file = file.strip()
            found[file if file.startswith(('trees/', 'core/')) else f'solvers/haar_cg/{file}', match[1]] = match[2]
    return found


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else '.').resolve()
    code, table = in_code(root), in_table(root)
    wrong = [key for key in sorted(code.keys() | table.keys()) if code.get(key) != table.get(key)]
    for file, name in wrong:
        print(f'src/{file}: {name} is {code.get((file, name), "no constant")}, {TABLE} has {table.get((file, name), "no row")}')
    print(f'{len(code)} constants, {len(wrong)} of them other than the table')
    return 1 if wrong or not code else 0


sys.exit(main())
