"""Pictures with matplotlib, which is imported when one is made. Every function returns the axes it drew on.

Maps have x to the right and y down, from the first row of the array on, like the command's pictures. Points without contact
are dark, so that small contacts are visible.

si: whether lengths are in m, forces in N and pressures in Pa, as the axes then say with a prefix ("20 um"); else they have
    plain numbers.
"""

from typing import Any, Optional, Sequence, Tuple, Union

import numpy as np

from ._arrays import Pitch
from ._errors import ArgumentError
from ._height_map import Surface
from ._request import as_surface, unit_of
from ._pictures import COLOURS, GROUND
from ._status import Status
from .analysis import Histogram, Patches
from ._history_result import HistoryResult
from .result import Grid, Result
from .surface import PowerLaw, Spectrum

DARK = "#{:02x}{:02x}{:02x}".format(*GROUND)
__all__ = ["heights", "pressure", "patches", "history", "law", "slip", "histogram", "spectrum"]
UNITS = {"approach": "m", "overclosure": "m", "pressure": "Pa", "load": "N", "contact_area": "m\u00b2", "stiffness": "N/m"}
LAW_MEMBERS = {
    "pressure": ("p", "p"),
    "area_fraction": ("area_fraction", "area"),
    "conductance": ("conductance", "conductance"),
}


def _axes(ax: Any) -> Any:
    if ax is not None:
        return ax
    from matplotlib import pyplot  # type: ignore[import-not-found,unused-ignore]

    return pyplot.figure().add_subplot()


def _with_prefix(axis: Any, unit: Optional[str]) -> None:
    """Ticks such as "20 um". Areas have none: a prefix would be squared with them."""
    from matplotlib.ticker import MaxNLocator  # type: ignore[import-not-found,unused-ignore]

    axis.set_major_locator(MaxNLocator(5))
    if unit and not unit.endswith("\u00b2"):
        _prefixes(axis, unit)


def _prefixes(axis: Any, unit: str) -> None:
    from matplotlib.ticker import EngFormatter  # type: ignore[import-not-found,unused-ignore]

    axis.set_major_formatter(EngFormatter(unit=unit))


def _extent(shape: Tuple[int, ...], pitch: Tuple[float, float]) -> Sequence[float]:
    return 0, shape[-1] * pitch[0], shape[0] * pitch[1], 0


def _map(
    values: Any, grid: Union[Grid, Surface], ax: Any, label: str, length: Optional[str], unit: Optional[str], **how: Any
) -> Any:
    ax, values = _axes(ax), np.atleast_2d(values)
    image = ax.imshow(values, origin="upper", extent=_extent(values.shape, grid.pitch), **{"interpolation": "nearest", **how})
    if label:
        _with_prefix(ax.figure.colorbar(image, ax=ax, label=label).ax.yaxis, unit)
    for axis, name in ((ax.xaxis, "x"), (ax.yaxis, "y")):
        _with_prefix(axis, length)
        axis.set_label_text(name)
    return ax


def _colours() -> Any:
    """From low to high pressure, all seen on the ground."""
    from matplotlib.colors import LinearSegmentedColormap  # type: ignore[import-not-found,unused-ignore]

    return LinearSegmentedColormap.from_list("pressure", COLOURS / 255)


def _status(answer: Union[Result, HistoryResult]) -> str:
    return "certified" if answer.status == Status.OK else answer.status.name


def _outcome(result: Result, si: bool) -> str:
    """Load, share of the points in contact, and whether that is certified."""
    from matplotlib.ticker import EngFormatter  # type: ignore[import-not-found,unused-ignore]

    load = EngFormatter("N", places=3)(result.load) if si else f"{result.load:.4g}"
    return f"load {load}, {_status(result)}\n{result.contacts / max(result.points, 1):.2%} of the points in contact"


def heights(surface: Any, *, pitch: Optional[Pitch] = None, ax: Any = None, si: bool = True, **how: Any) -> Any:
    """A map of heights; missing points are dark. A surface's own unit comes before si. how: for imshow."""
    found, own = as_surface(surface, pitch), unit_of(surface)
    found = found if own is None else found.in_unit(own)
    shown = found.heights if found.mask is None else np.ma.array(found.heights, mask=found.mask == 0)
    plain = found.unit not in (None, "m")
    unit = "m" if si and not plain else None
    ax = _map(shown, found, ax, f"height ({found.unit})" if plain else "height", unit, unit, **how)
    ax.set_facecolor(DARK)
    if plain:
        ax.set_xlabel(f"x ({found.unit})")
        ax.set_ylabel(f"y ({found.unit})")
    return ax


def pressure(result: Result, *, ax: Any = None, si: bool = True, **how: Any) -> Any:
    """A map of pressures, with the load and the status above it. how: for imshow."""
    p = result._needed()
    shown = np.ma.array(p, mask=~(p > 0))
    ax = _map(shown, result.grid, ax, "pressure", "m" if si else None, "Pa" if si else None, **{"cmap": _colours(), **how})
    ax.set_facecolor(DARK)
    ax.set_title(_outcome(result, si), fontsize="small")
    return ax


def patches(result: Result, found: Optional[Patches] = None, *, ax: Any = None, si: bool = True, **how: Any) -> Any:
    """A map of the contact in 20 colours, by the patches' numbers. how: for imshow."""
    label = (result.find_patches() if found is None else found).label
    shown = np.ma.array(label % 20, mask=label < 0)
    ax = _map(shown, result.grid, ax, "", "m" if si else None, None, **{"cmap": "tab20", **how})
    ax.set_facecolor(DARK)
    ax.set_title(f"{label.max(initial=-1) + 1} patches, {_outcome(result, si)}", fontsize="small")
    return ax


def history(path: HistoryResult, *, ax: Any = None, x: str = "approach", y: str = "load", si: bool = True, **how: Any) -> Any:
    """One array of a loading history over another. how: for plot."""
    ax = _axes(ax)
    ax.plot(getattr(path, x), getattr(path, y), **{"marker": "o", "markersize": 3, **how})
    for name, axis in ((x, ax.xaxis), (y, ax.yaxis)):
        unit = UNITS.get(name) if si else None
        _with_prefix(axis, unit)
        axis.set_label_text(name.replace("_", " ") + (f" ({unit})" if unit and unit.endswith("\u00b2") else ""))
    ax.set_title(f"{path.completed} of {len(path.targets)} steps, {_status(path)}", fontsize="small")
    return ax


def law(found: Any, *, ax: Any = None, y: str = "pressure", points: int = 400, si: bool = True, **how: Any) -> Any:
    """A `Law` between its bounds, on logarithmic axes. y: "pressure" against overclosure with the nodes; "area_fraction" or
    "conductance", which is to be divided by the sum of both resistivities, against pressure. how: for plot."""
    ax, at = _axes(ax), found._points(np.geomspace(found.info["x_lower"], found.info["x_upper"], points))
    if y not in LAW_MEMBERS:
        raise ArgumentError(f"y is {y!r}: one of {', '.join(LAW_MEMBERS)}")
    if y == "conductance" and not found.info["modulus"]:
        raise ArgumentError("y is 'conductance', which follows from a law of homogeneous half-spaces only")
    x, (member, bound) = "overclosure" if y == "pressure" else "pressure", LAW_MEMBERS[y]
    abscissa = at("x" if y == "pressure" else "p")
    ax.loglog(abscissa, at(member), **how)
    ax.set_autoscale_on(False)  # bounds that are not known leave the picture
    lower, upper = (np.nan_to_num(at(f"{bound}_{end}"), posinf=1e300) for end in ("lower", "upper"))
    ax.fill_between(abscissa, lower, upper, color=ax.lines[-1].get_color(), alpha=0.3, linewidth=0)
    if y == "pressure":
        ax.plot(found.nodes["x"][1:], found.nodes["p"][1:], ".", color="black", markersize=3)
    for name, axis in ((x, ax.xaxis), (y, ax.yaxis)):
        if si and name in UNITS:
            _prefixes(axis, UNITS[name])
        axis.set_label_text(name.replace("_", " ") + (" (1/m)" if si and name == "conductance" else ""))
    ax.set_title(f"{found.info['nodes']} nodes, p within {found.info['width']:.2g}", fontsize="small")
    return ax


def slip(found: Any, pressure: Optional[float] = None, *, ax: Any = None, si: bool = True, **how: Any) -> Any:
    """A `Slip` at a pressure: first loading with its bounds, and loops that turn at a quarter, a half and all of the sliding slip.
    pressure: the law's highest unless given. how: for plot."""
    ax, p = _axes(ax), found.law.info["p_upper"] if pressure is None else pressure
    most = float(found.sliding_slip(p))
    for share in (1, 0.5, 0.25):
        slips, shears = found.loop(share * most, p)
        ax.plot(slips, shears, **{"color": "C0", "alpha": share**0.5, **how})
    slips = np.linspace(0, most, 100)
    ax.fill_between(slips, *found.bounds(slips, p), color="C0", alpha=0.3, linewidth=0)
    for axis, name, unit in ((ax.xaxis, "slip", "m"), (ax.yaxis, "shear", "Pa")):
        _with_prefix(axis, unit if si else None)
        axis.set_label_text(name)
    ax.set_title(f"friction {found.mu:g}, Poisson's ratio {found.nu:g}", fontsize="small")
    return ax


def histogram(found: Histogram, *, ax: Any = None, si: bool = True, **how: Any) -> Any:
    """Distribution of pressure over the contact. how: for stairs."""
    ax = _axes(ax)
    ax.stairs(found.density, found.edges, **{"fill": True, **how})
    _with_prefix(ax.xaxis, "Pa" if si else None)
    ax.set_xlabel("pressure")
    ax.set_ylabel("share of the contact per pressure" + (" (1/Pa)" if si else ""))
    return ax


def spectrum(found: Spectrum, law: Optional[PowerLaw] = None, *, ax: Any = None, si: bool = True, **how: Any) -> Any:
    """The radial PSD, without what is round-off of its largest value, and the power law in its range. how: for loglog."""
    ax = _axes(ax)
    seen = found.psd > 1e-20 * found.psd.max(initial=0)
    ax.loglog(found.q[seen], found.psd[seen], **{"marker": ".", "linestyle": "none", **how})
    if law is not None and np.isfinite(law.slope):
        q = np.array([law.q_min, law.q_max])
        ax.loglog(q, law.prefactor * q**law.slope, color="black", label=f"H = {law.hurst:.2f}")
        ax.legend()
    ax.set_xlabel("wave number" + (" (1/m)" if si else ""))
    ax.set_ylabel("PSD" + (" (m$^4$)" if si else ""))
    return ax


def __dir__() -> Sequence[str]:
    return __all__
