"""What all answers can do: become tables, data sets and files, and show themselves in notebooks."""

import dataclasses
import html
import importlib
import io
import json
import os
from typing import Any, ClassVar, Dict, Optional, Tuple, Type, TypeVar

import numpy as np

from ._device import on_host
from ._errors import ArgumentError
from ._paths import Path, write_file
from ._status import Status

MAPS = ("pressure", "gap")
_STORED: Dict[str, "Type[Stored]"] = {}


class Stored:
    """A dataclass that goes into files of answers under its name."""

    def __init_subclass__(cls) -> None:
        _STORED[cls.__name__] = cls


def needed(package: str, purpose: str) -> Any:
    try:
        return importlib.import_module(package)
    except ImportError:
        raise ImportError(f"{purpose} needs the package {package}, which is not installed") from None


def _plain(value: Any) -> Any:
    if isinstance(value, Status):
        return value.name
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return {field.name: _plain(getattr(value, field.name)) for field in dataclasses.fields(value)}
    if isinstance(value, tuple):
        return tuple(map(_plain, value))
    return value


A = TypeVar("A", bound="Answer")


class Answer(Stored):
    """See `Result`, `HistoryResult`, `BatchResult`.

    steps: names of the axes along which members have one value for each step
    """

    steps: ClassVar[Tuple[str, ...]] = ()

    def _with(self: A, **members: Any) -> A:
        """A copy with other members; dataclasses.replace would set all of them one by one."""
        copy = object.__new__(type(self))
        vars(copy).update(vars(self), **members)
        return copy

    def _counts(self) -> Tuple[int, ...]:
        return ()

    def _fields(self) -> Dict[str, Any]:
        return {field.name: getattr(self, field.name) for field in dataclasses.fields(self)}  # type: ignore[arg-type]

    def to_dict(self) -> Dict[str, Any]:
        """All members under their names; the status by its name, members such as the grid as dictionaries, arrays as they are."""
        return {name: _plain(value) for name, value in self._fields().items()}

    def _columns(self) -> Dict[str, Any]:
        """Members with one value for each step."""
        counts, found = self._counts(), {}
        for name, value in self._fields().items():
            if not counts and isinstance(value, (int, float, str, Status)):
                found[name] = _plain(value)
            elif counts and name not in MAPS and isinstance(value, np.ndarray) and value.ndim <= len(counts):
                values = value[tuple(slice(n) for n in counts[-value.ndim :])]
                found[name] = np.broadcast_to(values, counts)
        return found

    def to_dataframe(self) -> Any:
        """A pandas DataFrame: one row for each step, with its numbers; maps are left out."""
        pandas = needed("pandas", "to_dataframe")
        columns, counts = self._columns(), self._counts()
        if not counts:
            return pandas.DataFrame([columns])
        index = pandas.MultiIndex.from_product([range(n) for n in counts], names=self.steps)
        table = pandas.DataFrame({name: values.reshape(-1) for name, values in columns.items()}, index)
        return table if len(counts) > 1 else table.set_axis(pandas.RangeIndex(counts[0], name=self.steps[0]))

    def to_xarray(self) -> Any:
        """An xarray Dataset: numbers of steps, and maps over x and y, which are the points' coordinates [length]."""
        xarray = needed("xarray", "to_xarray")
        grid = self._fields()["grid"]
        across = ("y", "x")[-len(grid.shape) :]
        places = {axis: np.arange(n) * h for axis, n, h in zip(across[::-1], grid.shape[::-1], grid.pitch)}
        variables: Dict[str, Any] = {}
        attributes: Dict[str, Any] = {}
        for name, value in self._columns().items():
            if self._counts():
                variables[name] = (self.steps, value)
            else:
                attributes[name] = value
        for name, value in self._fields().items():
            if name in MAPS and value is not None:
                variables[name] = (self.steps[: value.ndim - len(across)] + across, on_host(value))
            elif self._counts() and isinstance(value, (int, float, str, Status)):
                attributes[name] = _plain(value)
        if grid.mask is not None:
            variables["mask"] = (across, grid.mask)
        return xarray.Dataset(variables, places, attributes)

    def save(self, file: Path) -> None:
        """Writes the answer to a file of NumPy's (.npz), which `load` reads."""
        arrays: Dict[str, Any] = {}
        text = json.dumps(_packed(self, "", arrays))
        stream = io.BytesIO()
        np.savez_compressed(stream, answer=np.array(text), **arrays)
        write_file(file, stream.getvalue())

    def _rows(self) -> Dict[str, str]:
        """What a notebook shows, in its order."""
        raise NotImplementedError

    def _picture(self) -> Optional[str]:
        """As HTML."""
        raise NotImplementedError

    def _repr_html_(self) -> str:
        lines = "".join(
            f"<tr><th style='text-align:left'>{html.escape(name)}</th><td style='text-align:left'>{html.escape(value)}</td></tr>"
            for name, value in self._rows().items()
        )
        picture = self._picture() or ""
        return f"<div style='display:flex; gap:1em; align-items:center'><table>{lines}</table>{picture}</div>"


def _packed(value: Any, path: str, arrays: Dict[str, Any]) -> Any:
    """value as JSON has it; arrays go into `arrays`."""
    value = on_host(value)
    if isinstance(value, np.ndarray):
        stored = next((name for name, each in arrays.items() if each is value), path)  # once, as the mask of all steps
        arrays[stored] = value
        return {"array": stored}
    if isinstance(value, Status):
        return {"status": int(value)}
    if isinstance(value, Stored):
        members = {
            field.name: _packed(getattr(value, field.name), f"{path}.{field.name}" if path else field.name, arrays)
            for field in dataclasses.fields(value)  # type: ignore[arg-type]
        }
        return {"class": type(value).__name__, "members": members}
    if isinstance(value, tuple):
        return {"tuple": [_packed(each, f"{path}.{k}", arrays) for k, each in enumerate(value)]}
    return value.item() if isinstance(value, np.generic) else value


def _unpacked(value: Any, arrays: Any) -> Any:
    if not isinstance(value, dict):
        return value
    if "array" in value:
        return arrays[value["array"]]
    if "status" in value:
        return Status(value["status"])
    if "tuple" in value:
        return tuple(_unpacked(each, arrays) for each in value["tuple"])
    return _STORED[value["class"]](**{name: _unpacked(each, arrays) for name, each in value["members"].items()})


def load(file: Path) -> Any:
    """Reads an answer that `save` has written: a `Result`, `HistoryResult` or `BatchResult`."""
    with np.load(os.fsdecode(file), allow_pickle=False) as arrays:
        if "answer" not in arrays:
            raise ArgumentError(f"{os.fsdecode(file)} holds no answer of this package")
        try:
            return _unpacked(json.loads(str(arrays["answer"])), arrays)
        except (KeyError, TypeError, ValueError) as error:
            raise ArgumentError(f"{os.fsdecode(file)} holds an answer of another version: {error}") from error
