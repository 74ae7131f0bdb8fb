"""A contact as a differentiable function of JAX, which is to be installed beside this package.

    press = roughcontact.jax.Press(rc.HalfSpace((64, 64), pitch=1e-6, modulus=70e9), control="load")
    approach = lambda undeformed_gap, target: press(undeformed_gap, target)[3]
    slope = jax.grad(approach)(undeformed_gap, target)

It works below jit, grad and vmap (one after the other). Values pass through NumPy on the host in double precision, and come back
in the type of the undeformed gap: enable jax_enable_x64 to keep all digits.
"""

from typing import Any, Optional, Sequence, Tuple

import jax  # type: ignore[import-not-found, unused-ignore]
import jax.numpy as jnp  # type: ignore[import-not-found, unused-ignore]
import numpy as np

from . import _press

__all__ = ["Press"]


def __dir__() -> Sequence[str]:
    return __all__


class Press(_press.Press):
    __doc__ = _press.Press.__doc__

    def __init__(self, *arguments: Any, **named: Any) -> None:
        super().__init__(*arguments, **named)
        self._step = _differentiable(self)

    def __call__(self, undeformed_gap: Any, target: Any, modulus: Any = None) -> Tuple[Any, Any, Any, Any]:
        """Arrays (pressures, deformed gap, load, approach) of the type of undeformed_gap.

        undeformed_gap: of the system's shape [length]; target: approach [length] or load [force]
        modulus: E* [force/length^2]; None: the system's
        """
        gap = jnp.asarray(undeformed_gap)
        if not jnp.issubdtype(gap.dtype, jnp.floating):
            gap = gap.astype(float)
        numbers = [None if each is None else jnp.asarray(each, gap.dtype) for each in (target, modulus)]
        found: Tuple[Any, Any, Any, Any] = self._step(gap, *numbers)
        return found


def _number(value: Any) -> Optional[float]:
    return None if value is None else float(value)


def _double(value: Any) -> Any:
    return np.asarray(value, np.float64)


def _shapes(gap: Any) -> Tuple[Any, Any]:
    """The shapes of a field and of a number."""
    describe: Any = jax.ShapeDtypeStruct
    return describe(gap.shape, gap.dtype), describe((), gap.dtype)


def _differentiable(press: Press) -> Any:
    def solve(gap: Any, target: Any, modulus: Any) -> Tuple[Any, ...]:
        def call(gap: Any, target: Any, modulus: Any) -> Tuple[Any, ...]:
            answer = press.solve(_double(gap), float(target), _number(modulus))
            return tuple(np.asarray(each, gap.dtype) for each in answer)

        field, number = _shapes(gap)
        shapes = (field, field, number, number)
        found: Tuple[Any, ...] = jax.pure_callback(call, shapes, gap, target, modulus, vmap_method="sequential")
        return found

    def forward(gap: Any, target: Any, modulus: Any) -> Tuple[Any, Any]:
        answer = solve(gap, target, modulus)
        return answer, (gap, target, modulus, answer[0])

    def backward(kept: Any, by: Any) -> Tuple[Any, Any, Any]:
        def call(gap: Any, target: Any, modulus: Any, pressure: Any, by: Any) -> Tuple[Any, ...]:
            cotangents = (_double(by[0]), _double(by[1]), float(by[2]), float(by[3]))
            found = press.pull_back(_double(gap), float(target), _number(modulus), _double(pressure), cotangents)
            return tuple(np.asarray(each, gap.dtype) for each in found)

        gap, _, modulus, _ = kept
        field, number = _shapes(gap)
        by_gap, by_target, by_modulus = jax.pure_callback(call, (field, number, number), *kept, by, vmap_method="sequential")
        return by_gap, by_target, None if modulus is None else by_modulus

    step = jax.custom_vjp(solve)
    step.defvjp(forward, backward)
    return step
