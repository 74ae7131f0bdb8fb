# %% [markdown]
# # Stiffness, conductance, and the intervals in which they are proven to lie
#
# The stiffness dF/dd of a rough contact grows in proportion to the load, and the electrical conductance in proportion to the
# stiffness (Barber 2003). With a loose tolerance the contact set is not known exactly; option `stiffness` = 2 proves an interval
# for the exact stiffness, and the conductance has one as well.

# %%
import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc

surface = rc.surface.spectral(
    (128, 128), pitch=0.5e-6, rms_height=0.2e-6, hurst=0.8, q_rolloff=2 * np.pi / 16e-6, q_high=2 * np.pi / 4e-6, seed=5
)
loads = np.geomspace(0.02, 3, 10)
copper = 1.7e-8  # resistivity, Ohm m
answers = {tol: [rc.solve(surface, E=120e9, nu=0.34, load=F, tol=tol, stiffness=2) for F in loads] for tol in (3e-3, 1e-8)}

# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.8))
for (tol, results), colour in zip(answers.items(), ("tab:orange", "tab:blue")):
    low, high = np.array([(r.stiffness_lower, r.stiffness_upper) for r in results]).T
    left.fill_between(loads, low / 1e6, high / 1e6, alpha=0.4, color=colour, label=f"proven, tol {tol:g}")
    conductances = [r.conductance(copper, copper) for r in results]
    right.fill_between(
        loads,
        [c.lower for c in conductances],
        [c.upper for c in conductances],
        alpha=0.4,
        color=colour,
        label=f"proven, tol {tol:g}",
    )
left.loglog(loads, [r.stiffness / 1e6 for r in answers[1e-8]], ".-", label="stiffness")
left.set(xlabel="load [N]", ylabel="stiffness [N/µm]")
right.loglog(loads, [r.conductance(copper, copper).value for r in answers[1e-8]], ".-", label="conductance, copper")
right.set(xlabel="load [N]", ylabel="conductance [1/Ω]")
left.legend()
right.legend()
figure.tight_layout()
