"""All hard cases, by theme."""

from __future__ import annotations

from hertzwerk.runtime.hard_cases import crank, edges, events, friction, impacts, loops, many, rest
from hertzwerk.runtime.hard_cases.case import HardCase

CASES: tuple[HardCase, ...] = (
    *impacts.CASES,
    *rest.CASES,
    *events.CASES,
    *many.CASES,
    *crank.CASES,
    *friction.CASES,
    *loops.CASES,
    *edges.CASES,
)
BY_NAME = {case.name: case for case in CASES}
