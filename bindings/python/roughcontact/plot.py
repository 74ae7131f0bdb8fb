"""Pictures with matplotlib, which is imported when one is made. Every function returns the axes it drew on."""

from typing import Any, Optional, Sequence, Tuple, Union

import numpy as np

from ._arrays import Pitch
from ._maps import Surface, as_surface
from .analysis import Histogram, Patches
from .result import Grid, PathResult, Result
from .surface import PowerLaw, Spectrum


def _axes(ax: Any) -> Any:
    if ax is not None:
        return ax
    from matplotlib import pyplot  # type: ignore[import-not-found,unused-ignore]

    return pyplot.figure().add_subplot()


def _extent(shape: Tuple[int, ...], pitch: Tuple[float, float]) -> Sequence[float]:
    return 0, shape[-1] * pitch[0], 0, shape[0] * pitch[1]


def _map(values: Any, grid: Union[Grid, Surface], ax: Any, label: str, length: str, **how: Any) -> Any:
    ax = _axes(ax)
    image = ax.imshow(values, origin="lower", extent=_extent(values.shape, grid.pitch), **{"interpolation": "nearest", **how})
    if label:
        ax.figure.colorbar(image, ax=ax, label=label)
    ax.set_xlabel(f"x ({length})")
    ax.set_ylabel(f"y ({length})")
    return ax


def heights(surface: Any, *, pitch: Optional[Pitch] = None, ax: Any = None, length: str = "m", **how: Any) -> Any:
    """A map of heights. length: unit for the labels where the surface does not say its own; how: for imshow."""
    found = as_surface(surface, pitch, missing="exclude")
    shown = found.heights if found.mask is None else np.ma.array(found.heights, mask=found.mask == 0)
    unit = found.unit or length
    return _map(shown, found, ax, f"height ({unit})", unit, **how)


def pressure(result: Result, *, ax: Any = None, length: str = "m", label: str = "pressure (Pa)", **how: Any) -> Any:
    """A map of pressures; white where there is no contact."""
    p = result._needed()
    return _map(np.ma.array(p, mask=~(p > 0)), result.grid, ax, label, length, **how)


def patches(result: Result, found: Optional[Patches] = None, *, ax: Any = None, length: str = "m", **how: Any) -> Any:
    """A map of the contact, neighbouring patches in different colours."""
    label = (result.patches() if found is None else found).label
    return _map(np.ma.array(label % 20, mask=label < 0), result.grid, ax, "", length, **{"cmap": "tab20", **how})


def history(path: PathResult, *, ax: Any = None, x: str = "displacement", y: str = "load", **how: Any) -> Any:
    """One array of a loading history over another."""
    ax = _axes(ax)
    ax.plot(getattr(path, x), getattr(path, y), **{"marker": "o", "markersize": 3, **how})
    ax.set_xlabel(x.replace("_", " "))
    ax.set_ylabel(y.replace("_", " "))
    return ax


def histogram(found: Histogram, *, ax: Any = None, label: str = "pressure (Pa)", **how: Any) -> Any:
    """Distribution of pressure over the contact."""
    ax = _axes(ax)
    ax.stairs(found.density, found.edges, **{"fill": True, **how})
    ax.set_xlabel(label)
    ax.set_ylabel("share of the contact per pressure")
    return ax


def spectrum(found: Spectrum, law: Optional[PowerLaw] = None, *, ax: Any = None, length: str = "m", **how: Any) -> Any:
    """The radial PSD, and the power law in its range."""
    ax = _axes(ax)
    seen = found.psd > 0
    ax.loglog(found.q[seen], found.psd[seen], **{"marker": ".", "linestyle": "none", **how})
    if law is not None and np.isfinite(law.slope):
        q = np.array([law.q_min, law.q_max])
        ax.loglog(q, law.prefactor * q**law.slope, color="black", label=f"H = {law.hurst:.2f}")
        ax.legend()
    ax.set_xlabel(f"wave number (1/{length})")
    ax.set_ylabel(f"PSD ({length}$^4$)")
    return ax
