"""The rough interface of one Gauss point as preCICE's Micro Manager asks for it: a class MicroSimulation.

micro_simulation.py      presses one interface as the manager would, and prints what it answers
"""

import roughcontact as rc

SURFACE = rc.surface.spectral((64, 64), pitch=1e-6, rms_height=2e-7, hurst=0.8, seed=1)
SYSTEM = rc.HalfSpace(SURFACE.shape, pitch=1e-6, modulus=115e9, boundary="periodic")
AREA = SURFACE.heights.size * 1e-12  # m^2


class MicroSimulation:
    """The macro program gives the overclosure of the mean planes and gets nominal pressure and slope: with periodic boundaries the
    approach is the change of the mean gap."""

    def __init__(self, sim_id):
        self.sim_id, self.state, self.contact = sim_id, None, rc.Contact(SYSTEM, options={"stiffness": 1})

    def initialize(self):
        return {"pressure": 0.0, "slope": 0.0}

    def solve(self, macro_data, dt):
        if macro_data["overclosure"] <= 0:
            return self.initialize()
        result = self.contact.solve(SURFACE, approach=macro_data["overclosure"], start=self.state)
        self.state = result.pressure
        return {"pressure": result.mean_pressure, "slope": result.stiffness / AREA}

    def get_state(self):
        return self.state

    def set_state(self, state):
        self.state = state


if __name__ == "__main__":
    point = MicroSimulation(0)
    for overclosure in (0.0, 2e-7, 4e-7, 3e-7):
        answer = point.solve({"overclosure": overclosure}, 1.0)
        print(f"{overclosure:.1e} m: {answer['pressure']:.4g} Pa, {answer['slope']:.4g} Pa/m")
