"""Fluid-film laws: Reynolds' equation of a thin isoviscous film; pin and bush, spheres.

Let e be the eccentricity, n the direction of a place in the film, h = c - e.n its thickness, and w the velocity of
the pin's material against the bush's midway between their centres. Seen from there both surfaces roll past at
opposite speeds and carry no net flow along the circumference: wedge and squeeze together are the one rate -w.n at
which the film thins, div(h^3 grad p) = -12 eta w.n. The film carries load where its pressure is above that at its
edges: half the circumference (half-Sommerfeld, Guembel), turning with the motion, and for a pure squeeze the side
that closes.

A law gives the resistance to a unit of w, along and across it, and to a unit of spin, as functions of e/c along w
(`eps_w`) and across (`eps_c`). The direction of the eccentricity does not enter: the laws are smooth through the
centre. Pressure and shear together act as one force midway between the centres, on pin and bush alike, and a couple
against the spin: so the power -F.w + T omega is the whole dissipation of the film, and never negative.
"""

from __future__ import annotations

import sympy as sp

from hertzwerk.derive.expressions.parameter import POSITIVE
from hertzwerk.derive.laws.law import R_2, FilmLaw, L, Quantity, R_eff, dR, eps_c, eps_w, h

eta = Quantity("eta", "Pa s", "dynamic viscosity", POSITIVE)

S = Quantity("S", "1", "1 - eps^2 of the whole eccentricity ratio eps")
q = Quantity("q", "1", "its root")
A = Quantity("A", "1", "weighted angle of the half that bears, pi/2 where the journal only turns")
_THIN = ((S, 1 - eps_w**2 - eps_c**2), (q, sp.sqrt(S)))
_PETROFF = 2 * sp.pi * eta * R_2**3 * L / (dR * q)

short_bearing = FilmLaw(
    name="short_bearing",
    title="Short bearing (Ocvirk), half film, wedge and squeeze",
    parameters=(eta,),
    definitions=(*_THIN, (A, sp.pi / 2 + sp.atan(eps_w / q))),
    along=eta * R_2 * L**3 / dR**3 * (A * (S + 3 * eps_w**2) + 3 * eps_w * q) / (S**2 * q),
    across=eta * R_2 * L**3 / dR**3 * eps_c * (3 * eps_w * A + q * (2 + eps_w**2 / (S + eps_w**2))) / (S**2 * q),
    couple=_PETROFF,
    source="DuBois, Ocvirk, NACA Report 1157 (1953); Booker, J. Basic Eng. 87 (1965) 537; Frene et al., Hydrodynamic Lubrication (1997)",
    grade="A",
    note="Pressure falls parabolically to both ends: for L up to about the radius; by Gümbel's condition as by Reynolds'. The couple is of the whole "
    "circumference. In double precision the drag is exact to 5e-14 at eps = 0.9; while the film opens, where there is little of it, to 2e-11 at 0.99 "
    "and 6e-9 at 0.999.",
    pairs=("pin_in_bush",),
)

short_bearing_full = FilmLaw(
    name="short_bearing_full",
    title="Short bearing (Ocvirk), full film, which pulls where it opens",
    parameters=(eta,),
    definitions=_THIN,
    along=sp.pi * eta * R_2 * L**3 / dR**3 * (S + 3 * eps_w**2) / (S**2 * q),
    across=3 * sp.pi * eta * R_2 * L**3 / dR**3 * eps_w * eps_c / (S**2 * q),
    couple=_PETROFF,
    source="Frene et al., Hydrodynamic Lubrication (1997): both halves of the film of DuBois and Ocvirk (1953)",
    grade="A",
    note="For a film under a pressure around it that keeps it from cavitation.",
    pairs=("pin_in_bush",),
)

# The pressure of a long bearing is found up to a constant, that of its edges: they lie opposite each other, and the middle of the half between them
# is in the direction 2 w + (e.w) e/c^2. There e/c has the components a and b, and w, of length 1, has g and -k.
a = Quantity("a", "1", "eccentricity ratio towards the middle of the half that bears")
b = Quantity("b", "1", "eccentricity ratio across it")
G = Quantity("G", "1", "length of 2 w + (e.w) e/c^2, over that of w")
g = Quantity("g", "1", "squeeze velocity towards that middle, over its length")
k = Quantity("k", "1", "squeeze velocity across it, over its length, backwards")
m = Quantity("m", "1", "flow along the circumference that leaves the pressure periodic, over c w/2")
C_cc = Quantity("C_cc", "1", "integral of cos^2/(h/c)^3 over the half")
C_sc = Quantity("C_sc", "1", "integral of sin cos/(h/c)^3 over the half")
C_ss = Quantity("C_ss", "1", "integral of sin^2/(h/c)^3 over the half")
C_c = Quantity("C_c", "1", "integral of cos/(h/c)^3 over the half")
C_s = Quantity("C_s", "1", "integral of sin/(h/c)^3 over the half")
P = Quantity("P", "1", "force towards the middle of the half")
Q = Quantity("Q", "1", "force across it")
_WIDE = S + a**2  # = 1 - b^2
_LONG = (
    *_THIN,
    (G, sp.sqrt((2 + eps_w**2) ** 2 + (eps_w * eps_c) ** 2)),
    (g, (2 + eps_w**2) / G),
    (k, eps_w * eps_c / G),
    (a, eps_w * (3 - S) / G),
    (b, 2 * eps_c / G),
    (A, sp.pi / 2 + sp.atan(a / q)),
    (m, -3 * eps_c / (3 - S)),
    (C_cc, (A * (S + 3 * a**2) + 3 * a * q) / (S**2 * q)),
    (C_sc, b * (3 * a * A + q * (2 + a**2 / _WIDE)) / (S**2 * q)),
    (C_ss, A * (S + 3 * b**2) / (S**2 * q) + a / (S * _WIDE) * (1 + b**2 * (3 / S + 2 / _WIDE))),
    (C_c, 2 * (a * A / q + 1) / S + a * C_cc + b * C_sc),
    (C_s, 2 * b * (A / q + a / _WIDE) / S + a * C_sc + b * C_ss),
    (P, C_ss * g + C_sc * k + C_s * m),
    (Q, -C_sc * g - C_cc * k - C_c * m),
)

long_bearing = FilmLaw(
    name="long_bearing",
    title="Long bearing (Sommerfeld), half film, wedge and squeeze",
    parameters=(eta,),
    definitions=_LONG,
    along=12 * eta * R_2**3 * L / dR**3 * (P * g - Q * k),
    across=12 * eta * R_2**3 * L / dR**3 * (P * k + Q * g),
    couple=_PETROFF,
    source="Pinkus, Sternlicht, Theory of Hydrodynamic Lubrication (1961); Flores, Lankarani, Ambrosio, Claro, Proc. IMechE K 218 (2004) 183",
    grade="A",
    note="No flow to the ends: for L of four radii and more. Wedge alone is as in the sources. Where wedge and squeeze act together those fit a "
    "factor (k + 3)/(k + 3/2); here the edges of the half are found instead, where the pressure is the same. The couple is of the "
    "whole circumference.",
    pairs=("pin_in_bush",),
)

long_bearing_full = FilmLaw(
    name="long_bearing_full",
    title="Long bearing (Sommerfeld), full film, which pulls where it opens",
    parameters=(eta,),
    definitions=_THIN,
    along=12 * sp.pi * eta * R_2**3 * L / dR**3 * (2 * S + 3 * eps_w**2) / ((3 - S) * S * q),
    across=36 * sp.pi * eta * R_2**3 * L / dR**3 * eps_w * eps_c / ((3 - S) * S * q),
    couple=_PETROFF,
    source="Sommerfeld 1904; Pinkus, Sternlicht, Theory of Hydrodynamic Lubrication (1961)",
    grade="A",
    note="For a film under a pressure around it that keeps it from cavitation. It is also the limit of Reynolds' condition where oil is supplied "
    "at the ends alone: the pressure is raised until the least is that around, slowly: the force is 12 % lower for 32 radii, 6 % for 64.",
    pairs=("pin_in_bush",),
)

sphere_film = FilmLaw(
    name="sphere_film",
    title="Squeeze film of two spheres, or of a sphere and a plane (Reynolds)",
    parameters=(eta,),
    along=6 * sp.pi * eta * R_eff**2 / h,
    forms=("point",),
    source="Reynolds' equation of two paraboloids: Cameron, Basic Lubrication Theory (1976); Cox, Brenner, Chem. Eng. Sci. 22 (1967) 1753",
    grade="A",
    note="Exact as h goes to 0. Before a plane it is 2 % too low at h = R/100, 13 % at R/10, where `brenner` is not.",
    pairs=("sphere_on_plane", "sphere_on_sphere"),
)

_NEAR = R_eff / h  # of a plane the radius of the sphere
brenner = FilmLaw(
    name="brenner",
    title="Drag of a sphere that nears a plane, at any distance (Brenner)",
    parameters=(eta,),
    along=6 * sp.pi * eta * R_eff
    * (1 + _NEAR + sp.log(1 + _NEAR) / 5
       - sp.Rational(28736, 10**6) / (1 + sp.Rational(94, 100) * sp.sqrt(1 / _NEAR) + sp.Rational(115, 1000) / _NEAR)),
    forms=("point",),
    source="Brenner, Chem. Eng. Sci. 16 (1961) 242: a series; fit of ours between its limits, which Cox and Brenner (1967) give",
    grade="A",
    note="Within 8e-4 of the series at every distance. Reynolds' film where h is small, R/h + ln(R/h)/5 + 0.971264; Stokes' drag where it is large.",
    pairs=("sphere_on_plane",),
)  # fmt: skip
