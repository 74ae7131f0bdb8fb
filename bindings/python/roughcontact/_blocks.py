"""Maps with fewer points, of which it is said what each stands for."""

import math
from typing import Tuple

import numpy as np

from ._arrays import Doubles


def side_of_blocks(shape: Tuple[int, ...], most: int) -> int:
    """Points along the side of the square blocks of which a map has at most `most`."""
    side = max(1, int((math.prod(shape) / most) ** 0.5))
    while math.prod(-(-n // side) for n in shape) > most:
        side += 1
    return side


def _blocks(values: Doubles, side: int, beyond: float) -> Doubles:
    """[rows, columns, points of a block]; the last blocks are filled up with `beyond`."""
    rows, columns = (-(-n // side) for n in values.shape)
    padded = np.full((rows * side, columns * side), beyond)
    padded[: values.shape[0], : values.shape[1]] = values
    found: Doubles = padded.reshape(rows, side, columns, side).transpose(0, 2, 1, 3).reshape(rows, columns, side * side)
    return found


def means(values: Doubles, side: int) -> Doubles:
    """The mean of each block over its points that are not NaN; NaN if all are."""
    blocks = _blocks(values, side, np.nan)
    count = (~np.isnan(blocks)).sum(2)
    found: Doubles = np.where(count > 0, np.nansum(blocks, 2) / np.maximum(count, 1), np.nan)
    return found


def largest(values: Doubles, side: int) -> Doubles:
    found: Doubles = _blocks(values, side, -np.inf).max(2)
    return found
