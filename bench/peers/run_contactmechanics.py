"""ContactMechanics: its Polonsky-Keer solver. Works with forces per cell and heights -gap; `young` is E* for a half-space."""
from importlib.metadata import version as installed

import numpy as np
from ContactMechanics import FreeFFTElasticHalfSpace, PeriodicFFTElasticHalfSpace
from ContactMechanics.Optimization import constrained_conjugate_gradients


def version(request):
    return installed('ContactMechanics')


def half_space(request, n):
    kind = FreeFFTElasticHalfSpace if request['boundary'] == 'free' else PeriodicFFTElasticHalfSpace
    return kind((n, n), 1.0, (1.0, 1.0))


def minimise(request, substrate, heights):
    rms = float(np.std(heights))
    load = request['target']  # force: the domain's area is 1
    return constrained_conjugate_gradients(substrate, heights, external_force=load, pentol=request['tol'] * rms,
                                           forcetol=request['tol'] * load / heights.size, thermotol=request['tol'])


def warm_up(request):
    minimise({**request, 'target': 0.1, 'tol': 1e-3}, half_space(request, 64), -np.random.default_rng(1).random((64, 64)))


class Code:
    def __init__(self, request, gap):
        self.request = request
        self.heights = np.negative(gap, out=gap)
        self.substrate = half_space(request, request['n'])
        self.substrate.evaluate_disp(np.zeros(self.substrate.nb_subdomain_grid_pts))

    def solve(self):
        self.result = minimise(self.request, self.substrate, self.heights)
        return self.result.jac * self.heights.size  # cells have the area 1/size

    def setup_inside(self):
        return 0.0

    def details(self):
        return {'status': self.result.message, 'iterations': self.result.nit, 'products': self.result.nfev}
