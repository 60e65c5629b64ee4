"""One step of a Rosenbrock method or of a diagonally implicit Runge-Kutta method.

Both solve with I - h gamma J only, J the exact Jacobian of the right-hand side at the start of the step; the latter
by simplified Newton iterations. They take the same state and give the same trial as an explicit step. Hairer, Wanner,
Solving Ordinary Differential Equations II, 2nd ed. (1996), IV.7 and IV.8.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from itertools import accumulate
from typing import Any

import casadi as ca

from hertzwerk.runtime.engine.integration.step.contact_classes import (
    BY_MODE,
    Contacts,
    active_contacts,
    contact_classes,
    masked,
)
from hertzwerk.runtime.engine.integration.step.explicit_step import ARGUMENTS, MEAN_OF, Flow, calls_parts, flow
from hertzwerk.runtime.engine.integration.step.fed_friction import booked, solved
from hertzwerk.runtime.engine.integration.step.layout import CONTACT
from hertzwerk.runtime.engine.integration.step.linear_systems import Elimination, solver, solver_of_calls
from hertzwerk.runtime.engine.integration.step.rounding_errors import EPS
from hertzwerk.runtime.engine.integration.step.set_valued_friction import (
    Grips,
    directed,
    forces,
    grips,
    may_slip,
    rubbing,
    solve_sticking,
)
from hertzwerk.runtime.engine.integration.step.step_size_control import SAFETY
from hertzwerk.runtime.engine.integration.tableaux.implicit_tableaux import ITERATIONS, DiagonallyImplicit, Rosenbrock
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

CONVERGED = 0.05  # of the tolerance: iteration error allowed in a stage
ROUNDING = 1e-3  # of that: smaller changes need not contract
# last digits of a state: nor need those of this size contract where friction turns with the last digits of a slow sliding velocity
LAST_DIGITS = 2 * EPS
BACKWARD = 1e-9  # largest relative residual of a row; more means that elimination amplified rounding (random systems of 5 to 40: below 1e-12)
DIVERGED = 1e4  # error norm of a step whose iterations did not converge: it is retried with the largest reduction
FORESEEN = 0.1  # of a sliding velocity's rate: smaller changes count as none
SINGULAR = 1e300  # derivatives that are larger, or nan, count as zero

Parts = Mapping[str, Any]


LARGE = 2000  # instructions of the right-hand sides of all classes beyond which steps call them: in every stage they take long to build and compile


@per_model
def uses_calls(model: EngineModel) -> bool:
    """Return whether steps call functions instead of inlining them; pays off for large models."""
    if calls_parts(model):
        return True
    return bool(sum(flow(model, contacts).rates.n_instructions() for contacts in contact_classes(model)) > LARGE)


def linearised(model: EngineModel, contacts: Contacts = BY_MODE) -> Any:
    """Return the function (t, y, mode, m, c) -> derivatives J (ny, ny) and dt (ny) of the right-hand side.

    The right-hand side is `explicit_step.flow` of the same contacts. The chain rule is applied contact by contact, so that
    singular derivatives stay where they arise: at zero penetration, or without contact, the derivative of a root in a
    contact's force is nan; the force and its true derivative vanish there.
    """
    whole = may_slip(model, contacts) or not uses_calls(model)
    return (_linearised if whole else _linearised_by_calls)(model, contacts)


@per_model
def _linearised_by_calls(model: EngineModel, contacts: Contacts) -> Any:
    """Build the function `linearised` (MX) from functions shared by all classes of attempts."""
    t, y, mode, m, c = arguments = model.symbols(ARGUMENTS, ca.MX)
    f, df = _applied_derivatives(model)(t, y, c)
    dz = ca.DM(model.nz, y.numel() + 1)
    for j, pair in enumerate(model.pairs):
        if contacts is BY_MODE or j in contacts:
            active = mode[j] == CONTACT if contacts is BY_MODE else 1
            f_j, df_j, dz_j = _contact_derivatives(model, pair)(t, y, m, c, active)
            f, df, dz = f + f_j, df + df_j, dz + dz_j
    direct, mobility = _motion_derivatives(model)(t, y, f, c)
    J = direct + ca.mtimes(mobility, df) + ca.vertcat(ca.DM(model.nq + model.nu, y.numel() + 1), dz)
    n = y.numel()
    return ca.Function("linearised", arguments, [J[:, :n], ca.densify(J[:, n])], ARGUMENTS.split(), ["J", "dt"])


@per_model
def _applied_derivatives(model: EngineModel) -> Any:
    """Build the CasADi function (t, y, c) -> applied forces and their derivatives by (y, t)."""
    t, y, c = model.symbols("t y c")
    q, u, _ = model.parts(y)
    f = model.function("applied")(t, q, u, c)
    return ca.Function("of_applied", [t, y, c], ca.cse([f, ca.jacobian(f, ca.vertcat(y, t))]))


@per_model
def _contact_derivatives(model: EngineModel, pair: str) -> Any:
    """Build the function (t, y, m, c, active) -> force of a pair and derivatives by (y, t).

    The derivatives are those of the force and of the rates of z; all are 0 unless active.
    """
    t, y, m, c = model.symbols("t y m c")
    q, u, z = model.parts(y)
    f, dz, *_ = model.function(f"contact_{pair}")(t, q, u, z, m, c)
    x = ca.vertcat(y, t)
    # as in `_motion_derivatives` without a search for common parts, which finds one in nine
    one = ca.Function("of_pair", [t, y, m, c], [f, ca.jacobian(f, x), ca.jacobian(dz, x)])
    arguments, active = model.symbols("t y m c", ca.MX), ca.MX.sym("active")
    force, *derivatives = one(*arguments)
    finite = [_finite(each, active) for each in derivatives]
    return ca.Function("of_contact", [*arguments, active], [ca.if_else(active, force, 0), *finite])


@per_model
def _motion_derivatives(model: EngineModel) -> Any:
    """Build the function (t, y, f, c) -> derivatives of the right-hand side by (y, t) and by forces f."""
    t, y, f, c = model.symbols("t y f c")
    q, u, _ = model.parts(y)
    a, reactions, *multipliers = model.function("accelerations").call([t, q, u, f, c])
    power = model.function("ledger")(t, q, u, reactions, c) if model.has_ledger else ca.SX(model.nz, 1)
    dq, x = model.coordinate_rates(t, q, u, f, c), ca.vertcat(y, t)
    if model.has_function("balance"):  # nothing is driven: no reactions
        by_x, by_f = _implicit_derivatives(model, t, q, u, c, x, f, a, *multipliers)
        by_x = ca.vertcat(ca.jacobian(dq, x), by_x, ca.jacobian(power, x))
        by_f = ca.vertcat(ca.jacobian(dq, f), by_f, ca.SX(model.nz, f.numel()))
        return ca.Function("of_motion", [t, y, f, c], [by_x, by_f])
    dy = ca.vertcat(dq, a, power)
    # without a search for common parts: it finds one in sixty and takes five times as long as the derivatives
    return ca.Function("of_motion", [t, y, f, c], [ca.jacobian(dy, x), ca.jacobian(dy, f)])


def _implicit_derivatives(
    model: EngineModel, t: Any, q: Any, u: Any, c: Any, x: Any, f: Any, a: Any, multipliers: Any
) -> tuple[Any, Any]:
    """Differentiate the accelerations by x and f implicitly, from the equations that they solve.

    With K = [[M, G^T], [G, 0]], K (a, -multipliers) = (f - bias, -bias of G). The inverse of K is symmetric, so the
    derivatives of the multipliers by f are, up to sign, those of the accelerations by the loops' second derivatives.
    """
    solved = ca.vertcat(a, multipliers)
    known = ca.SX.sym("known", solved.numel())
    residual = ca.vertcat(
        *model.function("balance").call([t, q, u, *ca.vertsplit(known, [0, model.nu, known.numel()]), c])
    )
    by_x = ca.Function("residual_by_x", [x, known, c], [ca.jacobian(residual, x)])(x, solved, c)
    by_f = ca.jacobian(solved, f)
    mobility, reactions = by_f[: model.nu, :], by_f[model.nu :, :]
    return ca.mtimes(ca.horzcat(-mobility, reactions.T), by_x), mobility


@per_model
def _linearised(model: EngineModel, contacts: Contacts) -> Any:
    t, y, mode, m, c = arguments = model.symbols(ARGUMENTS)
    q, u, z = model.parts(y)
    x = ca.vertcat(y, t)
    f = model.function("applied")(t, q, u, c)
    df, dz = ca.jacobian(f, x), ca.SX(model.nz, x.numel())
    for _, contact, active in active_contacts(model, contacts, mode):
        f_j, dz_j, *_ = contact(t, q, u, z, m, c)
        f += masked(active, f_j)
        df += _masked_finite(ca.jacobian(f_j, x), active)
        dz += _masked_finite(ca.jacobian(dz_j, x), active)
    quantities, derivatives, sticks, n = [f], [df], ca.SX(0, 1), 0
    if may_slip(model, contacts):
        grip = grips(model, contacts, t, y, mode, m, c)
        shapes = [grip.along.sparsity(), grip.power.sparsity()]
        quantities += [_nonzeros(grip.along), _nonzeros(grip.power), grip.drift, grip.slipping()]
        derivatives += [_masked_finite(ca.jacobian(value, x), ca.SX(1)) for value in quantities[1:]]
        sticks, n = grip.sticks, len(grip.places)
    if model.fed and n:
        return _linearised_fed(model, grip, f, df, dz, arguments)
    if n and uses_calls(model):
        return _linearised_with_friction(model, grip, quantities, derivatives, dz, arguments)
    known = [ca.SX.sym("known", value.numel()) for value in quantities]
    symbols = ca.SX.sym("sticks", sticks.numel())
    force, *grip_symbols = known
    dq = model.coordinate_rates(t, q, u, force, c)
    power = ca.SX(model.nz, 1)
    if grip_symbols:
        along, rates, drift, slipping = grip_symbols
        along, rates = (ca.SX(shape, part) for shape, part in zip(shapes, (along, rates), strict=True))
        friction = forces(model, n)(t, q, u, force, along, drift, slipping, symbols, c)
        force, power = force + ca.mtimes(along, friction), ca.mtimes(rates, friction)
    a, reactions, *_ = model.function("accelerations").call([t, q, u, force, c])
    if model.has_ledger:
        power += model.function("ledger")(t, q, u, reactions, c)
    dy, inner = ca.vertcat(dq, a, power), ca.vertcat(*known)
    of_inner = ca.Function("of_inner", [x, inner, symbols, c], [ca.jacobian(dy, x), ca.jacobian(dy, inner)])
    n, parts, outer = y.numel(), [ca.vertcat(*quantities), ca.vertcat(*derivatives), sticks, dz], arguments
    if uses_calls(model):  # matrices are multiplied by a loop, not entry by entry
        parts_of = ca.Function("of_forces", arguments, ca.cse(parts))
        outer = model.symbols(ARGUMENTS, ca.MX)
        parts, x, c = parts_of.call(outer), ca.vertcat(outer[1], outer[0]), outer[4]
    values, of_values, sticks, dz = parts
    direct, mobility = of_inner(x, values, sticks, c)
    J = direct + ca.mtimes(mobility, of_values) + ca.vertcat(ca.DM(model.nq + model.nu, n + 1), dz)
    J = J if uses_calls(model) else ca.sparsify(J)
    results = ca.cse([J[:, :n], ca.densify(J[:, n])])
    return ca.Function("linearised", outer, results, ARGUMENTS.split(), ["J", "dt"])


def _linearised_with_friction(
    model: EngineModel, grip: Grips, quantities: list[Any], derivatives: list[Any], dz: Any, arguments: list[Any]
) -> Any:
    """Build `linearised` of a large model; quantities: forces and grips, and their derivatives by (y, t).

    What sticks follows from the equations that it solves, not from their written out solution: with the tangential
    accelerations r, 0 = dr + W dfriction, column by column.
    """
    t, y, _, _, c = arguments
    (q, u, _), x, n = model.parts(y), ca.vertcat(y, t), len(grip.places)
    force, *parts, drift, _ = known = [ca.SX.sym("known", value.numel()) for value in quantities]
    along, rates = (ca.SX(of.sparsity(), part) for of, part in zip((grip.along, grip.power), parts, strict=True))
    friction = ca.SX.sym("friction", n)
    a, reactions, *_ = model.function("accelerations").call([t, q, u, force + ca.mtimes(along, friction), c])
    power = ca.mtimes(rates, friction)
    if model.has_ledger:
        power += model.function("ledger")(t, q, u, reactions, c)
    dq, tangential = model.coordinate_rates(t, q, u, force, c), drift + ca.mtimes(along[: model.nu, :].T, a)
    stacked, inner = ca.vertcat(dq, a, power, tangential), ca.vertcat(*known)
    changes = [ca.jacobian(stacked, by) for by in (x, inner, friction)]
    of_inner = ca.Function("of_inner", [x, inner, friction, c], ca.cse(changes))
    W, right, sticks = ca.SX.sym("W", n, n), ca.SX.sym("right", n), ca.SX.sym("sticks", n)
    solved = ca.Function("of_stuck", [W, sticks, right], [ca.cse(solve_sticking(W, sticks, right))])
    parts_of = ca.Function(
        "of_forces", arguments, ca.cse([ca.vertcat(*quantities), ca.vertcat(*derivatives), grip.sticks, dz])
    )

    outer = model.symbols(ARGUMENTS, ca.MX)
    at, run, (values, of_values, stick, booked_by) = ca.vertcat(outer[1], outer[0]), outer[4], parts_of.call(outer)
    cuts = [0, *accumulate(value.numel() for value in quantities)]
    pushed, pressed, _, *speeds = ca.vertsplit(values, cuts)
    acting: list[Any] = [pushed, ca.MX(grip.along.sparsity(), pressed), *speeds, stick]
    carried = forces(model, n)(outer[0], *model.parts(outer[1])[:2], *acting, run)
    direct, by_inner, by_friction = of_inner(at, values, carried, run)
    J = direct + ca.mtimes(by_inner, of_values)
    columns, rows = J.size2(), outer[1].numel()
    J = J + ca.mtimes(by_friction, of_values[cuts[-2] :, :] * ca.repmat(1 - stick, 1, columns))
    stuck = solved.map("of_stuck_columns", "serial", columns, [0, 1], [])(by_friction[rows:, :], stick, -J[rows:, :])
    J = J[:rows, :] + ca.mtimes(by_friction[:rows, :], stuck)
    J = J + ca.vertcat(ca.DM(model.nq + model.nu, columns), booked_by)
    results = [J[:, : columns - 1], ca.densify(J[:, columns - 1])]
    return ca.Function("linearised", outer, results, ARGUMENTS.split(), ["J", "dt"])


def _linearised_fed(model: EngineModel, grip: Grips, f: Any, df: Any, dz: Any, arguments: list[Any]) -> Any:
    """Build `linearised` of a fed model; f, df, dz: of all but friction, and derivatives by (y, t)."""
    t, y, _, _, c = arguments
    q, u, _ = model.parts(y)
    x, fixed = ca.vertcat(y, t), ("sticks", "slip")
    varies = "along", "pushing", "power", "drift", "across", "sliding"
    quantities = [f, *(_nonzeros(getattr(grip, name)) for name in varies)]
    derivatives = [df, *(_masked_finite(ca.jacobian(value, x), ca.SX(1)) for value in quantities[1:])]
    force, *parts = known = [ca.SX.sym("known", value.numel()) for value in quantities]
    symbols = [ca.SX.sym(name, len(grip.places)) for name in fixed]
    shaped = {name: ca.SX(getattr(grip, name).sparsity(), part) for name, part in zip(varies, parts, strict=True)}
    shaped |= dict(zip(fixed, symbols, strict=True))
    inside = Grips(**(vars(grip) | shaped))
    fed = solved(model, inside, t, q, u, force, c)
    a, reactions, *_ = model.function("accelerations").call([t, q, u, fed.f, c])
    power = booked(model, inside, fed.friction)
    if model.has_ledger:
        power += model.function("ledger")(t, q, u, reactions, c)
    dy, inner = ca.vertcat(model.coordinate_rates(t, q, u, fed.f, c), a, power), ca.vertcat(*known)
    of_inner = ca.Function("of_inner", [x, inner, *symbols, c], [ca.jacobian(dy, x), ca.jacobian(dy, inner)])
    direct, mobility = of_inner(x, ca.vertcat(*quantities), grip.sticks, grip.slip, c)
    n = y.numel()
    J = ca.sparsify(
        direct + ca.mtimes(mobility, ca.vertcat(*derivatives)) + ca.vertcat(ca.SX(model.nq + model.nu, n + 1), dz)
    )
    results = ca.cse([J[:, :n], ca.densify(J[:, n])])
    return ca.Function("linearised", arguments, results, ARGUMENTS.split(), ["J", "dt"])


@per_model
def sliding(model: EngineModel, contacts: Contacts) -> Any:
    """Return the function (t, y, dy, mode, m, c) -> sliding velocities v (n) [m/s], dv/dt, dv/dy.

    0 for pairs not in contact; pairs whose sliding ends with an event (set-valued friction) are left out.
    """
    t, y, mode, m, c = model.symbols(ARGUMENTS)
    dy = ca.SX.sym("dy", y.numel())
    q, u, z = model.parts(y)
    velocities = [ca.SX(0, 1)]
    for j, contact, active in active_contacts(model, contacts, mode):
        if j not in rubbing(model):
            _, _, _, v, *_ = contact(t, q, u, z, m, c)
            velocities.append(masked(active, v))
    v = ca.vertcat(*velocities)
    names = ["t", "y", "dy", "mode", "m", "c"]
    results = ca.cse([v, ca.jtimes(v, ca.vertcat(t, y), ca.vertcat(1, dy)), ca.jacobian(v, y)])
    return ca.Function("sliding", [t, y, dy, mode, m, c], results, names, ["v", "dv", "dv_dy"])


@dataclass(frozen=True)
class Stepper:
    """One step of an implicit method with the contacts of one class of attempts."""

    table: Rosenbrock | DiagonallyImplicit
    right: Flow
    linear: Any
    sliding: Any
    nq: int
    turns: bool

    def __call__(self, start: Parts, run: Parts, h: Any, details: dict[str, Any] | None = None) -> dict[str, Any]:
        """Take one step of h [s] from a state; return the parts of a trial. `details` receives the Jacobian J."""
        table, conditions = self.table, (start["mode"], start["m"], run["c"])
        t, y = start["t"], start["y"]
        J, dt = self.linear(t, y, *conditions)
        if details is not None:
            details["J"] = J
        solve = (solver_of_calls if isinstance(J, ca.MX) else solver)(J, h * table.gamma, self.nq)
        least = run["tolerance"] * run["scale"]
        if isinstance(table, Rosenbrock):
            y1, slope, error, converged = _rosenbrock(table, self.right, solve, J, dt, start, conditions, h)
        else:
            settled = ROUNDING * CONVERGED
            if self.turns:
                settled = ca.fmax(settled, _norm(LAST_DIGITS * y, least, y))
            y1, slope, error, converged = _diagonally_implicit(
                table, self.right, solve, dt, start, conditions, h, least, settled
            )
        y1, is_closed = self.right.closed(t + h, y1, run)
        end = self.right.at(t + h, y1, *conditions)
        if slope is not None:
            end["dy"] = slope
        error = self.right.tangential_error(t + h, y1, error, run)
        norm = self.right.error(ca.if_else(converged, _norm(error, least, y1), DIVERGED), is_closed)
        v, rate, gradient = self.sliding(t, y, start["dy"], *conditions)
        v1, rate1, _ = self.sliding(t + h, y1, end["dy"], *conditions)
        if v.numel():
            foreseen = h * ca.mtimes(gradient, ca.mtimes(J, start["dy"]))
            part = ca.mmin(fraction_to_rest(v, rate, foreseen, v1, rate1, h))
            norm = ca.if_else(part < 1, ca.fmax(norm, (SAFETY / part) ** table.error_order), norm)
        return {"t": t + h, "y": y1, **end, "error": norm}


def stepper(model: EngineModel, table: Rosenbrock | DiagonallyImplicit, right: Flow, contacts: Contacts) -> Stepper:
    """Return the step of a method with the contacts of `right`."""
    return Stepper(table, right, linearised(model, contacts), sliding(model, contacts), model.nq, bool(directed(model)))


def fraction_to_rest(v: Any, rate: Any, foreseen: Any, v1: Any, rate1: Any, h: Any) -> Any:
    """Return the fraction of a step h at which a sliding velocity stops unresolved; 1 if none does.

    A smoothed friction law reverses the force in a layer of velocities that may be too narrow for a step to resolve:
    outside of it the Jacobian predicts no change of the rate. The step has crossed it if its end fits no smooth
    motion. Once a step ends in the layer, the Jacobian shows it, and steps are long again; without this the velocity
    would jump across the layer by as much as the tolerance allows.
    """
    meets = (v * rate < 0) * (v * (v + h * rate) < 0)
    unseen = ca.fabs(foreseen) < FORESEEN * ca.fabs(rate)
    smooth = (ca.fabs(v1 - v - h * (rate + rate1) / 2) < FORESEEN * h * ca.fabs(rate)) * (
        ca.fabs(rate1 - rate) < ca.fabs(rate) / 2
    )
    return ca.if_else(meets * unseen * (1 - smooth), -v / (h * rate), 1)


def _rosenbrock(
    table: Rosenbrock, right: Flow, solve: Any, J: Any, dt: Any, start: Parts, conditions: Any, h: Any
) -> tuple[Any, Any, Any, Any]:
    """Take a Rosenbrock step; return y1, None (no slope), the error, whether the systems were solved.

    The solution is checked because, unlike an iteration, the method itself would not notice a failed elimination.
    """
    t, y = start["t"], start["y"]
    U: list[Any] = []
    first: Any = None
    for a, c, alpha, gamma in zip(table.a, table.c, table.alpha, table.gammas, strict=True):
        slope = right.rates(t + alpha * h, y + _sum(a, U), *conditions) if U else start["dy"]
        known = h * slope + _sum(c, U)
        r = table.gamma * (known + gamma * h * h * dt if gamma else known)
        first = r if first is None else first
        U.append(solve(r))
    solved = solves(J, h * table.gamma, U[0], first)
    return y + _sum(table.m, U), None, _sum(table.error.weights, U), solved


def solves(J: Any, step: Any, x: Any, r: Any) -> Any:
    """Return 1 if x solves (I - step J) x = r up to rounding.

    The residual of every row is small beside the row's own terms, whatever its unit.
    """
    residual = x - step * ca.mtimes(J, x) - r
    terms = ca.fabs(x) + step * ca.mtimes(ca.fabs(J), ca.fabs(x)) + ca.fabs(r)
    return ca.mmin(ca.fabs(residual) <= BACKWARD * terms)


def _diagonally_implicit(
    table: DiagonallyImplicit,
    right: Flow,
    solve: Any,
    dt: Any,
    start: Parts,
    conditions: Any,
    h: Any,
    least: Any,
    settled: Any,
) -> tuple[Any, Any, Any, Any]:
    """Take a diagonally implicit step; return y1, the slope there, the error, whether Newton converged.

    The unknown of stage i is w = h gamma k_i. Slopes are taken from w, not from the right-hand side, which would
    amplify the iteration error; the last one is also the first of the next step. (For sticking friction it is the
    force that sticking needs.)
    """
    t, y, slope, gamma = start["t"], start["y"], start["dy"], table.gamma
    slopes = [h * slope]  # h k
    converged: Any = 1
    iterate = _iteration(right, solve, conditions, h * gamma, least, y)
    for row, node, predictor in zip(table.A[1:], table.c[1:], table.predictors[1:], strict=True):
        known = y + _sum(row[:-1], slopes)
        if len(slopes) > 1:
            w = gamma * _sum(predictor, slopes)
        else:  # the right-hand side linearised at the start
            w = y - known
            w = w + solve(h * gamma * (slope + node * h * dt) - w)
        sizes = []
        for _ in range(ITERATIONS):
            w, size = iterate(t + node * h, known, w)
            sizes.append(size)
        # what is left is a geometric series, unless the changes are but rounding
        left = sizes[-1] * sizes[-1] / (sizes[-2] - sizes[-1])
        converged *= (left >= 0) * (left <= CONVERGED) + (sizes[-1] <= settled) > 0
        slopes.append(w / gamma)
    y1 = known + w  # stiffly accurate: the last stage is the solution
    return y1, w / (h * gamma), _sum(table.error.weights, slopes), converged


def _iteration(right: Flow, solve: Any, conditions: Any, step: Any, least: Any, y: Any) -> Any:
    """Return (t, known, w) -> (w after one Newton iteration, norm of its change); one call if MX."""

    def improved(
        solve: Any, conditions: Any, step: Any, least: Any, y: Any, t: Any, known: Any, w: Any
    ) -> tuple[Any, Any]:
        change = solve(step * right.rates(t, known + w, *conditions) - w)
        return w + change, _norm(change, least, y)

    if not isinstance(solve, Elimination):
        return partial(improved, solve, conditions, step, least, y)
    parts = [solve.known, *conditions, step, least, y]
    kind = ca.MX if right.rates.is_a("MXFunction") else ca.SX
    symbols: list[Any] = [kind.sym("x", part.size1()) for part in (*parts, step, y, y)]
    entries, mode, m, c, *others = symbols
    results = improved(partial(solve.solve, entries), (mode, m, c), *others)
    function = ca.Function("iteration", symbols, list(results))
    return partial(function, *parts)


def _norm(error: Any, least: Any, y: Any) -> Any:
    """Return the root mean square of an error relative to the tolerances, as for explicit steps."""
    return ca.sqrt(ca.sumsqr(error / (least + 4 * EPS * ca.fabs(y))) / min(error.numel(), MEAN_OF))


def _sum(weights: tuple[float, ...], terms: list[Any]) -> Any:
    return sum((weight * term for weight, term in zip(weights, terms, strict=False) if weight), start=0.0)


def _nonzeros(matrix: Any) -> Any:
    """Return the structurally nonzero entries as a column."""
    return ca.vertcat(ca.SX(0, 1), *matrix.nonzeros())


def _finite(x: Any, active: Any) -> Any:
    """Return the entries that are finite while active, else 0."""
    return ca.if_else(active * (ca.fabs(x) < SINGULAR), x, 0)


def _masked_finite(matrix: Any, active: Any) -> Any:
    """Mask the entries of an SX matrix that are finite by `active`; the structure is kept."""
    entries = [_finite(x, active) for x in matrix.nonzeros()]
    return ca.SX(matrix.sparsity(), ca.vertcat(*entries)) if entries else matrix
