"""Derivatives of a run's outputs, the numbers that sweeps name, from those of histories and impacts.

An integral over a history changes with the history, and by its jump at every event whose time moves. The largest value of
a history changes as the history does at that time.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.engine.accuracy.error_estimate import VALID
from hertzwerk.runtime.engine.solution.averages import POWERS
from hertzwerk.runtime.engine.solution.dense_output import NORMS, Samples
from hertzwerk.runtime.engine.solution.history import units_of

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.sensitivity.sensitivities import Sensitivities
    from hertzwerk.runtime.engine.solution.solution import EngineSolution

NODES = 4  # of Gauss in a step: order 8, as the steps' own
LEVEL = 1e-9  # of a history's largest value: jumps below are rounding
PANELS = 64  # of a run, at least: few steps are long ones
BESIDE = 1e-5  # of a step: distance from an event from which its limits are taken
CLEAR = 1e-9  # of the scene's length at its speed: the least such distance, beyond the rounding of a gap
OF_IMPACTS = {"peak_force": "peak_force", "max_penetration": "peak_penetration"}
SUDDEN = "it is a count, and has no derivative"
WITHOUT = {
    "impacts": SUDDEN,
    "steps": SUDDEN,
    "rhs_evaluations": SUDDEN,
    "error": "it is an estimate, and has no derivative",
    "energy_residual": "it is an error, and has no derivative",
}
REGRESSION = "a sweep over the parameter gives it, with an interval: sweep(...).slope(OUTPUT, NAME)"
LONG = f"an average of a long run has no derivative along one trajectory; {REGRESSION}"
OWN = f"a function of yours has no derivative here; {REGRESSION}"
AVERAGES = (*POWERS.values(), ".impact_rate", ".mean_force", ".mean_peak_force", ".mean_largest_force")
STOPS = "it jumps where sliding in two directions ends, at an instant whose change is not known"


class NoDerivativeError(ArithmeticError):
    """An output without a derivative, and why."""


def without_derivative(output: str) -> str:
    """Return why an output of any run has no derivative; empty where it may have one."""
    if output.removesuffix(".half_width").endswith(AVERAGES):
        return LONG
    if output.startswith("final."):
        return ""
    return WITHOUT.get(output.rpartition(".")[2], "")


class OutputDerivatives:
    """Derivatives of a run's outputs, by name, with respect to the names of its sensitivities, in SI.

    run    with its steps
    """

    def __init__(self, run: EngineSolution, sensitivities: Sensitivities) -> None:
        self.run, self.of = run, sensitivities
        self._samples: Samples | None = None

    def __getitem__(self, output: str) -> np.ndarray:
        """Derivatives of an output, shape (P,); raises NoDerivativeError."""
        derivatives: np.ndarray = np.asarray(self._derivatives(output), dtype=float)
        if not np.isfinite(derivatives).all():
            reason = self.of.reason or "its derivative is not finite"
            raise NoDerivativeError(f"{reason}, at {self.of.until:.6g} s" if self.of.reason else reason)
        return derivatives

    def _derivatives(self, output: str) -> np.ndarray:
        run, model = self.run, self.run.engine.model
        before, _, last = output.rpartition(".")
        if before == "final":
            last = output.removeprefix("final.")
        if output.startswith("final.") or output in model.memory:
            return self._at(run.engine.t_end, output.removeprefix("final."))
        if last in OF_IMPACTS and before in ("", *model.pairs):
            return self._largest_impact(OF_IMPACTS[last], before)
        if last == "impulse" and before in model.pairs:
            return self._integral(f"{before}.normal_force", lambda h: h, np.ones_like)
        reducer = _REDUCERS.get(last)
        if reducer is not None and before in units_of(model, None):
            return reducer(self, before)
        raise NoDerivativeError(without_derivative(output) or OWN)

    def _at(self, time: float, history: str) -> np.ndarray:
        derivatives: np.ndarray = self.of.along(np.array([time]), history)[0]
        return derivatives

    def _largest_impact(self, quantity: str, pair: str) -> np.ndarray:
        some = [i for i, impact in enumerate(self.run.impacts) if pair in ("", impact.contact)]
        if not some:
            return np.zeros(len(self.of.names))
        top = max(some, key=lambda i: getattr(self.run.impacts[i], quantity))
        derivatives: np.ndarray = self.of.along_impacts(quantity)[top]
        return derivatives

    # -- integrals ---------------------------------------------------------------------------------------------------

    def _integral(
        self, name: str, of: Callable[[np.ndarray], np.ndarray], slope: Callable[[np.ndarray], np.ndarray]
    ) -> np.ndarray:
        """Return the derivatives of the integral over time of a function of a history, whose slope is given."""
        history = self.run.engine.history
        steps = np.flatnonzero(np.diff(history.t) > 0)
        panels = int(np.clip(PANELS // len(steps), 1, PANELS))
        h = np.diff(history.t)[steps] / panels
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        nodes = (np.arange(panels)[:, None] + (1 + nodes) / 2).ravel()
        index, later = np.repeat(steps, len(nodes)), np.outer(h, nodes).ravel()
        changes = self.of.along(history.t[index] + later, name)
        values = history.between(index, later)[name]
        weight = np.outer(h, np.tile(weights / 2, panels)).ravel() * slope(values)
        derivatives: np.ndarray = weight @ changes
        rows, instants = self.of.events
        if len(rows):
            before, after = self._sides(name, rows)
            jump, known = of(before) - of(after), np.isfinite(instants).all(axis=1)
            if np.any(np.abs(jump[~known]) > LEVEL * np.max(np.abs(of(values)))):
                raise NoDerivativeError(STOPS)
            derivatives += jump[known] @ instants[known]
        return derivatives

    def _sides(self, name: str, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the limits of a history before and after the events before rows (n,).

        By rounding the event itself may lie on the other side of a surface, where a force is another.
        """
        history = self.run.engine.history
        steps = np.append(np.diff(history.t), 0.0)
        length, speed = history.controls[history.engine.layouts.controls["scales"]][:2]
        by = np.minimum(np.maximum(BESIDE * steps, CLEAR * length / speed), steps / 4)

        def limit(index: np.ndarray, begin: np.ndarray, by: np.ndarray) -> np.ndarray:
            near, far = (history.between(index, begin + part * by)[name] for part in (1, 2))
            extrapolated: np.ndarray = 2 * near - far
            return extrapolated

        return limit(rows - 1, steps[rows - 1], -by[rows - 1]), limit(rows, 0 * steps[rows], by[rows])

    def _within_horizon(self) -> None:
        """Raise NoDerivativeError for an average beyond the range of derivatives along one trajectory."""
        horizon = self.of.horizon
        if self.run.engine.t_end > horizon:
            raise NoDerivativeError(
                f"the run is longer than the horizon of its derivatives, {horizon:.4g} s, by which an error as small as its tolerance "
                f"has grown to {VALID:.0%}: the derivative along this trajectory is not that of the average; {REGRESSION}"
            )

    def _mean(self, name: str) -> np.ndarray:
        self._within_horizon()
        return self._integral(name, lambda h: h, np.ones_like) / self._time

    def _norm(self, name: str, order: int) -> np.ndarray:
        self._within_horizon()
        value = self.samples.norm(name, order)
        if value == 0:
            raise NoDerivativeError("it is zero throughout, where a root has no derivative")
        by = self._integral(name, lambda h: (h / value) ** order, lambda h: order * (h / value) ** (order - 1) / value)
        return value * by / (order * self._time)

    @property
    def _time(self) -> float:
        return self.run.engine.t_end - self.run.engine.t_start

    @property
    def samples(self) -> Samples:
        """Histories between the steps."""
        if self._samples is None:
            self._samples = Samples(self.run)
        return self._samples

    # -- extremes ----------------------------------------------------------------------------------------------------

    def _extreme(self, name: str, sign: int) -> np.ndarray:
        time, value = self.samples.top(lambda history: sign * history[name])
        rows, _ = self.of.events
        t = self.run.t
        near = rows[np.abs(t[rows] - time) <= LEVEL * self._time]
        if not len(near):
            return self._at(time, name)
        before, after = self._sides(name, near[:1])
        if sign * before[0] > sign * after[0] + LEVEL * abs(value):
            raise NoDerivativeError(f"its extreme is just before a jump, at {time:.6g} s")
        return self.of.after_event(int(near[0]), name)

    def _peak_to_peak(self, name: str) -> np.ndarray:
        derivatives: np.ndarray = self._extreme(name, 1) - self._extreme(name, -1)
        return derivatives


_REDUCERS: dict[str, Callable[[OutputDerivatives, str], np.ndarray]] = {
    "max": lambda derivatives, name: derivatives._extreme(name, 1),
    "min": lambda derivatives, name: derivatives._extreme(name, -1),
    "mean": OutputDerivatives._mean,
    "rms": lambda derivatives, name: derivatives._norm(name, 2),
    "peak_to_peak": OutputDerivatives._peak_to_peak,
    **{kind: lambda derivatives, name, order=order: derivatives._norm(name, order) for kind, order in NORMS.items()},  # type: ignore[misc]
}
