"""What a report says in words and tables."""

from typing import Any, Dict, List, Optional, Sequence, Tuple

import numpy as np

from .._remarks import elastic_limit
from .._status import Status
from ..surface import PowerLaw
from .content import Content, Step
from .quantities import with_prefix

Rows = Sequence[Tuple[str, str]]
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def status(step: Step) -> str:
    if step.status == Status.WITHIN_GOAL:
        return "within accuracy"
    return "certified" if step.certified else step.status.name


def smooth(step: Step) -> str:
    """Hertz' answer for the smooth body, if a shape was given; begins with a blank."""
    if not (hasattr(step, "smooth_width") and step.contacts):
        return ""
    parts = [f"contact {with_prefix(step.smooth_width, 'm')} wide"]
    parts += [f"approach {with_prefix(step.smooth_approach, 'm')}"] if np.isfinite(step.smooth_approach) else []
    parts += (
        [f"largest pressure {with_prefix(step.smooth_max_pressure, 'Pa')}"] if np.isfinite(step.smooth_max_pressure) else []
    )
    return f" Without roughness (Hertz): {', '.join(parts)}."


def leak(step: Step) -> str:
    """With its proven interval, if it was asked for; begins with a blank."""
    if not hasattr(step, "leak"):
        return ""
    return f" Leak {_power(step.leak)} m³/s ({_power(step.leak_lower)} to {_power(step.leak_upper)})."


def conclusion(content: Content) -> str:
    """What the last step has shown, and how sure its area is."""
    last = content.steps[-1]
    area = next((f" {text}" for text in sentences(content) if text.startswith("Area")), "")
    return _conclusion(content, last) + area + smooth(last) + leak(last)


def _conclusion(content: Content, last: Step) -> str:
    if not last.contacts:
        return f"Load {with_prefix(last.load, 'N')}, no contact."
    line = "" if content.times is None else f"After {last.time:.6g} s: "
    line += "" if last.status in (Status.OK, Status.WITHIN_GOAL) else f"Not certified ({status(last)}): "
    line += f"Contact area {100 * last.area_fraction:.3g} % at {with_prefix(last.load, 'N')}; "
    hardness = content.hardness
    if hardness and last.capped:
        share = 100 * last.capped / last.contacts
        cell = content.surface.pitch[0] * content.surface.pitch[1]
        carried = 100 * last.capped * hardness * cell / last.load
        return (
            line
            + f"{share:.3g} % of the contact is at the hardness of {with_prefix(hardness, 'Pa')} and carries {carried:.3g} % of the load."
        )
    line += f"largest pressure {with_prefix(last.max_pressure, 'Pa')}"
    if hardness:
        return line + f", below the hardness of {with_prefix(hardness, 'Pa')}."
    doubt = elastic_limit(last.max_pressure, content.modulus, "--hardness")
    return line + (f". Warning: {doubt}." if doubt else ".")


def facts(content: Content) -> List[str]:
    """What was pressed and how, when and by what: for the line below the title."""
    loads = [step.load for step in content.steps]
    least, most = with_prefix(min(loads), "N"), with_prefix(max(loads), "N")
    return [
        f"E* {with_prefix(content.modulus, 'Pa')}",
        *([f"hardness {with_prefix(content.hardness, 'Pa')}"] if content.hardness else []),
        f"{content.input['boundary']} boundary",
        f"load {most}" if least == most else f"{len(loads)} loads, {least} to {most}",
        content.date,
        f"roughcontact {content.version}",
    ]


def step_rows(content: Content) -> List[Tuple[str, ...]]:
    """One row a step, below `step_head`."""
    return [
        (
            str(k),
            *([f"{step.time:.6g} s"] if content.times is not None else []),
            with_prefix(step.load, "N", 4),
            with_prefix(step.mean_pressure, "Pa", 4),
            with_prefix(step.approach, "m", 4),
            f"{100 * step.area_fraction:.4g} %",
            f"{100 * content.corrected(step):.4g} %",
            with_prefix(step.mean_gap, "m", 4),
            with_prefix(step.max_pressure, "Pa", 4) + (f" at {step.capped} points" if step.capped > 1 else ""),
            with_prefix(step.stiffness, "N/m", 4),
            str(step.patches),
            status(step),
        )
        for k, step in enumerate(content.steps, 1)
    ]


STEP_HEAD = (
    "step",
    "load",
    "mean pressure",
    "approach",
    "area",
    "corrected area",
    "mean gap",
    "largest pressure",
    "stiffness",
    "patches",
    "status",
)


def step_head(content: Content) -> Tuple[str, ...]:
    return STEP_HEAD if content.times is None else ("step", "after", *STEP_HEAD[1:])


LEAK_HEAD = ("step", "load", "leak", "exact, at this approach", "lowest gap on the best path")


def leak_rows(content: Content) -> List[Tuple[str, ...]]:
    """Below `LEAK_HEAD`; none without a leak."""
    return [
        (
            str(k),
            with_prefix(step.load, "N", 4),
            f"{step.leak:.4g} m³/s",
            f"{step.leak_lower:.6g} to {step.leak_upper:.6g} m³/s" if step.leak_upper else "0, proven",
            with_prefix(step.constriction, "m") if step.constriction else "no path",
        )
        for k, step in enumerate(content.steps, 1)
        if hasattr(step, "leak")
    ]


BUDGET_NAMES = ("load", "approach", "area", "mean_pressure", "stiffness", "mean_gap", "conductance", "leak")


def _quantities(content: Content) -> List[Tuple[str, Dict[str, Any]]]:
    """Those that a budget knows."""
    known = content.budget or {}
    return [(name, known[name]) for name in BUDGET_NAMES if name in known and known[name]["value"] is not None]


def sentences(content: Content) -> List[str]:
    """What dominates each quantity, as the budget says it."""
    return [
        f"{quantity['sentence'][0].upper()}{quantity['sentence'][1:]}.".replace("+-", "±")
        for _, quantity in _quantities(content)
        if quantity["standard"] > 1e-12 * abs(quantity["value"])
    ]


def budget_head(content: Content) -> Tuple[str, ...]:
    return ("source", *(name.replace("_", " ") for name, _ in _quantities(content)))


def budget_rows(content: Content) -> List[Tuple[str, ...]]:
    """A row for each source, the combined uncertainty and the coverage; none without a budget."""
    quantities = [quantity for _, quantity in _quantities(content)]
    if not quantities:
        return []

    def shown(value: Optional[float], quantity: Dict[str, Any]) -> str:
        if value is None:
            return "not known"
        if abs(value) < 1e-9 * abs(quantity["value"]):
            return "0"
        if "^" in quantity["unit"]:
            return f"{value:.2g} {quantity['unit']}"
        return f"{100 * value:.2g} %" if quantity["unit"] == "" else with_prefix(value, quantity["unit"], 2)

    def part(quantity: Dict[str, Any], source: str) -> str:
        found = quantity["contributions"][source]
        shift = f", shift {shown(found['shift'], quantity)}" if abs(found["shift"] or 0) > 1e-9 * abs(quantity["value"]) else ""
        return shown(found["standard"], quantity) + shift

    sources = quantities[0]["contributions"]
    rows = [
        (f"{source} {each['given']}".strip(), *(part(quantity, source) for quantity in quantities))
        for source, each in sources.items()
    ]
    rows.append(("combined", *(shown(quantity["standard"], quantity) for quantity in quantities)))
    return rows + [("coverage", *(f"{quantity['coverage']:.2f}" for quantity in quantities))]


PROOF_HEAD = (
    "step",
    "residual",
    "limit",
    "load, proven",
    "area, proven",
    "points proven in contact, open, undecided",
    "estimated error of load, area",
    "by",
)


def _errors(step: Step) -> str:
    """The errors of a coarser grid, if one was solved for the goal of option accuracy."""
    if step.status != Status.WITHIN_GOAL:
        return "this grid was solved"
    return (
        f"{100 * step.error_estimate:.2g} %, {100 * step.area_estimate:.2g} % ({step.model_nx} × {step.model_ny} points solved)"
    )


def _power(value: float) -> str:
    """ "1.3·10⁻⁸", which no line breaks in two."""
    if not (value > 0 and np.isfinite(value)):
        return f"{value:g}"
    digits, exponent = f"{value:.1e}".split("e")
    return f"{digits}·10{str(int(exponent)).translate(SUPERSCRIPTS)}"


def _interval(least: float, most: float, unit: str) -> str:
    """The middle and the half-width of a proven interval, the middle to the digit that the half-width leaves known."""
    if not np.isfinite([least, most]).all():
        return "not known"
    middle, half = (least + most) / 2, (most - least) / 2
    if unit == "%":
        return f"{middle:.6g} % ± {half:.2g} %"
    return f"{with_prefix(middle, unit, 6)} ± {with_prefix(half, unit, 2)}"


def proof_rows(content: Content) -> List[Tuple[str, ...]]:
    rows: List[Tuple[str, ...]] = []
    cells = content.nominal_area
    for k, r in enumerate(content.steps, 1):
        rows.append(
            (
                str(k),
                _power(r.residual),
                _power(r.tolerance),
                _interval(r.load_lower, r.load_upper, "N"),
                _interval(100 * r.area_lower / cells, 100 * r.area_upper / cells, "%"),
                f"{r.proven_contacts}, {r.proven_open}, {r.undecided}" if r.proven_contacts >= 0 else "not known",
                _errors(r),
                f"{r.solver} on {r.backend}, {r.iterations} iterations",
            )
        )
    return rows


def surface_rows(content: Content) -> Rows:
    surface = content.surface
    rows, columns = surface.shape
    rows_of: List[Tuple[str, str]] = [
        ("points", f"{columns} × {rows}"),
        ("pitch", " × ".join(with_prefix(side, "m", 5) for side in surface.pitch)),
        ("size", f"{with_prefix(columns * surface.pitch[0], 'm', 4)} × {with_prefix(rows * surface.pitch[1], 'm', 4)}"),
        ("boundary", content.input["boundary"]),
        ("missing points", f"{content.input['missing']} of {rows * columns}"),
    ]
    s, law = content.statistics, content.law
    if s is not None:
        rows_of += [
            ("rms height", with_prefix(s.rms_height, "m", 4)),
            ("highest, lowest", f"{with_prefix(s.highest, 'm', 4)}, {with_prefix(s.lowest, 'm', 4)}"),
            ("rms slope", f"{s.rms_slope:.4g} (x {s.rms_slope_x:.4g}, y {s.rms_slope_y:.4g})"),
            ("rms curvature", f"1/({with_prefix(1 / s.rms_curvature, 'm', 4)})" if s.rms_curvature > 0 else "0"),
            ("skewness, kurtosis", f"{s.skewness:.3g}, {s.kurtosis:.3g} (0, 3 for a Gaussian)"),
            ("Nayak's parameter", f"{s.nayak:.3g}"),
        ]
    elif not surface.missing.any() and np.ptp(surface.heights) > 0:
        rows_of.append(("roughness", "needs libroughcontact-surface, in Python's environment: pip install roughcontact-gpl"))
    if law is not None and np.isfinite(law.hurst):
        remark = "" if self_affine(law) else ", not self-affine"
        rows_of.append(("Hurst exponent", f"{law.hurst:.2f} ± {law.hurst_error:.2f}{remark}"))
    for name, q in (("roll-off", law.q_rolloff), ("cut-off", law.q_cutoff)) if law is not None else ():
        if np.isfinite(q):
            rows_of.append((f"{name} wavelength", with_prefix(2 * np.pi / q, "m")))
    return rows_of


def self_affine(law: PowerLaw) -> bool:
    """Whether the Hurst exponent is in 0 .. 1, within its error."""
    return bool(-law.hurst_error < law.hurst < 1 + law.hurst_error)


def _material(words: Dict[str, str]) -> str:
    if "modulus" in words:
        return "the contact modulus was given"
    bodies = [(words.get("E" + which), words.get("nu" + which)) for which in ("", "2")]
    moduli = " and ".join(f"E = {E}, ν = {nu}" for E, nu in bodies if E is not None)
    return moduli + ("" if "E2" in words or "," in words["E"] else "; the other body is rigid")


def assumptions(content: Content) -> List[str]:
    words, missing = content.words, content.input["missing"]
    lines = [f"{text[0].upper()}{text[1:]}." for text in content.input["assumed"]]
    if "unit" in words:
        lines.append(f"Lengths without a unit are in {words['unit']}.")
    if "pitch" in words:
        lines.append(f"The pitch was given: {' × '.join(with_prefix(side, 'm', 5) for side in content.surface.pitch)}.")
    rule = {"fill": "interpolated from their neighbours: contact there is a guess", "exclude": "kept out of contact"}
    lines.append(f"{missing} missing points were {rule[words['missing']]}." if missing else "No point is missing.")
    form = words.get("remove", "none")
    changes = [] if form == "none" else [f"A least-squares {form} was taken off the heights."]
    sentences = {"against": "The heights of {} were added.", "shape": "The shape {} was added."}
    changes += [text.format(words[word]) for word, text in sentences.items() if word in words]
    lines += changes or ["The heights were taken as they are."]
    lines.append(f"Contact modulus E* = {with_prefix(content.modulus, 'Pa', 4)}: {_material(words)}.")
    if content.hardness:
        lines.append(
            f"Elastic up to the hardness of {with_prefix(content.hardness, 'Pa', 4)}; where it acts the overlap is plastic and stays."
        )
    else:
        lines.append("Linear elastic at every pressure; no hardness was given.")
    for word, what in (("creep", "compliance grows"), ("relaxation", "modulus falls")):
        if word in words:
            lines.append(f"The bodies creep: their {what} with time as {words[word]} says, Poisson's ratio stays.")
    layer = f"a layer on it ({words['layer']})" if "layer" in words else "no layers"
    lines.append(f"Small slopes, an elastic half-space, no adhesion, no friction, {layer}.")
    if content.curve:
        lines.append("One target was given; the steps below it were added for the curves.")
    if content.input["boundary"] == "free":
        lines.append("Free boundary: nothing presses beyond the map's edges.")
    elif "boundary" in words:
        lines.append(f"Boundary {words['boundary']}: the map is a sample of a larger surface.")
    return lines


def doubts(content: Content) -> List[str]:
    """What the library remarks and what is not certified, each once."""
    found: List[str] = []
    for k, step in enumerate(content.steps, 1):
        if step.message:
            found.append(f"Step {k}: {step.message}")
        if step.note and step.note not in found:
            found.append(step.note)
    law, last = content.law, content.steps[-1]
    if law is not None and np.isfinite(law.hurst) and not self_affine(law):
        found.append(
            f"The spectrum falls with a Hurst exponent of {law.hurst:.2f}, beyond 0 to 1: the surface is not self-affine, and "
            "theories of self-affine roughness are not of it."
        )
    if content.corrected(last) < 0.9 * last.area_fraction:
        share = 100 * (1 - content.corrected(last) / last.area_fraction)
        found.append(
            f"About {share:.0f} % of the counted contact area are cells that touch in part: a finer grid would show less area."
        )
    return found


def certificate(content: Content) -> str:
    certified = sum(step.certified for step in content.steps)
    within = sum(step.status == Status.WITHIN_GOAL for step in content.steps)
    text = (
        f"{certified} of {len(content.steps)} steps are certified: a fresh product with the influence matrix has shown that every "
        "residual of the conditions of contact (no tension, no overlap, pressure only where the gap is closed, the load) is within "
        "the limit. That is a checked solution, not a calibrated instrument. The intervals hold the exact load and contact area of "
        "this grid at the approach found."
    )
    if within:
        text += f" {within} were solved on a coarser grid, within the goal of option accuracy: their errors are estimates, not proven."
    return text


CITATION = (
    "A. Bemporad, M. Paggi: Optimization algorithms for the solution of the frictionless normal contact between rough surfaces. "
    "International Journal of Solids and Structures 69-70 (2015) 94-105, arXiv:1506.00532"
)
PERSSON = "B. N. J. Persson: Theory of rubber friction and contact mechanics. Journal of Chemical Physics 115 (2001) 3840-3861"
