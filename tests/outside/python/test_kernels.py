"""Kernels that are Python functions of wave numbers."""

import gc

import numpy as np
import pytest

import roughcontact as rc

SHAPE = (24, 32)


def half_space(pitch=0.5e-6):
    return rc.HalfSpace(SHAPE, pitch=pitch, modulus=2e9, boundary="periodic")


def gap(pitch=0.5e-6):
    y, x = np.indices(SHAPE)
    along, across = 2 * np.pi * x / SHAPE[1], 2 * np.pi * y / SHAPE[0]
    return pitch * (2 + np.cos(along) + np.cos(across) + 0.3 * np.cos(5 * along))


def load(kernel, context, **options):
    with rc.Contact(half_space(), options={"kernel": kernel, "tol": 1e-10, **options}, context=context) as contact:
        return contact.solve(undeformed_gap=gap(), approach=0.6e-6)


def test_the_half_space_by_a_function():
    context = rc.Context()
    seen = []

    def symbol(qx, qy):
        seen.append((qx, qy))
        return 2 / np.hypot(qx, qy)

    context.add_kernel("mine", symbol, "the half-space again")
    assert [each.summary for each in rc.kernels(context) if each.name == "mine"] == ["the half-space again"]
    wanted = load("spectral", context)
    for options in ({"backend": "fft"}, {"backend": "dense"}, {"solver": "nnls"}, {"threads": 2, "backend": "fft"}):
        found = load("mine", context, **options)
        assert found.kernel == "mine" and found.status == rc.Status.OK
        assert found.load == pytest.approx(wanted.load, rel=1e-8)
        assert found.load_lower <= wanted.load * (1 + 1e-8) and found.load_upper >= wanted.load * (1 - 1e-8)
    with rc.Contact(half_space(), options={"kernel": "mine", "backend": "fft"}, context=context) as contact:
        del context  # which the kernel outlives
        gc.collect()
        assert contact.solve(undeformed_gap=gap(), approach=0.6e-6).status == rc.Status.OK
    qx, qy = seen[0]
    assert qx.shape == qy.shape == (13, 17)
    assert qx[0, 1] == pytest.approx(2 * np.pi / (32 * 0.5e-6)) and qy[1, 0] == pytest.approx(2 * np.pi / (24 * 0.5e-6))
    assert "mine" not in [each.name for each in rc.kernels()]


def raising(qx, qy):
    raise ValueError("no wave here")


@pytest.mark.parametrize(
    "symbol, error, says",
    [
        (raising, rc.ExternalError, "kernel wrong: ValueError: no wave here"),
        (lambda qx, qy: qx[0], rc.ExternalError, "kernel wrong: ShapeError: the symbol"),
        (lambda qx, qy: "text", rc.ExternalError, "kernel wrong: "),
        (lambda qx, qy: np.full(qx.shape, np.nan), rc.NumericError, 'kernel "wrong": the symbol at wave numbers (1, 0) is nan'),
        (lambda qx, qy: 1 - qx, rc.NumericError, ", must be >= 0 and finite"),
    ],
)
def test_what_goes_wrong_is_told(symbol, error, says):
    context = rc.Context()
    context.add_kernel("wrong", symbol)
    with pytest.raises(error) as caught:
        load("wrong", context)
    assert says in str(caught.value)
    load("spectral", context)
