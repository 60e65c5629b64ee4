"""Set-valued friction: slip and stick as modes of a pair, with the sticking force as a constraint.

A pair with such friction has a slip sigma in m: the sign of its sliding velocity s along its tangent, 0 while it
sticks. The friction force along the tangent is -sigma times the sliding force; of all sticking pairs together it is
the lambda of W lambda = -b, with W = D^T M^-1 D, D the generalised forces per newton and b the sliding accelerations
without lambda. A pair slips while its margin sigma s is positive. It sticks while (h^2 - lambda^2)/(h^2 + lambda^2) is, with h the
largest holding force: smooth where lambda changes its sign, and a ratio, for both forces vanish together where a contact opens.
Near zero it is (h - |lambda|)/h, so that a tolerance of forces is one of the margin, beside their size. Pfeiffer, Glocker,
Multibody Dynamics with Unilateral Contacts (1996), chapters 5 and 8.

A pair that may slide in two directions has two tangents, and vectors of two entries along them for s, lambda and
sigma. The direction of sliding has no value at rest, so sigma has one: at the onset of slip that in which the pair
accelerates, later that of s some steps ago. Its size is a small speed. Friction opposes s with its part along sigma, s', made
sqrt(s'^2 + sigma^2): the direction of s but for rest, and smooth where s' falls through zero, as it does where sliding
ends. It slips while s' is positive; where s has only turned that far, sigma follows.

Resistance to rolling and to drilling is the same with moments [N m] and angular velocities [rad/s] about axes in place of tangents.
What holds together, along the tangents of one pair or about the axes of one effect, is a grip; its name is that of pair or effect.
That of a circular patch has three velocities, of sliding and of its rim by spin, which end together: see `limit_sets`.

The friction of a joint is a grip of no pair, in one direction and always touching. What presses it is a reaction that depends on
it: such frictions, and those of pairs beside loads by reactions, are solved in `fed_friction`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from operator import mul
from typing import Any

import casadi as ca

from hertzwerk.runtime.engine.integration.friction.limit_sets import gauge, opposed, outward, positive, size_of, unit_of
from hertzwerk.runtime.engine.integration.step.contact_classes import BY_MODE, Contacts, masked
from hertzwerk.runtime.engine.integration.step.layout import CONTACT
from hertzwerk.runtime.engine.integration.step.linear_systems import eliminated
from hertzwerk.runtime.engine.integration.step.rounding_errors import time_rounding
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

Parts = Mapping[str, Any]

NO_PAIR = -1  # in the place of a pair: friction of a joint
LANDING = 1e-2  # of the tolerance, in the scene's scales: accuracy of a landing
STICK = 0.0  # slip of a pair that sticks
# of the landing tolerance, ten of the tolerance: size of the slip of a pair with two tangents; where steps are explicit, errors
# across the slip are of the tolerance, and would turn friction near rest if it were smaller
AHEAD = 1000.0
FAR = 10.0  # of that size: speed from which the slip follows the direction of sliding
TURNED = 1e-3  # of that size: least that a slip turns by
ASTRAY = 0.1  # likewise: for which a step is looked at that has no other reason
GROWTH = 10.0  # from rest, of the sliding speed beside that size: most in a step
COURSE = 0.25  # of a margin: most that its rates may leave of its change in a step
HELD = 0.5  # likewise of what sticks: forces d^1 to d^3 leave no more on the whole way to an opening
SEEMS_LOOSE = -0.5  # margin that an error of a step may have made
REDUNDANT = 1e-6  # relative shift of the diagonal that makes W regular: contacts of one body may share one force
REFINEMENTS = 2  # iterations that remove the shift's effect where W is regular
BREAKS = 0.25  # of the landing tolerance: excess of lambda over the holding force at which a pair breaks loose; landings aim at half


@dataclass(frozen=True)
class Grips:
    """Friction quantities along the n tangents of grips at a state; 0 without contact.

    places (n): indices among the slips; groups: indices among the n of each grip's own; along (nf, n): generalised force
    per newton of friction; power (nz, n): rates of z per newton; sliding, holding (n): forces [N], of a grip the same
    along its tangents, of joints their coefficients [1]; velocity (n): sliding velocity [m/s]; drift (n): its rate without any
    generalised acceleration [m/s^2]; across (n, nu): velocity by the speeds; pushing (nf, n): generalised force per unit of
    `sliding`; touching, sticks (n): 1 or 0; slip (n).
    """

    places: list[int]
    groups: list[list[int]]
    along: Any
    power: Any
    sliding: Any
    holding: Any
    velocity: Any
    drift: Any
    across: Any
    pushing: Any
    touching: Any
    sticks: Any
    slip: Any

    @property
    def direction(self) -> Any:
        """Direction (n) of sliding that friction opposes; 0 for pairs that stick."""
        direction = ca.SX(self.slip)
        for group in self.groups:
            if len(group) > 1:
                direction[group] = opposed(_ahead(self.velocity[group], self.slip[group]))
        return direction

    def slipping(self) -> Any:
        """Return the friction forces (n) [N] of the pairs that slide."""
        return -self.direction * self.sliding

    def hold(self, friction: Any, pressing: Any = 1) -> tuple[Any, Any]:
        """Return the margins (n) [1] of grips that stick, and the size (n) [N] of their forces.

        0 for pairs apart. friction (n) [N]; pressing: factor of the holding forces.
        """
        needed, held = ca.fabs(friction), self.holding * pressing
        for group in self.groups:
            if len(group) > 1:
                needed[group] = gauge(friction[group])
        total = self.touching * (held**2 + needed**2)
        return (held**2 - needed**2) * self.touching / positive(total), ca.sqrt(total / 2)

    def turning(self, W: Any) -> Any:
        """Return the fastest rate [1/s] at which a direction of sliding relaxes; 0 where none slides.

        W (n, n) [1/kg]: accelerations by forces along the tangents.
        """
        fastest = ca.SX(0)
        for group in self.groups:
            if len(group) > 1:
                speed = size_of(_ahead(self.velocity[group], self.slip[group]))
                rate = self.sliding[group[0]] * ca.trace(W[group, group]) / positive(speed)
                fastest = ca.fmax(fastest, ca.if_else(speed > 0, rate, 0))
        return fastest

    def pace(self, velocity: Any) -> Any:
        """Return the speeds (n) along their slips of pairs that slide, of velocities (n) or their rates."""
        speeds = self.slip * velocity
        for group in self.groups:
            if len(group) > 1:
                speeds[group] = ca.dot(unit_of(self.slip[group]), velocity[group])
        return speeds


def _ahead(velocity: Any, slip: Any) -> Any:
    """Velocity in two directions that friction opposes, see above."""
    way, size = unit_of(slip), ca.sumsqr(slip)
    along = ca.dot(way, velocity)
    reached = ca.sqrt(positive(along**2 + size))
    return ca.if_else(size > 0, velocity + (reached - along) * way, 0)


def pairs_of(model: EngineModel) -> list[int]:
    """Return the pairs with set-valued friction in the order of their slips, once for each tangent."""
    return [pair for _, _, pair in model.slips]


def grips_of(model: EngineModel) -> list[str]:
    """Return the name of the grip of each slip (ns)."""
    return [name.rpartition(".")[0] for name, *_ in model.slips]


def turns(slip: str) -> bool:
    """Return whether a slip is that of a moment: `rolling.turning_1`."""
    return slip.rpartition(".")[2].startswith("turning")


def rubbing(model: EngineModel) -> list[int]:
    """Return the pairs with set-valued friction, of which sliding has modes."""
    return [pair for name, _, pair in model.slips if not turns(name) and pair != NO_PAIR]


def at_slips(model: EngineModel, of_pairs: Any, of_joints: Any) -> Any:
    """Return a quantity of the pairs (k) for each slip (ns), and of joints another."""
    return ca.vertcat(*(of_joints if j == NO_PAIR else of_pairs[j] for j in pairs_of(model)))


def touching(model: EngineModel, mode: Any) -> Any:
    """Return for each slip (ns) whether its surfaces touch under the pairs' modes (k); those of joints do."""
    return at_slips(model, mode == CONTACT, ca.SX(1))


def groups_of(grips: Sequence[str]) -> list[list[int]]:
    """Return the places of each grip among `grips`, in which it stands once for each of its tangents."""
    return [[i for i, other in enumerate(grips) if other == grip] for grip in dict.fromkeys(grips)]


def slip_tolerances(
    model: EngineModel, run: Parts, m: Any, at: Parts, tol_rate: Any, tol_force: Any
) -> tuple[Any, Any]:
    """Return the tolerances (ns each) of velocities and forces at a landing, from those of pairs (k).

    What sticks holds the forces of all pairs, and is as uncertain as the most uncertain one. Those of turning follow by
    the scene's arm, which turns an angle into a way. No margin is known better than the time.
    """
    turning = [i for i, (name, *_) in enumerate(model.slips) if turns(name)]
    least = LANDING * run["tolerance"] * run["scales"]
    rate = at_slips(model, tol_rate, least[1])
    force = ca.repmat(ca.mmax(tol_force) if model.k else least[2], model.ns)
    if turning:
        fast = next(i for i, name in enumerate(model.speeds) if model.units[name] == "rad/s")
        arm = run["scales"][1] / run["scale"][model.nq + fast]
        rate[turning], force[turning] = rate[turning] / arm, force[turning] * arm
    sticks, timing = sticking(model, m), time_rounding(at["t"], at["margin_rate"])
    return ca.fmax(rate, ca.if_else(sticks, 0, timing)), ca.fmax(
        force, ca.if_else(sticks, timing, 0) * at["grip_force"]
    )


def sticking(model: EngineModel, m: Any) -> Any:
    """Return for each slip (ns) whether it is one of a grip that sticks or is apart."""
    slips = m[slips_in(model)]
    stuck = slips == STICK
    for group in groups_of(grips_of(model)):
        if len(group) > 1:
            still = reduce(mul, (stuck[i] for i in group))
            for i in group:
                stuck[i] = still
    return stuck


def slips_in(model: EngineModel) -> slice:
    """Return the slice of the slips in m."""
    return slice(model.nm - model.ns, model.nm)


def may_slip(model: EngineModel, contacts: Contacts) -> bool:
    """Return whether a pair with set-valued friction is among the contacts of a class."""
    return bool(model.ns) and (contacts is BY_MODE or any(j in contacts or j == NO_PAIR for j in pairs_of(model)))


def grips(model: EngineModel, contacts: Contacts, t: Any, y: Any, mode: Any, m: Any, c: Any) -> Grips:
    """Evaluate the friction quantities (SX) of the pairs in the contacts of a class."""
    columns, slips, stuck = [], m[slips_in(model)], sticking(model, m)
    places = [i for i, j in enumerate(pairs_of(model)) if contacts is BY_MODE or j in contacts or j == NO_PAIR]
    pairs = [pairs_of(model)[i] for i in places]
    for j in dict.fromkeys(pairs):
        own = [i for i, pair in enumerate(pairs_of(model)) if pair == j]
        active = mode[j] == CONTACT if contacts is BY_MODE and j != NO_PAIR else ca.SX(1)
        evaluated = (joint_grips(model) if j == NO_PAIR else pair_grip(model, j)).call([t, y, m, c])
        values = [masked(active, value) for value in evaluated]
        values += [values[0][: model.nu, :].T, values[0]] if j != NO_PAIR else []
        columns.append([*values, ca.repmat(active, len(own)), masked(active, stuck[own]), slips[own]])
    joined = list(zip(*columns, strict=True))
    beside = {0, 1, 7}  # a column for each
    parts = ((ca.horzcat if i in beside else ca.vertcat)(*part) for i, part in enumerate(joined))
    return Grips(places, groups_of([grips_of(model)[i] for i in places]), *parts)


@per_model
def pair_grip(model: EngineModel, j: int) -> Any:
    """Return the function (t, y, m, c) -> fields of `Grips` of one pair.

    In order: along, power, sliding, holding, velocity, drift, each for every tangent.
    """
    t, y, m, c = model.symbols("t y m c")
    q, u, z = model.parts(y)
    velocity, along, power, sliding, holding = pair_grips(model, j, t, q, u, z, m, c)
    dq = model.function("coordinate_rates")(t, q, u, c)
    drift = ca.jtimes(velocity, ca.vertcat(t, y), ca.vertcat(1, dq, ca.SX.zeros(model.nu + model.nz)))
    results = [ca.sparsify(along), ca.sparsify(power), *map(ca.densify, (sliding, holding, velocity, drift))]
    return ca.Function("grip", [t, y, m, c], ca.cse(results))


def pair_grips(model: EngineModel, j: int, *arguments: Any) -> tuple[Any, Any, Any, Any, Any]:
    """Return velocity (n), along (nf, n), power (nz, n), sliding and holding (n) of a pair's n slips.

    arguments: (t, q, u, z, m, c).
    """
    _, _, _, velocity, _, along, power, sliding, holding, *turning = model.function(f"contact_{model.pairs[j]}")(
        *arguments
    )
    velocity = ca.vertcat(*([velocity] if j in rubbing(model) else []), *turning)
    own = [grip for grip, pair in zip(grips_of(model), pairs_of(model), strict=True) if pair == j]
    along, power = (ca.reshape(part, part.numel() // len(own), len(own)) for part in (along, power))
    of = [list(dict.fromkeys(own)).index(grip) for grip in own]
    sliding, holding = (ca.vertcat(*(limit[i] for i in of)) for limit in (sliding, holding))
    return velocity, along, power, sliding, holding


@per_model
def joint_grips(model: EngineModel) -> Any:
    """Return the function (t, y, m, c) -> fields of `Grips` of the frictions of joints.

    With across and pushing. Their work is the ledger's, which has what presses them.
    """
    t, y, m, c, reactions = model.symbols("t y m c reactions")
    q, u, _ = model.parts(y)
    nf, n = model.function("applied").numel_out(0), len(model.rubbing)
    velocity, _, kinetic, static = model.function("rubbing")(t, q, u, ca.SX.zeros(reactions.shape), c)
    dq = model.function("coordinate_rates")(t, q, u, c)
    drift = ca.jtimes(velocity, ca.vertcat(t, q), ca.vertcat(1, dq))
    along, pushing = ca.SX(nf, n), ca.SX(nf, n)
    for i, (_, coefficient, holding, _) in enumerate(model.rubbing):
        along[holding, i] = pushing[coefficient, i] = 1
    limits = map(ca.densify, (kinetic, static, velocity, drift))
    results = [along, ca.SX(model.nz, n), *limits, ca.sparsify(ca.jacobian(velocity, u)), pushing]
    return ca.Function("joint_grips", [t, y, m, c], ca.cse(results))


@per_model
def forces(model: EngineModel, n: int) -> Any:
    """Return the CasADi function of the friction forces lambda (n) [N] along the tangents.

    Arguments: t, q, u, f, along, drift, slipping (n), sticks (n), c. f: all other generalised forces; slipping: the
    forces of the slipping pairs along the tangents.
    """
    t, q, u, f, c = model.symbols("t q u f c")
    along = ca.SX.sym("along", f.numel(), n)
    drift, slipping, sticks = (ca.SX.sym(name, n) for name in ("drift", "slipping", "sticks"))
    slides = ca.if_else(sticks, 0, slipping)
    a = model.function("accelerations").call([t, q, u, f + ca.mtimes(along, slides), c])[0]
    W = ca.mtimes(along[: model.nu, :].T, mobility(model, t, q, u, along, c))
    held = solve_sticking(W, sticks, -(drift + ca.mtimes(along[: model.nu, :].T, a)))
    arguments = [t, q, u, f, along, drift, slipping, sticks, c]
    return ca.Function("friction", arguments, [ca.cse(ca.if_else(sticks, held, slides))])


def mobility(model: EngineModel, t: Any, q: Any, u: Any, along: Any, c: Any) -> Any:
    """Return the changes (nu, n) of the speeds by a unit impulse along each tangent."""
    f = ca.SX.sym("f", along.shape[0])
    a = model.function("unloaded" if model.fed else "accelerations").call([t, q, u, f, c])[0]
    return ca.substitute(ca.jtimes(a, f, along), f, ca.SX.zeros(f.numel()))


def solve_sticking(W: Any, sticks: Any, right: Any) -> Any:
    """Solve W lambda = right for the sticking pairs; 0 for the others.

    Where W is singular the result is (nearly) that of least norm.
    """
    n = W.shape[0]
    right = ca.if_else(sticks, right, 0)
    both = [[sticks[i] * sticks[j] for j in range(n)] for i in range(n)]
    coupled = [[ca.if_else(both[i][j], W[i, j], 0) for j in range(n)] for i in range(n)]
    share = REDUNDANT if n > 1 else 0.0
    # friction without effect on any motion, and a pair that does not stick, have a zero diagonal and a zero right-hand side
    diagonal = [ca.if_else(coupled[i][i] > 0, (1 + share) * coupled[i][i], 1) for i in range(n)]
    regular = [[diagonal[i] if i == j else coupled[i][j] for j in range(n)] for i in range(n)]
    solve = eliminated(regular, pivoting=False)
    solution = ca.vertcat(*solve([right[i] for i in range(n)]))
    for _ in range(REFINEMENTS if n > 1 else 0):
        residual = [right[i] - sum((coupled[i][j] * solution[j] for j in range(n)), start=ca.SX(0)) for i in range(n)]
        solution = solution + ca.vertcat(*solve(residual))
    return solution


# -- modes and events --------------------------------------------------------------------------------------------------


def margin_tolerances(model: EngineModel, run: Parts, m: Any, at: Parts, tol_rate: Any, tol_force: Any) -> Any:
    """Return each margin's tolerance (ns) at a landing: a speed if slipping, a ratio if sticking."""
    rate, force = slip_tolerances(model, run, m, at, tol_rate, tol_force)
    return ca.if_else(sticking(model, m), force / positive(at["grip_force"]), rate)


def turned(model: EngineModel, m: Any, friction: Any, margin: Any) -> Any:
    """Turn slips in two directions to those of sliding, but near rest; return m and if one turned.

    Margins are speeds along slips: they are evaluated anew where one turned.
    """
    m, first, some = ca.SX(m), slips_in(model).start, ca.SX(0)
    for group in directed(model):
        rows = [first + i for i in group]
        follows, way = _follows(m[rows], friction[group], margin[group[0]], TURNED)
        m[rows] = ca.if_else(follows, way, m[rows])
        some = ca.fmax(some, follows)
    return m, some


def _follows(slip: Any, friction: Any, margin: Any, least: float) -> tuple[Any, Any]:
    """Return whether a slip in two directions turns, by a share of its size, and what it turns to."""
    size = size_of(slip)
    way = size * outward(-friction)
    follows = (size > 0) * (margin > FAR * size) * (ca.sumsqr(friction) > 0)
    return follows * (ca.mmax(ca.fabs(way - slip)) > least * size), way


def undecided_and_breaking(
    model: EngineModel, mode: Any, m: Any, margin: Any, margin_rate: Any, small: Any, was: Any
) -> tuple[Any, Any]:
    """Return which pairs (n) have an undecided direction of sliding, and which sticking pairs break loose.

    Undecided are pairs in contact that came to rest or that were in another mode (`was`) before. Both follow from
    margins and rates as reached, with the tolerances `small`.
    """
    touches, fresh = touching(model, mode), 1 - touching(model, was)
    sticks = sticking(model, m)
    rests = (margin < -small) + (margin <= small) * (margin_rate < 0) > 0
    undecided = touches * (fresh + (1 - sticks) * rests > 0)
    return undecided, touches * (1 - fresh) * sticks * (margin < -BREAKS * small)


def directed(model: EngineModel) -> list[list[int]]:
    """Return the places of each grip among the slips that may slide in two directions, or more."""
    return [group for group in groups_of(grips_of(model)) if len(group) > 1]


def unresolved_grips(model: EngineModel, run: Parts, start: Parts, end: Parts, h: Any) -> Any:
    """Return how badly a step of h [s] resolves margins; above 1 it has to be shorter.

    Sliding in two directions turns the faster the slower it is. An implicit step from rest takes that rate for all of its course, and
    sees no error in a direction that does not turn; an explicit one beyond its stability can repeat a state. The growth of the speed
    beside the size of the slip shows the one, its change the other.
    """
    slips, m0, m1 = start["m"][slips_in(model)], start["margin"], end["margin"]
    error = ca.fabs(m1 - m0 - h / 2 * (start["margin_rate"] + end["margin_rate"]))
    least = time_rounding(end["t"], ca.fabs(start["margin_rate"]) + ca.fabs(end["margin_rate"]))
    worst = ca.mmax(_unresolved_hold(model, run, start, end, h))
    for group in directed(model):
        i, size = group[0], ca.sqrt(ca.sumsqr(slips[group]))
        growth = (m1[i] + size) / (GROWTH * (ca.fmax(m0[i], 0) + size) + least[i])
        course = error[i] / (COURSE * (ca.fmax(ca.fabs(m0[i]), ca.fabs(m1[i])) + size) + least[i])
        worst = ca.fmax(worst, ca.if_else(size > 0, ca.fmax(growth, course), 0))
    return worst


def _unresolved_hold(model: EngineModel, run: Parts, start: Parts, end: Parts, h: Any) -> Any:
    """Return the same for the margins (ns) of what sticks, 0 for all others.

    What sticks has not let go in between where its change is that of its rates. A margin is a ratio, and falls the steeper the nearer a
    contact is to its opening; with the size of its forces it is as smooth as they are. The holding force of a pair changes as its normal
    force does, that of a joint is taken to stay. Where both forces are below their tolerance the ratio is one of rounding. At the end it
    may seem to have let go, though not by as much as it holds.
    """
    of_pairs = at_slips(model, ca.DM.ones(model.k), 0)
    small = [ca.repmat(LANDING * run["tolerance"] * run["scales"][i], model.k) for i in (1, 2)]
    largest = positive(ca.fmax(start["grip_force"], end["grip_force"]))
    values, rates, known = [], [], []
    for side in (start, end):
        margin, rate = side["margin"], side["margin_rate"]
        fading = at_slips(model, side["force_rate"] / positive(side["force"]), 0)
        share = ca.if_else(of_pairs, side["grip_force"] / largest, 1)
        values.append(share * margin)
        rates.append(share * ca.if_else(of_pairs, fading * margin + rate * (2 + margin) / (2 * (1 + margin)), rate))
        known.append(margin_tolerances(model, run, start["m"], side, *small))
    error = ca.fabs(values[1] - values[0] - h / 2 * (rates[0] + rates[1]))
    least = HELD * ca.fmax(*map(ca.fabs, values)) + ca.fmin(*known)
    held = sticking(model, start["m"]) * (start["margin"] > 0) * (end["margin"] > SEEMS_LOOSE) * (ca.fmax(*known) < 1)
    return ca.if_else(held, error / (least + time_rounding(end["t"], ca.fabs(rates[0]) + ca.fabs(rates[1]))), 0)


def margins_ahead(model: EngineModel, mode: Any, m: Any, end: Parts, time: Any) -> Any:
    """Return which margins (ns) stay positive for a time [s] after a step.

    They go on as at its end; 1 for pairs apart. That of a pair that sticks falls the steeper the nearer its contact is to its opening: it may not.
    """
    ahead = (end["margin"] > 0) * (end["margin"] + time * end["margin_rate"] > 0)
    of_pairs = ca.DM([pair != NO_PAIR for pair in pairs_of(model)])
    return ca.if_else(touching(model, mode), ahead * (1 - of_pairs * sticking(model, m)), 1)


def margins_positive(model: EngineModel, mode: Any, start: Parts, end: Parts) -> Any:
    """Return 1 if no margin comes near zero in a step, and no slip in two directions has turned far.

    Near rest, where none follows, friction is as far off as the slip's direction is.
    """
    touches, clear, slips = touching(model, mode), ca.SX(1), start["m"][slips_in(model)]
    for group in directed(model):
        clear *= 1 - _follows(slips[group], end["friction"][group], end["margin"][group[0]], ASTRAY)[0]
    for coefficient in margins(start, end):
        clear *= ca.mmin(ca.if_else(touches, coefficient > 0, 1))
    return clear


def margins(start: Parts, end: Parts) -> list[Any]:
    """Return the Bernstein coefficients of the cubics through the margins over a step."""
    h, f, f1 = start["h"], start["margin"], end["margin"]
    return [f, f + h * start["margin_rate"] / 3, f1 - h * end["margin_rate"] / 3, f1]
