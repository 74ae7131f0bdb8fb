"""A contact as a differentiable function of PyTorch, which is to be installed beside this package.

    press = roughcontact.torch.Press(rc.HalfSpace((64, 64), pitch=1e-6, modulus=70e9), control="load")
    pressure, gap, load, approach = press(undeformed_gap, target)
    approach.backward()

Values pass through NumPy on the CPU, in double precision.
"""

from typing import Any, Optional, Sequence, Tuple

import numpy as np
import torch  # type: ignore[import-not-found, unused-ignore]

from . import _press

__all__ = ["Press"]


def __dir__() -> Sequence[str]:
    return __all__


class Press(_press.Press):
    __doc__ = _press.Press.__doc__

    def __call__(self, undeformed_gap: Any, target: Any, modulus: Any = None) -> Tuple[Any, Any, Any, Any]:
        """Tensors (pressures, deformed gap, load, approach) of the type and on the device of undeformed_gap.

        undeformed_gap: tensor of the system's shape [length]; target: number or tensor, approach [length] or load [force]
        modulus: number or tensor, E* [force/length^2]; None: the system's

        Derivatives are first ones: what `backward` computes cannot be differentiated again.
        """
        like = {"dtype": undeformed_gap.dtype, "device": undeformed_gap.device}
        given = [None if each is None else torch.as_tensor(each, **like) for each in (target, modulus)]
        found: Tuple[Any, Any, Any, Any] = _Step.apply(self, undeformed_gap, *given)
        return found


def _number(tensor: Any) -> Optional[float]:
    return None if tensor is None else float(tensor.detach())


def _array(tensor: Any) -> Any:
    return tensor.detach().cpu().double().numpy()


class _Step(torch.autograd.Function):  # type: ignore[misc, unused-ignore]
    @staticmethod
    def forward(ctx: Any, press: Press, gap: Any, target: Any, modulus: Any) -> Tuple[Any, ...]:
        answer = press.solve(_array(gap), _number(target) or 0.0, _number(modulus))
        tensors = tuple(torch.as_tensor(np.asarray(each), dtype=gap.dtype, device=gap.device) for each in answer)
        ctx.press, ctx.has_modulus = press, modulus is not None
        ctx.save_for_backward(gap, target, tensors[0], *([modulus] if ctx.has_modulus else []))
        return tensors

    @staticmethod
    @torch.autograd.function.once_differentiable  # type: ignore[untyped-decorator, unused-ignore]
    def backward(ctx: Any, *by: Any) -> Tuple[Any, ...]:
        gap, target, pressure, *rest = ctx.saved_tensors
        modulus: Any = rest[0] if ctx.has_modulus else None
        cotangents = (_array(by[0]), _array(by[1]), float(by[2]), float(by[3]))
        found = ctx.press.pull_back(_array(gap), float(target), _number(modulus), _array(pressure), cotangents)
        by_gap, by_target, by_modulus = (
            torch.as_tensor(np.asarray(each), dtype=gap.dtype, device=gap.device) for each in found
        )
        return None, by_gap, by_target.reshape(target.shape), by_modulus.reshape(modulus.shape) if ctx.has_modulus else None
