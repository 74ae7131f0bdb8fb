"""Whole numbers reach C as they are, or are refused: none loses its high bits or its fraction on the way."""

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc

GAP = np.zeros((4, 4))
HOW = {"pitch": 1.0, "modulus": 1.0}
CASES = {
    "levels": lambda: rc.surface.rmd(2**32 + 8),
    "stage": lambda: rc.surface.rmd(8, stage=2**32 + 8),
    "a side of the shape": lambda: rc.surface.spectral((-(2**64) + 512, 512)),
    "seed": lambda: rc.surface.noise((4, 4), seed=2**64 + 1),
    "seed below zero": lambda: rc.surface.spectral((4, 4), seed=-1),
    "levels of advice": lambda: rc.surface.cmr_advice(rc.surface.noise((8, 8)), 2**32 + 1),
    "bins": lambda: rc.analysis.histogram(GAP, bins=-(2**64) + 200000, pitch=1.0),
    "a side": lambda: rc.HalfSpace((2**64 + 4, 4), **HOW),
    "a fraction": lambda: rc.HalfSpace((2.7, 3.2), **HOW),
    "text": lambda: rc.HalfSpace("44", **HOW),
    "every": lambda: rc.Contact(rc.HalfSpace((4, 4), **HOW), every=2**64 + 1),
    "every of one call": lambda: rc.solve(undeformed_gap=GAP, approach=1.0, every=1.5, **HOW),
    "max_iter": lambda: rc.direct.nnls(np.eye(2), np.ones(2), max_iter=2**64 + 1),
    "levels of the cascade": lambda: rc.direct.cmr(GAP, approach=1.0, levels=2**64 + 2, **HOW),
    "sides of coefficients": lambda: rc.kernel_coefficients("love", 2**64 + 2, 1.0),
}


@pytest.mark.parametrize("case", CASES)
def test_what_does_not_fit_is_refused(case):
    refused(rc.ArgumentError, "whole number is needed|the library takes", CASES[case])
