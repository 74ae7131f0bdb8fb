# %% [markdown]
# # Stiffness, conductance, and the intervals in which they are proven to lie
#
# The stiffness dF/dd of a rough contact grows in proportion to the load, and the electrical conductance in proportion to the
# stiffness (Barber 2003). The tolerance says how well the contact set is known. Option `stiffness` = 2 proves an interval for the
# exact stiffness of this grid; the picture shows how its width falls with the tolerance.

# %%
import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc

surface = rc.surface.spectral(
    (128, 128), pitch=0.5e-6, rms_height=0.2e-6, hurst=0.8, q_rolloff=2 * np.pi / 16e-6, q_high=2 * np.pi / 4e-6, seed=5
)
loads = np.geomspace(0.02, 3, 10)
copper = 1.7e-8  # resistivity, Ohm m
tols = (1e-3, 1e-5, 1e-8)
answers = {tol: [rc.solve(surface, E=120e9, nu=0.34, load=F, tol=tol, stiffness=2) for F in loads] for tol in tols}

# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.8))
best = answers[tols[-1]]
left.loglog(loads, [r.stiffness / 1e6 for r in best], ".-", label="stiffness [N/µm]")
left.loglog(loads, [r.conductance(copper, copper).value / 1e3 for r in best], "s-", label="conductance, copper [1/mΩ]")
left.set(xlabel="load [N]", ylabel="stiffness, conductance")
left.legend()
for tol, results in answers.items():
    width = [(r.stiffness_upper - r.stiffness_lower) / r.stiffness for r in results]
    right.loglog(loads, width, ".-", label=f"tol {tol:g}")
right.set(xlabel="load [N]", ylabel="width of the interval / stiffness")
right.set_ylim(top=2)
right.legend(title="proven for this grid", ncols=3)
figure.tight_layout()
