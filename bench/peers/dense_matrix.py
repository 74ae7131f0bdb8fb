"""The matrix of influence coefficients for codes that need it, from the library's own coefficients."""
import numpy as np

from library import Library


def love_matrix(build, n):
    """H of n x n cells of the unit square, contact modulus 1."""
    table = Library(build).love(n, n, 1 / n)
    y, x = np.divmod(np.arange(n * n), n)
    return table[np.abs(y[:, None] - y[None, :]), np.abs(x[:, None] - x[None, :])]
