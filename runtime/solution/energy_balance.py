"""Energy balance of a run, and its approach speeds beside their limits, from state to state."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from hertzwerk.runtime.integrate.step.layout import CONTACT, RELEASED, Layout
from hertzwerk.runtime.model.caller import Fold, Follower
from hertzwerk.runtime.model.per_model import per_model
from hertzwerk.runtime.solution.history import energies_at

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.loop.attempt import Integrator
    from hertzwerk.runtime.model.model import Model
    from hertzwerk.runtime.solution.history import History

EPSILON = float(np.finfo(float).eps)
SMALL = 1e-6  # of the scene's energy scale: least energy that errors are relative to


class Balance:
    """Observer of the energy balance of a run, and of how fast contacts begin where a law limits that.

    The balance, energy - initial energy + dissipated - input, should stay zero. It is measured by the energy that the
    run moves: the largest kinetic energy, energy dissipated or put in, or change of potential energy. The total energy
    is no measure, since the zero of the potential is arbitrary.

    It may be shown attempts as the loop leaves them: those that were not accepted change nothing.

    limits    approach speeds [m/s] by pair (k,)
    """

    def __init__(self, model: Model, limits: np.ndarray) -> None:
        self._model, self._layout = model, self._layout_for(model)
        self._last = np.zeros(self._layout.size)  # what is carried on
        if is_limited(model):
            self._last[self._layout["limit"]] = limits
        self._scale = 0.0  # J, the scene's

    @staticmethod
    def _layout_for(model: Model) -> Layout:
        return carried(model)

    @staticmethod
    def _follower_for(model: Model, integrator: Integrator) -> Follower:
        return balancing(model, integrator)

    def take(self, block: History, fresh: int) -> None:
        """Take the next steps, accepted or not; see `Observer`."""
        self._last = self._followed(block, block.rows[fresh:] if fresh else block.rows)

    def _followed(self, block: History, states: np.ndarray) -> np.ndarray:
        """Return what is carried on after the next states of a block, or after each."""
        self._scale = block.energy_scale
        return self._follower_for(self._model, block.engine)(block.controls, self._last, states)

    @property
    def residual(self) -> float | None:
        """Return the largest error over the largest energy moved; None where something was not finite."""
        measure = max(self._number("moved"), SMALL * self._scale)
        return self._number("error") / measure if self._number("size") < math.inf and measure > 0 else None

    @property
    def unclosed(self) -> float:
        """Return the largest error beyond rounding over the largest energy moved or the scene's energy scale.

        The larger of the two: a run's accuracy is relative to its scales, however little moves. 0 where something was
        not finite, which ends a run by itself.
        """
        measure = max(self._number("moved"), self._scale)
        # of energies that are large because their zero is far, and of sums over steps
        rounding = EPSILON * self._number("row") * self._number("size")
        return max(self._number("error") - rounding, 0.0) / measure if rounding < math.inf and measure > 0 else 0.0

    @property
    def onsets(self) -> tuple[np.ndarray, ...]:
        """By pair (k,): limit [m/s], contacts begun, those that were faster, largest approach speed [m/s]."""
        return tuple(self._last[self._layout[name]] for name in ("limit", "begun", "over", "fastest"))

    def _number(self, name: str) -> float:
        return float(self._last[self._layout[name].start])


def is_limited(model: Model) -> bool:
    """Return whether a law limits the approach speed of a pair."""
    return bool(getattr(model.module, "SPEED_LIMITED", ()))


def limits_of(model: Model, p: np.ndarray) -> np.ndarray:
    """Return the limits [m/s] of approach speeds by pair (k,) at parameters p, infinite for none."""
    limits = np.full(model.k, math.inf)
    if is_limited(model):
        limits[[model.pairs.index(pair) for pair in model.module.SPEED_LIMITED]] = model.evaluate("speed_limits", p)[0]
    return limits


@per_model
def carried(model: Model) -> Layout:
    """Return the layout of what is carried from state to state.

    row: their number; start (4), moved, error, size: energies at the start, largest moved, largest error, largest [J];
    where approach speeds are limited for each pair the limit, whether its contact is open, how many were begun, how
    many faster than the limit, and the largest speed [m/s].
    """
    balance = {"start": 4, "moved": 1, "error": 1, "size": 1} if model.has_ledger else {}
    speeds = ("limit", "open", "begun", "over", "fastest") if is_limited(model) else ()
    return Layout({"row": 1} | balance | dict.fromkeys(speeds, model.k))


@per_model
def balancing(model: Model, integrator: Integrator) -> Fold:
    """Build the function (controls, carried, state) -> carried after one more state, if that was accepted."""
    vectors, layout = integrator.layouts, carried(model)
    controls, state, last = vectors.controls.symbol("controls"), vectors.state.symbol("state"), layout.symbol("carried")
    at, was = vectors.state.split(state), layout.split(last)
    new = {
        name: ca.if_else(at["accepted"], value, was[name])
        for name, value in later(model, at, was, vectors, controls).items()
    }
    return Fold(ca.Function("balancing", [controls, last, state], [layout.join({**was, **new})]))


def later(model: Model, at: dict[str, Any], was: dict[str, Any], vectors: Any, controls: Any) -> dict[str, Any]:
    """Return what of `carried` changes with one more state, as expressions."""
    new = {"row": was["row"] + 1}
    if model.has_ledger:
        energies = energies_at(model, at, vectors.controls.split(controls)["c"])
        start = ca.if_else(was["row"] == 0, energies, was["start"])
        kinetic, potential, dissipated, given = ca.vertsplit(energies - start)
        size = ca.sum1(ca.fabs(energies))
        new |= {
            "start": start,
            "moved": ca.mmax(ca.vertcat(was["moved"], energies[0], *map(ca.fabs, (potential, dissipated, given)))),
            "error": ca.fmax(was["error"], ca.fabs(kinetic + potential + dissipated - given)),
            "size": ca.if_else(size < math.inf, ca.mmax(ca.vertcat(was["size"], ca.fabs(energies))), math.inf),
        }
    if is_limited(model):
        begins, speed = begin(at, was), approach_speed(at)
        new |= {
            "open": is_open(at, was),
            "begun": was["begun"] + begins,
            "over": was["over"] + begins * (speed > was["limit"]),
            "fastest": ca.if_else(begins, ca.fmax(was["fastest"], speed), was["fastest"]),
        }
    return new


def is_open(at: dict[str, Any], was: dict[str, Any]) -> Any:
    """Return whether the contact of each pair goes on: it may be released and touch again."""
    return ca.if_else(at["mode"] == RELEASED, was["open"], at["mode"] == CONTACT)


def begin(at: dict[str, Any], was: dict[str, Any]) -> Any:
    """Return whether a contact of each pair begins."""
    return (at["mode"] == CONTACT) * (1 - was["open"])


def approach_speed(at: dict[str, Any]) -> Any:
    """Return the speed [m/s] at which the surfaces of each pair approach each other."""
    return ca.if_else(at["gap_rate"] >= 0, 0, -at["gap_rate"])
