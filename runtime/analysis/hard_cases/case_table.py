"""All hard cases, by theme."""

from __future__ import annotations

from hertzwerk.runtime.analysis.hard_cases.case import HardCase
from hertzwerk.runtime.analysis.hard_cases.cases import (
    borderline_events,
    closed_loops,
    crank,
    edge_of_friction,
    edges,
    feet,
    geneva,
    jamming,
    many,
    relays,
    rest,
    shaken,
    single_impacts,
    sliding,
)

CASES: tuple[HardCase, ...] = (
    *single_impacts.CASES,
    *rest.CASES,
    *borderline_events.CASES,
    *many.CASES,
    *crank.CASES,
    *sliding.CASES,
    *closed_loops.CASES,
    *edges.CASES,
    *relays.CASES,
    *jamming.CASES,
    *feet.CASES,
    *geneva.CASES,
    *shaken.CASES,
    *edge_of_friction.CASES,
    *sliding.BESIDE_RIGID_LIMIT,
)
BY_NAME = {case.name: case for case in CASES}
