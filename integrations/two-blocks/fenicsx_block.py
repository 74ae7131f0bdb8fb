"""A block in FEniCSx (0.5 and later), for two_blocks.Blocks."""

import dolfinx.fem.petsc
import numpy as np
import scipy.sparse as sparse
import ufl
from dolfinx import fem, mesh
from mpi4py import MPI
from two_blocks import E, HEIGHT, NU, WIDTH


def block(cells):
    corners = [np.array([0, 0]), np.array([WIDTH, HEIGHT])]
    grid = mesh.create_rectangle(MPI.COMM_SELF, corners, [cells, cells], mesh.CellType.quadrilateral)
    vectors = (
        fem.VectorFunctionSpace(grid, ("Lagrange", 1))
        if hasattr(fem, "VectorFunctionSpace")
        else fem.functionspace(grid, ("Lagrange", 1, (2,)))
    )
    u, v = ufl.TrialFunction(vectors), ufl.TestFunction(vectors)
    mu, lam = E / 2 / (1 + NU), E * NU / (1 + NU) / (1 - 2 * NU)
    strain = ufl.sym(ufl.grad(u))
    work = ufl.inner(lam * ufl.tr(strain) * ufl.Identity(2) + 2 * mu * strain, ufl.grad(v)) * ufl.dx
    matrix = fem.petsc.assemble_matrix(fem.form(work))
    matrix.assemble()
    stiffness = sparse.csr_matrix(matrix.getValuesCSR()[::-1], shape=matrix.getSize())
    nodes = vectors.tabulate_dof_coordinates()[:, :2].T
    return stiffness, nodes, 2 * np.arange(nodes.shape[1]) + np.array([[0], [1]])
