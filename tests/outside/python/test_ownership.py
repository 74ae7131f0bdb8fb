"""Who owns what: handles are not copied, and arrays outlive calls."""

import copy
import pickle

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc
from roughcontact import _library
from roughcontact._arrays import as_doubles


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


def unaligned(array):
    memory = np.frombuffer(bytearray(array.nbytes + 1), np.float64, offset=1, count=array.size).reshape(array.shape)
    memory[...] = array
    return memory


def test_arrays_are_aligned(sphere_gap, small_matrix):
    assert as_doubles(unaligned(sphere_gap), "gap").flags.aligned
    assert rc.Matrix(unaligned(small_matrix), pitch=1).H.flags.aligned


def test_a_batch_of_none_that_is_refused_raises():
    with pytest.raises(rc.OptionError):
        how = {"approach": 1.0, "pitch": 1.0, "modulus": 1.0}
        rc.batch(undeformed_gap=np.zeros((0, 4, 4)), **how, options={"threads": -5}, check=False)
    with pytest.raises(rc.ArgumentError):
        rc.batch(undeformed_gap=np.zeros((0, 4, 4)), approach=1.0, pitch=1.0, modulus=-1.0, check=False)


def test_the_library_of_the_same_prefix_comes_before_the_systems(tmp_path, monkeypatch):
    package = tmp_path / "lib" / "python3" / "dist-packages" / "roughcontact"
    package.mkdir(parents=True)
    library = tmp_path / "lib64" / _library.SONAME
    library.parent.mkdir()
    library.write_bytes(b"")
    (package / "library_folder.txt").write_text("../../../../lib64\n")
    monkeypatch.delenv(_library.VARIABLE, raising=False)
    monkeypatch.setattr(_library, "__file__", str(package / "_library.py"))
    assert [file for file, _ in _library._candidates()] == [str(library), _library.SONAME]


def test_borrowed_masks_are_let_go(half_space, sphere_gap):
    with rc.Contact(half_space) as contact:
        contact.solve(undeformed_gap=sphere_gap, approach=3e-7, borrow=True)
        for _ in range(5):
            contact.solve(mask=np.ones((64, 64), bool), approach=3e-7, borrow=True)
        assert len(contact._borrowed) <= 2 and np.shares_memory(contact._borrowed[0][0], sphere_gap)


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
