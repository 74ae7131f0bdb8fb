"""Backends, solvers, kernels, options and versions."""

import numpy as np
from conftest import refused

import roughcontact as rc


def test_components_are_listed():
    for kind, known in ((rc.backends, {"callback", "dense", "fft"}), (rc.solvers, {"cmr", "haar-cg"}), (rc.kernels, {"love", "spectral"})):
        names = [each.name for each in kind()]
        assert known <= set(names) and names == sorted(names) and all(each.summary for each in kind())
    fft = next(each for each in rc.backends() if each.name == "fft")
    assert "BSD" in fft.license and fft.origin.endswith("rcb_fft.so")
    assert ".".join(map(str, rc.version())) == rc.__version__


def test_options_are_described():
    specs = {spec.key: spec for spec in rc.options()}
    tol, kernel = specs["tol"], specs["kernel"]
    assert (tol.kind, tol.default, tol.fixed) == (float, 1e-8, False) and tol.minimum < tol.default < tol.maximum
    assert (kernel.kind, kernel.default, kernel.fixed, kernel.minimum) == (str, "auto", True, None)
    assert specs["max_iter"].kind is int and specs["accuracy.of"].choices == ("load", "area")
    assert "fft.precision" in specs and all(spec.help for spec in specs.values())
    assert set(rc.effective_options()) == set(specs)
    given = {"tol": "1e-6", "threads": np.int64(3), "bounds": False, "solver": "gp", "time_limit": 2}
    values = rc.effective_options(given)
    assert [values[key] for key in given] == [1e-6, 3, 0, "gp", 2.0]


def test_contexts_of_ones_own(sphere_gap, half_space):
    bare = rc.Context(plugins=False)
    assert [each.name for each in rc.backends(bare)] == ["callback", "dense"]
    refused(rc.NoBackendError, "", rc.Contact, half_space, options={"backend": "fft"}, context=bare)
    with rc.Contact(half_space, options={"backend": "dense"}, context=bare) as contact:
        del bare  # the contact keeps it
        assert contact.solve(undeformed_gap=sphere_gap, approach=1e-7).backend == "dense"
    said = []
    rc.backends(rc.Context("relative", log=lambda level, message: said.append((level, message))))
    assert said and said[0][0] == "warning" and "relative" in said[0][1]
