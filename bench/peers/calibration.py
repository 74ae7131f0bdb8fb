"""Each code first solves a Hertz contact. A code whose largest pressure is off is not compared: its units or operator are not what
the comparison takes them for."""
import math
import os

import numpy as np

import process
from certificate import Judge
from plan import CODES

ALLOWED = 0.01  # of the largest pressure


def calibrate(bench, name, boundary):
    """Radius 1, E* = 1. a = 0.1 keeps periodic images away; dense codes have few cells and take a = 0.3."""
    code = CODES[name]
    n, radius = (32, 0.3) if code.small else (256, 0.1)
    load = 4 * radius**3 / 3
    exact = 2 * radius / math.pi  # 3 F / (2 pi a^2)
    control = code.controls[0]
    target = load if control == 'load' else radius**2
    file = bench.surface('sphere', n)['file']
    request = {'build': bench.build, 'gap': file, 'n': n, 'boundary': boundary, 'control': control, 'target': target,
               'tol': 1e-4 if 'float' in name else 1e-6, 'threads': bench.threads,
               'out': os.path.join(bench.arguments.work, 'hertz.npy')}
    if not code.tols[0]:
        request['tol'] = 0.0
    answer = process.solve(code, request, 60)[-1]
    if answer.get('error'):
        return {'error': answer['error']}
    pressure = np.load(answer['file'])
    judge = Judge(bench.library, n, boundary, bench.threads)
    try:
        residual = judge.judge(control, target, np.load(file), pressure)['residual']
    finally:
        judge.close()
    deviation = float(pressure.max()) / exact - 1
    return {'version': answer.get('version'), 'n': n, 'largest_pressure': float(pressure.max()), 'exact': exact, 'deviation': deviation,
            'load_deviation': float(pressure.mean()) / load - 1, 'residual': residual, 'passed': abs(deviation) <= ALLOWED}
