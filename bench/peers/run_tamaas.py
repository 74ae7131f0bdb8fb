"""Tamaas: Polonsky-Keer-Rey. Heights are -gap, the target is the mean pressure, E = 1 with nu = 0 is E* = 1."""
import numpy as np
import tamaas


def version(request):
    return tamaas.__version__


def make(request, gap, n):
    tamaas.set_log_level(tamaas.LogLevel.error)
    tamaas.initialize(request['threads'])
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [1.0, 1.0], [n, n])
    model.E, model.nu = 1.0, 0.0  # before the operator is registered, else it has another modulus
    np.negative(gap, out=gap)
    solver = tamaas.PolonskyKeerRey(model, gap, request['tol'])
    solver.max_iter = 100000
    solver.dump_freq = 1 << 30
    if request['boundary'] == 'free':
        tamaas.ModelFactory.registerNonPeriodic(model, 'free')
        solver.setIntegralOperator('free')
        model.operators['free'](model.traction, model.displacement)
    else:
        model.solveNeumann()  # makes the plans
    return model, solver


def warm_up(request):
    make({**request, 'tol': 1e-2}, np.random.default_rng(1).random((64, 64)), 64)[1].solve(0.1)


class Code:
    def __init__(self, request, gap):
        self.request = request
        self.model, self.solver = make(request, gap, request['n'])

    def solve(self):
        self.error = self.solver.solve(self.request['target'])
        return self.model.traction

    def setup_inside(self):
        return 0.0

    def details(self):
        return {'status': 'converged' if self.error <= self.request['tol'] else f'error {self.error:.1e}'}
