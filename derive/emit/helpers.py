"""Helper functions that CasADi lacks, added to a generated module that calls them."""

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
    "_samples": '''def _samples(curve, data, given):
    """Points of a curve at the parameters of its samples, first all x, then all y."""
    points = [curve(s, *ca.vertsplit(given))[:2] for s in data[-1]]
    return ca.vertcat(*(x for x, _ in points), *(y for _, y in points))''',
    "_drawn": '''def _drawn(curve, data, given):
    """Points of a curve for a picture, at equal steps of its parameter, first all x, then all y."""
    start, end = data[0]
    points = [curve(start + (end - start)*k/180, *ca.vertsplit(given))[:2] for k in range(181)]
    return ca.vertcat(*(x for x, _ in points), *(y for _, y in points))''',
    "_nearest": '''def _nearest(curve, data, samples, given, point):
    """Signed distance of a point from a curve, normal there, curvature of the parallel curve through the point, parameter.

    Newton's method from the nearest sample, and of a curve that is not convex from the nearest in another hollow. A function
    of its own, which is called; its derivatives are the results themselves.
    """
    if curve not in _NEAREST:
        (start, end), closed, hole, tries, at = data
        side = -1 if hole else 1
        widest = max(b - a for a, b in zip(at, (*at[1:], at[0] + end - start) if closed else at[1:], strict=False))
        s, at_point, values = ca.SX.sym("s"), ca.SX.sym("point", 2), ca.SX.sym("given", given.numel())
        found = s
        for k in range(7):
            here = found - (end - start)*ca.floor((found - start)/(end - start)) if closed else found
            x, y, dx, dy, ddx, ddy = curve(here, *ca.vertsplit(values))
            px, py, square = at_point[0] - x, at_point[1] - y, dx**2 + dy**2
            slope = ca.fmax(square - px*ddx - py*ddy, square/1000)
            if k < 6:
                found = here + ca.fmin(ca.fmax((px*dx + py*dy)/slope, -widest), widest)
                found = found if closed else ca.fmin(ca.fmax(found, start), end)
        speed = ca.sqrt(square)
        nx, ny = side*dy/speed, -side*dx/speed
        h = px*nx + py*ny
        curvature = side*(dx*ddy - dy*ddx)/(square*speed)
        bend = curvature/(1 + curvature*h)
        apart = ca.sqrt(px**2 + py**2)
        if not closed:  # beyond an end the end is nearest
            way = px*dx + py*dy
            beyond = ca.logic_or(ca.logic_and(here <= start, way < 0), ca.logic_and(here >= end, way > 0))
            nx, ny, h, bend = (ca.if_else(beyond, a, b) for a, b in ((px/apart, nx), (py/apart, ny), (apart, h), (1/apart, bend)))
        refined = ca.Function("refined", [s, at_point, values], [ca.vertcat(h, nx, ny, bend, here, apart)])
        at_point, values, table = ca.MX.sym("point", 2), ca.MX.sym("given", given.numel()), ca.MX.sym("samples", samples.numel())
        d = (table[: len(at)] - at_point[0])**2 + (table[len(at) :] - at_point[1])**2
        parameters, least = ca.MX(ca.DM(at)), ca.mmin(d)
        result = refined(parameters[ca.find(d <= least)], at_point, values)
        if tries > 1:
            before = ca.vertcat(d[-1] if closed else 1e300, d[:-1])
            after = ca.vertcat(d[1:], d[0] if closed else 1e300)
            hollow = ca.if_else(ca.logic_and(d <= before, d < after), ca.if_else(d > least, d, 1e300), 1e300)
            other = refined(parameters[ca.find(hollow <= ca.mmin(hollow))], at_point, values)
            result = ca.if_else(other[-1] < result[-1], other, result)
        o = ca.SX.sym("o", 5)
        n, t, empty = ca.vertcat(o[1], o[2]), ca.vertcat(-o[2], o[1]), ca.SX(5, samples.numel())
        by_point = ca.vertcat(n.T, o[3]*t@t.T, ca.SX(2, 2))
        inputs = [table, values, at_point]
        slopes = ca.Function(
            "jac_nearest", [*(ca.SX.sym("i", x.shape) for x in inputs), o], [empty, ca.SX(5, given.numel()), by_point],
            ["samples", "given", "point", "out_found"], ["jac_found_samples", "jac_found_given", "jac_found_point"],
        )
        called = {"never_inline": True, "custom_jacobian": slopes, "enable_forward": False, "enable_reverse": False}
        _NEAREST[curve] = ca.Function("nearest", inputs, [result[:5]], ["samples", "given", "point"], ["found"], called)
    return _NEAREST[curve](samples, given, point)


_NEAREST: "dict[object, ca.Function]" = {}''',
    "_support": '''def _support(curve, data, samples, given, direction):
    """Point of a curve with the least component along a unit direction, radius of curvature and parameter there.

    Newton's method from the least sample. A function of its own, which is called; its derivatives are the results themselves.
    """
    if curve not in _SUPPORT:
        (start, end), closed, _, _, at = data
        widest = max(b - a for a, b in zip(at, (*at[1:], at[0] + end - start) if closed else at[1:], strict=False))
        s, along, values = ca.SX.sym("s"), ca.SX.sym("direction", 2), ca.SX.sym("given", given.numel())
        found = s
        for k in range(7):
            here = found - (end - start)*ca.floor((found - start)/(end - start)) if closed else found
            x, y, dx, dy, ddx, ddy = curve(here, *ca.vertsplit(values))
            square = dx**2 + dy**2
            slope = ca.fmax(ddx*along[0] + ddy*along[1], 1e-6*ca.sqrt(square))
            if k < 6:
                found = here - ca.fmin(ca.fmax((dx*along[0] + dy*along[1])/slope, -widest), widest)
                found = found if closed else ca.fmin(ca.fmax(found, start), end)
        refined = ca.Function("refined", [s, along, values], [ca.vertcat(x, y, square/slope, here)])
        along, values, table = ca.MX.sym("direction", 2), ca.MX.sym("given", given.numel()), ca.MX.sym("samples", samples.numel())
        d = table[: len(at)]*along[0] + table[len(at) :]*along[1]
        result = refined(ca.MX(ca.DM(at))[ca.find(d <= ca.mmin(d))], along, values)
        o, towards = ca.SX.sym("o", 4), ca.SX.sym("i", 2)
        t = ca.vertcat(-towards[1], towards[0])
        inputs = [table, values, along]
        slopes = ca.Function(
            "jac_support", [*(ca.SX.sym("i", x.shape) for x in inputs[:2]), towards, o],
            [ca.SX(4, samples.numel()), ca.SX(4, given.numel()), ca.vertcat(-o[2]*t@t.T, ca.SX(2, 2))],
            ["samples", "given", "direction", "out_found"], ["jac_found_samples", "jac_found_given", "jac_found_direction"],
        )
        called = {"never_inline": True, "custom_jacobian": slopes, "enable_forward": False, "enable_reverse": False}
        _SUPPORT[curve] = ca.Function("support", inputs, [result], ["samples", "given", "direction"], ["found"], called)
    return _SUPPORT[curve](samples, given, direction)


_SUPPORT: "dict[object, ca.Function]" = {}''',
    "_samples_of_chain": '''def _samples_of_chain(pieces, data, given):
    """Pieces of a chain of arcs and lines: start x, y, end x, y, centre x, y of each."""
    return ca.vertcat(*pieces(*ca.vertsplit(given)))''',
    "_drawn_of_chain": '''def _drawn_of_chain(pieces, data, given):
    """Points of a chain of arcs and lines for a picture, first all x, then all y."""
    values, (closed, _, turns) = pieces(*ca.vertsplit(given)), data
    points = []
    for k, turn in enumerate(turns):
        ax, ay, bx, by, cx, cy = values[6*k : 6*k + 6]
        ux, uy, vx, vy = ax - cx, ay - cy, bx - cx, by - cy
        angle = ca.atan2(turn*(ux*vy - uy*vx), ux*vx + uy*vy)
        angle = turn*(angle + 2*ca.pi*(angle <= 0))
        for j in range(25 if turn else 1):
            c, s = ca.cos(angle*j/25), ca.sin(angle*j/25)
            points.append((cx + ux*c - uy*s, cy + ux*s + uy*c) if turn else (ax, ay))
    points.append(values[-4:-2] if not closed else points[0])
    return ca.vertcat(*(x for x, _ in points), *(y for _, y in points))''',
    "_nearest_of_chain": '''def _nearest_of_chain(pieces, data, samples, given, point):
    """Signed distance of a point from a chain of arcs and lines, as of a curve; its parameter is the piece and the part of it.

    The least of the distances of all pieces, where the point is beside them, and of all corners, each in closed form. A
    function of its own, which is called; its derivatives are the results themselves.
    """
    if pieces not in _NEAREST_OF_CHAIN:
        closed, hole, turns = data
        side, count = -1 if hole else 1, len(turns)
        rows, values, p = ca.SX.sym("samples", 6*count), ca.SX.sym("given", given.numel()), ca.SX.sym("point", 2)
        found, ends = [], []
        for k, turn in enumerate(turns):
            a, b, c = rows[6*k : 6*k + 2], rows[6*k + 2 : 6*k + 4], rows[6*k + 4 : 6*k + 6]
            if turn:
                u, v, w = a - c, b - c, p - c
                radius, away = ca.sqrt(u[0]**2 + u[1]**2), ca.sqrt(w[0]**2 + w[1]**2)
                whole, part = (turn*ca.atan2(u[0]*x[1] - u[1]*x[0], u[0]*x[0] + u[1]*x[1]) for x in (v, w))
                share = (part + 2*ca.pi*(part < 0))/(whole + 2*ca.pi*(whole <= 0))
                least = ca.fmax(away, 1e-12*radius)
                found.append((share <= 1, turn*side*(away - radius), turn*side*w/least, turn*side/least, k + share))
                ends.append((turn*u/radius, turn*v/radius))
            else:
                way, w = b - a, p - a
                length = ca.sqrt(way[0]**2 + way[1]**2)
                n = ca.vertcat(way[1], -way[0])/length
                share = (w[0]*way[0] + w[1]*way[1])/length**2
                beside = ca.logic_and(share >= 0, share <= 1)
                found.append((beside, side*(w[0]*n[0] + w[1]*n[1]), side*n, 0, k + share))
                ends.append((n, n))
        for k in range(count + (not closed)):
            corner = rows[6*k : 6*k + 2] if k < count else rows[-4:-2]
            w = p - corner
            away = ca.sqrt(w[0]**2 + w[1]**2)
            least = ca.fmax(away, 1e-300)
            sign = 1
            if closed or 0 < k < count:  # outside by the sum of both normals
                n = ends[k - 1][1] + ends[k][0]
                sign = ca.if_else(side*(w[0]*n[0] + w[1]*n[1]) < 0, -1, 1)
            found.append((1, sign*away, sign*w/least, sign/least, k))
        best, result = 1e300, ca.SX.zeros(5)
        for beside, h, n, bend, s in found:
            here = ca.if_else(beside, ca.fabs(h), 1e300)
            result = ca.if_else(here < best, ca.vertcat(h, n, bend, s), result)
            best = ca.fmin(here, best)
        o = ca.SX.sym("o", 5)
        n, t = ca.vertcat(o[1], o[2]), ca.vertcat(-o[2], o[1])
        inputs = [rows, values, p]
        slopes = ca.Function(
            "jac_nearest", [*(ca.SX.sym("i", x.shape) for x in inputs), o],
            [ca.SX(5, rows.numel()), ca.SX(5, given.numel()), ca.vertcat(n.T, o[3]*t@t.T, ca.SX(2, 2))],
            ["samples", "given", "point", "out_found"], ["jac_found_samples", "jac_found_given", "jac_found_point"],
        )
        called = {"never_inline": True, "custom_jacobian": slopes, "enable_forward": False, "enable_reverse": False}
        _NEAREST_OF_CHAIN[pieces] = ca.Function("nearest", inputs, [ca.densify(result)], ["samples", "given", "point"], ["found"], called)
    return _NEAREST_OF_CHAIN[pieces](samples, given, point)


_NEAREST_OF_CHAIN: "dict[object, ca.Function]" = {}''',
    "_support_of_chain": '''def _support_of_chain(pieces, data, samples, given, direction):
    """Point of a chain of arcs and lines with the least component along a unit direction, as of a curve.

    Of an arc to the left that faces it, or a corner. A function of its own, which is called; its derivatives are the results.
    """
    if pieces not in _SUPPORT_OF_CHAIN:
        closed, _, turns = data
        count = len(turns)
        rows, values, m = ca.SX.sym("samples", 6*count), ca.SX.sym("given", given.numel()), ca.SX.sym("direction", 2)
        best, result = 1e300, ca.SX.zeros(4)
        for k in range(count + (not closed)):
            corner = rows[6*k : 6*k + 2] if k < count else rows[-4:-2]
            found = [(corner, 0, 1, k)]
            if k < count and turns[k] > 0:
                a, b, c = rows[6*k : 6*k + 2], rows[6*k + 2 : 6*k + 4], rows[6*k + 4 : 6*k + 6]
                u, v = a - c, b - c
                whole, part = (ca.atan2(u[0]*x[1] - u[1]*x[0], u[0]*x[0] + u[1]*x[1]) for x in (v, -m))
                share = (part + 2*ca.pi*(part < 0))/(whole + 2*ca.pi*(whole <= 0))
                radius = ca.sqrt(u[0]**2 + u[1]**2)
                found.append((c - radius*m, radius, share <= 1, k + share))
            for foot, radius, faces, s in found:
                here = ca.if_else(faces, foot[0]*m[0] + foot[1]*m[1], 1e300)
                result = ca.if_else(here < best, ca.vertcat(foot, radius, s), result)
                best = ca.fmin(here, best)
        o, towards = ca.SX.sym("o", 4), ca.SX.sym("i", 2)
        t = ca.vertcat(-towards[1], towards[0])
        inputs = [rows, values, m]
        slopes = ca.Function(
            "jac_support", [*(ca.SX.sym("i", x.shape) for x in inputs[:2]), towards, o],
            [ca.SX(4, rows.numel()), ca.SX(4, given.numel()), ca.vertcat(-o[2]*t@t.T, ca.SX(2, 2))],
            ["samples", "given", "direction", "out_found"], ["jac_found_samples", "jac_found_given", "jac_found_direction"],
        )
        called = {"never_inline": True, "custom_jacobian": slopes, "enable_forward": False, "enable_reverse": False}
        _SUPPORT_OF_CHAIN[pieces] = ca.Function("support", inputs, [ca.densify(result)], ["samples", "given", "direction"], ["found"], called)
    return _SUPPORT_OF_CHAIN[pieces](samples, given, direction)


_SUPPORT_OF_CHAIN: "dict[object, ca.Function]" = {}''',
}
