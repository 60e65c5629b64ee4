"""Closed forms of a single impact, evaluated by mpmath at 60 digits and returned as floats. SI units throughout.

Law: F = K d^n (1 + h v/v0), v0 the speed of approach at the onset, no other force unless a name says so. Everything
follows from m v dv/dd = -F. With w = v/v0 it separates into

    K d^(n+1)/(n+1) = m v0^2 I(w),   I(w) = integral of s/(1 + h s) ds from w to 1
                                          = (1 - w)/h - ln((1 + h)/(1 + h w))/h^2,

the loading branch being 1 > w > 0 and the unloading one 0 > w > -e_out, where I = 0 again. Depth (w = 0), restitution
and time (dt = -m dv/F) are readings of this one curve.

Sources: the hysteresis form and its energy balance, Hunt & Crossley, J. Appl. Mech. 42 (1975) 440; the implicit
relation between h and the restitution, e.g. Carvalho & Martins, Mech. Mach. Theory 139 (2019) 174; the elastic impact,
Johnson, Contact Mechanics (1985), section 11.4 (duration 2.94 dmax/v0 for n = 3/2). The numbers of
`shared/reference/contact-laws.md` sections 1 and 2 and of `scenarios.md` are compared in test_reference.py.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from mpmath import mp, mpf

DIGITS = 60  # the terms of I cancel like h^2, so h = 1e-9 still leaves 40
Number = float | str  # a str such as "0.9" is that decimal exactly

# h(e) of the laws with m = n, `shared/reference/contact-laws.md` section 1, where each is cited.
FACTORS: dict[str, Callable[[Any], Any]] = {
    "hunt_crossley": lambda e: 3 * (1 - e) / 2, "herbert_mcwhannell": lambda e: 6 * (1 - e) / ((2 * e - 1) ** 2 + 3),
    "lee_wang": lambda e: 3 * (1 - e) / 4, "lankarani_nikravesh": lambda e: 3 * (1 - e**2) / 4, "gonthier": lambda e: (1 - e**2) / e,
    "zhiying_qishao": lambda e: 3 * (1 - e**2) * mp.exp(2 * (1 - e)) / 4, "flores": lambda e: 8 * (1 - e) / (5 * e),
    "gharib_hurmuzlu": lambda e: 1 / e, "hu_guo": lambda e: 3 * (1 - e) / (2 * e),
    "carvalho_martins": lambda e: 3 * (1 - e) * (11 - e) / (2 * (1 + 9 * e)),
}  # fmt: skip


@dataclass(frozen=True)
class Collision:
    """What one impact does: depth [m], peak force [N], duration [s], rebound over approach speed, energy lost [J]."""

    depth: float
    peak_force: float
    duration: float
    restitution: float
    dissipated: float


def factor(law: str, e: Number) -> float:
    """The published h(e) of a law [-]."""
    with mp.workdps(DIGITS):
        return float(FACTORS[law](mpf(e)))


def _root(f: Callable[[Any], Any], low: Any, high: Any) -> Any:
    """The sign change of f from negative at `low` to positive at `high`, by bisection to the working precision."""
    if not f(low) < 0 < f(high):
        raise ValueError("no sign change")
    for _ in range(int(3.4 * mp.dps)):
        middle = (low + high) / 2
        low, high = (middle, high) if f(middle) < 0 else (low, middle)
    return high


def _restitution(h: Any) -> tuple[Any, Any]:
    """Root e_out in (0, 1] of h (1 + e_out) = ln((1 + h)/(1 - h e_out)), and x = -ln(1 - h e_out)."""
    if h < 0:
        raise ValueError("h must not be negative")
    if h == 0:
        return mpf(1), mpf(0)
    x = _root(lambda x: mp.log1p(h) + x - h + mp.expm1(-x), h * mpf(10) ** (-DIGITS // 4), h + 1)
    return -mp.expm1(-x) / h, x


def restitution(h: Number) -> float:
    """Restitution e_out that a factor h really gives, whatever n, K, the masses and the speed."""
    with mp.workdps(DIGITS):
        return float(_restitution(mpf(h))[0])


def exact_factor(e: Number) -> float:
    """The factor h that gives the restitution e exactly: the root of the same relation in h, 0 < e <= 1."""
    with mp.workdps(DIGITS):
        e = mpf(e)
        if not 0 < e <= 1:
            raise ValueError("e must lie in (0, 1]")
        if e == 1:
            return 0.0

        def factor_at(x: Any) -> Any:
            return -mp.expm1(-x) / e

        def imbalance(x: Any) -> Any:  # x = -ln(1 - h e)
            return mp.log1p(factor_at(x)) + x - factor_at(x) * (1 + e)

        return float(factor_at(_root(imbalance, e * (1 - e) / 2, 1 + 1 / e)))


def _loading(h: Any, w: Any) -> Any:
    """I(w) of the module docstring; h = 0 is the elastic limit."""
    if h == 0:
        return (1 - w**2) / 2
    return (1 - w) / h - (mp.log1p(h) - mp.log1p(h * w)) / h**2


def collision(K: Number, n: Number, mass: Number, v0: Number, h: Number = 0.0) -> Collision:
    """Two free bodies of the effective mass `mass` meeting at v0; h = 0 is the elastic impact."""
    with mp.workdps(DIGITS):
        K, n, mass, v0, h = (mpf(value) for value in (K, n, mass, v0, h))
        e, _ = _restitution(h)
        energy = mass * v0**2

        def depth(w: Any) -> Any:
            return ((n + 1) * energy * _loading(h, w) / K) ** (1 / (n + 1))

        def force(w: Any) -> Any:
            return K * depth(w) ** n * (1 + h * w)

        # dF/dt = 0 is n w = h (n + 1) I(w): one root on the loading branch.
        peak = _root(lambda w: n * w - h * (n + 1) * _loading(h, w), mpf(0), mpf(1)) if h else mpf(0)
        return Collision(
            depth=float(depth(mpf(0))), peak_force=float(force(peak)), duration=float(_duration(K, n, mass, v0, h)), restitution=float(e),
            dissipated=float(energy * (1 - e**2) / 2),
        )  # fmt: skip


def _duration(K: Any, n: Any, mass: Any, v0: Any, h: Any) -> Any:
    """Integral of m dv/F over the impact, in y = ln(1 + h v/v0): T = m v0/(h K) times the integral of dy/d^n.

    y falls from ln(1 + h) to 0 (deepest) to -x. With z the distance to the nearer of the outer ends, h^2 I is
    (1 + h)(1 - exp(-z)) - z while loading and z - exp(-x)(exp(z) - 1) while unloading; d^-n is infinite there like
    z^(-n/(n+1)), which z = p^(2n+2) turns into an integrand odd and smooth in p.
    """
    k = n + 1
    if h == 0:
        dmax = (k * mass * v0**2 / (2 * K)) ** (1 / k)
        return dmax / v0 * 2 * mp.sqrt(mp.pi) * mp.gamma(1 + 1 / k) / mp.gamma(mpf(1) / 2 + 1 / k)
    _, x = _restitution(h)

    def branch(length: Any, loading: Callable[[Any], Any]) -> Any:
        def integrand(p: Any) -> Any:
            z = p ** (2 * k)
            d = (k * mass * v0**2 * loading(z) / (K * h**2)) ** (1 / k)
            return 2 * k * p ** (2 * k - 1) / d**n

        return mp.quad(integrand, [0, length ** (1 / (2 * k))])

    down = branch(mp.log1p(h), lambda z: -(1 + h) * mp.expm1(-z) - z)
    up = branch(x, lambda z: z - mp.exp(-x) * mp.expm1(z))
    return mass * v0 / (h * K) * (down + up)


def depth_with_gravity(K: Number, n: Number, mass: Number, v0: Number, g: Number) -> float:
    """Depth of an elastic impact on a plane under gravity: K d^(n+1)/(n+1) = m v0^2/2 + m g d (energy, no losses)."""
    with mp.workdps(DIGITS):
        K, n, mass, v0, g = (mpf(value) for value in (K, n, mass, v0, g))
        free = ((n + 1) * mass * v0**2 / (2 * K)) ** (1 / (n + 1))
        return float(mp.findroot(lambda d: K * d ** (n + 1) / (n + 1) - mass * v0**2 / 2 - mass * g * d, free))


def static_penetration(K: Number, n: Number, mass: Number, g: Number) -> float:
    """Penetration at which the contact carries the weight: (m g/K)^(1/n)."""
    with mp.workdps(DIGITS):
        return float((mpf(mass) * mpf(g) / mpf(K)) ** (1 / mpf(n)))


def drop_speed(height: Number, g: Number) -> float:
    """Speed after a fall from rest: sqrt(2 g height)."""
    with mp.workdps(DIGITS):
        return float(mp.sqrt(2 * mpf(g) * mpf(height)))


@dataclass(frozen=True)
class Bounce:
    """One bounce between two walls: onset [s], approach and rebound speed [m/s], depth [m], duration [s]."""

    onset: float
    approach: float
    rebound: float
    depth: float
    duration: float


def ball_between_walls(
    K: Number, n: Number, mass: Number, v0: Number, h: Number, bounces: int, first_gap: Number, clearance: Number
) -> tuple[Bounce, ...]:
    """Bounces of a ball flying without gravity at v0, `first_gap` [m] from its first wall.

    `clearance` [m] is the free travel from wall to wall. Each bounce starts and ends at zero penetration, multiplies
    the speed by e_out(h) and lasts the time of `collision`; free flight lies between.
    """
    with mp.workdps(DIGITS):
        K, n, mass, speed, h = (mpf(value) for value in (K, n, mass, v0, h))
        e, _ = _restitution(h)
        time = mpf(first_gap) / speed
        rows = []
        for _ in range(bounces):
            depth = ((n + 1) * mass * speed**2 * _loading(h, mpf(0)) / K) ** (1 / (n + 1))
            duration = _duration(K, n, mass, speed, h)
            rows.append(Bounce(*(float(value) for value in (time, speed, e * speed, depth, duration))))
            speed *= e
            time += duration + mpf(clearance) / speed
        return tuple(rows)


def two_spheres(v0: Number, h: Number) -> tuple[float, float]:
    """Speeds after one of two equal spheres moving at v0 meets the other at rest: v0 (1 -/+ e_out)/2 (momentum)."""
    with mp.workdps(DIGITS):
        (e, _), v = _restitution(mpf(h)), mpf(v0)
        return float(v * (1 - e) / 2), float(v * (1 + e) / 2)
