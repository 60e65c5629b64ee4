"""Difference of two runs of one motion: along it, and of their impacts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress

import numpy as np

from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.run.single_run import Trace
from hertzwerk.runtime.engine.solution import error_scales as scaling
from hertzwerk.runtime.engine.solution.error_scales import Scales
from hertzwerk.runtime.engine.solution.impacts import Impact
from hertzwerk.runtime.engine.solution.step_observers import Findings


def compared_histories(model: EngineModel) -> tuple[str, ...]:
    """Return the names of the histories whose differences follow the error in `differences`."""
    return (*model.coordinates, *model.speeds, *(f"{pair}.normal_force" for pair in model.pairs))


def differences(model: EngineModel, scales: Scales, one: Trace, other: Trace, n: int) -> np.ndarray:
    """Return the differences (n, 1 + m) of two runs at the first n times at which they are compared.

    The first column is the error of one if the other is true, that of its state (`error_scales.error`) or of an impact that
    begins until then; the others are those of `compared_histories` in SI, but for the shift in time.
    """
    rows, reference = (trace.compared.history.of(trace.compared.history.rows[:n]) for trace in (one, other))
    m = model.nq + model.nu
    size = scales.state[:m]
    apart, forces = (rows.part(name) - reference.part(name) for name in ("y", "force"))
    motions = reference, rows  # where one of them has had an event before the other, their rates differ
    rates = np.stack([motion.part("dy")[:, :m] for motion in motions])
    held = list(model.held)
    apart[:, held] = apart[:, model.timers] = 0
    rates[..., model.timers] = 0
    force_rates = np.stack([motion.part("force_rate") for motion in motions])
    error, shift = scaling.distance(apart[:, :m] / size, rates / size, scales.pace)
    error, shift = error[..., None], shift[..., None]
    left = np.abs(apart[:, :m] - rates * shift), np.abs(forces - force_rates * shift)
    table: np.ndarray = np.where(error[0] <= error[1], *np.concatenate([error, *left], axis=2))
    if held:
        jumped = scaling.event_differences(*(trace.part("y")[:, held] for trace in (rows, reference)))
        table[:, [1 + row for row in held]] = jumped
        table[:, 0] = np.maximum(table[:, 0], np.max(jumped / size[held], axis=1))
    until = float(rows.t[-1])
    lists: list[tuple[Impact, ...]] = []
    with suppress(Exception):  # whatever it is, the run reports that its impacts could not be found
        Findings.find_impacts([trace.findings for trace in (one, other)])
        lists += [trace.findings.impacts for trace in (one, other)]
    for j, pair in enumerate(model.pairs if len(lists) == 2 else ()):
        of_one, of_other = (
            [impact for impact in each if impact.contact == pair and impact.t <= until] for each in lists
        )
        for t, off, force in impact_differences(of_one, of_other, scales):
            at = min(int(np.searchsorted(rows.t, t)), n - 1), [0, 1 + m + j]
            table[at] = np.maximum(table[at], np.array([off, force]))
    return table


def impact_differences(
    one: Sequence[Impact], other: Sequence[Impact], scales: Scales
) -> Iterator[tuple[float, float, float]]:
    """Yield time [s], error and difference of the peak forces [N] of the impacts of one pair in two runs.

    Approach speeds count by the scene's speed, peak forces by its force or the largest; onsets and durations by the
    scene's length over the approach speed, as it is by lengths that surfaces are too near. An impact that only one run has
    is off by its approach speed and its peak force.
    """
    length, speed = scales.scene[:2]
    force = max([scales.scene[2], *(impact.peak_force for impact in other)])

    def alone(impact: Impact) -> float:
        return float(max(impact.speed / speed, impact.peak_force / force))

    i = k = 0
    while i < len(one) or k < len(other):
        if i < len(one) and k < len(other):
            a, b = one[i], other[k]
            apart, peak = abs(a.t - b.t), abs(a.peak_force - b.peak_force)
            if a.duration is not None and b.duration is not None:
                apart = max(apart, abs(a.duration - b.duration))
            elif a.duration is not b.duration:  # one has been stopped in it
                peak = 0.0
            off = max(max(a.speed, b.speed) / length * apart, abs(a.speed - b.speed) / speed, peak / force)
            if off <= max(alone(a), alone(b)):
                yield a.t, off, peak
                i, k = i + 1, k + 1
                continue
        only = one[i] if k == len(other) or (i < len(one) and one[i].t <= other[k].t) else other[k]
        yield only.t, alone(only), only.peak_force
        i, k = (i + 1, k) if i < len(one) and only is one[i] else (i, k + 1)
