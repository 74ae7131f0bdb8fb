"""progress=True: a bar over the iterations of a step, the steps of a path, the steps of a batch."""

import io
import sys
import types

import pytest

import roughcontact as rc

PRESS = {"modulus": 1e9, "solver": "gp"}


class Bar:
    """What the package does with a bar of tqdm."""

    made = []

    def __init__(self, total, unit, leave):
        self.total, self.unit, self.n, self.seen, self.open, self.said = total, unit, 0, [], True, ""
        Bar.made.append(self)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.open = False

    def update(self, by):
        assert self.open
        self.n += by
        self.seen.append(self.n)

    def set_postfix_str(self, text, refresh):
        self.said = text


@pytest.fixture
def bars(monkeypatch):
    monkeypatch.setattr(Bar, "made", [])
    monkeypatch.setitem(sys.modules, "tqdm.auto", types.SimpleNamespace(tqdm=Bar))
    return Bar.made


def test_bars_count_iterations_and_steps(rough, bars):
    """Of a step iterations, of a history and of all contacts of a batch steps; a contact shows a bar for each call."""
    found = rc.solve(rough, **PRESS, load=1e-4, progress=True)
    (bar,) = bars
    assert not bar.open and bar.total is None and bar.unit == " iterations" and 0 < bar.n <= found.iterations
    assert bar.said.startswith("residual ") and bar.seen == sorted(bar.seen)
    loads = {"modulus": 1e9, "load": [1e-4, 2e-4, 3e-4]}
    rc.history(rough, **loads, progress=True)
    assert (bars[-1].total, bars[-1].n, bars[-1].unit, bars[-1].open) == (3, 3, " steps", False) and {1, 2, 3} <= set(
        bars[-1].seen
    )
    for threads in (1, 2):
        rc.batch([rough, rough], **loads, threads=threads, progress=True)
        assert (bars[-1].total, bars[-1].n) == (6, 6)
    rc.batch([rough], modulus=1e9, load=1e-4)
    assert len(bars) == 4
    with rc.Contact(rc.HalfSpace.under(rough, modulus=1e9), progress=True, solver="gp") as contact:
        contact.solve(rough, load=1e-4)
        contact.history(load=[2e-4, 3e-4])
        contact.certify(contact.solve(load=1e-4).pressure, load=1e-4)
    assert [bar.total for bar in bars[4:]] == [None, 2, None] and not any(bar.open for bar in bars)


def test_without_tqdm_a_warning_says_so(rough, monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    with pytest.warns(RuntimeWarning, match="tqdm is not installed"):
        assert rc.solve(rough, **PRESS, load=1e-4, progress=True).certified
    rc.solve(rough, **PRESS, load=1e-4, progress=False)


def test_the_bars_of_tqdm(rough, monkeypatch):
    pytest.importorskip("tqdm")
    shown = io.StringIO()
    monkeypatch.setattr(sys, "stderr", shown)
    rc.history(rough, modulus=1e9, load=[1e-4, 2e-4], progress=True)
    assert "2/2" in shown.getvalue() and "residual" in shown.getvalue()
