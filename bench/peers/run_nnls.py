"""scipy.optimize.nnls (Lawson-Hanson): with H = L L', min |L'p - inv(L) u| over p >= 0 is the contact problem."""
import numpy as np
import scipy.linalg
import scipy.optimize

from dense_matrix import love_matrix


def version(request):
    return scipy.__version__


def warm_up(request):
    scipy.optimize.nnls(np.eye(8), np.arange(8.0) - 4)


class Code:
    def __init__(self, request, gap):
        factor = scipy.linalg.cholesky(love_matrix(request['build'], request['n']), lower=True)
        self.right = scipy.linalg.solve_triangular(factor, request['target'] - gap.ravel(), lower=True)
        self.factor = np.ascontiguousarray(factor.T)

    def solve(self):
        return scipy.optimize.nnls(self.factor, self.right, maxiter=100 * self.right.size)[0]

    def setup_inside(self):
        return 0.0

    def details(self):
        return {'status': 'solved'}
