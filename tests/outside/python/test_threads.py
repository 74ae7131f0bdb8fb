"""Several Python threads: contacts of their own run side by side, one contact refuses a second user."""

import os
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc
from roughcontact._threads import usable_cores, with_threads


def test_errors_belong_to_their_threads():
    def fail(k):
        with pytest.raises(rc.OptionError, match=f"unknown_{k}"):
            rc.solve(undeformed_gap=np.zeros((4, 4)), pitch=1, modulus=1, approach=1, options={f"unknown_{k}": 1})
        return True

    with ThreadPoolExecutor(4) as pool:
        assert all(pool.map(fail, range(40)))


def test_one_caller_at_a_time(rough):
    """During a history neither its own callback nor another thread may use the contact, but for its points and cancel()."""
    seen, told = [], []

    def busy(words, *calls):
        told.extend(refused(rc.BusyError, words, call).status for call in calls)

    def each(k, result):
        seen.append(contact.points())
        assert np.array_equal(seen[-1][1], result.pressure.ravel()[seen[-1][0]])
        busy("callback belongs to", contact.indentation, contact.close, contact.reset, lambda: contact.solve(approach=1e-8))
        thread = threading.Thread(target=busy, args=("another thread", contact.points, contact.close, contact.reset))
        thread.start()
        thread.join()
        if k == 1:
            other = threading.Thread(target=contact.cancel)
            other.start()
            other.join()

    with rc.Contact(rc.HalfSpace.under(rough, modulus=1e9), tol=1e-12) as contact:
        history = contact.history(rough, approach=[2e-8, 4e-8, 6e-8], each=each, check=False)
        assert history.status == rc.Status.STOP_CANCELLED and len(history.load) == 2
        assert [len(index) for index, _ in seen] == history.contacts.tolist() and told == [rc.Status.ERR_BUSY] * 14
        assert np.array_equal(contact.points()[0], seen[-1][0])


def cores(monkeypatch, number, **variables):
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: set(range(number)))
    for name in ("OMP_THREAD_LIMIT", "OMP_NUM_THREADS"):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)


def test_every_core_is_used_where_it_pays(monkeypatch):
    large = rc.HalfSpace((256, 256), pitch=1, modulus=1, boundary="free")
    cores(monkeypatch, 3)
    for given, expected in (({}, 3), ({"threads": 2}, 2), ({"options": {"threads": 1}}, 1)):
        with rc.Contact(large, **given) as contact:
            assert contact._options["threads"] == expected
    assert with_threads(None, rc.HalfSpace((128, 128), pitch=1, modulus=1, boundary="free")) == {"threads": 1}  # too small
    assert with_threads({"tol": 1}, rc.HalfSpace((512, 512), pitch=1, modulus=1, boundary="free")) == {"threads": 3, "tol": 1}
    assert with_threads(None, rc.Product(lambda p: p, (512, 512), pitch=1)) == {"threads": 1}
    assert with_threads(None, rc.Matrix(np.eye(1024), pitch=1)) == {"threads": 3}
    assert with_threads(None, rc.HalfSpace((8, 8), pitch=1, modulus=1, boundary="free"), 2) == {"threads": 2}
    cores(monkeypatch, 3, OMP_NUM_THREADS="2")
    assert with_threads(None, large) == {"threads": 2}
    cores(monkeypatch, 3, OMP_NUM_THREADS="2", OMP_THREAD_LIMIT="1")
    assert with_threads(None, large) == {"threads": 1}
    rubbish = ("", " ", "0", "-1", "abc", "1.0", "²", "2,x", "2,", ",2", "2 2", "1e0", "0x1", "99999999999999999999")
    for text in ("2,1", " 2 ", "\t2", "2 , 7", "+2", *rubbish):
        cores(monkeypatch, 3, OMP_NUM_THREADS=text)
        assert usable_cores() == (3 if text in rubbish else 2), text


def test_a_contact_keeps_its_threads_when_options_change(monkeypatch):
    cores(monkeypatch, 2)
    with rc.Contact(rc.HalfSpace((128, 128), pitch=1.0, modulus=1.0, boundary="free")) as contact:
        contact.set_options({"tol": 1e-7})
        cores(monkeypatch, 4)
        contact.set_options({"tol": 1e-8})
