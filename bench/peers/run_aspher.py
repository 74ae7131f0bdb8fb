"""ASPHER: its nested solver, one call that builds the operators too. Load control, E* = 1, domain 1: pressures are ours."""
from importlib.metadata import version as installed

import aspher
import numpy as np


def version(request):
    return installed('aspher')


def call(request, gap, n):
    settings = dict(request['options'])
    if settings['backend'] == 'h2':  # the parameters that its author's harness uses
        settings.update(dict(q=6, leaf_side=8) if n <= 4096 else dict(q=4, leaf_side=16))
    return aspher.solve_nested(grid_size=n, gap=gap.ravel(), p_nominal=request['target'], domain_size=1.0, E_star=1.0,
                               tol=request['tol'], light_result=True, **settings)


def warm_up(request):
    call({**request, 'target': 0.1, 'tol': 1e-4}, np.random.default_rng(1).random((128, 128)), 128)


class Code:
    def __init__(self, request, gap):
        self.request, self.gap = request, gap

    def solve(self):
        self.result = call(self.request, self.gap, self.request['n'])
        return self.result.pressure

    def setup_inside(self):
        return self.result.timings['build']

    def details(self):
        result = self.result
        return {'status': str(result.status), 'iterations': result.iterations, 'products': result.matvec_count}
