"""Fluid around a pressed asperity: the gap is solved dry, and GaPFlow's flow begins in it."""

import numpy as np
import rough_elasticity
import roughcontact as rc
from GaPFlow.problem import Problem

n, length = 32, 320e-6
wave = np.cos(2 * np.pi * (np.arange(n) - n / 2) / n)
dry = rc.solve(2e-6 * (wave[:, None] + wave), pitch=length / n, modulus=115e9, boundary="periodic", pressure=4e8, want_gap=True)
rough_elasticity.install()
problem = Problem.from_yaml("dry_contact.yaml")
rough_elasticity.start_from_contact(problem, dry.gap.T, least=5e-7)
problem.run()
flow = ((problem.q[1] / problem.q[0] * problem.topo.h)[1:-1, 1:-1] * problem.grid["dy"]).sum(axis=1)
print(f"contact {dry.contact_area / length**2:.1%}, gap {dry.mean_gap * 1e6:.3g} um, {problem.step} steps")
print(f"flow {flow.mean():.4g} m^3/s, from column to column within {np.ptp(flow) / flow.mean():.1%}")
