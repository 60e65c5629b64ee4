"""Depth, force and approach speed at first yield, against Johnson's and Thornton's numbers and Hertz's pressure."""

import sympy as sp
from mpmath import mp, mpf
from pytest import approx

from hertzwerk.derive.laws.formulas.yield_onset import YIELD_PRESSURE, yield_depth, yield_force, yield_speed

MODULUS, RADIUS, STRENGTH, DENSITY = 1.137e11, 0.01, 1.0e9, 7800.0
PRESSURE = 1.6 * STRENGTH


def test_yield_begins_at_the_published_depth_force_and_speed():
    depth, force = float(yield_depth(MODULUS, RADIUS, PRESSURE)), float(yield_force(MODULUS, RADIUS, PRESSURE))
    assert force == approx(4 / 3 * MODULUS * RADIUS**0.5 * depth**1.5, rel=1e-14)  # Hertz
    assert 1.5 * force / (float(sp.pi) * RADIUS * depth) == approx(PRESSURE, rel=1e-14)  # p_0, of a^2 = R d
    # Johnson (1985), 11.5: rho V^2/Y = 26 (Y/E*)^4; Thornton (1997), eq. 33: V = 1.56 sqrt(p^5/(E*^4 rho)).
    mass = 4 / 3 * sp.pi * RADIUS**3 * DENSITY
    speed = float(yield_speed(MODULUS, RADIUS, YIELD_PRESSURE * STRENGTH, mass))
    assert f"{DENSITY * speed**2 / STRENGTH / (STRENGTH / MODULUS) ** 4:.0f}" == "26"
    assert f"{speed / (PRESSURE**5 / (MODULUS**4 * DENSITY)) ** 0.5:.2f}" == "1.56"
    with mp.workdps(20):
        depth = mpf(yield_depth(MODULUS, RADIUS, PRESSURE).evalf(20))
        work = mp.quad(lambda d: mpf(4) / 3 * MODULUS * mp.sqrt(RADIUS) * d**1.5, [0, depth])
        assert float(mp.sqrt(2 * work / 0.03)) == approx(float(yield_speed(MODULUS, RADIUS, PRESSURE, 0.03)), rel=1e-12)


def test_a_material_states_its_yield_strength():
    import hertzwerk.derive as hd

    steel = hd.Material(
        hd.Parameter("E", "GPa", 207), hd.Parameter("nu", "1", 0.3), yield_strength=hd.Parameter("Y", "MPa", 900)
    )
    assert [slot.unit for slot in steel.slots()] == ["Pa", "1", "Pa"]
