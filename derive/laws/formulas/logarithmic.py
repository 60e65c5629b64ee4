"""Logarithmic stiffness laws of line contact, published as d(F) and inverted to explicit forces F(d).

They have the form d = alpha F (ln(B/F) + c). With w = -ln(B/F) - c this is w exp(w) = -d exp(-c)/(alpha B), so F =
-d/(alpha w) on the lower branch w = W_-1 of Lambert's function, up to the turning point dd/dF = 0 at w = -1, d =
alpha B exp(c - 1).
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from hertzwerk.derive.expressions.parameter import POSITIVE, Parameter
from hertzwerk.derive.laws.formulas.stiffness import EFFECTIVE_MODULUS, MATERIALS, REVIEW, E_eff
from hertzwerk.derive.laws.law import R_1, R_2, F, L, Quantity, R_eff, StiffnessLaw, d, dR

alpha = Quantity("alpha", "m/N", "compliance in d = alpha F (ln(B/F) + c)")
B = Quantity("B", "N", "force in d = alpha F (ln(B/F) + c)")
sigma = Quantity("sigma", "1/Pa", "h1 + h2, h = (1 - nu^2)/(pi E)")
c_b = Quantity("c_b", "1", "whole width of the contact, b/sqrt(F R/(L E*))", POSITIVE)

_COMPLIANCE_SUM = (sigma, 1 / (sp.pi * E_eff))


def logarithmic(compliance: sp.Expr, scale: sp.Expr, c: sp.Expr) -> dict[str, Any]:
    """Force, stored energy and reach of d = alpha F (ln(B/F) + c), alpha = `compliance`, B = `scale`."""
    depth = -sp.LambertW(-d * sp.exp(-c) / (alpha * B), -1)  # ln(B/F) + c, from 1 at the turning point upwards
    return {
        "definitions": ((alpha, compliance), (B, scale)),
        "force": d / (alpha * depth),
        "stored": d**2 * (2 * depth - 1) / (4 * alpha * depth**2),
        "reach": alpha * B * sp.exp(c - 1),
        "forms": ("line",),
    }


def _with(*definitions: tuple[Quantity, sp.Expr], law: dict[str, Any]) -> dict[str, Any]:
    """Prepend definitions to those of a law's fields."""
    return {**law, "definitions": (*definitions, *law["definitions"])}


johnson = StiffnessLaw(
    name="johnson",
    title="Johnson, line contact of cylinders",
    parameters=MATERIALS,
    relation=F / (sp.pi * E_eff * L) * (sp.log(4 * sp.pi * E_eff * dR * L / F) - 1),
    **_with(EFFECTIVE_MODULUS, law=logarithmic(1 / (sp.pi * E_eff * L), 4 * sp.pi * E_eff * L * dR, -1)),
    source=f"Johnson, Contact Mechanics (1985); {REVIEW}",
    grade="A",
    note="Explicit: F = (A/e) exp(W_-1(-e d/(4 dR))), A = 4 pi E* L dR, up to d = (4/e^2) dR = 0.5413 dR.",
)

hertz_cylinder = StiffnessLaw(
    name="hertz_cylinder",
    title="Law quoted as Hertz's for cylinders",
    parameters=MATERIALS,
    relation=2 * F / (sp.pi * E_eff * L) * (sp.log(sp.pi * E_eff * dR * L / F) - 1),
    **_with(EFFECTIVE_MODULUS, law=logarithmic(2 / (sp.pi * E_eff * L), sp.pi * E_eff * L * dR, -1)),
    source=f"quoted in {REVIEW}",
    grade="B",
    note="Hertz's theory of line contact leaves the approach open; this is a law of the literature under his name. It is about twice as compliant as "
    "johnson: with E/(1 - nu^2) of one material for E* the same formula is near it.",
)

radzimovsky = StiffnessLaw(
    name="radzimovsky",
    title="Radzimovsky, two cylinders pressed together",
    parameters=(*MATERIALS, c_b),
    defaults=((c_b, Parameter("width_constant", "1", 2.256758334191025, "4/sqrt(pi), of the whole width by Hertz")),),
    relation=F
    / (sp.pi * E_eff * L)
    * (
        sp.Rational(2, 3)
        + sp.log(4 * R_1 / (c_b * sp.sqrt(F * R_eff / (L * E_eff))))
        + sp.log(4 * R_2 / (c_b * sp.sqrt(F * R_eff / (L * E_eff))))
    ),
    **_with(
        EFFECTIVE_MODULUS,
        law=logarithmic(1 / (sp.pi * E_eff * L), 16 * R_1 * R_2 * E_eff * L / (c_b**2 * R_eff), sp.Rational(2, 3)),
    ),
    source=f"Radzimovsky, Univ. Illinois Eng. Exp. Station Bulletin 408 (1953); {REVIEW}",
    grade="B",
    note="b is the whole width of the contact, c_b = 4/sqrt(pi) = 2.257; Roark's 1.60 sqrt(p K_D C_E) is the same, of diameters. In circulation are "
    "Hertz's half-width, 1.128, and 1.6 of radii: the force at 1 um is 15 and 8 % lower. The law is the compression of both cylinders to their "
    "centres under a parabola of pressure over b; johnson takes Hertz's ellipse.",
)


def _goldsmith(m: int, **fields: Any) -> StiffnessLaw:
    return StiffnessLaw(
        parameters=MATERIALS,
        relation=F * sigma / L * (sp.log(L**m / (F * R_eff * sigma)) + 1),
        **_with(EFFECTIVE_MODULUS, _COMPLIANCE_SUM, law=logarithmic(sigma / L, L**m / (R_eff * sigma), 1)),
        source=f"Goldsmith, Impact (1960); {REVIEW}",
        **fields,
    )


goldsmith = _goldsmith(
    1,
    name="goldsmith",
    title="Goldsmith, line contact of cylinders, m = 1 as quoted",
    grade="B",
    verdict="inconsistent",
    repair="goldsmith_m3",
)

goldsmith_m3 = _goldsmith(
    3,
    name="goldsmith_m3",
    grade="A",
    title="Goldsmith, line contact of cylinders, repaired with m = 3",
    note="Then it is the law of Dubowsky and Freudenstein, since 1/R = dR/(R1 R2).",
)

dubowsky_freudenstein = StiffnessLaw(
    name="dubowsky_freudenstein",
    title="Dubowsky and Freudenstein, pin in bush",
    parameters=MATERIALS,
    relation=F * sigma / L * (sp.log(L**3 * dR / (F * R_1 * R_2 * sigma)) + 1),
    **_with(
        EFFECTIVE_MODULUS,
        _COMPLIANCE_SUM,
        law=logarithmic(sigma / L, L**3 * dR / (R_1 * R_2 * sigma), 1),
    ),
    source=f"Dubowsky, Freudenstein, J. Eng. Ind. 93 (1971) 305; {REVIEW}",
    grade="A",
)

esdu_78035 = StiffnessLaw(
    name="esdu_78035",
    title="ESDU 78035, line contact of cylinders",
    parameters=MATERIALS,
    relation=F * sigma / L * (sp.log(4 * L * dR / (F * sigma)) + 1),
    **_with(EFFECTIVE_MODULUS, _COMPLIANCE_SUM, law=logarithmic(sigma / L, 4 * L * dR / sigma, 1)),
    source=f"ESDU 78035, Contact phenomena I (1978); {REVIEW}",
    grade="B",
)
