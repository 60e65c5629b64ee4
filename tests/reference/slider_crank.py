"""The slider-crank with a clearance joint, derived by hand and integrated in quadruple precision.

Data: first row of `shared/reference/scenarios.md` (the set used by Ravn, Schwab and Flores).

Coordinates: x to the right along the guide, y up, gravity along -y. The crank turns at constant speed, phi = w t. The
other two are theta, the absolute angle of the rod, and x, the position of the slider on the guide. (A relative angle at
the crank pin is theta - phi.) With u = (cos theta, sin theta) and u' = (-sin theta, cos theta):

    crank pin     A = r (cos phi, sin phi),        A'' = -r w^2 (cos phi, sin phi)
    rod centre    A + s u,                         its velocity is A' + s theta' u'
    pin centre    P = A + l u,                     bush centre (x, 0)
    eccentricity  e = P - (x, 0),                  normal n = e/|e|, tangent t = (-n_y, n_x), penetration d = |e| - c

Rod, moments about the crank pin A, which is accelerated: (J + m_r s^2) theta'' + m_r s u'.A'' = moment, and
u'.A'' = -r w^2 sin(phi - theta), so that

    (J + m_r s^2) theta'' = m_r s (r w^2 sin(phi - theta) - g cos theta) - F l (n.u') - f (l t.u' + R_pin)
    m_s x''               = F n_x + f t_x = F n_x - f n_y

because the bush pushes the pin with -F n - f t at the shared contact point P + R_pin n, the pin pushes the bush with
the opposite, and the guide takes the slider's y force and every moment on it (so its weight does not appear).
The rod's material point there has the velocity P' + R_pin theta' t (t is n turned by +90 degrees), hence the lever arms
above and the sliding velocity

    v_t = t.(P' - (x', 0)) + R_pin theta'

Force: F = K d^(3/2) (1 + h d'/v0), K = (4/3) E* sqrt(R), R = R_bush R_pin/c, E* = E/(2 (1 - nu^2)) for two equal
materials, h = 3 (1 - e^2)/4 (Lankarani & Nikravesh 1990), v0 = max(approach speed at the onset, floor), latched until
the gap opens; f = mu F tanh(v_t/v_s). Where the law would begin to pull (1 + h d'/v0 < 0) the pair is released: no
force and no new onset before the gap has opened. (It does not happen in these two revolutions.) The effective mass
along n has 1/m_eff = n_x^2/m_s + (l n.u')^2/(J + m_r s^2).

Start: phi = theta = 0, x = r + l, theta' = -w r/l, x' = 0, i.e. the ideal mechanism at its outer dead centre.

The digits in slider_crank.json come from programs/slider_crank_quad.cpp (g++ and libquadmath), run at two
tolerances and two step limits; what the two runs differ by is stored as the uncertainty. Regenerate, 5 minutes:

    python tests/reference/slider_crank.py
"""

from __future__ import annotations

import json
import math
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from decimal import Decimal
from functools import cache
from pathlib import Path
from typing import NamedTuple

HERE = Path(__file__).parent
DATA = HERE / "slider_crank.json"
PROGRAM = HERE / "programs" / "slider_crank_quad.cpp"
# (local error in the scene's scales, longest step [s]) of the two runs; the digits of the second are kept.
TOLERANCES = (("1e-26", "1.7e-6"), ("1e-29", "1.1e-6"))
TIMES = tuple(f"{ms}e-3" for ms in range(1, 25))


@dataclass(frozen=True)
class SliderCrank:
    """The mechanism's data in SI units, and its equations of motion as derived above."""

    r: float = 0.05
    l: float = 0.12
    w: float = 5000 * 2 * math.pi / 60
    m_rod: float = 0.21
    J_rod: float = 2.5e-4
    s: float = 0.06
    m_slider: float = 0.14
    g: float = 9.81
    R_bush: float = 0.01
    c: float = 5e-4
    E: float = 207e9
    nu: float = 0.3
    e: float = 0.9
    mu: float = 0.1
    v_s: float = 0.1
    floor: float = 1e-3

    @property
    def R_pin(self) -> float:
        return self.R_bush - self.c

    @property
    def K(self) -> float:
        """Hertz stiffness of a ball in a socket [N/m^1.5]."""
        return 4 / 3 * self.E / (2 * (1 - self.nu**2)) * math.sqrt(self.R_bush * self.R_pin / self.c)

    @property
    def h(self) -> float:
        return 3 * (1 - self.e**2) / 4

    @property
    def start(self) -> tuple[float, float, float, float]:
        return 0.0, self.r + self.l, -self.w * self.r / self.l, 0.0

    def journal(self, t: float, state: tuple[float, ...]) -> tuple[float, float, float, float]:
        """Eccentricity [m] and its rate [m/s]: (e_x, e_y, e_x', e_y')."""
        theta, x, dtheta, dx = state
        phi = self.w * t
        return (
            self.r * math.cos(phi) + self.l * math.cos(theta) - x,
            self.r * math.sin(phi) + self.l * math.sin(theta),
            -self.r * self.w * math.sin(phi) - self.l * dtheta * math.sin(theta) - dx,
            self.r * self.w * math.cos(phi) + self.l * dtheta * math.cos(theta),
        )

    def contact(self, t: float, state: tuple[float, ...], v0: float, friction: bool) -> tuple[float, float, float]:
        """Normal force, friction force along t [N] and sliding velocity [m/s]; zero forces without penetration."""
        ex, ey, vx, vy = self.journal(t, state)
        eps = math.hypot(ex, ey)
        n_x, n_y = ex / eps, ey / eps
        d, dd = eps - self.c, n_x * vx + n_y * vy
        v_t = n_x * vy - n_y * vx + self.R_pin * state[2]
        F = self.K * d**1.5 * (1 + self.h * dd / v0) if d > 0 else 0.0
        return F, self.mu * F * math.tanh(v_t / self.v_s) if friction else 0.0, v_t

    def accelerations(
        self, t: float, state: tuple[float, ...], *, v0: float | None = None, friction: bool = True
    ) -> tuple[float, float]:
        """(theta'' [rad/s^2], x'' [m/s^2]); in flight if `v0` is None, else in contact with that latched speed."""
        theta = state[0]
        moment = self.m_rod * self.s * (self.r * self.w**2 * math.sin(self.w * t - theta) - self.g * math.cos(theta))
        force = 0.0
        if v0 is not None:
            F, f, _ = self.contact(t, state, v0, friction)
            ex, ey, _, _ = self.journal(t, state)
            n_x, n_y = ex / math.hypot(ex, ey), ey / math.hypot(ex, ey)
            n_u = n_y * math.cos(theta) - n_x * math.sin(theta)
            t_u = n_x * math.cos(theta) + n_y * math.sin(theta)
            moment -= F * self.l * n_u + f * (self.l * t_u + self.R_pin)
            force = F * n_x - f * n_y
        return moment / (self.J_rod + self.m_rod * self.s**2), force / self.m_slider

    def effective_mass(self, t: float, state: tuple[float, ...]) -> float:
        """Mass the contact feels along its normal [kg]."""
        ex, ey, _, _ = self.journal(t, state)
        eps = math.hypot(ex, ey)
        lever = self.l * (ey * math.cos(state[0]) - ex * math.sin(state[0])) / eps
        return 1 / ((ex / eps) ** 2 / self.m_slider + lever**2 / (self.J_rod + self.m_rod * self.s**2))


class State(NamedTuple):
    """theta [rad] (absolute), x [m] and their rates; unpacks in the order of `SliderCrank.accelerations`."""

    theta: float
    x: float
    dtheta: float
    dx: float


@dataclass(frozen=True)
class Impact:
    """One contact, SI units; `end` is None and the peaks are those so far where the run ends inside it."""

    onset: float
    speed: float
    effective_mass: float
    depth_time: float
    depth: float
    force_time: float
    force: float
    end: float | None
    kind: str


@dataclass(frozen=True)
class Reference:
    """Two revolutions (24 ms) from the start; doubles are the correctly rounded quadruple digits."""

    states: dict[float, State]  # at every millisecond 0.001, 0.002, ..., 0.024
    impacts: tuple[Impact, ...]
    uncertainty: dict[str, float]  # largest relative difference between the two runs, by quantity

    def error(self, t: float, state: tuple[float, ...], mechanism: SliderCrank | None = None) -> float:
        """max(position error/clearance, speed error/(r w)) of (theta, x, theta', x'); angles count times rod length."""
        m = mechanism or SliderCrank()
        off = [abs(a - b) for a, b in zip(state, self.states[t], strict=True)]
        return max(max(m.l * off[0], off[1]) / m.c, max(m.l * off[2], off[3]) / (m.r * m.w))


@cache
def reference(friction: bool) -> Reference:
    """The stored digits, with or without friction."""
    record = json.loads(DATA.read_text())["friction" if friction else "frictionless"]
    states = {float(t): State(*(float(value) for value in row)) for t, row in record["states"].items()}
    impacts = tuple(
        Impact(**{key: value if key == "kind" or value is None else float(value) for key, value in row.items()})
        for row in record["impacts"]
    )
    return Reference(states, impacts, {key: float(value) for key, value in record["uncertainty"].items()})


STATE_FIELDS = State._fields
IMPACT_FIELDS = tuple(Impact.__dataclass_fields__)


def _run(program: Path, tolerance: str, max_step: str, friction: bool) -> list[list[str]]:
    command = [str(program), tolerance, max_step, str(int(friction)), "5e-4", "5000", *TIMES]
    out = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return [line.split("\t") for line in out.splitlines()]


def _rounded(text: str) -> str:
    return f"{Decimal(text):.21e}"


def _record(loose: list[list[str]], tight: list[list[str]]) -> dict[str, object]:
    if [row[0] for row in loose] != [row[0] for row in tight]:
        raise SystemExit("the two runs count different impacts: tighten both tolerances")
    spread: dict[str, Decimal] = {}
    states, impacts = {}, []
    for a, b in zip(loose, tight, strict=True):
        names = ("t", *STATE_FIELDS) if b[0] == "state" else IMPACT_FIELDS
        for name, rough, fine in zip(names, a[1:], b[1:], strict=True):
            if name == "kind":
                if rough != fine:
                    raise SystemExit("the two runs end an impact differently: tighten both tolerances")
            elif Decimal(fine):
                change = abs((Decimal(rough) - Decimal(fine)) / Decimal(fine))
                spread[name] = max(spread.get(name, Decimal(0)), change)
        if b[0] == "state":
            states[f"{Decimal(b[1]):.6f}"] = [_rounded(value) for value in b[2:]]
        else:
            row = {name: text if name == "kind" else _rounded(text) for name, text in zip(names, b[1:], strict=True)}
            if row["kind"] == "unfinished":
                row["end"] = None
            impacts.append(row)
    return {"states": states, "impacts": impacts, "uncertainty": {k: f"{v:.1e}" for k, v in spread.items() if k != "t"}}


def regenerate() -> None:
    """Compile and run the quadruple-precision program and write the data file."""
    compiler = shutil.which("g++")
    if compiler is None:
        raise SystemExit("g++ is needed to regenerate the digits")
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "slider_crank_quad"
        subprocess.run([compiler, "-O2", str(PROGRAM), "-lquadmath", "-o", str(program)], check=True)
        data: dict[str, object] = {
            "source": "slider_crank_quad.cpp, written by `python tests/reference/slider_crank.py`",
            "units": "SI; states are theta, x, theta', x' at t [s]",
            "uncertainty": f"largest relative difference between runs at (tolerance, longest step) = {TOLERANCES}",
        }
        for name, friction in (("frictionless", False), ("friction", True)):
            data[name] = _record(*(_run(program, *pair, friction) for pair in TOLERANCES))
    DATA.write_text(json.dumps(data, indent=1) + "\n")


if __name__ == "__main__":
    regenerate()
