"""Single impacts: extreme restitutions, speeds, exponents, stiffnesses, damping and mass ratios."""

from __future__ import annotations

import math

from hertzwerk.runtime.analysis.hard_cases import closed_forms
from hertzwerk.runtime.analysis.hard_cases.case import (
    METHODS,
    REFERENCED,
    HardCase,
    Source,
    contacts,
    final,
    impact,
    largest,
)

RELATION = "h (1 + e) = ln((1 + h)/(1 - h e)), Hunt and Crossley 1975"
TOLERANCE = 1e-8
PART = 10 * TOLERANCE  # tolerance of a known speed or depth, relative to that of the impact
FLORES, EXACT = Source("free_impact_flores", hard=True), Source("free_impact_exact", hard=True)
PULLS, RELEASED = (Source(f"free_impact_{name}", hard=True) for name in ("kelvin_voigt", "kelvin_voigt_without_pull"))
RISTOW, UNLIKE = Source("free_impact_ristow", hard=True), Source("unlike_masses", hard=True)


def _nearly_plastic(law: str, source: Source, restitution: float) -> HardCase:
    return HardCase(
        name=f"impact_e001_{law}",
        theme="impacts",
        hard="restitution 0.01: damping a hundred times the elastic force, and a slow separation",
        source=source,
        duration=0.2,
        tolerance=TOLERANCE,
        methods=REFERENCED,
        parameters={"e": 0.01},
        known=(
            contacts(1, "one impact"),
            final("ball.speed", restitution, PART, RELATION),
            final("wall.dissipated", (1 - restitution**2) / 2, PART, "energy before less energy after"),
        ),
    )


def _slowest() -> HardCase:
    speed, h = 1e-9, closed_forms.flores(0.5)
    return HardCase(
        name="slowest_approach",
        theme="impacts",
        hard="approach at 1e-9 m/s, the floor of the approach speed lowered to 1e-12 m/s: penetration of 0.04 nm",
        source=FLORES,
        duration=2.0,
        tolerance=TOLERANCE,
        methods=METHODS,
        parameters={"e": 0.5, "approach": "1e-9 m/s", "approach_floor": "1e-12 m/s"},
        known=(
            contacts(1, "one impact"),
            final("ball.speed", closed_forms.restitution_out(h) * speed, PART * speed, RELATION),
            impact(
                0,
                "peak_penetration",
                closed_forms.depth(1e8, 1.5, 1, speed, h),
                PART * 5e-11,
                "energy integral of F(d, v)",
            ),
        ),
    )


def _exponent(n: float, text: str, label: str) -> HardCase:
    h = closed_forms.flores(0.7)
    depth = closed_forms.depth(1e8, n, 1, 1, h)
    return HardCase(
        name=f"exponent_{label}",
        theme="impacts",
        hard=f"exponent n = {text}: "
        + (
            "the force has a kink at the surface"
            if n == 1
            else "the force is not smooth at the surface"
            if n != 2
            else "the force has a kink in its slope at the surface"
        ),
        source=FLORES,
        duration=20 * depth,
        tolerance=TOLERANCE,
        methods=REFERENCED,
        parameters={"e": 0.7, "exponent": n, "stiffness": (1e8, f"N/m^({text})")},
        known=(
            final("ball.speed", closed_forms.restitution_out(h), PART, RELATION + ": the same for every n"),
            impact(0, "peak_penetration", depth, PART * depth, "energy integral of F(d, v)"),
        ),
    )


def _stiffness(K: float, label: str) -> HardCase:
    g, v0 = 9.81, math.sqrt(2 * 9.81)
    depth = closed_forms.depth_under_gravity(K, 1.5, 1, v0, g)
    return HardCase(
        name=f"stiffness_{label}",
        theme="impacts",
        hard=f"K = {K:g} N/m^1.5: two elastic bounces {2.94 * depth / v0:.1g} s long in 1.5 s",
        source=Source("bouncing_ball"),
        duration=1.5,
        tolerance=TOLERANCE,
        methods=METHODS,
        parameters={"restitution": 1.0, "stiffness": (K, "N/m^1.5")},
        known=(
            impact(0, "speed", v0, PART * v0, "free fall"),
            impact(0, "peak_penetration", depth, PART * depth, "K d^2.5/2.5 = m v0^2/2 + m g d"),
            impact(1, "speed", v0, PART * v0, "nothing is lost"),
        ),
    )


def _jump(
    name: str,
    source: Source,
    hard: str,
    parameters: dict[str, float | str | tuple[float, str]],
    xi: float,
    *,
    pulls: bool,
) -> HardCase:
    K = 1e6
    e, duration = closed_forms.oscillator(K, 1.0, xi, pulls=pulls)
    return HardCase(
        name=name,
        theme="impacts",
        hard=hard,
        source=source,
        duration=0.01,
        tolerance=TOLERANCE,
        methods=REFERENCED,
        parameters={"exponent": 1, "stiffness": (K, "N/m^1"), **parameters},
        known=(
            contacts(1, "one impact"),
            final("ball.speed", e, PART, "damped oscillator"),
            impact(0, "duration", duration, PART * duration, "damped oscillator"),
        ),
    )


def _masses(striker: float, target: float, label: str, hard: str) -> HardCase:
    e, share = 0.7, striker / (striker + target)
    speeds = share - (1 - share) * e, share * (1 + e)
    return HardCase(
        name=f"masses_{label}",
        theme="impacts",
        hard=hard,
        source=UNLIKE,
        duration=0.02,
        tolerance=TOLERANCE,
        methods=REFERENCED,
        parameters={"restitution": e, "striker_mass": (striker, "kg"), "target_mass": (target, "kg")},
        known=(
            final("striker_path.speed", speeds[0], PART, "momentum and restitution"),
            final("target_path.speed", speeds[1], PART, "momentum and restitution"),
        ),
    )


def _through_film() -> HardCase:
    # a position off by one tolerance, 5 pm, where 1 nm of oil is left, changes the speed by per/layer times that: 6e-5 m/s
    per, layer = 6 * math.pi * 0.2 * 0.01**2 / 0.0327, 1e-9
    lost = per * (math.log(0.5e-3 / (2 * layer)) + 1.615448332425325)
    return HardCase(
        name="through_a_nanometre_of_oil",
        theme="impacts",
        hard="a film that thins from 0.5 mm to 1 nm, its drag over six decades, then dry contact ten thousand times as deep",
        source=Source("ball_on_oil"),
        duration=0.008,
        tolerance=TOLERANCE,
        parameters={"boundary_layer": "1 nm"},
        known=(
            contacts(1, "one impact: a film that opens has ruptured"),
            impact(0, "speed", 0.3 - lost, 1e-6 * 0.3, "Reynolds' film: v0 - 6 pi eta R^2/m times an integral of 1/h"),
        ),
    )


_R, _G, _STRENGTH, _MODULUS = 0.025, 9.81, 1e9, 207e9 / (2 * (1 - 0.3**2))
_BALL = 4 / 3 * math.pi * _R**3 * 7800


def _yields(label: str, hard: str, height: float) -> HardCase:
    """Return the case of a ball that yields in its first impact, and falls on the plane again."""
    depth, returned = closed_forms.thornton(_R, _BALL, _MODULUS, 1.6 * _STRENGTH, height, _G)
    again = math.sqrt(2 * (returned / _BALL - _G * depth))
    v0 = math.sqrt(2 * _G * height)
    return HardCase(
        name=f"yields_{label}",
        theme="impacts",
        hard=hard,
        source=Source("yielding_ball"),
        duration=(v0 + 2.2 * again) / _G,
        tolerance=TOLERANCE,
        methods=METHODS,
        parameters={"drop_height": (height, "m")},
        known=(
            contacts(2, "the ball falls on the plane again"),
            impact(0, "peak_penetration", depth, PART * depth, "work of loading by Thornton's law = m g (h + d)"),
            impact(1, "speed", again, PART * again, "energy that unloading returns, less m g d"),
        ),
    )


def _on_its_dent() -> HardCase:
    """Return the case of a ball so heavy that it stays in its dent, and vibrates there."""
    height, g = 1e-3, 1e6
    depth, _ = closed_forms.thornton(_R, _BALL, _MODULUS, 1.6 * _STRENGTH, height, g)
    return HardCase(
        name="vibrates_on_its_dent",
        theme="impacts",
        hard="a contact that has yielded and stays loaded comes back each time to just the penetration at which it would yield again",
        source=Source("yielding_ball"),
        duration=2e-3,
        tolerance=TOLERANCE,
        methods=METHODS,
        parameters={"gravity": (g, "m/s^2"), "drop_height": (height, "m")},
        known=(
            contacts(1, "it does not leave the plane"),
            largest("floor.deepest", depth, PART * depth, "work of loading by Thornton's law = m g (h + d)", "m"),
        ),
    )


_XI = closed_forms.damping_ratio(0.5)
_GAMMA = 2 * _XI * math.sqrt(1e6)

CASES = (
    _nearly_plastic("flores", FLORES, closed_forms.restitution_out(closed_forms.flores(0.01))),
    _nearly_plastic("exact", EXACT, 0.01),
    _slowest(),
    *(
        _exponent(n, text, label)
        for n, text, label in ((1, "1", "1"), (10 / 9, "10/9", "10_9"), (1.5, "3/2", "3_2"), (2, "2", "2"))
    ),
    *(_stiffness(K, label) for K, label in ((1e4, "1e4"), (1e7, "1e7"), (1e10, "1e10"), (1e14, "1e14"))),
    _jump(
        "jump_and_pull",
        PULLS,
        "m = 0: the force jumps at the onset and pulls before the gap opens, where the contact ends",
        {"e": 0.5},
        _XI,
        pulls=True,
    ),
    _jump(
        "jump_without_pull",
        RELEASED,
        "m = 0: the force jumps at the onset; the contact ends, overlapping, where it would pull",
        {"e": 0.5},
        _XI,
        pulls=False,
    ),
    _jump(
        "jump_ristow",
        RISTOW,
        "m = 0 with a damping rate in place of a restitution; the contact ends where it would pull",
        {"gamma": (_GAMMA, "1/s")},
        _XI,
        pulls=False,
    ),
    _yields("just", "an impact 0.14 % faster than first yield: it unloads 0.1 us after", 1e-3),
    _yields("deep", "an impact 700 times as fast as first yield: 99 m/s, restitution 0.23", 500.0),
    _on_its_dent(),
    _masses(1e4, 1e-4, "heavy_striker", "mass ratio 1e8, the heavy one strikes"),
    _masses(1e-4, 1e4, "light_striker", "mass ratio 1e8, the light one strikes"),
    _through_film(),
)
