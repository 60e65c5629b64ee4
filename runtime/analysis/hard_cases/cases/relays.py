"""Relays: events of effects that follow each other as fast as the tolerance lets them."""

from __future__ import annotations

from hertzwerk.runtime.analysis.hard_cases.case import HardCase, Source, final, largest

HELD = "the sliding mode of a relay: the signal stays within what an event is located to"

CASES = (
    HardCase(
        name="relay_without_hysteresis",
        theme="events of effects",
        hard="a relay switches at once again, some 1e4 times in 50 us",
        source=Source("chattering_relay", hard=True),
        duration=5e-5,
        tolerance=1e-6,
        known=(
            final("slide.speed", 0.0, 1e-8, HELD),
            largest("slide.speed", 0.0, 1e-8, HELD),
            final("slide.travel", 0.0, 1e-12, HELD),
        ),
    ),
)
