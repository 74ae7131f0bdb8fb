#!/usr/bin/env python3
"""The numbers of golden.txt, which scripts/bindings.py writes and which are kept, so that a change of the binary interface shows.

golden.py >golden.c: C that does not compile where the headers have other numbers, see golden.h
"""
import pathlib

FILE = pathlib.Path(__file__).with_name('golden.txt')
HEADERS = FILE.parents[3] / 'include/roughcontact'  # all but mpi.h, which needs that of MPI


def numbers(plugin=True):
    """({constant: value}, {struct: size}, {struct: {member: offset}}, [function]); plugin: also those of plugin.h."""
    constants, sizes, offsets, functions, struct = {}, {}, {}, [], ''
    of_users, _, rest = FILE.read_text().partition('# plugin.h\n')
    of_plugins, _, of_libraries = rest.partition('# functions\n')
    of_users = of_users.partition('\n')[2]
    for word in (of_users + of_plugins * plugin + of_libraries).split():
        name, equals, value = word.partition('=')
        if equals and name.startswith('RC_'):
            constants[name] = int(value)
        elif equals:
            struct, sizes[name], offsets[name] = name, int(value), {}
        elif ':' in word:
            member, _, at = word.partition(':')
            offsets[struct][member] = int(at)
        else:
            functions.append(word)
    return constants, sizes, offsets, functions


def main():
    constants, sizes, offsets, _ = numbers()
    print('#include "golden.h"')
    print('\n'.join(f'#include <roughcontact/{file.name}>' for file in sorted(HEADERS.glob('*.h')) if file.name != 'mpi.h'))
    for name, value in constants.items():
        print(f'VALUE({name}, {value if value < 1 << 31 else f"INT64_C({value})"});')
    for struct, size in sizes.items():
        print(f'SIZE({struct}, {size});')
        print('\n'.join(f'AT({struct}, {member}, {at});' for member, at in offsets[struct].items()))
    print('int main(void) { return 0; }')


if __name__ == '__main__':
    main()
