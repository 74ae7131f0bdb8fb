"""Arrays of CuPy, PyTorch and JAX on a CUDA device; skipped where there is none."""

import os

import numpy as np
import pytest

import roughcontact as rc

PAIR = {"solver": "haar-cuda", "backend": "cuda"}
SIDE = 128


@pytest.fixture(scope="module")
def gap():
    x = np.arange(SIDE) / SIDE
    heights = np.cos(6 * np.pi * x)[:, None] * np.cos(4 * np.pi * x)[None, :] + 0.1 * np.cos(46 * np.pi * x)[None, :]
    return heights.max() - heights


@pytest.fixture(scope="module")
def on_host(gap):
    try:
        return rc.solve(undeformed_gap=gap, **ask())
    except (rc.PluginError, rc.NoSolverError) as refusal:
        pytest.skip(str(refusal))


def ask():
    return dict(pitch=1 / SIDE, modulus=1.0, pressure=0.5, want_gap=True, **PAIR)


def with_cupy(values):
    return pytest.importorskip("cupy").asarray(values), lambda array: array.get()


def with_torch(values):
    torch = pytest.importorskip("torch")
    return torch.asarray(values, device="cuda"), lambda array: array.cpu().numpy()


def with_jax(values):
    os.environ.setdefault("XLA_PYTHON_CLIENT_PREALLOCATE", "false")
    jax = pytest.importorskip("jax")
    jax.config.update("jax_enable_x64", True)
    return jax.numpy.asarray(values, device=jax.devices("gpu")[0]), np.asarray


@pytest.mark.parametrize("arrays", [with_cupy, with_torch, with_jax])
@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_a_package_hands_its_gap_over_and_gets_its_own_arrays(arrays, kind, gap, on_host):
    given, to_host = arrays(gap.astype(kind))
    result = rc.solve(undeformed_gap=given, **ask())
    assert isinstance(result.pressure, type(given)) and isinstance(result.gap, type(given))
    assert str(result.pressure.device) == str(given.device)
    assert result.pressure.dtype == given.dtype and result.contacts > 100
    wanted = on_host if kind is np.float64 else rc.solve(undeformed_gap=gap.astype(kind), **ask())
    np.testing.assert_array_equal(to_host(result.pressure), wanted.pressure.astype(kind))
    np.testing.assert_array_equal(to_host(given), gap.astype(kind))
