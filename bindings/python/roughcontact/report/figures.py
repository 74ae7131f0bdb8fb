"""The figures of a report, made with Plotly. Each returns a figure of its module graph_objects."""

import importlib
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from .._arrays import Doubles
from .._constants import RC_LAW_BULK_MEAN
from .._pictures import COLOURS, GROUND
from ..analysis import Crossing
from ..system import REPEATS, axes_of
from .content import Content
from .quantities import prefix_for
from .wording import status

RED, BLUE, BLACK = "#e6002e", "#3070c0", "#303030"
LOG: Dict[str, Any] = {"type": "log", "tickformat": "~g", "nticks": 4}  # each tick with its whole number: 20, not a small 2
SPREAD = 30  # loads whose largest is that many times the least have a logarithmic axis


class Figure(NamedTuple):
    name: str
    title: str
    caption: str
    figure: Any
    wide: bool = False  # takes the page's whole width


def _colour(rgb: Sequence[float]) -> str:
    return "rgb({:.0f}, {:.0f}, {:.0f})".format(*rgb)


GROUND_COLOUR = _colour(GROUND)
PRESSURES = [[0.0, GROUND_COLOUR]] + [
    [1e-6 + (1 - 1e-6) * k / (len(COLOURS) - 1), _colour(colour)] for k, colour in enumerate(COLOURS)
]


class Figures:
    def __init__(self, content: Content) -> None:
        self.graph = importlib.import_module("plotly.graph_objects")
        self.content = content
        self.loads = np.array([step.load for step in content.steps])

    def all(self) -> List[Figure]:
        found: List[Optional[Figure]] = [*self.curves()] if len(self.loads) > 1 else []
        found += [self.contact_law(), self.pressure_map(), self.height_map(), self.gap_map(), self.pressures(), self.patches(), self.fluid_map()]
        return [each for each in [*found, self.spectrum(), self.bearing()] if each is not None]

    def _figure(self, traces: Sequence[Any], x: str, y: str, **layout: Any) -> Any:
        base: Dict[str, Any] = {
            "template": "plotly_white",
            "margin": {"l": 70, "r": 20, "t": 20, "b": 55},
            "legend": {"x": 0.02, "y": 0.98, "bgcolor": "rgba(255,255,255,0.7)"},
            "xaxis": {"title": {"text": x}},
            "yaxis": {"title": {"text": y}},
        }
        figure = self.graph.Figure(traces, base)
        figure.update_layout(**layout)
        return figure

    def _curve(self, values: Union[Sequence[float], Doubles], unit: str, name: str, y_log: bool, others: Sequence[Any] = ()) -> Any:
        """Values of the steps against the load; on logarithmic axes where the loads spread."""
        y = np.array(values, float)
        y[~np.isfinite(y)] = np.nan
        force, factor = prefix_for(self.loads.max()), (
            prefix_for(np.nanmax(np.abs(y), initial=0)) if unit not in ("%", "m³/s") else (1.0, "")
        )
        text = [f"step {k}, {status(step)}" for k, step in enumerate(self.content.steps, 1)]
        points = self.graph.Scatter(
            x=self.loads / force[0],
            y=y / factor[0],
            text=text,
            mode="lines+markers",
            name="steps",
            line={"color": RED},
            hovertemplate=f"%{{x:.4g}} {force[1]}N: %{{y:.4g}} {factor[1]}{unit}<br>%{{text}}<extra></extra>",
        )
        figure = self._figure([points, *others], f"load [{force[1]}N]", f"{name} [{factor[1]}{unit}]")
        if self.spread:
            figure.update_xaxes(LOG)
            if y_log:
                figure.update_yaxes(LOG)
        return figure

    def _each(self, name: str) -> Doubles:
        return np.array([getattr(step, name, np.nan) for step in self.content.steps], float)

    def _smooth(self, approaches: Doubles) -> List[Any]:
        """Hertz' approach, drawn beside these."""
        values = self._each("smooth_approach")
        if not np.isfinite(values).any():
            return []
        factor = prefix_for(np.nanmax(np.abs(approaches), initial=0))[0]
        line = {"color": BLACK, "dash": "dash"}
        x = self.loads / prefix_for(self.loads.max())[0]
        return [self.graph.Scatter(x=x, y=values / factor, mode="lines", name="Hertz, smooth", line=line)]

    @property
    def spread(self) -> bool:
        return bool(self.loads.min() > 0 and self.loads.max() > SPREAD * self.loads.min())

    @property
    def wide(self) -> bool:
        rows, columns = self.content.surface.shape
        return columns * self.content.surface.pitch[0] > 2 * rows * self.content.surface.pitch[1]

    def area(self) -> Figure:
        c, factor = self.content, prefix_for(self.loads.max())[0]
        markers = {"symbol": "circle-open", "size": 9, "color": BLUE}
        hover = "%{x:.4g}: %{y:.4g} %<extra>%{fullData.name}</extra>"
        others = [
            self.graph.Scatter(
                x=self.loads / factor,
                y=[100 * c.corrected(step) for step in c.steps],
                mode="markers",
                name="corrected for cells that touch in part",
                marker=markers,
                hovertemplate=hover,
            )
        ]
        if c.persson:
            least = self.loads.min() / 1.5 if self.spread else 0.0
            line = (
                np.geomspace(least, 1.5 * self.loads.max(), 80) if self.spread else np.linspace(0, 1.1 * self.loads.max(), 80)
            )
            others.append(
                self.graph.Scatter(
                    x=line / factor,
                    y=[100 * area if area < 0.5 else None for area in map(c.persson_area, line)],
                    mode="lines",
                    name=f"Persson, rms slope {c.persson:.3g}",
                    line={"color": BLACK, "dash": "dash"},
                    hovertemplate=hover,
                )
            )
        figure = self._curve([100 * step.area_fraction for step in c.steps], "%", "contact area", True, others)
        caption = "Share of the nominal area in contact."
        caption += " Persson's line is erf(√2 p/(E* h′)) with the rms slope h′ of the map." if c.persson else ""
        return Figure("area", "Contact area against load", caption, figure)

    def of_time(self) -> List[Figure]:
        """Area and load against the time; on a logarithmic axis, without what is at or before 0, if times spread."""
        times = np.array(self.content.times, float)
        later = times[times > 0]
        spread = later.size > 2 and later.max() > SPREAD * later.min()
        text = [f"step {k}, {status(step)}" for k, step in enumerate(self.content.steps, 1)]
        found = []
        force, prefix = prefix_for(self.loads.max())
        for key, title, values, unit in (
            ("area-time", "Contact area against time", 100 * self._each("area_fraction"), "%"),
            ("load-time", "Load against time", self.loads / force, f"{prefix}N"),
        ):
            points = self.graph.Scatter(
                x=times,
                y=values,
                text=text,
                mode="lines+markers",
                line={"color": RED},
                hovertemplate=f"%{{x:.4g}} s: %{{y:.4g}} {unit}<br>%{{text}}<extra></extra>",
            )
            figure = self._figure([points], "time [s]", f"{title.split(' against')[0].lower()} [{unit}]")
            figure.update_yaxes(rangemode="tozero")
            if spread:
                figure.update_xaxes(LOG)
            caption = f"The bodies creep. At {times[0]:g} s {values[0]:.3g} {unit}, at {times[-1]:g} s {values[-1]:.3g} {unit}."
            found.append(Figure(key, title, caption, figure))
        return found

    def curves(self) -> List[Figure]:
        if self.content.times is not None:
            return self.of_time()
        found = [self.area()]
        for key, name, unit, y_log, caption in (
            ("gap", "mean gap", "m", False, "Of the deformed bodies, over all points."),
            ("stiffness", "stiffness", "N/m", True, "dW/dd: how much the load grows with the approach."),
            ("approach", "approach", "m", False, "Counted from first touch of the highest point."),
            ("leak", "leak", "m³/s", True, "Through the gap, under the pressure that was given."),
        ):
            values = self._each(name.replace(" ", "_"))
            if np.isfinite(values).any():
                title = f"{name.capitalize()} against load"
                smooth = self._smooth(values) if name == "approach" else []
                caption += " Dashed: Hertz' for the smooth body." if smooth else ""
                found.append(Figure(key, title, caption, self._curve(values, unit, name, y_log, smooth)))
        return found

    def contact_law(self) -> Optional[Figure]:
        law = self.content.contact_law
        if law is None:
            return None
        info, steps = law.info, self.content.steps
        at = law._points(np.geomspace(info["x_lower"], info["x_upper"], 200))
        x, (length, metre), (pressure, pascal) = at("x"), prefix_for(info["x_upper"]), prefix_for(info["p_upper"])
        line: Any = {"mode": "lines", "line": {"width": 0}, "showlegend": False, "hoverinfo": "skip"}
        of_steps = np.array([step.approach for step in steps])
        if info["bulk"] == RC_LAW_BULK_MEAN:
            of_steps = info["mean_gap"] - np.array([step.mean_gap for step in steps])
        elif info["bulk_stiffness"]:
            of_steps = of_steps - self.loads / info["bulk_stiffness"]
        hover = f"%{{x:.4g}} {metre}m: %{{y:.4g}} {pascal}Pa<extra>%{{fullData.name}}</extra>"
        named: Any = {"hovertemplate": hover}
        traces = [
            self.graph.Scatter(x=x / length, y=at("p_lower") / pressure, **line),
            self.graph.Scatter(
                x=x / length, y=at("p_upper") / pressure, fill="tonexty", fillcolor="rgba(230, 0, 46, 0.3)", **line
            ),
            self.graph.Scatter(x=x / length, y=at("p") / pressure, mode="lines", name="law", line={"color": RED}, **named),
            self.graph.Scatter(
                x=of_steps / length,
                y=[step.mean_pressure / pressure for step in steps],
                mode="markers",
                name="steps",
                marker={"color": BLUE},
                **named,
            ),
        ]
        caption = f"Contact law of {info['nodes']} nodes, nominal pressure within {100 * info['width']:.2g} %, and the steps of the table."
        labels = f"overclosure [{metre}m]", f"nominal pressure [{pascal}Pa]"
        figure = self._figure(traces, *labels, xaxis=LOG, yaxis=LOG)
        return Figure("law", "Pressure against overclosure", caption, figure)

    def _map(self, values: Doubles, unit: str, name: str, colours: Any, **how: Any) -> Any:
        maps = self.content.maps
        rows, columns = values.shape
        length = prefix_for(max(rows * maps.pitch[1], columns * maps.pitch[0]))
        factor = prefix_for(float(np.nanmax(np.abs(values), initial=0))) if unit else (1.0, "")
        trace = self.graph.Heatmap(
            z=(values / factor[0]).astype(np.float32),
            x0=0.5 * maps.pitch[0] / length[0],
            dx=maps.pitch[0] / length[0],
            y0=0.5 * maps.pitch[1] / length[0],
            dy=maps.pitch[1] / length[0],
            colorscale=colours,
            colorbar={"title": {"text": f"[{factor[1]}{unit}]" if unit else ""}, "thickness": 14},
            hovertemplate=f"x %{{x:.4g}}, y %{{y:.4g}} {length[1]}m<br>{name} %{{z:.4g}} {factor[1]}{unit}<extra></extra>",
            **how,
        )
        figure = self._figure([trace], f"x [{length[1]}m]", f"y [{length[1]}m]")
        across = columns * maps.pitch[0] / (rows * maps.pitch[1])
        figure.update_yaxes(autorange="reversed", constrain="domain", **({"scaleanchor": "x"} if 0.05 < across < 20 else {}))
        figure.update_xaxes(constrain="domain")
        figure.update_layout(
            plot_bgcolor=GROUND_COLOUR, height=int(np.clip((1000 if self.wide else 430) / across + 130, 220, 760))
        )
        return figure

    def _of_blocks(self, what: str) -> str:
        side = self.content.maps.side
        return f" Each cell shows the {what} of {side} × {side} points." if side > 1 else " Each cell is a point."

    def height_map(self) -> Figure:
        caption = "Above the mean, as pressed; the highest point touches first." + self._of_blocks("mean")
        return Figure("heights", "Heights", caption, self._map(self.content.maps.heights, "m", "height", "Greys_r"), self.wide)

    def pressure_map(self) -> Figure:
        last, shown = self.content.steps[-1], self.content.maps.pressure
        top = float(np.quantile(shown[shown > 0], 0.995)) if (shown > 0).any() else 1.0
        factor = prefix_for(float(shown.max()))[0]
        figure = self._map(shown, "Pa", "pressure", PRESSURES, zmin=0, zmax=top / factor)
        caption = f"Of the last step, {100 * last.area_fraction:.3g} % of the points in contact; no contact is dark."
        if self.content.maps.side > 1:
            caption += (
                f" Cells with contact cover {100 * (shown > 0).mean():.3g} % of the map, because one point makes a cell bright."
            )
        return Figure("pressure", "Pressure", caption + self._of_blocks("largest"), figure, self.wide)

    def gap_map(self) -> Figure:
        last = self.content.steps[-1]
        crossing = Crossing(last.contact_crosses, last.gap_crosses, axes_of(REPEATS[self.content.input["boundary"]]))
        caption = f"Between the deformed bodies in the last step; 0 in contact. From side to side {crossing}." + self._of_blocks(
            "mean"
        )
        return Figure("gaps", "Gap", caption, self._map(self.content.maps.gap, "m", "gap", "Viridis"), self.wide)

    def fluid_map(self) -> Optional[Figure]:
        fluid = self.content.maps.fluid
        if fluid is None or np.isnan(fluid).all():
            return None
        caption = "In the last step, over the drop: 1 where the fluid enters. Where nothing flows is dark." + self._of_blocks("mean")
        return Figure("fluid", "Pressure of the fluid", caption, self._map(fluid, "", "pressure", "Viridis", zmin=0, zmax=1), self.wide)

    def pressures(self) -> Optional[Figure]:
        found = self.content.histogram
        if found is None:
            return None
        factor, prefix = prefix_for(found.max_pressure)
        middle = (found.edges[1:] + found.edges[:-1]) / 2
        bars = self.graph.Bar(
            x=middle / factor,
            y=100 * found.counts / found.contacts,
            width=np.diff(found.edges) / factor,
            marker={"color": RED, "line": {"width": 0}},
            hovertemplate=f"%{{x:.4g}} {prefix}Pa: %{{y:.3g}} % of the contact<extra></extra>",
        )
        caption = "Of the points in contact, in the last step."
        return Figure(
            "pressures",
            "Distribution of pressure",
            caption,
            self._figure([bars], f"pressure [{prefix}Pa]", "share of the contact [%]", bargap=0),
        )

    def patches(self) -> Optional[Figure]:
        areas = self.content.patches.area
        if not len(areas):
            return None
        cell = self.content.surface.pitch[0] * self.content.surface.pitch[1]
        edges = cell * 2.0 ** np.arange(-0.5, np.log2(areas.max() / cell) + 1.5)
        counts, _ = np.histogram(areas, edges)
        seen = counts > 0
        bars = self.graph.Scatter(
            x=np.sqrt(edges[1:] * edges[:-1])[seen] * 1e12,
            y=counts[seen],
            mode="markers+lines",
            line={"color": RED},
            hovertemplate="about %{x:.3g} µm²: %{y} patches<extra></extra>",
        )
        caption = f"{len(areas)} connected parts in the last step; the largest has {100 * areas.max() / areas.sum():.3g} % of the contact."
        figure = self._figure([bars], "area of a patch [µm²], by factors of two", "patches", xaxis=LOG, yaxis=LOG)
        return Figure("patches", "Sizes of contact patches", caption, figure)

    def spectrum(self) -> Optional[Figure]:
        found, law = self.content.spectrum, self.content.law
        if found is None or law is None:
            return None
        seen = found.psd > 1e-20 * found.psd.max(initial=0)
        hover = "q %{x:.4g} 1/m: %{y:.4g} m⁴<extra></extra>"
        traces = [
            self.graph.Scatter(
                x=found.q[seen],
                y=found.psd[seen],
                mode="markers",
                name="map",
                marker={"color": RED, "size": 4},
                hovertemplate=hover,
            )
        ]
        if np.isfinite(law.slope):
            q = np.geomspace(law.q_min, law.q_max, 20)
            name = f"Hurst exponent {law.hurst:.2f} ± {law.hurst_error:.2f}"
            traces.append(
                self.graph.Scatter(
                    x=q, y=law.prefactor * q**law.slope, mode="lines", name=name, line={"color": BLACK, "dash": "dash"}
                )
            )
        figure = self._figure(traces, "wave number [1/m]", "power spectral density [m⁴]", xaxis=LOG, yaxis=LOG)
        figure.update_layout(legend={"x": 0.02, "y": 0.04})
        return Figure("spectrum", "Spectrum", "Radial average; wave numbers are 2π over the wavelength.", figure)

    def bearing(self) -> Figure:
        shares, heights = self.content.bearing
        factor, prefix = prefix_for(float(np.abs(heights).max()))
        hover = f"%{{x:.3g}} % of the points are above %{{y:.4g}} {prefix}m<extra></extra>"
        line = self.graph.Scatter(x=100 * shares, y=heights / factor, mode="lines", line={"color": RED}, hovertemplate=hover)
        caption = "The share of the undeformed surface that lies higher (Abbott and Firestone)."
        return Figure("bearing", "Bearing curve", caption, self._figure([line], "share [%]", f"height above mean [{prefix}m]"))


def figures_of(content: Content) -> Tuple[List[Figure], str]:
    """(the figures, Plotly's script)"""
    return Figures(content).all(), importlib.import_module("plotly.offline").get_plotlyjs()
