#!/usr/bin/env python3
"""The same scene solved from every language and from the command line has the same bits.

same_pressures.py ROUGHCONTACT [-- NAME COMMAND...]...
Each COMMAND is called with HEIGHTS NX NY PITCH MODULUS APPROACH PRESSURES: it reads raw doubles, x fastest, takes the gap
below the highest point, solves with default options, and writes raw doubles. The first one is what the others are compared with.
"""
import pathlib
import struct
import subprocess
import sys
import tempfile

NX, NY, PITCH, MODULUS = 96, 64, '0.5', '3.25'


def values_of_npy(path):
    """The raw doubles behind the header of a .npy file, version 1."""
    data = path.read_bytes()
    return data[10 + struct.unpack('<H', data[8:10])[0]:]


def npy(heights):
    header = f"{{'descr': '<f8', 'fortran_order': False, 'shape': ({NY}, {NX}), }}"
    header += ' ' * (-(10 + len(header) + 1) % 64) + '\n'
    return b'\x93NUMPY\x01\x00' + struct.pack('<H', len(header)) + header.encode() + heights


def rough():
    """Heights from integers alone, so that this test needs no library: three sums of a linear congruential generator."""
    state, rows = 1, []
    for _ in range(NX * NY):
        total = 0
        for _ in range(3):
            state = (6364136223846793005 * state + 1442695040888963407) % 2**64
            total += state >> 40
        rows.append(total / 2**24)
    smooth = [sum(rows[(iy + dy) % NY * NX + (ix + dx) % NX] for dy in range(-2, 3) for dx in range(-2, 3)) / 25
              for iy in range(NY) for ix in range(NX)]
    return struct.pack(f'<{NX * NY}d', *smooth)


def main():
    arguments, commands = sys.argv[1:], []
    while '--' in arguments:
        last = len(arguments) - 1 - arguments[::-1].index('--')
        commands.insert(0, (arguments[last + 1], arguments[last + 2:]))
        arguments = arguments[:last]
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / 'heights.raw').write_bytes(rough())
        (folder / 'heights.npy').write_bytes(npy(rough()))
        for approach in ('0.125', '0.75'):
            found = {}
            for name, command in commands:
                out = folder / f'{name}.raw'
                scene = ['heights.raw', str(NX), str(NY), PITCH, MODULUS, approach, out.name]
                subprocess.run([*command, *scene], check=True, cwd=folder)
                found[name] = out.read_bytes()
            if arguments:
                tool = str(pathlib.Path(arguments[0]).resolve())
                subprocess.run([tool, 'solve', 'heights.npy', '--pitch', PITCH, '--unit', 'm', '--modulus', MODULUS, '--boundary', 'free', '--approach',
                                approach, '--out', 'results', '--quiet'], check=True, cwd=folder)
                found['command line'] = values_of_npy(folder / 'results' / 'pressure-1.npy')
            (first, expected), *others = found.items()
            contacts = sum(p > 0 for p in struct.unpack(f'<{NX * NY}d', expected))
            print(f'approach {approach}: {contacts} points in contact; {", ".join(found)}')
            failures += [f'{name} differs from {first}' for name, p in others if p != expected]
            if not 0 < contacts < NX * NY or len(found) < 2:
                failures.append('nothing was compared')
    print('\n'.join(failures) or 'the same bits')
    return 1 if failures else 0


sys.exit(main())
