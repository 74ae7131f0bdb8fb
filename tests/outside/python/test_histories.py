"""Paths and batches: against single steps, what they keep, how they end."""

import threading

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc


def test_path_ends_early(rough):
    how = {"modulus": 1e9, "approach": [2e-8, 4e-8, 6e-8]}
    caught = refused(rc.NotCertifiedError, "", rc.history, rough, **how, each=lambda k, result: k == 1)
    assert caught.status == rc.Status.STOP_CANCELLED and caught.result.completed == 2
    assert rc.history(rough, **how, each=lambda k, result: k == 0, check=False).load.shape == (1,)


def test_path_that_fails_keeps_what_was_done(rough):
    with pytest.raises(rc.InfeasibleError, match="step 2") as caught:
        rc.history(rough, modulus=1e9, approach=[2e-8, 4e-8, 1.0, 6e-8], keep_pressure=True)
    done = caught.value.result
    assert done.completed == 2 and done.pressure.shape == (2, *rough.shape) and len(done.targets) == 4
    refused(rc.ArgumentError, "2 axes", rc.history, rough, modulus=1e9, approach=[[1e-8]])


def surfaces(n):
    return [rc.surface.spectral((32, 32), pitch=1e-6, rms_height=1e-7, seed=k) for k in range(n)]


def test_batch_shares_surfaces_histories_and_masks():
    each = surfaces(3)
    gaps = np.stack([s.undeformed_gap() for s in each])
    how = {"pitch": 1e-6, "modulus": 1e9, "boundary": "periodic"}
    by_surfaces = rc.batch(each, modulus=1e9, load=[1e-4, 1e-3])
    assert np.array_equal(by_surfaces.load, rc.batch(undeformed_gap=gaps, load=[1e-4, 1e-3], **how).load)
    stacked = rc.batch(np.stack([s.heights for s in each]), load=[1e-4, 1e-3], **how)
    assert np.array_equal(by_surfaces.approach, stacked.approach)  # every surface touches at 0
    assert rc.batch(undeformed_gap=gaps, load=1e-3, **how).load.shape == (3, 1)
    one = rc.batch(undeformed_gap=gaps[0], load=[[1e-4], [1e-3]], **how)
    assert one.load.shape == (2, 1) and one.approach[0, 0] == by_surfaces.approach[0, 0]
    mask = np.ones((32, 32), bool)
    mask[:, 16:] = False
    shared = rc.batch(undeformed_gap=gaps, load=1e-3, mask=mask, keep_pressure=True, **how)
    own = rc.batch(undeformed_gap=gaps, load=1e-3, mask=np.stack([mask] * 3), keep_pressure=True, **how)
    assert shared.pressure[..., 16:].max() == 0 and np.array_equal(shared.pressure, own.pressure)
    how.update(undeformed_gap=gaps, approach=1e-7, options={"solver": "gp"})
    cold = rc.batch(keep_pressure=True, **how)
    assert rc.batch(start=cold.pressure, **how).iterations.sum() < cold.iterations.sum() / 2


def test_batch_goes_on_after_a_failure():
    each = surfaces(3)
    approaches = [[5e-8], [1.0], [5e-8]]
    caught = refused(rc.InfeasibleError, "", rc.batch, each, modulus=1e9, approach=approaches)
    answer = caught.result
    assert list(answer.statuses[:, 0]) == [0, rc.Status.ERR_INFEASIBLE, 0] and answer.first == 1
    assert np.isnan(answer.load[1, 0]) and answer.load[2, 0] > 0 and answer.products[1, 0] == -1
    assert rc.batch(each, modulus=1e9, approach=approaches, check=False).status == rc.Status.ERR_INFEASIBLE


def test_batch_that_is_refused():
    caught = refused(rc.ArgumentError, "", rc.batch, surfaces(2), modulus=-1.0, approach=1e-8)
    assert caught.result is None
    with pytest.raises(rc.ShapeError, match="numbers of contacts differ"):
        rc.batch(surfaces(2), modulus=1e9, approach=[[1e-8], [1e-8], [1e-8]])
    refused(rc.ShapeError, "differ in shape or pitch", rc.batch, surfaces(1) + [rc.surface.noise((8, 8))], modulus=1e9, load=1)
    with pytest.raises(rc.ShapeError, match="undeformed_gap have 4 x 3 points"):
        rc.batch(undeformed_gap=np.zeros((2, 3, 4)), system=rc.HalfSpace((5, 4), pitch=1, modulus=1, boundary="free"), load=1)


def test_a_batch_of_none_that_is_refused_raises():
    none = {"undeformed_gap": np.zeros((0, 4, 4)), "approach": 1.0, "pitch": 1.0, "check": False}
    refused(rc.OptionError, "", rc.batch, **none, modulus=1.0, options={"threads": -5})
    refused(rc.ArgumentError, "", rc.batch, **none, modulus=-1.0)
    beyond = np.vstack([np.zeros((1, 16)), np.full((3, 16), np.nan)]).reshape(4, 4, 4)  # what an empty stack must not read
    for stack in ({"heights": beyond[1:1]}, {"undeformed_gap": beyond[1:1], "mask": np.zeros((4, 4), bool)}):
        assert rc.batch(**stack, pitch=1.0, modulus=1.0, boundary="free", load=1.0, check=False).load.shape == (0, 1)


def test_batch_shows_every_step():
    seen, threads = {}, set()

    def each(contact, step, result):
        seen[contact, step] = result.load, result.load_lower <= result.load <= result.load_upper
        threads.add(threading.get_ident())

    answer = rc.batch(surfaces(4), modulus=1e9, load=[1e-4, 1e-3], each=each, options={"threads": 2})
    assert {key: load for key, (load, _) in seen.items()} == {(i, k): answer.load[i, k] for i in range(4) for k in range(2)}
    assert all(bounded for _, bounded in seen.values())
    stopped = rc.batch(surfaces(4), modulus=1e9, load=1e-3, each=lambda i, k, r: i == 1, check=False)
    assert stopped.status == rc.Status.STOP_CANCELLED and stopped.statuses[0, 0] == 0 and stopped.statuses[3, 0] == 103
