"""Pressures of a rough body that creeps, beside Tamaas' generalised Maxwell solver. E* and the side are 1.

Tamaas takes steps by backward Euler, and its steps add up for a long-term shear modulus of 1 only (2.9.0: other units give other
answers), so its problem is scaled to that."""
import importlib.util
import time

import numpy as np
import roughcontact as rc

from surfaces import self_affine_gap

SLOPE, RELAXATION, END = 0.1, ((0.4, 0.5), (0.3, 2.0)), 2.0
STEPS, FINEST, TOL = (4, 8, 16, 32, 64, 128), 512, 1e-10


def available():
    return importlib.util.find_spec('tamaas') is not None


def ours(gap, load, steps):
    """(pressures at the end, seconds of the processor)"""
    n = len(gap)
    system = rc.HalfSpace((n, n), pitch=1 / n, modulus=1, boundary='periodic', relaxation=RELAXATION)
    start = time.process_time()
    with rc.Contact(system, options={'tol': TOL, 'threads': 1}) as contact:
        answer = contact.solve(undeformed_gap=gap, load=load, time=0)
        for k in range(1, steps + 1):
            answer = contact.solve(load=load, time=END * k / steps)
    return answer.pressure, time.process_time() - start


def theirs(gap, load, steps):
    import tamaas
    tamaas.set_log_level(tamaas.LogLevel.error)
    tamaas.initialize(1)
    n = len(gap)
    last = 1 - sum(ratio for ratio, _ in RELAXATION)
    unit = 2 / last
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [1.0, 1.0], [n, n])
    model.E, model.nu = last * unit, 0.0
    heights = np.ascontiguousarray(-gap)
    solver = tamaas.MaxwellViscoelastic(model, heights, TOL, END / steps, [unit / 2 * ratio for ratio, _ in RELAXATION],
                                        [each for _, each in RELAXATION])
    solver.max_iter = 10000
    start = time.process_time()
    for _ in range(steps):
        solver.solve(load * unit)
    return model.traction.reshape(n, n) / unit, time.process_time() - start


def errors(n, steps, exact):
    """exact: pressures at the end; relative errors in the mean square, and seconds"""
    gap, load, found = self_affine_gap(n, 1, 0.8, 4, n // 8, SLOPE), 0.05 * SLOPE, {}
    for name, solve in (('ours', ours), ('theirs', theirs)):
        pressures, seconds = solve(gap, load, steps)
        found[name], found[f'{name}_seconds'] = float(np.linalg.norm(pressures - exact) / np.linalg.norm(exact)), seconds
    return found


def finest(n):
    return ours(self_affine_gap(n, 1, 0.8, 4, n // 8, SLOPE), 0.05 * SLOPE, FINEST)[0]
