"""One body against one plane, with friction that sticks and slips, integrated in extended precision by `body_on_plane.c` beside this file.

The factors of the damping laws are typed here from the publications (`shared/reference/contact-laws.md`, section 1).
"""

from __future__ import annotations

import math
import subprocess
import tempfile
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import numpy as np

SOURCE = Path(__file__).parent / "programs" / "body_on_plane.c"
MOST = 400_000  # steps
ELASTIC, HYSTERESIS, SECANT, SECANT_APPROACHING, TANGENT, POWER = range(6)

HYSTERESIS_FACTORS = {
    "hunt_crossley": lambda e: 1.5 * (1 - e), "herbert_mcwhannell": lambda e: 6 * (1 - e) / ((2 * e - 1) ** 2 + 3),
    "lee_wang": lambda e: 0.75 * (1 - e), "lankarani_nikravesh": lambda e: 0.75 * (1 - e * e), "gonthier": lambda e: (1 - e * e) / e,
    "zhiying_qishao": lambda e: 0.75 * (1 - e * e) * math.exp(2 * (1 - e)), "flores": lambda e: 8 * (1 - e) / (5 * e),
    "gharib_hurmuzlu": lambda e: 1 / e, "hu_guo": lambda e: 3 * (1 - e) / (2 * e),
    "carvalho_martins": lambda e: 3 * (1 - e) * (11 - e) / (2 * (1 + 9 * e)), "safaeifar_farshidianfar": lambda e: 5 * (1 - e) / (4 * e),
    "exact": lambda e: _exact(e),
}  # fmt: skip


def _exact(e: float) -> float:
    """Return the h of h (1 + e) = ln((1 + h)/(1 - h e)), by bisection in 40 digits."""
    import mpmath

    with mpmath.workdps(40):
        e = mpmath.mpf(e)
        low, high = mpmath.mpf("1e-12"), 1 / e
        for _ in range(140):
            h = (low + high) / 2
            below = h * (1 + e) > mpmath.log((1 + h) / (1 - h * e))
            low, high = (h, high) if below else (low, h)
        return float(low)


def _log_ratio(e: float) -> float:
    return -math.log(e) / math.sqrt(math.pi**2 + math.log(e) ** 2)


@dataclass(frozen=True)
class Body:
    """A body: all of it that either side needs, in SI; offset is from the mass centre to the sphere's, `known` the damping's parameter."""

    plane: bool
    damping: str
    exponent: float
    mass: float
    inertia: tuple[float, float, float]
    offset: tuple[float, float, float]
    radius: float
    tilt: float
    turn: float
    stiffness: float
    known: dict[str, float]
    mu_k: float
    mu_s: float
    duration: float
    x: tuple[float, float, float]
    q: tuple[float, float, float, float]
    angle: float
    v: tuple[float, float, float]
    w: tuple[float, float, float]
    depth: float
    pace: float
    gravity: float = 9.81
    floor: float = 1e-3

    @property
    def normal(self) -> tuple[float, float, float]:
        """Outward normal of the plane, which contains the origin."""
        if self.plane:
            return math.sin(self.tilt), math.cos(self.tilt), 0.0
        return (
            math.sin(self.tilt) * math.cos(self.turn), math.sin(self.tilt) * math.sin(self.turn), math.cos(self.tilt),
        )  # fmt: skip

    @property
    def law(self) -> tuple[int, float, float]:
        """Kind of the damping in the oracle, its coefficient and its exponent."""
        e = self.known.get("restitution", 1.0)
        if self.damping in HYSTERESIS_FACTORS:
            return HYSTERESIS, HYSTERESIS_FACTORS[self.damping](e), 0.0
        return {
            "elastic": lambda: (ELASTIC, 0.0, 0.0), "kelvin_voigt": lambda: (SECANT, 2 * _log_ratio(e), 0.0),
            "tsuji": lambda: (SECANT, math.sqrt(5) * _log_ratio(e), 0.0),
            "jankowski": lambda: (SECANT_APPROACHING, 9 * math.sqrt(5) * (1 - e * e) / (e * (e * (9 * math.pi - 16) + 16)), 0.0),
            "ristow": lambda: (POWER, self.known["damping_rate"] * self.mass, 0.0),
            "kuwabara_kono": lambda: (TANGENT, self.known["material_time"], 0.0), "power_damping": lambda: (POWER, self.known["damping"], 1.0),
        }[self.damping]()  # fmt: skip

    def line(self, perturbed: float = 0.0, at: Sequence[float] = ()) -> str:
        """Line that the oracle reads; `perturbed` by a share of the start, of a sign and a size that differ by entry; `at` rising times."""
        kind, coefficient, exponent = self.law
        down = (0.0, -self.gravity, 0.0) if self.plane else (0.0, 0.0, -self.gravity)
        numbers = [perturbed, self.mass, *self.inertia, *self.offset, self.radius, *self.normal, *down]
        numbers += [self.stiffness, self.exponent, coefficient, exponent, self.floor, self.mu_k, self.mu_s]
        numbers += [self.duration, *self.x, *self.q, *self.v, *self.w]
        known, times = ([float(x).hex() for x in row] for row in (numbers, at))
        return " ".join([str(int(self.plane)), str(kind), str(MOST), *known, str(len(times)), *times])


@dataclass(frozen=True)
class Motion:
    """What the oracle found: events (time, kind, approach speed), final state (13), final mode, steps, least sliding speed passed.

    states, rates (times, 13): at the times that were requested, as far as it got
    """

    body: Body
    events: tuple[tuple[float, str, float], ...] = field(repr=False)
    state: tuple[float, ...]
    mode: int
    steps: int
    least: float
    wrong: int
    states: np.ndarray = field(repr=False, compare=False)
    rates: np.ndarray = field(repr=False, compare=False)


@cache
def program(quad: bool = False, *flags: str, source: Path = SOURCE) -> Path:
    """Compile the oracle, in long double or in quadruple precision, or in double by a flag: -DDOUBLE."""
    folder = Path(tempfile.mkdtemp(prefix="body_on_plane_"))
    target = folder / "body_on_plane"
    precision = ["-DQUAD", "-lquadmath"] if quad else []
    subprocess.run(["gcc", "-O2", "-o", target, source, *flags, *precision, "-lm"], check=True)
    return target


def motions(
    bodies: Iterable[Body],
    perturbed: float = 0.0,
    *,
    at: Sequence[float] = (),
    quad: bool = False,
    command: Sequence[str] = (),
    by: Path | None = None,
) -> list[Motion]:
    """Return the motion of each body, with its states at rising times."""
    bodies = list(bodies)
    text = "\n".join(body.line(perturbed, at) for body in bodies)
    done = subprocess.run(
        [*command, by or program(quad)], input=text, stdout=subprocess.PIPE, text=True, check=True
    ).stdout
    found, events, rows = [], [], []
    for line in done.splitlines():
        first, *rest = line.split()
        if first == "e":
            events.append((float(rest[0]), rest[1], float(rest[2])))
            continue
        if first == "s":
            rows.append([float(x) for x in rest[1:]])
            continue
        *state, mode, steps, least, wrong = rest
        body = bodies[len(found)]
        end = tuple(map(float, state)), int(mode), int(steps), float(least), int(wrong)
        found.append(Motion(body, tuple(events), *end, *np.split(np.reshape(rows, (-1, 2 * len(state))), 2, axis=1)))
        events, rows = [], []
    return found
