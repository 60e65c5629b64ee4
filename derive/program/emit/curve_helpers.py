"""Helper functions that search along planar curves, added to a generated module that calls them."""

CURVE_HELPERS = {
    "_called": '''def _called(name, inputs, result, slope, shaped):
    """Function that is called, not expanded, with its derivatives: by the last input slope(it, what is found), by others none.

    If _SHAPED they are shaped(all of these), by every input, of the first rows; None by one that only leads to the result.
    These take time, and a run has no use for them.
    """
    *others, last = plain = [ca.SX.sym("i", x.shape) for x in inputs]
    n, names, o = result.numel(), [f"i{k}" for k in range(len(inputs))], ca.SX.sym("o", result.numel())
    blocks = shaped(*plain, o) if _SHAPED else [*(None for _ in others), slope(last, o)]
    slopes = [
        ca.SX(n, x.numel()) if block is None else ca.vertcat(block, ca.SX(n - block.size1(), x.numel()))
        for x, block in zip(plain, blocks, strict=True)
    ]
    slopes = ca.Function(f"jac_{name}", [*plain, o], slopes, [*names, "out_found"], [f"jac_found_{k}" for k in names])
    called = {"never_inline": True, "custom_jacobian": slopes, "enable_forward": False, "enable_reverse": False}
    return ca.Function(name, inputs, [ca.densify(result)], names, ["found"], called)

_SHAPED = False''',
    "_slope_between": '''def _slope_between(pose, found):
    """Derivative of where two curves are nearest by the pose of the first."""
    h, nx, ny, px, py, share, rolling, bend, _, _, own, other, *_ = ca.vertsplit(found)
    x, y, c, s = ca.vertsplit(pose)
    columns = []
    for vx, vy, turn in ((1, 0, 0), (0, 1, 0), (s*(py - y), s*(x - px), -s), (c*(y - py), c*(px - x), c)):
        slide = nx*vy - ny*vx
        normal, foot = bend*slide + (1 - share)*turn, share*slide + rolling*turn
        parameters = own*(slide + h*turn - foot - h*normal), other*foot
        columns.append(ca.vertcat(nx*vx + ny*vy, -ny*normal, nx*normal, -ny*foot, nx*foot, ca.SX(3, 1), *parameters))
    return ca.horzcat(*columns)''',
    "_samples": '''def _samples(curve, data, given):
    """Points of a curve at the parameters of its samples, first all x, then all y."""
    points = [curve(s, *ca.vertsplit(given))[:2] for s in data[-1]]
    return ca.vertcat(*(x for x, _ in points), *(y for _, y in points))''',
    "_drawn": '''def _drawn(curve, data, given):
    """Points of a curve for a picture, at equal steps of its parameter, first all x, then all y."""
    (start, end), copies = data[0], data[4]
    count = 180 if copies == 1 else 8
    points = [curve(start + (end - start)*k/count, *ca.vertsplit(given))[:2] for k in range(count + 1)]
    turns = [(ca.cos(2*ca.pi*k/copies), ca.sin(2*ca.pi*k/copies)) for k in range(copies)] if copies > 1 else [(1, 0)]
    points = [(c*x - s*y, s*x + c*y) for c, s in turns for x, y in points]
    return ca.vertcat(*(x for x, _ in points), *(y for _, y in points))''',
    "_drawn_teeth": '''def _drawn_teeth(curve, data, given, root):
    """Points of teeth for a picture: each flank from its root, followed by its mirror image, first all x, then all y."""
    (start, end), copies = data[0], data[4]
    flank = [curve(start + (end - start)*k/8, *ca.vertsplit(given))[:2] for k in range(9)]
    (x, y), deep = flank[0], root/ca.sqrt(flank[0][0]**2 + flank[0][1]**2)
    flank = [(deep*x, deep*y), *flank]
    tooth = [*flank, *((x, -y) for x, y in flank[::-1])]
    turns = [(ca.cos(2*ca.pi*k/copies), ca.sin(2*ca.pi*k/copies)) for k in range(copies)]
    points = [(c*x - s*y, s*x + c*y) for c, s in turns for x, y in tooth]
    return ca.vertcat(*(x for x, _ in points), *(y for _, y in points))''',
    "_nearest": '''def _nearest(curve, data, samples, given, point):
    """Signed distance of a point from a curve, normal there, curvature of the parallel curve through the point, parameter.

    Newton's method from the nearest sample, and of a curve that is not convex from the nearest in another hollow. A function
    of its own, which is called; its derivatives are the results themselves.
    """
    if curve not in _NEAREST:
        (start, end), closed, hole, tries, _, at = data
        side = -1 if hole else 1
        widest = max(b - a for a, b in zip(at, (*at[1:], at[0] + end - start) if closed else at[1:], strict=False))
        s, at_point, values = ca.SX.sym("s"), ca.SX.sym("point", 2), ca.SX.sym("given", given.numel())

        def refine(count):  # of Newton's method, from a parameter
            found = s
            for k in range(count + 1):
                here = found - (end - start)*ca.floor((found - start)/(end - start)) if closed else found
                x, y, dx, dy, ddx, ddy = curve(here, *ca.vertsplit(values))
                px, py, square = at_point[0] - x, at_point[1] - y, dx**2 + dy**2
                slope = ca.fmax(square - px*ddx - py*ddy, square/1000)
                if k < count:
                    found = here + ca.fmin(ca.fmax((px*dx + py*dy)/slope, -widest), widest)
                    found = found if closed else ca.fmin(ca.fmax(found, start), end)
            speed = ca.sqrt(square)
            nx, ny = side*dy/speed, -side*dx/speed
            h, along = px*nx + py*ny, side*speed/slope
            curvature = side*(dx*ddy - dy*ddx)/(square*speed)
            bend = curvature/(1 + curvature*h)
            apart = ca.sqrt(ca.fmax(px**2 + py**2, 1e-300))
            if not closed:  # beyond an end the end is nearest
                way = px*dx + py*dy
                beyond = ca.logic_or(ca.logic_and(here <= start, way < 0), ca.logic_and(here >= end, way > 0))
                of_end = (px/apart, nx), (py/apart, ny), (apart, h), (1/apart, bend), (0, along)
                nx, ny, h, bend, along = (ca.if_else(beyond, a, b) for a, b in of_end)
            return ca.Function("refined", [s, at_point, values], [ca.vertcat(h, nx, ny, bend, here, along, apart)])

        refined, again = refine(6 if tries > 1 else 5), refine(1)
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

        def slope(_, o):
            t = ca.vertcat(-o[2], o[1])
            return ca.vertcat(o[1:3].T, o[3]*t@t.T, ca.SX(1, 2), o[5]*t.T)

        def shaped(_, values, point, o):
            return None, *(ca.jacobian(again(o[4], point, values)[:5], x) for x in (values, point))

        _NEAREST[curve] = _called("nearest", [table, values, at_point], result[:6], slope, shaped)
    return _NEAREST[curve](samples, given, point)


_NEAREST: "dict[object, ca.Function]" = {}''',
    "_support": '''def _support(curve, data, samples, given, direction):
    """Point of a curve with the least component along a unit direction, radius of curvature and parameter there.

    Newton's method from the least sample. A function of its own, which is called; its derivatives are the results themselves.
    """
    if curve not in _SUPPORT:
        (start, end), closed, *_, at = data
        widest = max(b - a for a, b in zip(at, (*at[1:], at[0] + end - start) if closed else at[1:], strict=False))
        s, along, values = ca.SX.sym("s"), ca.SX.sym("direction", 2), ca.SX.sym("given", given.numel())

        def refine(count):  # of Newton's method, from a parameter
            found = s
            for k in range(count + 1):
                here = found - (end - start)*ca.floor((found - start)/(end - start)) if closed else found
                x, y, dx, dy, ddx, ddy = curve(here, *ca.vertsplit(values))
                square = dx**2 + dy**2
                slope = ca.fmax(ddx*along[0] + ddy*along[1], 1e-6*ca.sqrt(square))
                if k < count:
                    found = here - ca.fmin(ca.fmax((dx*along[0] + dy*along[1])/slope, -widest), widest)
                    found = found if closed else ca.fmin(ca.fmax(found, start), end)
            turned = (dx*along[1] - dy*along[0])/slope
            return ca.Function("refined", [s, along, values], [ca.vertcat(x, y, square/slope, here, turned)])

        refined, again = refine(6), refine(1)
        along, values, table = ca.MX.sym("direction", 2), ca.MX.sym("given", given.numel()), ca.MX.sym("samples", samples.numel())
        d = table[: len(at)]*along[0] + table[len(at) :]*along[1]
        result = refined(ca.MX(ca.DM(at))[ca.find(d <= ca.mmin(d))], along, values)

        def slope(towards, o):
            t = ca.vertcat(-towards[1], towards[0])
            return ca.vertcat(-o[2]*t@t.T, ca.SX(1, 2), o[4]*t.T)

        def shaped(_, values, along, o):
            return None, *(ca.jacobian(again(o[3], along, values)[:4], x) for x in (values, along))

        _SUPPORT[curve] = _called("support", [table, values, along], result, slope, shaped)
    return _SUPPORT[curve](samples, given, direction)


_SUPPORT: "dict[object, ca.Function]" = {}''',
    "_between": '''def _between(first, first_data, second, second_data, samples, other_samples, given, other_given, pose, which=1):
    """Signed distance of two curves, normal out of the second, its foot there, coefficients of their motion, both parameters.

    `pose` is x, y, cosine and sine of the first curve's place against the second's. Newton's method on both parameters, until the
    normals are opposite and in line, or at an end, from the nearest samples: in several hollows where a curve is not convex, and
    at the three copies that face the other curve. Of these the least distance, not deeper than samples are apart, or of copies the
    next in this order, `which`. A function of
    its own, which is called; its derivatives are the results themselves.
    """
    if (first, second, which) not in _BETWEEN:
        curves, rows = (first, second), (first_data, second_data)
        at, place = ca.SX.sym("at", 2), ca.SX.sym("pose", 4)
        values = [ca.SX.sym("given", x.numel()) for x in (given, other_given)]
        steps = [max(b - a for a, b in zip(d[5], (*d[5][1:], d[5][0] + d[0][1] - d[0][0]) if d[1] else d[5][1:], strict=False)) for d in rows]
        one_hollow = rows[0][4] > 1 or rows[0][3] == rows[1][3] == 1

        def refine(count):  # of Newton's method, from two parameters
            ox, oy, c, s = ca.vertsplit(place)
            found = ca.vertsplit(at)

            def ends(i, move):  # whether it stands at an end and would go on
                (start, end), closed = rows[i][:2]
                way = move*speeds[i]
                return 0 if closed else ca.logic_or(ca.logic_and(found[i] <= start, way < 0), ca.logic_and(found[i] >= end, way > 0))

            for k in range(count + 1):
                points, ways, bends, speeds = [], [], [], []
                for i, (curve, ((start, end), closed, hole, *_)) in enumerate(zip(curves, rows, strict=True)):
                    if closed:
                        found[i] = found[i] - (end - start)*ca.floor((found[i] - start)/(end - start))
                    x, y, dx, dy, ddx, ddy = curve(found[i], *ca.vertsplit(values[i]))
                    length, side = ca.sqrt(dx**2 + dy**2), -1 if hole else 1
                    way = side*dx/length, side*dy/length
                    points.append((x, y) if i else (ox + c*x - s*y, oy + s*x + c*y))
                    ways.append(way if i else (c*way[0] - s*way[1], s*way[0] + c*way[1]))
                    bends.append(side*(dx*ddy - dy*ddx)/length**3)
                    speeds.append(side*length)
                (ax, ay), (bx, by) = ways
                wx, wy = points[0][0] - points[1][0], points[0][1] - points[1][1]
                h, under = wx*by - wy*bx, wy*ax - wx*ay  # heights over the second and the first
                along, beside = wx*bx + wy*by, wx*ax + wy*ay
                tilt = ca.atan2(by*ax - bx*ay, -ax*bx - ay*by)
                wide, other = ca.fmax(1 + bends[1]*h, 1e-3), ca.fmax(1 + bends[0]*under, 1e-3)
                bent, least = bends[0]*wide + bends[1], 1e-3*(ca.fabs(bends[0]) + ca.fabs(bends[1])) + 1e-300
                newton, bent = bent > least, ca.fmax(bent, least)  # else each goes to where it is nearest to the other's point
                move = ca.if_else(newton, (bends[1]*along - wide*tilt)/bent, -beside/other)
                one = ends(0, move)
                last = ca.if_else(ca.logic_and(newton, ca.logic_not(one)), (bends[0]*along + tilt)/bent, along/wide)
                two = ends(1, last)
                move = ca.if_else(two, -beside/other, move)
                one = ends(0, move)
                for i, (stands, way) in enumerate(((one, move), (two, last)) if k < count else ()):
                    (start, end), closed = rows[i][:2]
                    found[i] = found[i] + ca.if_else(stands, 0, ca.fmin(ca.fmax(way/speeds[i], -steps[i]), steps[i]))
                    found[i] = found[i] if closed else ca.fmin(ca.fmax(found[i], start), end)
            apart = ca.fmax(ca.sqrt(wx**2 + wy**2), 1e-300)
            result = ca.vertcat(h, by, -bx, bends[0]/bent, (1 + bends[0]*h)/bent, bends[0]*bends[1]/bent)
            result = ca.if_else(one, ca.vertcat(h, by, -bx, 1/wide, h/wide, bends[1]/wide), result)
            result = ca.if_else(two, ca.vertcat(under, -ay, ax, 0, 0, bends[0]/other), result)
            result = ca.if_else(ca.logic_and(one, two), ca.vertcat(apart, wx/apart, wy/apart, 0, 0, 1/apart), result)
            met = ca.logic_or(ca.fabs(tilt) < 1e-3, ca.logic_or(one, two))
            result = ca.vertcat(result[:3], *points[1], result[3:], *found, *(1/speed for speed in speeds), met)
            return ca.Function("refined", [at, place, *values], [ca.densify(result)])

        refined, again = refine(6 if one_hollow else 9), refine(1)

        tables = [ca.MX.sym("samples", x.numel()) for x in (samples, other_samples)]
        values, place = [ca.MX.sym("given", x.numel()) for x in (given, other_given)], ca.MX.sym("pose", 4)
        ox, oy, c, s = ca.vertsplit(place)

        def seen(at, angle, how, place, *values):  # what is found from two parameters, of copies that are turned by angles
            ox, oy, c, s = ca.vertsplit(place)
            cos, sin = ca.cos(angle[1]), ca.sin(angle[1])
            turned = ca.atan2(s, c) + angle[0] - angle[1]
            near = ca.vertcat(cos*ox + sin*oy, cos*oy - sin*ox, ca.cos(turned), ca.sin(turned))
            h, nx, ny, px, py, *rest, met = ca.vertsplit(how(at, near, *values))
            return [h, cos*nx - sin*ny, sin*nx + cos*ny, cos*px - sin*py, sin*px + cos*py, *rest], met

        spread = []
        for table, (_, _, _, _, copies, at), (dx, dy) in zip(tables, rows, ((-c*ox - s*oy, s*ox - c*oy), (ox, oy)), strict=True):
            x, y, m = table[: len(at)], table[len(at) :], len(at)
            turns = ca.MX(0)
            if copies > 1:  # the copy towards the other curve, and its neighbours
                facing = ca.floor((ca.atan2(dy, dx) - ca.atan2(ca.sum1(y), ca.sum1(x)))*copies/(2*ca.pi) + 0.5)
                turned = [facing + j for j in (-1, 0, 1)]
                angles = [2*ca.pi*turn/copies for turn in turned]
                x, y = (
                    ca.vertcat(*(ca.cos(a)*x - ca.sin(a)*y for a in angles)), ca.vertcat(*(ca.sin(a)*x + ca.cos(a)*y for a in angles)),
                )
                turns = ca.vertcat(*(turn for turn in turned for _ in at))
            spread.append((x, y, ca.MX(ca.DM(at*3 if copies > 1 else at)), turns))
        (x, y, parameters, turns), (to_x, to_y, to_parameters, to_turns) = spread
        x, y = ox + c*x - s*y, oy + s*x + c*y

        def nearest(some_x, some_y, at_x, at_y):  # of some points
            apart = (some_x - at_x)**2 + (some_y - at_y)**2
            return ca.find(apart <= ca.mmin(apart))

        n, m, starts = x.numel(), to_x.numel(), []
        if one_hollow:  # to and fro
            count = len(rows[0][5])
            for j in range(n//count):
                here = slice(j*count, (j + 1)*count)
                k = nearest(to_x, to_y, ca.sum1(x[here])/count, ca.sum1(y[here])/count)
                starts.append(j*count + nearest(x[here], y[here], to_x[k], to_y[k]))
        else:
            squares = (ca.repmat(x.T, m, 1) - ca.repmat(to_x, 1, n))**2 + (ca.repmat(y.T, m, 1) - ca.repmat(to_y, 1, n))**2
            d = ca.vertcat(*map(ca.mmin, ca.horzsplit(squares)))
            starts.append(ca.find(d <= ca.mmin(d)))
            before, after = ca.vertcat(d[-1] if rows[0][1] else 1e300, d[:-1]), ca.vertcat(d[1:], d[0] if rows[0][1] else 1e300)
            hollow, least = ca.if_else(ca.logic_and(d <= before, d < after), d, 1e300), ca.mmin(d)
            for _ in range(3):
                hollow = ca.if_else(hollow > least, hollow, 1e300)
                least = ca.mmin(hollow)
                starts.append(ca.find(hollow <= least))
        widest = []
        for table, (*_, at) in zip(tables, rows, strict=True):
            all_x, all_y = table[: len(at)], table[len(at) :]
            widest.append(ca.mmax((all_x[1:] - all_x[:-1])**2 + (all_y[1:] - all_y[:-1])**2))
        deepest = -ca.sqrt(ca.fmin(*widest))
        best = []
        for i in starts:
            j = nearest(to_x, to_y, x[i], y[i])
            angle = [2*ca.pi*turn[k if copies > 1 else 0]/copies for turn, k, copies in ((turns, i, rows[0][4]), (to_turns, j, rows[1][4]))]
            (*result, one, two, own, other), met = seen(ca.vertcat(parameters[i], to_parameters[j]), angle, refined, place, *values)
            along = (
                p + (row[0][1] - row[0][0])*(turn[k] - row[4]*ca.floor(turn[k]/row[4])) if row[4] > 1 else p
                for p, turn, k, row in ((one, turns, i, rows[0]), (two, to_turns, j, rows[1]))
            )
            new = ca.vertcat(*result, *along, own, other, one, two, *angle)
            here = ca.if_else(ca.logic_and(met, new[0] >= deepest), new[0], 1e299)
            for k, (old, least) in enumerate(best):  # in order; equal ones, but for rounding, as they come
                first_ = here < least + 1e-10*deepest
                best[k] = ca.if_else(first_, new, old), ca.if_else(first_, here, least)
                new, here = ca.if_else(first_, old, new), ca.if_else(first_, least, here)
            best = [*best, (new, here)][:which]
        result, least = best[-1]
        if which > 1:  # if there is one
            result = ca.vertcat(ca.if_else(least < 1e290, result[0], ca.fabs(result[0]) - deepest), result[1:])

        def shaped(_, __, first_values, second_values, place, o):
            value, _ = seen(o[12:14], ca.vertsplit(o[14:16]), again, place, first_values, second_values)
            return None, None, *(ca.jacobian(ca.vertcat(*value[:10]), x) for x in (first_values, second_values, place))

        _BETWEEN[first, second, which] = _called("between", [*tables, *values, place], result, _slope_between, shaped)
    return _BETWEEN[first, second, which](samples, other_samples, given, other_given, pose)


_BETWEEN: "dict[object, ca.Function]" = {}''',
}
