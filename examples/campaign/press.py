"""What a worker does with a chunk of tasks, on one thread: columns with a value for each step. A worker needs this file, NumPy and
roughcontact."""

import dataclasses
import itertools
import json

import numpy as np
import roughcontact as rc

GOOD = ("OK", "WITHIN_GOAL")
ARRAYS = ("load", "approach", "contact_area", "certificate", "iterations", "products", "stiffness")  # of a BatchResult


@dataclasses.dataclass(frozen=True)
class Task:
    """One surface, pressed through one history of loads. key: hash of `asked`, which decides its numbers; work: points times steps."""

    key: str
    asked: dict
    work: int


def surface_of(described):
    described = dict(described)
    if "file" not in described:
        return getattr(rc.surface, described.pop("generator"))(**described)
    surface, missing = rc.read(described["file"]), described.get("missing")
    if missing == "fill":
        surface = surface.filled()
    if missing == "exclude":
        surface = dataclasses.replace(surface, mask=(~surface.missing).astype(np.uint8))
    return surface.without(described["form"]) if "form" in described else surface


def details(result):
    """All numbers and names of a step's `Result`, and its largest pressure."""
    kept = {name: value for name, value in vars(result).items() if isinstance(value, (int, float, str))}
    return {**kept, "max_pressure": float(result.pressure.max())}


def outcome(batch, i, step):
    """What a batch says of a step."""
    arrays = {name: getattr(batch, name) for name in ARRAYS}
    cells = float(np.prod(batch.grid.shape)) * batch.grid.pitch[0] * batch.grid.pitch[1]
    kept = {name: values[i, step].item() for name, values in arrays.items() if values is not None}
    share = {"mean_pressure": kept["load"] / cells, "area_fraction": kept["contact_area"] / cells}
    return {"status": rc.Status(batch.statuses[i, step]).name, "message": "", **kept, **share}


def failure(error):
    status = error.status.name if isinstance(error, rc.RoughContactError) else type(error).__name__
    return {"status": status, "message": str(error)}


def row(task, step, outcome):
    """`task` says all that was asked; what names or numbers a surface has is also in columns of their own."""
    asked = task.asked
    plain = {name: value for name, value in asked["surface"].items() if isinstance(value, (int, float, str))}
    target = {"control": asked["control"], "target": asked["history"][step], "step": step}
    return {"key": task.key, **plain, **target, **outcome, "task": json.dumps(asked, sort_keys=True)}


def how(asked):
    """Keywords that all tasks of a study share."""
    given = {**asked["system"], "options": {**asked["options"], "threads": 1}, "check": False}
    return {**given, "stiffness": asked["options"].get("stiffness", 0) > 0}


def ending(task, surface):
    """The message of a history that a batch could not finish; a batch keeps that of its first contact only."""
    asked = task.asked
    try:
        return rc.history(surface, **{asked["control"]: asked["history"]}, **how(asked)).message
    except rc.RoughContactError as error:
        return str(error)


def pressed(tasks):
    """Rows of tasks whose histories have as many steps."""
    made, surfaces, more, asked = {}, [], {}, tasks[0].asked
    try:
        for task in tasks:
            described = json.dumps(task.asked["surface"])
            if described not in made:
                made[described] = surface_of(task.asked["surface"])
            surfaces.append(made[described])
        batch = rc.batch(
            surfaces,
            **{asked["control"]: [task.asked["history"] for task in tasks]},
            **how(asked),
            each=(lambda i, step, result: more.update({(i, step): details(result)})) if asked["details"] else None,
        )
    except Exception as error:  # the batch is refused: whose fault it is shows when each is alone
        return [each for task in tasks for each in pressed([task])] if len(tasks) > 1 else [row(tasks[0], 0, failure(error))]
    found = []
    for i, task in enumerate(tasks):
        for step in range(len(task.asked["history"])):
            each = {**more.get((i, step), {}), **outcome(batch, i, step)}
            good = each["status"] in GOOD
            found.append(row(task, step, each if good else {**each, "message": ending(task, surfaces[i])}))
            if not good:
                break
    return found


def columns(rows):
    """A row that lacks a name has None there."""
    names = dict.fromkeys(name for each in rows for name in each)
    return {name: [each.get(name) for each in rows] for name in names}


def chunk(tasks):
    """The answers of tasks, with one row for each step; the first step that is not certified is a task's last."""
    version = ".".join(map(str, rc.version()))
    if version != tasks[0].asked["version"]:
        raise RuntimeError(f"a worker has roughcontact {version}, the client {tasks[0].asked['version']}")

    def steps(task):
        return len(task.asked["history"])

    groups = itertools.groupby(sorted(tasks, key=steps), key=steps)
    return columns([each for _, group in groups for each in pressed(list(group))])


def lost(task, error):
    """What stands for a task that ended every process which tried it."""
    return columns([row(task, 0, failure(error))])
