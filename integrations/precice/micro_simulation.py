"""The rough interface of one Gauss point as preCICE's Micro Manager asks for it: a class MicroSimulation.

The contact law answers where it holds, between its first and last node; elsewhere the contact is solved.

micro_simulation.py      presses one interface as the manager would, and prints what it answers
"""

import roughcontact as rc

SURFACE = rc.surface.spectral((64, 64), pitch=1e-6, rms_height=2e-7, hurst=0.8, seed=1)
SYSTEM = rc.HalfSpace(SURFACE.shape, pitch=1e-6, modulus=115e9, boundary="periodic")
AREA = SURFACE.heights.size * 1e-12  # m^2
LAW = rc.law(SURFACE, system=SYSTEM, pressure=(1e7, 5e8), tolerance=1e-3, bulk="none")  # one for all points of a process


class MicroSimulation:
    """The macro program gives the overclosure of the mean planes and gets nominal pressure and slope: with periodic boundaries the
    approach is the change of the mean gap. "Solved" is 1 where the contact was solved, 0 where it was not."""

    def __init__(self, sim_id):
        self.sim_id, self.state, self.contact = sim_id, None, None

    def initialize(self):
        return {"Pressure": 0.0, "Slope": 0.0, "Solved": 0.0}

    def solve(self, macro_data, dt):
        x = float(macro_data["Overclosure"])
        if x <= 0:
            return self.initialize()
        if LAW.info["x_lower"] <= x <= LAW.info["x_upper"]:
            return {"Pressure": float(LAW(x)), "Slope": float(LAW.slope(x)), "Solved": 0.0}
        if self.contact is None:
            self.contact = rc.Contact(SYSTEM, options={"stiffness": 1})
        result = self.contact.solve(SURFACE, approach=x, start=self.state)
        self.state = result.pressure
        return {"Pressure": result.mean_pressure, "Slope": result.stiffness / AREA, "Solved": 1.0}

    def get_state(self):
        return self.state

    def set_state(self, state):
        self.state = state


if __name__ == "__main__":
    point = MicroSimulation(0)
    for overclosure in (0.0, 1e-7, 3e-7, 4.9e-7, 4e-7):
        answer = point.solve({"Overclosure": overclosure}, 1.0)
        how = "solved" if answer["Solved"] else "by the law"
        print(f"{overclosure:.1e} m: {answer['Pressure']:.4g} Pa, {answer['Slope']:.4g} Pa/m, {how}")
