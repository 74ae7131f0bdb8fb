"""OSQP (ADMM for quadratic programs) with polishing: min 1/2 p'Hp - u'p over p >= 0, H as a full sparse matrix."""
import numpy as np
import osqp
import scipy.sparse

from dense_matrix import love_matrix


def version(request):
    return osqp.__version__


def warm_up(request):
    make(np.eye(8), np.arange(8.0) - 4, 1e-6).solve()


def make(matrix, right, tol):
    problem = osqp.OSQP()
    problem.setup(P=scipy.sparse.triu(matrix, format='csc'), q=-right, A=scipy.sparse.identity(right.size, format='csc'),
                  l=np.zeros(right.size), u=np.full(right.size, np.inf), eps_abs=tol, eps_rel=tol, max_iter=100000,
                  polishing=True, verbose=False)
    return problem


class Code:
    """Its tolerances are absolute too, so it gets cells of side 1 and compenetrations of at most 1."""

    def __init__(self, request, gap):
        right = request['target'] - gap.ravel()
        self.depth, self.n = right.max(), request['n']
        self.problem = make(love_matrix(request['build'], self.n) * self.n, right / self.depth, request['tol'])

    def solve(self):
        self.result = self.problem.solve(raise_error=False)
        return np.maximum(self.result.x, 0) * (self.depth * self.n)

    def setup_inside(self):
        return 0.0

    def details(self):
        return {'status': self.result.info.status, 'iterations': self.result.info.iter}
