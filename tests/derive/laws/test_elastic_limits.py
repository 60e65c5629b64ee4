"""Onset of yield: the stress beneath Hertz's pressure on its axis, in closed form, reaches the strength at the stated force."""

import numpy as np
import pytest
import sympy as sp

import hertzwerk.derive as hd
from hertzwerk.derive.laws.elastic_limits import onset_of_yield

E, NU, Y, R, L = 210e9, 0.3, 0.5e9, 0.01, 0.02
MODULUS = E / (2 * (1 - NU**2))
Z = np.linspace(1e-3, 3, 30_000)  # depth over contact radius


def at_a_point():
    """Difference of the principal stresses on the axis over the largest pressure: Johnson (1985), eq. 3.45."""
    along = -1 / (1 + Z**2)
    return (-(1 + NU) * (1 - Z * np.arctan(1 / Z)) - along / 2 - along).max()


def on_a_line():
    """The same beneath a line, Johnson (1985), eq. 4.46."""
    return (1 / np.sqrt(1 + Z**2) - (1 + 2 * Z**2) / np.sqrt(1 + Z**2) + 2 * Z).max()


def force(law, strength=Y):
    steel = hd.Material(sp.Float(E), sp.Float(NU), yield_strength=strength)
    found = onset_of_yield(law(steel, steel), {"R_eff": R, "L": L})
    return None if found is None else float(found)


@pytest.mark.parametrize(
    "law, largest, error", [(hd.laws.hertz_point, at_a_point, 0.008), (hd.laws.johnson, on_a_line, 0.004)]
)
def test_yield_begins_where_the_stress_beneath_the_surface_reaches_the_strength(law, largest, error):
    loaded = force(law)
    if law is hd.laws.hertz_point:
        pressure = (6 * loaded * MODULUS**2 / (np.pi**3 * R**2)) ** (1 / 3)
    else:
        pressure = np.sqrt(loaded * MODULUS / (np.pi * R * L))
    assert pressure * largest() == pytest.approx(Y, rel=error)  # Johnson rounds to 1.60 and 1.67
    assert pressure / Y == pytest.approx(1.60 if law is hd.laws.hertz_point else 1.67, rel=1e-12)


def test_the_softer_material_yields_first_and_none_without_a_strength():
    soft, hard, unknown = (
        hd.Material(sp.Float(E), sp.Float(NU), yield_strength=strength) for strength in (Y, 2 * Y, None)
    )
    of = {"R_eff": R}
    assert onset_of_yield(hd.laws.hertz_point(hard, soft), of) == onset_of_yield(hd.laws.hertz_point(soft, unknown), of)
    assert onset_of_yield(hd.laws.hertz_point(unknown, unknown), of) is None
    assert onset_of_yield(hd.laws.johnson(soft, soft), of) is None  # of no known length
    assert onset_of_yield(hd.laws.persson(soft, soft), {**of, "L": L}) is None  # whose surfaces conform
