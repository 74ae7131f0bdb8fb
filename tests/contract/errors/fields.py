#!/usr/bin/env python3
"""fields.py >fields.inc: the members and constants of the headers, as tests/contract/abi/golden.txt lists them, for the table of bad
input, which sets them by name."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'abi'))
import golden  # noqa: E402

constants, _, offsets, _ = golden.numbers()
print('#ifdef FIELD')
for struct, members in offsets.items():
    for member in members:
        print(f'FIELD({struct}, {member})')
print('#else')
for name in constants:
    print(f'VALUE({name})')
print('#endif')
