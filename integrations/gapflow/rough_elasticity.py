"""Elastic deformation in GaPFlow by products with roughcontact's H.

    import rough_elasticity
    rough_elasticity.install()  # before a Problem is made

GaPFlow's elastic walls then use `roughcontact.Influence` for all its boundaries: periodic, free, and periodic along one axis,
where the sum over images is exact instead of cut off after `n_images`. Each step takes the whole deformation of its pressure.
`start_from_contact(problem, gap, least)` begins with a solved dry contact.
"""

import numpy as np
import roughcontact
from GaPFlow import topography

_HALF_SPACE = topography.ElasticDeformation
_BOUNDARIES = {(True, True): "periodic", (False, False): "free", (True, False): "periodic-y", (False, True): "periodic-x"}


class ElasticDeformation(_HALF_SPACE):
    """As the class of the same name in GaPFlow, without its half-space."""

    relaxation = 1.0  # in place of the input's alpha_underrelax, unless it is None

    def __init__(self, E, v, alpha_underrelax, grid, n_images):
        """E, v: Young's modulus and Poisson's ratio. alpha_underrelax: share of the new deformation in each step. grid: GaPFlow's
        [length]. n_images is not used."""
        del n_images
        self.alpha_underrelax = alpha_underrelax if self.relaxation is None else self.relaxation
        points = grid["Nx"] + 2, grid["Ny"] + 2  # ghost cells included
        repeats = bool(grid["bc_xE_P"][0]), bool(grid["bc_yS_P"][0])
        lengths = [grid["Lx"], grid["Ly"]]
        self.periodicity = {2: "full", 1: "half", 0: "none"}[sum(repeats)]
        self._line = None  # the axis of a line contact: a strip of unit length, of which the middle counts
        if sum(repeats) == 1 and points[repeats.index(True)] == 3:
            self._line = repeats.index(True)
            repeats, lengths[self._line] = (False, False), 1.0
        # The half-space has the cells into which GaPFlow divides its lengths; forces are its pressures times dx dy.
        pitch = lengths[0] / points[0], lengths[1] / points[1]
        self._pressure_factor = grid["dx"] * grid["dy"] / (pitch[0] * pitch[1])
        self._influence = roughcontact.Influence(
            roughcontact.HalfSpace(points, pitch=pitch[::-1], E=E, nu=v, boundary=_BOUNDARIES[repeats])
        )
        self.u_prev = np.zeros(points)

    def get_deformation(self, p):
        """Deformation [length], positive under positive pressure p [points along x, along y]."""
        deformation = self._influence @ (np.asarray(p) * self._pressure_factor)
        if self._line is None:
            return deformation
        return np.broadcast_to(deformation.take([1], axis=self._line), deformation.shape).copy()


def install(relaxation=1.0):
    """Makes every GaPFlow problem that is made from here on use this class. relaxation: share of the new deformation in each step;
    None for alpha_underrelax of the input."""
    ElasticDeformation.relaxation = relaxation
    topography.ElasticDeformation = ElasticDeformation


def start_from_contact(problem, gap, least):
    """The walls of a GaPFlow problem begin as a dry contact leaves them, and deform from there by the fluid's pressure.

    gap [points along x, along y]: solved for the cells of the problem's grid, `result.gap.T`. least [length]: the film where walls
    touch, since GaPFlow needs one everywhere. Call this before the run. It replaces the geometry of input.yaml."""
    grid, gap = problem.grid, np.asarray(gap)
    if gap.shape != (grid["Nx"], grid["Ny"]):
        raise ValueError(f"the gap has {gap.shape} points, the grid {grid['Nx'], grid['Ny']} cells; solve the contact on the grid")
    if not (least > 0 and np.isfinite(gap).all()):
        raise ValueError(f"least is {least}, and a gap must be finite; GaPFlow needs a film above 0 in every cell")
    film = np.maximum(gap, least)
    for axis, repeats in enumerate((grid["bc_xE_P"][0], grid["bc_yS_P"][0])):
        ghosts = [(0, 0), (0, 0)]
        ghosts[axis] = 1, 1
        film = np.pad(film, ghosts, mode="wrap" if repeats else "edge")
    problem.topo.h_undeformed = film.copy()
    problem.topo.h = film
