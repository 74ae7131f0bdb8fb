"""The one judge of every code: roughcontact's certificate of the pressures that the code returned."""
import math

import numpy as np

from library import Contact, residual

LEVELS = (1e-4, 1e-6, 1e-8)


class Judge:
    """For the cases of one grid and boundary. Independent of the solver under test: a fresh product with H over all points."""

    def __init__(self, library, n, boundary, threads):
        self.contact = Contact(library, n, boundary, threads=threads)

    def close(self):
        self.contact.__exit__()

    def judge(self, control, target, gap, pressure):
        """Residuals of pressures [force/length^2] for a load or an approach. The load of a code that keeps the mean pressure is
        mean pressure x 1, because the cells fill the unit square with modulus 1."""
        pressure = np.array(pressure, dtype=np.float64, order='C').reshape(gap.shape)
        if not np.isfinite(pressure).all():
            return {'residual': math.inf, 'reason': 'pressures are not finite'}
        result = self.contact.certify(control, target, gap, pressure)
        return {'residual': residual(result), 'primal': result.kkt_primal, 'dual': result.kkt_dual,
                'complementarity': result.kkt_complementarity, 'control': result.kkt_control,
                'area': result.contacts / gap.size, 'load': result.load, 'approach': result.displacement}


def reached(value):
    """The tightest level that a residual meets, or None."""
    met = [level for level in LEVELS if value <= level]
    return min(met) if met else None
