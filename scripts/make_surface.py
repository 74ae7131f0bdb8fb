#!/usr/bin/env python3
"""make_surface.py FILE [N]: a self-affine surface of N x N heights (N a power of two; 512), rms slope 0.1 at unit pitch, as a
.npy file, the same at every call. Amplitudes fall as q^-(1+H) with Hurst exponent H = 0.8 beyond 4 waves a side and are flat
below."""
import array
import cmath
import math
import random
import sys


def fft(x):
    n = len(x)
    if n == 1:
        return x
    even, odd = fft(x[::2]), fft(x[1::2])
    odd = [w * o for w, o in zip(TWIDDLES[n], odd)]
    return [e + o for e, o in zip(even, odd)] + [e - o for e, o in zip(even, odd)]


file, n = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 512
hurst, roll_off, rms_slope = 0.8, 4.0, 0.1
TWIDDLES = {m: [cmath.exp(-2j * math.pi * k / m) for k in range(m // 2)] for m in (2**b for b in range(1, n.bit_length()))}

uniform = random.Random(1).random
spectrum, slope = [], 0.0
for ky in range(n):
    row = []
    for kx in range(n):
        q = math.hypot(min(kx, n - kx), min(ky, n - ky))
        amplitude = max(q, roll_off) ** -(1 + hurst) if q else 0.0
        slope += (amplitude * q) ** 2
        row.append(cmath.rect(amplitude, 2 * math.pi * uniform()))
    spectrum.append(row)
scale = rms_slope / (2 * math.pi / n * math.sqrt(slope / 2))

# The real part of the transform of random phases is a real surface with half the power.
columns = zip(*map(fft, spectrum))
heights = array.array('d', (scale * z.real for row in zip(*map(fft, map(list, columns))) for z in row))
if sys.byteorder == 'big':
    heights.byteswap()
header = f"{{'descr': '<f8', 'fortran_order': False, 'shape': ({n}, {n}), }}"
header += ' ' * (63 - (10 + len(header)) % 64) + '\n'
with open(file, 'wb') as out:
    out.write(b'\x93NUMPY\x01\x00' + len(header).to_bytes(2, 'little') + header.encode('latin1') + heights.tobytes())
