"""Limits up to which elastic contact laws hold, where their materials state what those depend on."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import sympy as sp

from hertzwerk.derive.common.hertzian_laws import LINE, POINT
from hertzwerk.derive.laws.formulas.stiffness import EFFECTIVE_MODULUS, MATERIALS
from hertzwerk.derive.laws.formulas.yield_onset import YIELD_PRESSURE, yield_force
from hertzwerk.derive.laws.law import BoundLaw

LINE_YIELD = sp.Rational(167, 100)
"""Largest pressure over yield strength at first yield, by Tresca: Johnson (1985), section 6.1; 1.79 by von Mises."""


def speed_limit(bounds: Iterable[BoundLaw]) -> sp.Expr | None:
    """Approach speed 1e-5 sqrt(E/rho) [m/s] up to which compliant laws hold; None without a known density.

    The least over the materials whose density is known: Johnson's limit of elastic impact, as used by Lankarani &
    Nikravesh (1994).
    """
    materials = dict.fromkeys(m for bound in bounds for m in bound.materials)
    limits = [sp.Float("1e-5") * sp.sqrt(m.youngs_modulus / m.density) for m in materials if m.density is not None]
    return sp.Min(*limits) if limits else None


def onset_of_yield(bound: BoundLaw, geometry: Mapping[str, Any]) -> sp.Expr | None:
    """Normal force [N] at which the softer of two materials begins to yield; None where that is not known.

    geometry    of the pair by name: `R_eff`, and the length `L` of a line

    Point contact: pi^3 R^2 (1.60 Y)^3/(6 E*^2), line contact: pi R L (1.67 Y)^2/E*, Johnson (1985), sections 6.1 and 4.2.
    The least over the materials whose yield strength is known.
    """
    strengths = [m.yield_strength for m in dict.fromkeys(bound.materials) if m.yield_strength is not None]
    needed = {POINT: ("R_eff",), LINE: ("R_eff", "L")}
    needs = next((needs for names, needs in needed.items() if bound.law.name in names), None)
    if not strengths or needs is None or not set(needs) <= {*geometry} or not {*MATERIALS} <= {*bound.binding}:
        return None
    strength, modulus = sp.Min(*strengths), EFFECTIVE_MODULUS[1].xreplace(bound.binding)
    if "L" in needs:
        return sp.pi * geometry["R_eff"] * geometry["L"] * (LINE_YIELD * strength) ** 2 / modulus
    return yield_force(modulus, geometry["R_eff"], YIELD_PRESSURE * strength)
