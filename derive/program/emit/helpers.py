"""Helper functions that CasADi lacks, added to a generated module that calls them."""

from __future__ import annotations

import re
from collections.abc import Iterable

from hertzwerk.derive.program.emit.box_helpers import BOX_HELPERS
from hertzwerk.derive.program.emit.chain_helpers import CHAIN_HELPERS
from hertzwerk.derive.program.emit.curve_helpers import CURVE_HELPERS
from hertzwerk.derive.program.emit.sector_helpers import SECTOR_HELPERS

_NAMES = re.compile(r"(?<!def )\b_\w+")  # but of what is defined there

HELPERS = {
    "_lambert_w_lower": '''def _lambert_w_lower(x):
    """Lower branch of Lambert's W on [-1/e, 0): series at the branch point or at 0, then three steps of 4th order; -1 below.

    Corless, Gonnet, Hare, Jeffrey, Knuth, Adv. Comput. Math. 5 (1996) 329, eqs. 4.19, 4.22; Fritsch, Shafer, Crowley, CACM 16 (1973) 123.
    """
    x = ca.fmax(x, -0.36787944117144233)
    root = ca.sqrt(ca.fmax(2*(1 + 2.718281828459045*x), 0))
    near = -1 - root*(1 + root*(1/3 + root*(11/72 + root*43/540)))
    first = ca.log(-x)
    second = ca.log(-first)
    w = ca.fmin(ca.if_else(x < -0.2, near, first - second + second/first), -1 - 1e-9)
    for _ in range(3):
        z = ca.log(x/w) - w
        y = 1 + w
        q = 2*y*(y + 2*z/3)
        w = ca.fmin(w*(1 + z/y*(q - z)/(q - 2*z)), -1 - 1e-9)
    return w''',
    "_gamma": '''def _gamma(x):
    """Gamma function for x > 0, to about 1e-15: Lanczos's approximation with nine terms.

    Lanczos, J. SIAM Numer. Anal. Ser. B 1 (1964) 86; coefficients by Godfrey (2001).
    """
    series = 0.9999999999998099 + 676.5203681218851/x - 1259.1392167224028/(x + 1) + 771.3234287776531/(x + 2)
    series = series - 176.6150291621406/(x + 3) + 12.507343278686905/(x + 4) - 0.13857109526572012/(x + 5)
    series = series + 9.984369578019572e-6/(x + 6) + 1.5056327351493116e-7/(x + 7)
    return 2.5066282746310002*(x + 6.5)**(x - 0.5)*ca.exp(-x - 6.5)*series''',
    "_spline": '''def _spline(rows, x):
    """Value, slope and curvature of piecewise polynomials, rows (x, c0, ..., c5), at x; beyond their ends, of the tangent there.

    A function of its own, one per table, which is called: it looks its interval up, and an unrolled expression could not.
    """
    if rows not in _SPLINES:
        at = ca.MX.sym("at")
        knots, polynomials = ca.DM([row[0] for row in rows]), ca.DM([row[1:] for row in rows])
        inside = ca.fmin(ca.fmax(at, knots[0]), knots[-1])
        interval = ca.low(knots, inside, {"lookup_mode": "binary"})
        s = inside - ca.MX(knots)[interval]
        c = ca.horzsplit(ca.MX(polynomials)[interval, :])
        slope = c[1] + s*(2*c[2] + s*(3*c[3] + s*(4*c[4] + s*5*c[5])))
        value = c[0] + s*(c[1] + s*(c[2] + s*(c[3] + s*(c[4] + s*c[5])))) + slope*(at - inside)
        curvature = 2*c[2] + s*(6*c[3] + s*(12*c[4] + s*20*c[5]))
        results = [ca.vertcat(value, slope, curvature)]
        _SPLINES[rows] = ca.Function("spline", [at], results, {"never_inline": True})
    return _SPLINES[rows](x)


_SPLINES = {}''',
    **CURVE_HELPERS,
    **CHAIN_HELPERS,
    **BOX_HELPERS,
    **SECTOR_HELPERS,
}


def helpers_in(texts: Iterable[str]) -> list[str]:
    """Texts of the helpers that some texts call, and of those that these call."""
    wanted: set[str] = set()
    pending = [*texts]
    while pending:
        called = HELPERS.keys() & _NAMES.findall(pending.pop())
        pending += [HELPERS[name] for name in called - wanted]
        wanted |= called
    return [text for name, text in HELPERS.items() if name in wanted]
