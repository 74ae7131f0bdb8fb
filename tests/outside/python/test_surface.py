"""Generators and judgement of surfaces."""

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc


@pytest.mark.parametrize(
    "name, expected", [("subsample", [[0, 2], [6, 8]]), ("mean", [[2, 3.5], [6.5, 8]]), ("max", [[4, 5], [7, 8]])]
)
def test_downsampling(name, expected):
    heights = np.arange(9.0).reshape(3, 3)
    coarse = rc.surface.downsample(heights, name, pitch=(1.0, 2.0))
    assert np.array_equal(coarse.heights, expected) and coarse.pitch == (2.0, 4.0) and coarse.mask is None
    mask = np.ones((3, 3), bool)
    mask[2, 2] = False
    holes = rc.surface.downsample(heights, name, pitch=1.0, mask=mask)
    assert holes.mask.tolist() == [[1, 1], [1, 0]] and np.isnan(holes.heights[1, 1])
    refused(rc.ArgumentError, "filter", rc.surface.downsample, heights, "median", pitch=1.0)
