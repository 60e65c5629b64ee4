"""Meanings of the columns of a sweep's table, by their names."""

from __future__ import annotations

_WHOLE = {
    "outcome": "how the run ended",
    "message": "message of the outcome",
    "warnings": "warnings of the run",
    "impacts": "number of contacts that began",
    "peak_force": "peak normal force of the contacts",
    "max_penetration": "peak penetration of the contacts",
    "impulse": "impulse of the normal force",
    "energy_residual": "largest error of the energy balance, of the energy that moves",
    "error": "estimated error of the run, its maximum or that at the end, as requested, in the scene's scales",
    "steps": "accepted steps",
    "rhs_evaluations": "evaluations of the equations of motion",
    "wall_s": "time that the row took",
    "impact_rate": "contacts that begin per time, after the transient",
    "mean_force": "mean normal force, after the transient",
    "mean_peak_force": "mean of the peak force of a contact, after the transient",
    "mean_largest_force": "mean of the peak force in a period, after the transient",
    "dissipated_power": "mean power dissipated, after the transient",
    "input_power": "mean power put in, after the transient",
}
_REDUCED = {
    "max": "maximum of {}",
    "min": "minimum of {}",
    "mean": "mean of {} over time",
    "rms": "root mean square of {} over time",
    "peak_to_peak": "maximum less minimum of {}",
    "half_width": "half the width of the 95 % interval of {}",
}


_NONE = {
    **dict.fromkeys(("impact_rate", "mean_force", "mean_largest_force"), "fewer than two intervals"),
    **dict.fromkeys(("dissipated_power", "input_power"), "fewer than two intervals"),
    "mean_peak_force": "fewer than two intervals, or no impact after the transient",
    "half_width": "fewer than eight independent intervals after the transient",
    "error": "runs at a given tolerance have no estimate of their error",
}


def reason_of_none(name: str) -> str:
    """Return why a column has no number in rows that ran; empty where that depends on the run."""
    return _NONE.get(name.rpartition(".")[2], "")


def meaning_of(name: str, *, varied: bool) -> str:
    """Return what a column is; empty for a user's own function."""
    if varied:
        return f"{name} as given"
    if name.startswith("final."):
        return f"{name.removeprefix('final.')} at the end"
    whose, _, part = name.rpartition(".")
    if whose and part in _REDUCED:
        return _REDUCED[part].format(whose)
    words = _WHOLE.get(part, "")
    return f"{words}, of {whose}" if whose and words else words
