"""A study's file, and the tasks that it asks for."""

import hashlib
import inspect
import itertools
import json
import math
import pathlib
import tomllib

import numpy as np
import press
import roughcontact as rc

CONTROLS = ("pressure", "load", "approach")
SYSTEM = ("modulus", "E", "nu", "boundary", "hardness")
KINDS = {str: "a text", bool: "true or false", list: "a list", dict: "a table"}


class StudyError(Exception):
    """The file does not describe a study."""


def tasks(file):
    """(tasks, folder of the store, text of the file)."""
    path = pathlib.Path(file)
    text = path.read_text(encoding="utf-8")
    try:
        study = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise StudyError(f"{path}: {error}") from None
    study = {"details": False, "options": {}, **study}
    _known(
        study, {"store": str, "details": bool, "surfaces": list, "system": dict, "loads": dict, "options": dict}, "the study"
    )
    _known(study["system"], dict.fromkeys(SYSTEM, object), "system", needed=False)
    for name in ("threads", "time_limit"):
        if name in study["options"]:
            raise StudyError(
                f"options.{name} is of no use: a task has one thread, and its numbers are not to depend on the time"
            )
    control, histories = _histories(study["loads"])
    shared = {name: study[name] for name in ("system", "options", "details")}
    shared["version"] = ".".join(map(str, rc.version()))
    found = {}
    for family in study["surfaces"]:
        surfaces = list(_surfaces(family, path.parent))
        _try(surfaces[0][0], control, study["system"], study["options"])
        for surface, points in surfaces:
            for history in histories:
                asked = {"surface": surface, "control": control, "history": history, **shared}
                key = hashlib.sha256(json.dumps(asked, sort_keys=True).encode()).hexdigest()[:32]
                found[key] = press.Task(key, asked, points * len(history))
    return list(found.values()), path.parent / study["store"], text


def _known(table, kinds, where, needed=True):
    """Refuses names that mean nothing, values of another kind, and tables that lack a name."""
    for name in table:
        if name not in kinds:
            raise StudyError(f"{name} is unknown in {where}; {', '.join(kinds)} are known")
    for name, kind in kinds.items():
        if needed and name not in table:
            raise StudyError(f"{where} has no {name}")
        if name in table and not isinstance(table[name], kind):
            raise StudyError(f"{name} of {where} is {table[name]!r}: {KINDS[kind]} is needed")


def _histories(loads):
    _known(loads, dict.fromkeys(CONTROLS, list), "loads", needed=False)
    if len(loads) != 1:
        raise StudyError(f"loads needs exactly one of {', '.join(CONTROLS)}")
    ((control, values),) = loads.items()
    histories = [each if isinstance(each, list) else [each] for each in values]
    if not histories or not all(history and all(type(value) in (int, float) for value in history) for history in histories):
        raise StudyError(f"{control} of loads is {values}: numbers are needed, or lists of numbers")
    return control, [[float(value) for value in history] for history in histories]


def _surfaces(family, folder):
    """(description, points) of every surface of a family."""
    if "files" in family:
        _known(family, {"files": str, "form": str, "missing": str}, "surfaces", needed=False)
        files = sorted(folder.glob(family["files"]))
        if not files:
            raise StudyError(f"no file is named {folder / family['files']}")
        if family.get("missing", "reject") not in ("reject", "exclude", "fill"):
            raise StudyError(f"missing of surfaces is {family['missing']!r}: reject, exclude or fill")
        how = {name: family[name] for name in ("form", "missing") if name in family}
        for file in files:
            contents = hashlib.sha256(file.read_bytes()).hexdigest()[:32]
            yield {"file": str(file.resolve()), "contents": contents, **how}, rc.read(file).heights.size
        return
    arguments = dict(family)
    generator, axes, seeds = (arguments.pop(name, none) for name, none in (("generator", ""), ("vary", {}), ("seeds", None)))
    if generator not in rc.surface.__all__ or not inspect.isfunction(getattr(rc.surface, generator)):
        raise StudyError(f"generator of surfaces is {generator!r}: a function of roughcontact.surface, or files, is needed")
    if seeds is not None:
        axes = {**axes, "seed": list(range(1, seeds + 1)) if isinstance(seeds, int) else seeds}
    for name, values in axes.items():
        if not isinstance(values, list) or not values:
            raise StudyError(f"{name} of surfaces varies over {values!r}: a list of values is needed")
    for values in itertools.product(*axes.values()):
        each = {**arguments, **dict(zip(axes, values))}
        yield {"generator": generator, **each}, _points(each)


def _points(arguments):
    if "shape" not in arguments:
        return 4 ** arguments.get("stage", arguments.get("levels", 0))
    shape = arguments["shape"]
    return shape if isinstance(shape, int) else math.prod(shape)


def _try(surface, control, system, options):
    """Raises what the library has against the first surface, the system or the options, before there are thousands of tasks. No
    contact is solved."""
    try:
        made = press.surface_of(surface)
        boundary = system.get("boundary", "periodic" if made.periodic else None)
        none = np.empty((0, *made.shape))
        rc.batch(none, pitch=made.pitch, **{**system, "boundary": boundary}, **{control: 0.0}, options=options)
    except (TypeError, ValueError) as error:
        raise StudyError(str(error)) from error


def chunks(todo, workers, most_work=200 * 128**2):
    """Lists of consecutive tasks: about a second of work, so that sending them costs little, and several for each worker."""
    share = sum(task.work for task in todo) / (8 * workers)
    chunk, work = [], 0
    for task in todo:
        if chunk and work + task.work > min(share, most_work):
            yield chunk
            chunk, work = [], 0
        chunk.append(task)
        work += task.work
    if chunk:
        yield chunk
