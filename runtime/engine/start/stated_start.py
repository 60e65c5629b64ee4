"""Start that is closed as its scene states it: one function of the parameters, with nothing to find."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from hertzwerk.runtime.engine.model.caller import Callers
from hertzwerk.runtime.engine.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel


def as_stated(model: EngineModel, bound: BoundParameters) -> tuple[np.ndarray, np.ndarray] | None:
    """Return q (nq,) and u (nu,) as a scene states them; None where they are to be found."""
    stated = _stated(model)
    if stated is None:
        return None
    q, u, closed = stated(bound.p, bound.c)
    return (q, u) if closed[0] else None


@per_model
def _stated(model: EngineModel) -> Callers | None:
    """Build the function (p, c) -> q, u, and whether they are closed; None where more is to be done."""
    module = model.module
    if module.GIVEN is None or module.SEATED or model.quaternions or model.joints is not model:
        return None
    from hertzwerk.runtime.engine.start.assembly import journals, judged  # a tree without journals needs none

    if model.nl and journals(model):
        return None
    p, c = model.symbols("p c", ca.MX)
    q, u = model.function("start")(p)
    closed: Any = ca.sum1(ca.fabs(ca.vertcat(q, u))) < ca.inf
    loops = judged(model, model if journals(model) else None).function
    phi, rate, _, _, size, rate_size = loops(0, q, u, c, model.function("scales")(p)[1])
    closed *= ca.sum1(ca.vertcat(ca.fabs(phi) <= size, ca.fabs(rate) <= rate_size)) == 2 * size.numel()
    return Callers(ca.Function("as_stated", [p, c], [q, u, closed]))
