"""What is known of a contact of a scene: the approach for a contact area, certified solutions, theory, and errors against them."""
from dataclasses import dataclass

import numpy as np
import roughcontact as rc

from contact import share_in_contact, solve
from surfaces import block_means


@dataclass(frozen=True)
class Truth:
    load: float
    area: float
    pressure: np.ndarray = None

    def errors(self, result):
        """Relative errors: of load and contact area, and of the pressures in the L2 norm, on the same grid."""
        off = np.linalg.norm(result.pressure - self.pressure) / np.linalg.norm(self.pressure)
        return {'load_error': abs(result.load / self.load - 1), 'area_error': abs(result.contact_area / self.area - 1),
                'pressure_error': float(off)}


def search_approach(scene, contact, threads):
    """At which a share of the cells of the scene's grid is in contact, to 2 %, by loose solves."""
    gap = scene.gap(scene.n)
    with rc.Contact(scene.system(scene.n), options={'tol': 1e-3, 'threads': threads}) as solver:
        def share_at(approach):
            return share_in_contact(solver.solve(undeformed_gap=gap, check=False, want_pressure=False, **{scene.control: approach}))

        low, high = gap.min(), gap.mean()
        while share_at(high) < contact:
            low, high = high, high + 2 * (high - low)
        for _ in range(30):
            middle = (low + high) / 2
            share = share_at(middle)
            if abs(share / contact - 1) < 0.02:
                return middle
            low, high = (middle, high) if share < contact else (low, middle)
    return (low + high) / 2


def solve_certified(scene, target, n, tol, threads):
    """(truth, result) of the certified solution on n x n cells."""
    result = solve(scene.system(n), scene.gap(n), {'tol': tol, 'threads': threads}, **{scene.control: target})
    return Truth(result.load, result.contact_area, result.pressure), result


class GridTruth:
    """What theory knows of the contact, completed by the solution on the finest grid, with pressures on as many cells as asked for.
    source: "analytic", "analytic load" or "finest grid"."""

    def __init__(self, scene, contact, target, threads):
        finest, known = 4 * scene.n, scene.known and scene.known(contact)
        self.source = 'finest grid' if not known else 'analytic' if known.pressure else 'analytic load'
        if known and known.pressure:
            self.truth = Truth(known.load, known.area, known.pressure(finest))
        else:
            solved, _ = solve_certified(scene, target, finest, 1e-10, threads)
            self.truth = Truth(known.load, known.area, solved.pressure) if known else solved

    def on(self, n):
        return Truth(self.truth.load, self.truth.area, block_means(self.truth.pressure, n))
