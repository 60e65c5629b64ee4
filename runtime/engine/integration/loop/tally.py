"""Tally of a run from state to state: its energy balance, and contacts faster than their law allows.

The loop keeps it beside the attempts, since every outcome needs it. A state that is counted twice, as an attempt that was
not accepted leaves the state before it, changes nothing.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.runtime.engine.integration.step.layout import CONTACT, RELEASED, Layout, layouts
from hertzwerk.runtime.engine.model.caller import Callers
from hertzwerk.runtime.engine.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import EngineModel

APPROACHES = "open", "begun", "over", "fastest"  # of each pair, where approach speeds are limited


@dataclass(frozen=True)
class Tally:
    """CasADi functions of a model's tally.

    layout   start (4): energies at the first state, kinetic, potential, dissipated, put in; moved, error, size: largest
             energy moved, largest error of the balance, largest energy [J], where a ledger is booked. Of each pair, where
             approach speeds are limited: open, whether its contact goes on; begun, contacts; over, those faster than the
             limit; fastest, the largest approach speed [m/s]
    first    (state, controls) -> tally of a first state
    add      (tally, state, controls) -> tally with one more state
    """

    layout: Layout
    first: Callers
    add: Any


@per_model
def tally(model: EngineModel) -> Tally:
    """Build the tally of a model."""
    vectors, balance, pairs = layouts(model), ("moved", "error", "size"), APPROACHES
    sizes = {"start": 4} | dict.fromkeys(balance, 1) if model.has_ledger else {}
    layout = Layout(sizes | dict.fromkeys(pairs, len(model.speed_limited) and model.k))
    known, (state, controls) = (
        layout.symbol("tally"),
        (vectors.state.symbol("state"), vectors.controls.symbol("controls")),
    )
    at, was, limits = vectors.state.split(state), layout.split(known), vectors.controls.split(controls)["speed_limits"]
    after = {**was, **_balance(model, at, was), **_approaches(at, was, limits)}
    add = ca.Function(
        "tally", [known, state, controls], [layout.join(after)], ["tally", "state", "controls"], ["after"]
    )
    nothing = {name: ca.SX.zeros(size) for name, size in layout.sizes.items()}
    start = {"start": _energies(model, at)} if model.has_ledger else {}
    first = ca.Function("tallied", [state, controls], [add(layout.join({**nothing, **start}), state, controls)])
    return Tally(layout, Callers(first), add)


def _energies(model: EngineModel, at: dict[str, Any]) -> Any:
    """Return the energies (4) of a state as booked [J]: kinetic, potential, dissipated, put in."""
    z = at["y"][model.nq + model.nu :]
    booked = (
        ca.sum1(z[[i for i, name in enumerate(model.memory) if name.endswith(end)]])
        for end in (".dissipated", ".input")
    )
    return ca.densify(ca.vertcat(at["kinetic"], at["potential"], *booked))


def _balance(model: EngineModel, at: dict[str, Any], was: dict[str, Any]) -> dict[str, Any]:
    """Return the energy balance with one more state."""
    if not model.has_ledger:
        return {}
    energies = _energies(model, at)
    kinetic, potential, dissipated, supplied = ca.vertsplit(energies - was["start"])
    size = ca.sum1(ca.fabs(energies))
    return {
        "moved": ca.mmax(ca.vertcat(was["moved"], energies[0], *map(ca.fabs, (potential, dissipated, supplied)))),
        "error": ca.fmax(was["error"], ca.fabs(kinetic + potential + dissipated - supplied)),
        "size": ca.if_else(size < math.inf, ca.mmax(ca.vertcat(was["size"], ca.fabs(energies))), math.inf),
    }


def _approaches(at: dict[str, Any], was: dict[str, Any], limits: Any) -> dict[str, Any]:
    """Return how fast contacts began, with one more state."""
    if not limits.numel():
        return {}
    begins, speed = begin(at, was), approach_speed(at)
    return {
        "open": is_open(at, was),
        "begun": was["begun"] + begins,
        "over": was["over"] + begins * (speed > limits),
        "fastest": ca.if_else(begins, ca.fmax(was["fastest"], speed), was["fastest"]),
    }


def is_open(at: dict[str, Any], was: dict[str, Any]) -> Any:
    """Return whether the contact of each pair goes on: it may be released and touch again."""
    return ca.if_else(at["mode"] == RELEASED, was["open"], at["mode"] == CONTACT)


def begin(at: dict[str, Any], was: dict[str, Any]) -> Any:
    """Return whether a contact of each pair begins."""
    return (at["mode"] == CONTACT) * (1 - was["open"])


def approach_speed(at: dict[str, Any]) -> Any:
    """Return the speed [m/s] at which the surfaces of each pair approach each other."""
    return ca.if_else(at["gap_rate"] >= 0, 0, -at["gap_rate"])
