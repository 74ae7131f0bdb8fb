"""A block in scikit-fem, for two_blocks.Blocks."""

import numpy as np
from skfem import Basis, ElementQuad1, ElementVector, MeshQuad
from skfem.models.elasticity import lame_parameters, linear_elasticity
from two_blocks import E, HEIGHT, NU, WIDTH


def block(cells):
    mesh = MeshQuad.init_tensor(np.linspace(0, WIDTH, cells + 1), np.linspace(0, HEIGHT, cells + 1))
    basis = Basis(mesh, ElementVector(ElementQuad1()))
    return linear_elasticity(*lame_parameters(E, NU)).assemble(basis), mesh.p, basis.nodal_dofs
