"""What a report says in words and tables."""

from typing import List, Sequence, Tuple

import numpy as np

from .._status import Status
from .content import Content, Step
from .quantities import with_prefix

Rows = Sequence[Tuple[str, str]]
HARDEST_STEEL, SMALL_STRAIN = 10e9, 0.2  # [Pa], largest pressure over E*; as the command has them


def status(step: Step) -> str:
    if step.result.status == Status.WITHIN_GOAL:
        return "within accuracy"
    return "certified" if step.result.certified else step.result.status.name


def good(step: Step) -> bool:
    return step.result.status in (Status.OK, Status.WITHIN_GOAL)


def conclusion(content: Content) -> str:
    """What the last step has shown."""
    last = content.steps[-1]
    if not last.result.contacts:
        return "Nothing carries pressure."
    line = "" if good(last) else f"Not certified ({status(last)}): "
    line += f"{100 * last.fraction:.3g} % of the area carries {with_prefix(last.result.load, 'N')}; "
    hardness = content.request.hardness
    if hardness and last.result.capped:
        share = 100 * last.result.capped / last.result.contacts
        cell = content.surface.pitch[0] * content.surface.pitch[1]
        carried = 100 * last.result.capped * hardness * cell / last.result.load
        return (
            line
            + f"{share:.3g} % of the contact is at the hardness of {with_prefix(hardness, 'Pa')} and carries {carried:.3g} % of the load."
        )
    line += f"the largest pressure is {with_prefix(last.max_pressure, 'Pa')}"
    if hardness:
        return line + f", below the hardness of {with_prefix(hardness, 'Pa')}."
    if last.max_pressure > HARDEST_STEEL:
        line += ", above the hardness of any steel: most bodies yield there, and this answer is elastic. --hardness bounds it"
    elif last.max_pressure > SMALL_STRAIN * content.request.modulus:
        line += f", {last.max_pressure / content.request.modulus:.2g} E*: strains are large, and the answer is of small ones"
    return line + "."


def step_rows(content: Content) -> List[Tuple[str, ...]]:
    """One row a step, below `STEP_HEAD`."""
    return [
        (
            str(k),
            with_prefix(step.result.load, "N", 4),
            with_prefix(step.result.mean_pressure, "Pa", 4),
            with_prefix(step.result.approach, "m", 4),
            f"{100 * step.fraction:.4g} %",
            f"{100 * step.corrected:.4g} %",
            with_prefix(step.mean_gap, "m", 4),
            with_prefix(step.max_pressure, "Pa", 4),
            with_prefix(step.result.stiffness, "N/m", 4),
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
PROOF_HEAD = (
    "step",
    "residual",
    "limit",
    "load proven between",
    "area proven between",
    "points proven in contact, open, undecided",
    "estimated error of load, area",
    "by",
)


def _errors(step: Step) -> str:
    """Of a coarser grid that was solved for the goal of --accuracy."""
    accuracy = step.result.accuracy
    if step.result.status != Status.WITHIN_GOAL or accuracy is None:
        return "this grid was solved"
    return f"{100 * accuracy.error_estimate:.2g} %, {100 * accuracy.area_estimate:.2g} % ({accuracy.model_nx} × {accuracy.model_ny} points solved)"


def proof_rows(content: Content) -> List[Tuple[str, ...]]:
    rows: List[Tuple[str, ...]] = []
    for k, step in enumerate(content.steps, 1):
        r = step.result
        cells = content.nominal_area
        known = np.isfinite([r.load_lower, r.load_upper]).all()
        rows.append(
            (
                str(k),
                f"{r.residual:.1e}",
                f"{r.tolerance:.1e}",
                f"{with_prefix(r.load_lower, 'N', 6)} and {with_prefix(r.load_upper, 'N', 6)}" if known else "not known",
                (
                    f"{100 * r.area_lower / cells:.4g} % and {100 * r.area_upper / cells:.4g} %"
                    if np.isfinite(r.area_upper)
                    else "not known"
                ),
                f"{r.proven_contacts}, {r.proven_open}, {r.undecided}" if r.proven_contacts >= 0 else "not known",
                _errors(step),
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
        ("boundary", "periodic" if surface.periodic else "free"),
        ("missing points", f"{content.missing} of {rows * columns}"),
    ]
    s, law = content.statistics, content.law
    if s is not None:
        rows_of += [
            ("rms height", with_prefix(s.rms_height, "m", 4)),
            ("highest, lowest", f"{with_prefix(s.highest, 'm', 4)}, {with_prefix(s.lowest, 'm', 4)}"),
            ("rms slope", f"{s.rms_slope:.4g} (x {s.rms_slope_x:.4g}, y {s.rms_slope_y:.4g})"),
            ("rms curvature", with_prefix(s.rms_curvature, "/m", 4)),
            ("skewness, kurtosis", f"{s.skewness:.3g}, {s.kurtosis:.3g} (0, 3 for a Gaussian)"),
            ("Nayak's parameter", f"{s.nayak:.3g}"),
        ]
    if law is not None and np.isfinite(law.hurst):
        rows_of.append(("Hurst exponent", f"{law.hurst:.2f} ± {law.hurst_error:.2f}"))
    for name, q in (("roll-off", law.q_rolloff), ("cut-off", law.q_cutoff)) if law is not None else ():
        if np.isfinite(q):
            rows_of.append((f"{name} wavelength", with_prefix(2 * np.pi / q, "m")))
    return rows_of


def assumptions(content: Content) -> List[str]:
    request, told = content.request, []
    told.append(f"Units: {content.assumed}." if content.assumed else "Units and pitch are those that the file states.")
    if request.pitch is not None:
        told.append(f"The pitch was given: {' × '.join(with_prefix(side, 'm', 5) for side in content.surface.pitch)}.")
    rule = {"fill": "interpolated from their neighbours: contact there is a guess", "exclude": "kept out of contact"}
    told.append(
        f"{content.missing} missing points were {rule[request.missing]}." if content.missing else "No point is missing."
    )
    told.append(
        "The heights were taken as they are."
        if request.remove == "none"
        else f"A least-squares {request.remove} was taken off the heights."
    )
    told.append(f"Contact modulus E* = {with_prefix(request.modulus, 'Pa', 4)}: {request.material}.")
    if request.hardness:
        told.append(
            f"Elastic up to the hardness of {with_prefix(request.hardness, 'Pa', 4)}; where it acts the overlap is plastic and stays."
        )
    else:
        told.append("Linear elastic at every pressure; no hardness was given.")
    told.append("Small slopes, an elastic half-space, no adhesion, no friction, no layers.")
    if request.curve:
        told.append("One target was given; the steps below it were added for the curves.")
    if not content.surface.periodic:
        told.append("Free boundary: nothing presses beyond the map's edges.")
    return told


def doubts(content: Content) -> List[str]:
    """What the library remarks and what is not certified, each once."""
    found: List[str] = []
    for k, step in enumerate(content.steps, 1):
        if step.result.message:
            found.append(f"Step {k}: {step.result.message}")
        note = step.result.note.replace("level them", "level them with --remove plane")
        if note and note not in found:
            found.append(note)
    last = content.steps[-1]
    if last.fraction > 0 and last.corrected < 0.9 * last.fraction:
        share = 100 * (1 - last.corrected / last.fraction)
        found.append(
            f"About {share:.0f} % of the counted contact area are cells that touch in part: a finer grid would show less area."
        )
    return found


def certificate(content: Content) -> str:
    certified = sum(step.result.certified for step in content.steps)
    within = sum(step.result.status == Status.WITHIN_GOAL for step in content.steps)
    told = (
        f"{certified} of {len(content.steps)} steps are certified: a fresh product with the influence matrix has shown that every "
        "residual of the conditions of contact (no tension, no overlap, pressure only where the gap is closed, the load) is within "
        "the limit. The intervals hold the exact load and contact area of this grid at the approach found."
    )
    if within:
        told += (
            f" {within} were solved on a coarser grid, within the goal of --accuracy: their errors are estimates, not proven."
        )
    return told


CITATION = (
    "A. Bemporad, M. Paggi: Optimization algorithms for the solution of the frictionless normal contact between rough surfaces. "
    "International Journal of Solids and Structures 69-70 (2015) 94-105, arXiv:1506.00532"
)
PERSSON = "B. N. J. Persson: Theory of rubber friction and contact mechanics. Journal of Chemical Physics 115 (2001) 3840-3861"
