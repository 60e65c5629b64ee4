"""Impact laws of rigid bodies, and the impulses or forces of several contacts at one instant.

For each contact the normal part is complementary and friction dissipates most: it holds, or opposes the sliding after the
impact with all that Coulomb's law allows. Glocker, Set-Valued Force Laws (2001); Leine, Nijmeijer, Dynamics and Bifurcations
of Non-Smooth Mechanical Systems (2004), chapter 5.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from hertzwerk.derive.common.faults import Fault, shown, unknown
from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
from hertzwerk.runtime.engine.run.run_request import is_real
from hertzwerk.runtime.system.arrays import Array

RULES = ("newton", "poisson")
SWEEPS = 200_000  # of all contacts, at most
SETTLED = 1e-15  # of the largest impulse: change in a sweep below which it is rounding
SOLVED = 1e-11  # of the largest velocity: residual of the complementarity that counts as rounding


@dataclass(frozen=True)
class RigidImpact:
    """Impact of rigid bodies: a coefficient of restitution and Coulomb friction, at an instant.

    restitution    0..1: a number, or the name of a parameter of the scene
    friction       coefficient of friction, 0 or above: a number, or the name of a parameter
    rule           "newton": the separation speed is restitution times the approach speed (Newton 1687); "poisson": the impulse of
                   expansion is restitution times that of compression (Poisson 1817). They agree without friction for one contact.

    Friction needs the tangents of the pair's own friction effect, whose law must be `coulomb` in space.
    """

    restitution: float | str
    friction: float | str = 0.0
    rule: str = "newton"


@dataclass(frozen=True)
class Contact:
    """A pair as a rigid contact, with the numbers of its impact law.

    n, tangents    its rows: along the normal, and along no, one or two tangents
    mu, e, poisson    coefficient of friction, restitution, and whether that is Poisson's
    least    impulse below which the normal one does not fall (Poisson's expansion)
    slides    direction (tangents,) of a sliding that goes on; None where friction may hold
    """

    pair: str
    n: int
    tangents: list[int]
    mu: float
    e: float = 0.0
    poisson: bool = False
    least: float = 0.0
    slides: Array | None = None


def read_impacts(
    model: EngineModel,
    laws: Mapping[str, object],
    rows: Iterable[tuple[int, list[int]]],
    bound: BoundParameters | None,
    faults: list[Fault],
) -> list[Contact]:
    """Return each pair with its law and its rows; bad input is appended to `faults`."""
    faults += [unknown("contact pair", name, model.pairs) for name in laws if name not in model.pairs]
    missing = [pair for pair in model.pairs if pair not in laws]
    if missing:
        faults.append(Fault("law", f"none for {', '.join(missing)}", "a RigidImpact for every contact pair"))
    contacts = []
    for pair, (n, tangents) in zip(model.pairs, rows, strict=True):
        one = laws.get(pair, RigidImpact(0.0))
        if not isinstance(one, RigidImpact):
            faults.append(Fault(f"law of {pair}", shown(one), "a RigidImpact(restitution, friction)"))
            one = RigidImpact(0.0)
        if one.rule not in RULES:
            faults.append(Fault(f"law of {pair}", f"rule {shown(one.rule)}", f"one of {', '.join(RULES)}"))
        e = _number(model, bound, f"restitution of {pair}", one.restitution, 1.0, faults)
        mu = _number(model, bound, f"friction of {pair}", one.friction, math.inf, faults)
        contacts.append(Contact(pair, n, tangents, mu, e, one.rule == "poisson"))
    lacking = ", ".join(one.pair for one in contacts if one.mu > 0 and not one.tangents)
    if lacking:
        faults.append(Fault(f"friction of {lacking}", "no tangents along which it could act",
                            "pairs with a friction effect: any law in the plane, coulomb in space"))  # fmt: skip
    return contacts


def _number(
    model: EngineModel, bound: BoundParameters | None, where: str, value: object, highest: float, faults: list[Fault]
) -> float:
    """Return a number from 0 to `highest`, or a parameter's value; bad input is appended to `faults`."""
    read: Any = value
    if isinstance(value, str):
        without = [name for name, port in model.parameters.items() if port.unit == "1"]
        if value not in without:
            port = model.parameters.get(value)
            faults.append(unknown(f"{where}: dimensionless parameter", value, without) if port is None else
                          Fault(where, f"{value}, a parameter in {port.unit}", f"one without a unit: {', '.join(without)}"))  # fmt: skip
            return 0.0
        read = 0.0 if bound is None else bound[value]
    if not is_real(read) or not 0 <= read <= highest or math.isinf(read):
        expected = "a number from 0 to 1" if highest == 1 else "a number, 0 or above"
        faults.append(Fault(where, shown(value), f"{expected}, or the name of a parameter"))
        return 0.0
    return float(read)


class NoSolutionError(Exception):
    """Lack of impulses or forces that agree with the law: a pair, and the reason."""

    def __init__(self, pair: str, why: str) -> None:
        super().__init__(why)
        self.pair, self.why = pair, why


def solved(D: Array, b: Array, contacts: Sequence[Contact]) -> Array:
    """Return impulses x (m,) of contacts with velocities D x + b after them; raises NoSolutionError.

    D (m, m) [1/kg or alike] is the inverse inertia along the rows of all contacts, b (m,) the velocities without them, plus
    restitution times the approach speed along normals; x is zero along all other rows. By projected Gauss-Seidel sweeps
    (Moreau 1988; Jourdan, Alart, Jean, Comput. Methods Appl. Mech. Eng. 155 (1998) 31), to rounding.
    """
    x = np.zeros(len(b))
    for one in contacts:
        if one.slides is not None and _pressed(D, one) <= 1e-12 * D[one.n, one.n]:
            raise NoSolutionError(one.pair, "friction raises the normal force on which it depends (Painleve 1895)")
    for _ in range(SWEEPS):
        before = x.copy()
        for one in contacts:
            _relax(D, b, x, one)
        if float(np.max(np.abs(x - before), initial=0.0)) <= SETTLED * float(np.max(np.abs(x), initial=0.0)):
            break
    v, rows = D @ x + b, [row for one in contacts for row in (one.n, *one.tangents)]
    size = max(float(np.max(np.abs(b[rows]), initial=0.0)), 1e-300)
    for one in contacts:
        if _residual(v, x, one, np.diag(D)) > SOLVED * size:
            raise NoSolutionError(one.pair, "no impulses agree with the impact law at all contacts")
    return x


def _pressed(D: Array, one: Contact) -> float:
    """Return how much a newton of normal force opens a contact, with the friction of one that slides."""
    along = 0.0 if one.slides is None else D[one.n, one.tangents] @ one.slides
    return float(D[one.n, one.n] - one.mu * along)


def _relax(D: Array, b: Array, x: Array, one: Contact) -> None:
    """Solve one contact, in place, with the impulses of all others as they are."""
    n, rows = one.n, one.tangents
    x[n] = max(one.least, x[n] - (D[n] @ x + b[n]) / _pressed(D, one))
    most = one.mu * x[n]
    if one.slides is not None:
        x[rows] = -most * one.slides
    elif rows and one.mu:
        v, block = D[rows] @ x + b[rows], D[np.ix_(rows, rows)]
        held = x[rows] - np.linalg.solve(block, v)
        if len(rows) > 1 and 0 < most < np.linalg.norm(held):  # the boundary, by steps towards where sliding opposes it
            held = x[rows] - v / float(np.trace(block))
        size = float(np.linalg.norm(held))
        x[rows] = held if size <= most else held * (most / size)


def _residual(v: Array, x: Array, one: Contact, inverse: Array) -> float:
    """Return by how much a contact misses its law, as a velocity."""
    n, rows = one.n, one.tangents
    normal = abs(min(v[n], (x[n] - one.least) * inverse[n]))
    if not rows or one.slides is not None or not one.mu:
        return float(normal)
    step = x[rows] - v[rows] / inverse[rows].max()
    size, most = float(np.linalg.norm(step)), one.mu * x[n]
    nearest = step if size <= most else step * (most / size)
    return float(max(normal, np.linalg.norm(x[rows] - nearest) * inverse[rows].max()))
