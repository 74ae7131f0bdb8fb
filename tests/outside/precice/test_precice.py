"""test_precice.py INTEGRATION: preCICE's Micro Manager runs the micro simulation of the folder INTEGRATION. A stand-in takes the place
of preCICE and of the macro program: it has three Gauss points, and asks for each time window twice, as an implicit coupling does."""

import os
import shutil
import sys
import tempfile
import types

import numpy as np

# What the macro program asks for: [window, iteration, Gauss point]
OVERCLOSURES = np.array(
    [[[-1e-7, 1e-7, 2e-7], [0, 1.1e-7, 3e-7]], [[1e-7, 3e-7, 4.9e-7], [2e-7, 2.5e-7, 4.8e-7]], [[4e-7, 4.9e-7, 5e-7], [3e-7, 1e-7, -1e-7]]]
)
WINDOWS, ITERATIONS, POINTS = OVERCLOSURES.shape


class Participant:
    """The calls of preCICE 3 that the Micro Manager makes."""

    answers = {}  # by name: [window, iteration, Gauss point]

    def __init__(self, name, config, rank, size):
        assert (name, os.path.basename(config), rank, size) == ("Micro-Manager", "precice-config.xml", 0, 1)
        self.window, self.iteration = 0, 0

    def get_mesh_dimensions(self, mesh):
        return 2

    def set_mesh_access_region(self, mesh, bounds):
        assert (mesh, list(bounds)) == ("Macro-Mesh", [0, 1, 0, 1])

    def initialize(self):
        self.started = True

    def get_mesh_vertex_ids_and_coordinates(self, mesh):
        return np.arange(POINTS), np.linspace((0.1, 0.5), (0.9, 0.5), POINTS)

    def get_max_time_step_size(self):
        return 1.0

    def is_coupling_ongoing(self):
        return self.window < WINDOWS

    def is_time_window_complete(self):
        return self.iteration == 0

    def requires_writing_checkpoint(self):
        return self.iteration == 0

    def requires_reading_checkpoint(self):
        return self.iteration > 0

    def read_data(self, mesh, name, ids, dt):
        assert name == "Overclosure"
        return OVERCLOSURES[self.window, self.iteration][ids]

    def write_data(self, mesh, name, ids, values):
        self.answers.setdefault(name, np.full(OVERCLOSURES.shape, np.nan))[self.window, self.iteration, ids] = values

    def advance(self, dt):
        self.iteration = (self.iteration + 1) % ITERATIONS
        self.window += self.iteration == 0

    def finalize(self):
        assert self.started and not self.is_coupling_ongoing()

    def start_profiling_section(self, name):
        pass

    def stop_last_profiling_section(self):
        pass


sys.modules["precice"] = types.SimpleNamespace(Participant=Participant)
try:
    from micro_manager import MicroManagerCoupling
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

sys.path.insert(0, sys.argv[1])
import micro_simulation as micro  # noqa: E402
import roughcontact as rc  # noqa: E402

with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)  # the manager writes its records where it runs
    shutil.copy(sys.argv[1] + "/micro-manager-config.json", folder)
    manager = MicroManagerCoupling(folder + "/micro-manager-config.json")
    manager.initialize()
    manager.solve()
    os.chdir("/")

info, solves = micro.LAW.info, 0
for x, p, slope, solved in zip(OVERCLOSURES.flat, *(Participant.answers[name].flat for name in ("Pressure", "Slope", "Solved"))):
    exact = rc.solve(micro.SURFACE, system=micro.SYSTEM, approach=x, options={"stiffness": 1}) if x > 0 else None
    off = abs(p / exact.mean_pressure - 1) if exact else abs(p)
    off_slope = abs(slope * micro.AREA / exact.stiffness - 1) if exact else abs(slope)
    print(f"{x: .1e} m: {p:.4g} Pa, {'solved' if solved else 'not solved'}, off by {off:.1e}, its slope by {off_slope:.1e}")
    assert solved == (x > 0 and not info["x_lower"] <= x <= info["x_upper"])
    assert off < (1e-6 if solved else 1e-3) and off_slope < (1e-4 if solved else 0.07)
    solves += solved
assert solves == 8, f"{solves} solves"
