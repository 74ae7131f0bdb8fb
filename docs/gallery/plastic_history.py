# %% [markdown]
# # Loading, unloading, loading again, with plasticity
#
# A rough surface is loaded and unloaded three times, each time further. Yielded points remain indented: unloading is stiffer than
# loading, and up to the largest load so far loading follows the last unloading.

# %%
import matplotlib.pyplot as plt
import numpy as np

import roughcontact as rc

surface = rc.surface.spectral(
    (128, 128), pitch=0.25e-6, rms_slope=0.1, hurst=0.8, q_rolloff=2 * np.pi / 8e-6, q_high=2 * np.pi / 1e-6, seed=2
)
system = rc.HalfSpace.under(surface, modulus=115e9, hardness=4e9)  # steel on steel
turns = np.array([0, 0.18, 0.12, 0.21, 0.15, 0.24, 0.18]) * 1e-6
approaches = np.concatenate([np.linspace(a, b, 9)[1:] for a, b in zip(turns, turns[1:])])

# %%
with rc.Contact(system) as contact:
    path = contact.history(surface, approach=approaches)
    indentation = contact.indentation()
elastic = rc.history(surface, modulus=115e9, approach=np.linspace(0, 0.24e-6, 24)[1:])

figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.8))
d, F = np.r_[0, approaches] * 1e6, np.r_[0, path.load] * 1e3
for part in range(6):  # eight steps each
    legs = slice(8 * part, 8 * part + 9)
    left.plot(
        d[legs],
        F[legs],
        ("^-", "v--")[part % 2],
        markersize=4,
        color=f"C{part // 2}",
        label=f"cycle {part // 2 + 1}, {('loading', 'unloading')[part % 2]}",
    )
left.plot(elastic.approach * 1e6, elastic.load * 1e3, ":", color="0.4", label="elastic")
left.set(xlabel="approach [µm]", ylabel="load [mN]", title="hardness 4 GPa")
left.set_xlim(0.08, 0.25)
left.legend(fontsize="small")
side = 128 * 0.25
image = right.imshow(
    np.ma.masked_equal(indentation, 0) * 1e9, cmap="viridis", extent=(0, side, side, 0), interpolation="nearest"
)
right.set_facecolor("0.25")
right.set(xlabel="x [µm]", ylabel="y [µm]", title="remaining indentation")
figure.colorbar(image, ax=right, label="indentation [nm]")
figure.tight_layout()
