# %% [markdown]
# # No more accuracy than is wanted
#
# Option `accuracy` names the error in the load that is accepted. The library solves coarser grids where these will do and
# corrects their answers on the given one. The picture has the estimated and the true error for a goal, and the time that the goal
# saves. Where no coarser grid will do, the whole grid is solved, to a tolerance that fits the goal: such an answer has no estimate.

# %%
import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc

surface = rc.surface.spectral(
    (1024, 1024), pitch=0.1e-6, rms_height=0.2e-6, hurst=0.8, q_rolloff=2 * np.pi / 50e-6, q_high=2 * np.pi / 1e-6, seed=4
)
press = dict(E=70e9, nu=0.3, approach=0.5e-6, threads=1)
rc.solve(surface, **press)  # plans of transforms are made once
full = rc.solve(surface, **press)
goals = np.array([0.1, 0.03, 0.01, 0.003, 0.001])
answers = [rc.solve(surface, accuracy=goal, **press) for goal in goals]

# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.8))
left.loglog(goals, goals, "--", color="0.6", label="goal")
coarse = np.array([r.status == rc.Status.WITHIN_GOAL for r in answers])
left.loglog(goals[coarse], [r.accuracy.error_estimate for r, c in zip(answers, coarse) if c], "o", label="estimate")
errors = np.array([abs(r.load / full.load - 1) for r in answers])
left.loglog(goals[coarse], errors[coarse], "s", label="error, coarser grid")
left.loglog(goals[~coarse], errors[~coarse], "s", mfc="none", color="C1", label="error, whole grid")
left.set(xlabel="goal", ylabel="relative error of the load")
left.legend()
names = ["no goal", *(f"{goal:g}" for goal in goals)]
times = [r.seconds + r.setup_seconds for r in (full, *answers)]
bars = right.bar(names, times, color=["0.6"] + ["C0" if c else "C1" for c in coarse])
right.bar_label(bars, [f"{r.accuracy.model_nx}²" for r in (full, *answers)])
right.set(xlabel="goal", ylabel="seconds on one core", title="grids that were solved (orange: the whole one)")
right.margins(y=0.12)
figure.tight_layout()
