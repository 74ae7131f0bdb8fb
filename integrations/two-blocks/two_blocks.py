"""Two elastic blocks with a rough interface under friction, with any finite element library: Newton's method with the tangent of the contact law.

Units are mm, N and MPa; both blocks repeat along x."""

import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import spsolve

E, NU, HEIGHT, WIDTH = 210e3, 0.3, 10.0, 10.0
CLOSE = 1e-9  # of coordinates


def on(coordinate, side):
    return np.abs(coordinate - side) < CLOSE


class Blocks:
    """One on the other; the lower one stands still, the top of the upper one is moved. Contact is between nodes that face each other."""

    def __init__(self, slip, block, cells=6):
        """block: a function of the number of cells along each side that returns the stiffness matrix of one block, its nodes
        [2, n], and the degree of freedom of each component at each node [2, n]."""
        stiffness, (x, y), at = block(cells)
        nodes, total = np.arange(len(x)), stiffness.shape[0]
        left, right = (nodes[on(x, side)][np.argsort(y[on(x, side)])] for side in (0, WIDTH))
        same = np.arange(total)
        same[at[:, right]] = at[:, left]  # periodic
        of = np.unique(same, return_inverse=True)[1]
        tie = sparse.csr_matrix((np.ones(total), (np.arange(total), of)))
        one = tie.T @ stiffness @ tie
        self.size = one.shape[0]
        self.stiffness = sparse.block_diag([one, one], format="csr")
        inner = [nodes[on(y, level) & ~on(x, WIDTH)] for level in (HEIGHT, 0)]  # below and above the interface
        order = [each[np.argsort(x[each])] for each in inner]
        self.below, self.above = of[at[:, order[0]]], of[at[:, order[1]]] + self.size
        self.bottom, self.top = of[at[:, order[1]]], of[at[:, order[0]]] + self.size
        self.area = WIDTH / cells
        self.u, self.states, self.iterations = np.zeros(2 * self.size), [slip.rest.step(0)] * cells, []

    def contact(self, u, moved):
        """Forces on all degrees of freedom, their tangent, and the states, by the displacements and what changed in the step."""
        forces, entries, states = np.zeros_like(u), [], []
        for i, before in enumerate(self.states):
            dofs = np.concatenate([self.above[:, i], self.below[:, i]])
            gap = np.array([[0, -1, 0, 1], [1, 0, -1, 0]])  # overclosure and slip by these
            x, slip = gap[0] @ u[dofs], gap[1] @ moved[dofs]
            state = before.step(x, (slip, 0))
            forces[dofs] -= self.area * gap.T @ [state.p, state.shear[0]]
            tangent = np.array([[state.slope, 0], [state.shear_by_x[0], state.shear_by_slip[0, 0]]])
            entries.append((dofs, self.area * gap.T @ tangent @ gap))
            states.append(state)
        rows, columns = (
            np.concatenate([np.ravel(part) for part in parts])
            for parts in zip(*(np.meshgrid(d, d, indexing="ij") for d, _ in entries))
        )
        values = np.concatenate([each.ravel() for _, each in entries])
        return forces, sparse.csr_matrix((values, (rows, columns)), shape=self.stiffness.shape), states

    def move(self, along, down, most=30):
        """Moves the top there; (mean pressure, mean shear)."""
        u, held = self.u.copy(), np.concatenate([self.bottom.ravel(), self.top.ravel()])
        free = np.setdiff1d(np.arange(len(u)), held)
        u[self.top[0]], u[self.top[1]] = along, -down
        for iteration in range(most):
            forces, tangent, states = self.contact(u, u - self.u)
            rest = (forces - self.stiffness @ u)[free]
            if np.abs(rest).max() <= 1e-10 * max(np.abs(forces).max(), 1e-9):
                break
            u[free] += spsolve((self.stiffness + tangent)[free][:, free].tocsc(), rest)
        else:
            raise RuntimeError("Newton's method does not converge")
        self.u, self.states = u, states
        self.iterations.append(iteration)
        return np.mean([state.p for state in states]), np.mean([state.shear[0] for state in states])
