"""What several tests press."""

import numpy as np
import pytest

import roughcontact as rc

PITCH, RADIUS, MODULUS = 1e-6, 1e-3, 100e9  # cells of 1 um, a sphere of 1 mm


def refused(kind, words, call, /, *arguments, **named):
    """The exception of this kind, with these words ("": any) in its message, that a call raises."""
    with pytest.raises(kind, match=words) as caught:
        call(*arguments, **named)
    return caught.value


@pytest.fixture
def sphere_gap():
    """[64, 64] distance of a paraboloid to a plane, 0 between the four points in the middle."""
    x = (np.arange(64) - 31.5) * PITCH
    return (x[:, None] ** 2 + x**2) / (2 * RADIUS)


@pytest.fixture
def half_space():
    return rc.HalfSpace((64, 64), pitch=PITCH, modulus=MODULUS, boundary="free")


@pytest.fixture
def rough():
    """A periodic surface that is not square."""
    return rc.surface.spectral((48, 64), pitch=1e-6, rms_height=1e-7, hurst=0.8, seed=3)


@pytest.fixture
def small_matrix():
    """Symmetric positive definite, 12 x 12, its own row a third of the largest sum."""
    i = np.arange(12)
    return 1.0 / (1.0 + np.abs(i[:, None] - i)) + 2.0 * np.eye(12)
