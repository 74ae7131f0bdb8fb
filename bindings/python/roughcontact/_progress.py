"""progress=True: bars of the package tqdm."""

import importlib
import threading
import warnings
from contextlib import contextmanager
from typing import Any, Callable, Iterator, Optional


def _tqdm() -> Any:
    """The class of its bars, None where it is not installed."""
    try:
        return importlib.import_module("tqdm.auto").tqdm
    except ImportError:
        warnings.warn("progress=True shows nothing: the package tqdm is not installed", RuntimeWarning)
        return None


class Bars:
    """A bar for each call, on which any thread may say how far it is."""

    def __init__(self) -> None:
        self._bar: Any = None
        self._done: Optional[Callable[[], int]] = None
        self._lock = threading.Lock()

    @contextmanager
    def over(self, unit: str, total: Optional[int] = None, done: Optional[Callable[[], int]] = None) -> Iterator[None]:
        """A bar over the time of a with statement. done: units that are complete; None: the solver's iterations."""
        kind = _tqdm()
        if kind is None:
            yield
            return
        with kind(total=total, unit=" " + unit, leave=True) as bar:
            self._bar, self._done = bar, done
            try:
                yield
                self.show()
            finally:
                self._bar = None

    def show(self, iteration: Optional[int] = None, residual: Optional[float] = None) -> None:
        bar, done = self._bar, iteration if self._done is None else self._done()
        if bar is None:
            return
        with self._lock:
            if residual is not None:
                bar.set_postfix_str(f"residual {residual:.1e}", refresh=False)
            if done is not None:
                bar.update(max(done - bar.n, 0))
