"""Nothing is kept by solving again and again."""

import gc
import os

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc


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
        "path": lambda: rc.history(undeformed_gap=gap, pitch=1.0, modulus=1.0, boundary="free", approach=[1.0], each=lambda k, r: None),
    }


@pytest.mark.parametrize("name", ["solve", "step", "refused", "product", "path"])
def test_memory_is_flat_over_some(name):
    assert grows(calls()[name], 100) < 2 << 20  # twenty times that leaks show in the test of 10000
