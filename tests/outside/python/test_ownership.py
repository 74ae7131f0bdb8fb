"""Who owns what: handles are not copied, arrays outlive calls, and nothing is kept by solving again and again."""

import copy
import gc
import os
import pickle

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc


def test_what_owns_a_handle_is_not_copied(half_space):
    for owner in (rc.Contact(half_space), rc.Context(plugins=False)):
        for call in (copy.copy, copy.deepcopy, pickle.dumps):
            refused(TypeError, "cannot be copied or pickled", call, owner)


def test_a_product_may_keep_what_it_is_given(small_matrix):
    kept, sums = [], []

    def apply(x):
        kept.append(x)
        sums.append(x.sum())
        return small_matrix @ x

    rc.solve(undeformed_gap=np.linspace(0, 2, 12), approach=1.5, system=rc.Product(apply, 12, pitch=1))
    assert [x.sum() for x in kept] == sums and all(x.base is None or x.base.base is None for x in kept)


@pytest.mark.parametrize("text", ["gp\0x", "gp\ud800"])
def test_text_that_c_would_cut_off_is_refused(text, half_space):
    for options in ({"solver": text}, {text: 1}):
        refused(rc.OptionError, "NUL|surrogate", rc.Contact, half_space, options=options)
    calls = (
        lambda: rc.kernel_coefficients(text, (2, 2), 1.0),
        lambda: rc.supported(text, "fft", half_space),
        lambda: rc.supported("gp", text, half_space),
        lambda: rc.Context("/" + text),
        lambda: rc.direct.cmr(np.zeros((4, 4)), pitch=1.0, modulus=1.0, approach=1.0, levels=1, inner=text),
    )
    for call in calls:
        refused(rc.ArgumentError, "NUL|surrogate", call)


def resident():
    gc.collect()
    with open("/proc/self/statm") as numbers:
        return int(numbers.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def grows(call, times):
    for _ in range(times // 10):
        call()
    before = resident()
    for _ in range(times):
        call()
    return resident() - before


def calls():
    gap = rc.surface.noise((24, 24)).undeformed_gap()
    how = {"pitch": 1.0, "modulus": 1.0, "approach": 1.0}

    contact = rc.Contact(rc.HalfSpace((24, 24), pitch=1.0, modulus=1.0, boundary="free"), progress=lambda p: None)
    H = np.eye(30)
    return {
        "solve": lambda: rc.solve(undeformed_gap=gap, **how, want_gap=True),
        "step": lambda: contact.solve(undeformed_gap=gap, approach=1.0),
        "refused": lambda: refused(rc.OptionError, "", rc.solve, undeformed_gap=gap, **how, options={"unknown": 1}),
        "product": lambda: rc.solve(undeformed_gap=np.ones(30), approach=2.0, system=rc.Product(H.dot, 30, pitch=1)),
        "path": lambda: rc.history(
            undeformed_gap=gap, pitch=1.0, modulus=1.0, boundary="free", approach=[1.0], each=lambda k, r: None
        ),
    }


@pytest.mark.parametrize("name", ["solve", "step", "refused", "product", "path"])
def test_memory_is_flat_over_some(name):
    assert grows(calls()[name], 100) < 2 << 20  # twenty times that leaks show in the test of 10000
