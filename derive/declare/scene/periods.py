"""Common period of everything in a scene that depends on time.

Time must be the argument of sines and cosines, or turn an angle.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from hertzwerk.derive.declare.effects.couplings import Coupling
from hertzwerk.derive.declare.effects.state_expression import T, as_choice, states_in
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.expressions.algebra.functions import Where

_CIRCULAR = (sp.sin, sp.cos, sp.tan)


def period(scene: Scene) -> Any | None:
    """Common period [s], a function of parameters; None where nothing varies periodically.

    None too where something varies without a period, as inputs do, and where a coupling passes a steady rotation on, at another rate.
    The past of a drive, before its last branch at a time, does not count: a speed that rises and stays is periodic from
    then on. A drive of constant speed is periodic if it turns an angle.
    """
    angles = {freedom.key for freedom in scene.mechanism.freedoms if freedom.kind == "turn"}
    coupled = {key for coupling in scene.all(Coupling) for key in coupling.joints}
    frequencies: list[Any] = []
    if scene.inputs:
        return None
    try:
        for joint, effect in scene.driven.items():
            frequencies += _of_drive(effect.motion, joint in angles - coupled)
        for slot in scene.slots():
            value = as_choice(slot.value)
            if T in states_in(value) and not any(
                slot.where.startswith(f"{drive.where},") for drive in scene.driven.values()
            ):
                frequencies += _of(value)
        common = _common(frequencies)
    except _Aperiodic:
        return None
    return None if common is None else 2 * sp.pi / sp.Abs(common)


class _Aperiodic(Exception):
    """Dependence on time without a common period."""


def _of_drive(motion: Any, turns: bool) -> list[Any]:
    """Frequencies [rad/s] of a motion, including its mean rotation if it `turns` an angle."""
    if motion.order == 0:
        steady, others = _split(_later(motion.law))
    elif motion.order == 1 and not motion.law.has(T):
        steady, others = motion.law, []
    else:
        raise _Aperiodic
    if steady == 0:
        return others
    if not turns:
        raise _Aperiodic
    return [steady, *others]


def _split(expression: Any) -> tuple[Any, list[Any]]:
    """Factor of time in a sum, and the frequencies of its other terms."""
    steady, others = sp.S.Zero, []
    for term in sp.Add.make_args(sp.expand(expression)):
        rate = sp.diff(term, T)
        if rate.has(T):
            others += _of(term)
        else:
            steady += rate
    return steady, others


def _of(expression: Any) -> list[Any]:
    """Frequencies [rad/s] in an expression; raises _Aperiodic for time outside sines and cosines."""
    if not expression.has(T):
        return []
    if isinstance(expression, _CIRCULAR):
        steady, others = _split(expression.args[0])
        return [*([steady] if steady != 0 else []), *others]
    if not expression.args:
        raise _Aperiodic
    return [frequency for part in expression.args for frequency in _of(part)]


def _later(expression: Any) -> Any:
    """Replace branches before and after a time by the later one."""

    def chosen(node: Any) -> Any:
        condition, holds, fails = node.args
        if isinstance(condition, sp.Gt | sp.Ge | sp.Lt | sp.Le):
            less, greater = condition.lts, condition.gts
            if less == T and not greater.has(T):
                return fails
            if greater == T and not less.has(T):
                return holds
        return node

    return sp.sympify(expression).replace(lambda node: isinstance(node, Where), chosen)


def _common(frequencies: list[Any]) -> Any | None:
    """Greatest common divisor of frequencies; None without any, raises _Aperiodic if there is none."""
    if not frequencies:
        return None
    ratios = [sp.simplify(frequency / frequencies[0]) for frequency in frequencies]
    if not all(ratio.is_Rational for ratio in ratios):
        raise _Aperiodic
    return frequencies[0] * sp.gcd_list([abs(ratio) for ratio in ratios])
