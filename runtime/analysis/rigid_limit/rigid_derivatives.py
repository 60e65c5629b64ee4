"""Derivatives of a run in the rigid limit: variational equations between events, and a jump at each.

A jump is a central difference between neighbours of the run that follow its modes, of fourth order. An event's
time changes by the change of its margin over the margin's rate (Leine, Nijmeijer, Dynamics and Bifurcations of Non-Smooth
Mechanical Systems (2004), section 7.1.3).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from hertzwerk.derive.common.faults import InputError, refuse, shown, unknown
from hertzwerk.runtime.analysis.rigid_limit.rigid_equations import Equations
from hertzwerk.runtime.analysis.rigid_limit.rigid_impact import NoSolutionError, RigidImpact
from hertzwerk.runtime.analysis.rigid_limit.rigid_run import OPEN, SLIDES, Motion, RigidEvent, RigidImpulse, RigidRun
from hertzwerk.runtime.engine.model.binding import Value, times_within
from hertzwerk.runtime.engine.model.free_quantities import derivative_faults
from hertzwerk.runtime.engine.sensitivity.sensitivities import start_changes
from hertzwerk.runtime.engine.sensitivity.tangent import directions_by
from hertzwerk.runtime.system.arrays import Array
from hertzwerk.runtime.system.lazy import cached_property

OF_PARAMETER, OF_STATE = (
    1e-5,
    1e-3,
)  # steps of differences of fourth order, relative to a parameter, to the scales of states
TOLERANCE = 1e-10  # of the variational equations, relative
STAYS = 1e-6  # of the scene's length, by a change of a parameter to twice its value: change of a gap that is none


class _NotSmoothError(Exception):
    """Lack of a derivative at an event, with the reason."""


class RigidDerivatives:
    """Derivatives of a rigid limit with respect to parameters and initial states, in SI.

    names    parameters and initial states
    until    time [s] up to which there are derivatives; reason    why not to the end of the run, else empty
    """

    def __init__(
        self,
        run: RigidRun,
        law: Mapping[str, RigidImpact],
        initial: Mapping[str, Value],
        names: tuple[str, ...],
        again: Callable[[], RigidRun],
        step: float = 1.0,
    ) -> None:
        model, bound = run.equations.model, run.equations.bound
        refuse(f"derivatives of {model.name}", derivative_faults(model, names))
        self.names, self._run, self._law, self._initial, self._again, self._step = names, run, law, initial, again, step
        self._pairs = model.pairs
        self._directions = directions_by(model, bound, names)
        self.until, self.reason = run.motion.t[-1], ""
        self._starts = np.array([event.t for event in run.motion.events])
        begin = start_changes(model, bound, initial, names)
        columns = [self._followed(i, begin[:, i]) for i in range(len(names))]
        self._pieces, self._numbers = [column[0] for column in columns], [column[1] for column in columns]

    def at(self, times: Value | Sequence[float] | Array, name: str, to: str) -> Array:
        """Return the derivative (n,) of a coordinate or speed at one or more times of the run [s].

        At an event it is that just after it, beyond `until` nan. Raises InputError for what is no time of the run.
        """
        model, motion = self._run.equations.model, self._run.motion
        place = (*model.coordinates, *model.speeds).index(name)
        return self._changes(times_within(times, 0.0, motion.t[-1]), to)[:, place]

    def impulses(self, quantity: str, to: str) -> Array:
        """Return the derivatives (n,) of a field of all `RigidImpulse` by a name; nan beyond `until`."""
        fields = RigidImpulse._fields[1:]
        if quantity not in fields:
            raise InputError("derivatives", [unknown("number of an impact", quantity, fields)])
        rows = [row for of_impacts, _ in self._numbers[self._column(to)] for row in of_impacts]
        missing = [np.nan] * (len(self._run.motion.impulses) - len(rows))
        return np.array([row[fields.index(quantity)] for row in rows] + missing)

    def accumulations(self, to: str) -> Array:
        """Return the derivatives (n,) of the ends of sequences of impacts by a name; nan beyond `until`."""
        known = [t for _, ends in self._numbers[self._column(to)] for t in ends]
        return np.array(known + [np.nan] * (len(self._run.motion.accumulations) - len(known)))

    @cached_property
    def differences(self) -> float:
        """Estimate of the relative error of impacts' times and of the end, by a finer run and half the step.

        The end state's is that of changes above its scales, by a parameter of twice its value.
        """
        finer = RigidDerivatives(self._again(), self._law, self._initial, self.names, self._again, self._step / 2)

        def of(one: RigidDerivatives) -> list[Array]:
            ends = (
                size * one._changes([self.until], name)[0] / self._run.sizes
                for name, size in zip(self.names, self._directions.sizes, strict=True)
            )
            return [*(one.impulses("t", name) for name in self.names), *ends]

        return max(
            float(np.nanmax(np.abs(a[: len(b)] - b[: len(a)]), initial=0.0) / np.nanmax(np.abs(a), initial=1.0))
            for a, b in zip(of(self), of(finer), strict=True)
        )

    # -- how they are found --------------------------------------------------------------------------------------------

    def _changes(self, times: Sequence[float] | Array, to: str) -> Array:
        """Return the changes of the state (n, nq + nu) at times (n,), nan beyond `until`."""
        pieces, index = self._pieces[self._column(to)], np.searchsorted(self._starts, times, side="right") - 1
        beyond = np.full(len(self._run.sizes), np.nan)
        return np.array(
            [pieces[k](t) if t <= self.until and k < len(pieces) else beyond for k, t in zip(index, times, strict=True)]
        )

    def _column(self, to: str) -> int:
        if to not in self.names:
            raise InputError("derivatives", [unknown("parameter or initial state", to, self.names)])
        return self.names.index(to)

    def _followed(self, i: int, s: Array) -> tuple[list[Callable[[float], Array]], list[tuple[Array, Array]]]:
        """Return the changes of the state after each event, of its impacts (n, 6) and accumulations (n,)."""
        from scipy.integrate import solve_ivp  # slow to import

        events, pieces, numbers = self._run.motion.events, [], []
        dc, name = self._directions.dc[:, i], self.names[i]
        dmu = np.array([float(self._law[pair].friction == name) for pair in self._pairs])
        atol = TOLERANCE * self._run.sizes / self._directions.sizes[i]
        for event, stop in zip(events, [*self._starts[1:], self._run.motion.t[-1]], strict=True):
            try:
                s, of_impacts, ends = self._jump(i, event, s)
            except (_NotSmoothError, NoSolutionError) as error:
                if event.t <= self.until:
                    self.until, self.reason = event.t, f"at t = {event.t:.9g} s, by {name}: {error}"
                break
            numbers.append((of_impacts, ends))
            last = np.nextafter(stop, event.t)  # at an event the motion is that after it

            def rate(t: float, s: Array, event: RigidEvent = event, last: float = last) -> Array:
                y = self._run.motion.at(np.array([min(t, last)]))[0]
                return event.after.changes(t, y, s, dc, dmu)

            if stop > event.t:
                solution = solve_ivp(
                    rate, (event.t, stop), s, method="DOP853", rtol=TOLERANCE, atol=atol, dense_output=True
                )
                pieces.append(solution.sol)
                s = solution.y[:, -1]
            else:
                pieces.append(lambda t, s=s: s)
        return pieces, numbers

    def _difference(
        self,
        run: RigidRun,
        of: Callable[[RigidRun, float, Array], Array],
        i: int | None,
        t: float,
        y: Array,
        s: Array,
        dt: float = 0.0,
    ) -> Array:
        """Return the change of a function where time and state change by dt and s, a parameter by 1.

        i    None where no parameter changes
        """
        size = 1.0 if i is None else self._directions.sizes[i]
        moves = max(float(np.max(np.abs(s) / run.sizes)), abs(dt) / run.duration, 1e-300)
        h = min(OF_PARAMETER * size, OF_STATE / moves) * self._step
        far, near = ([of(self._neighbour(run, i, x), t + x * dt, y + x * s) for x in (k * h, -k * h)] for k in (2, 1))
        return (8 * (near[0] - near[1]) - far[0] + far[1]) / (12 * h)

    def _neighbour(self, run: RigidRun, i: int | None, change: float) -> RigidRun:
        """Return a run in the modes of another, with a parameter that differs."""
        run = replace(run, ways=list(run.ways), motion=Motion())
        if i is None:
            return run
        bound, name, of = run.equations.bound, self.names[i], self._directions
        moved = replace(bound, p=bound.p + change * of.dp[:, i], c=bound.c + change * of.dc[:, i])
        contacts = [
            replace(one, e=one.e + change * (law.restitution == name), mu=one.mu + change * (law.friction == name))
            for one in run.contacts
            for law in (self._law[one.pair],)
        ]
        return replace(run, equations=Equations(run.equations.model, moved), contacts=contacts)

    def _jump(self, i: int, event: RigidEvent, s: Array) -> tuple[Array, Array, Array]:
        """Return the changes of the state after an event, of its impacts (n, 6) and accumulations (n,)."""
        t, y, ended, before, after = event.t, event.y, event.ended, event.before, event.after
        modes, hit, _ = after.pattern()
        collide = [
            name
            for name, old, new in zip(self._pairs, before.mode, modes, strict=True)
            if old == OPEN and (new != OPEN or name in hit)
        ]
        shift, f = 0.0, np.zeros(len(s))
        if ended is None:
            change = before.equations.changes(t, y, s, self._directions.dc[:, i]).gap
            moved = np.abs(change) * self._directions.sizes[i] > STAYS * self._run.scale[0]
            opens = [name for name, far in zip(self._pairs, moved, strict=True) if far and name in collide]
            if opens:
                raise _NotSmoothError(f"{', '.join(opens)} touches at the start, and opens or closes")
            before = replace(before, mode=[SLIDES if name in collide else OPEN for name in self._pairs])
        else:
            others = [pair for pair in collide if pair != self._pairs[ended]]
            if others:
                raise _NotSmoothError(f"{' and '.join([self._pairs[ended], *others])} collide at one instant")
            f = before.rates(t, y)

            shift = self._shift(i, event, ended, s, f)
        expected, n, m = after.pattern(), len(y), len(y) + 6 * len(hit)

        def settled(one: RigidRun, t: float, y: Array) -> Array:
            one.last = (t, ended) if event.repeated else (-1.0, None)
            moved = one.settled(t, y, ended) - y
            if one.pattern() != expected:
                raise _NotSmoothError(f"its neighbours go on as {shown(one.pattern())}, it as {shown(expected)}")
            numbers = [number for impulse in one.motion.impulses for number in impulse[1:]]
            return np.concatenate([moved, numbers, [end.t for end in one.motion.accumulations]])

        s = s + f * shift
        change = self._difference(before, settled, i, t, y, s, shift)
        s = s + change[:n] - after.rates(t, event.y_after) * shift
        return s, change[n:m].reshape(-1, 6), change[m:]

    def _shift(self, i: int, event: RigidEvent, ended: int, s: Array, f: Array) -> float:
        """Return the change of an event's time: that of its margin over the rate of the margin."""
        t, y, before = event.t, event.y, event.before
        if before.mode[ended] == OPEN:
            closing = before.equations.at(t, y).velocity[before.contacts[ended].n]
            return -float(before.equations.changes(t, y, s, self._directions.dc[:, i]).gap[ended] / closing)

        def margin(one: RigidRun, t: float, y: Array) -> Any:
            return one.margins(t, y)[ended][event.which]

        change, rate = (
            self._difference(before, margin, i, t, y, s),
            self._difference(before, margin, None, t, y, f, 1.0),
        )
        return -float(change / rate)
