"""Helper functions that search along chains of arcs and lines, for generated modules."""

CHAIN_HELPERS = {
    "_samples_of_chain": '''def _samples_of_chain(pieces, data, given):
    """Twelve lengths of each piece of a chain of arcs and lines.

    Its start, end and centre, x and y of each; the way along a line, or from an arc's centre to its middle; the least part along that
    of its points; length of a line, radius of an arc; a way out of the corner at its start.
    """
    values, (closed, _, turns), rows, ends = pieces(*ca.vertsplit(given)), data, [], []
    for k, turn in enumerate(turns):
        ax, ay, bx, by, cx, cy = values[6*k : 6*k + 6]
        ux, uy, vx, vy = ax - cx, ay - cy, bx - cx, by - cy
        if turn:
            whole, size = turn*ca.atan2(ux*vy - uy*vx, ux*vx + uy*vy), ca.sqrt(ux**2 + uy**2)
            half = turn*(whole + 2*ca.pi*(whole <= 0))/2
            way, least = (ux*ca.cos(half) - uy*ca.sin(half), ux*ca.sin(half) + uy*ca.cos(half)), size*(ca.cos(half) - 1e-14)
            ends.append(((turn*ux/size, turn*uy/size), (turn*vx/size, turn*vy/size)))
        else:
            way, least, size = (vx, vy), 0, ca.sqrt(vx**2 + vy**2)
            ends.append(((vy/size, -vx/size),)*2)
        rows.append([ax, ay, bx, by, cx, cy, *way, least, size])
    for k, row in enumerate(rows):
        (mx, my), (nx, ny) = ends[k - 1][1] if k or closed else (0, 0), ends[k][0]
        row += [row[9]*(mx + nx), row[9]*(my + ny)]
    return ca.vertcat(*(x for row in rows for x in row))''',
    "_drawn_of_chain": '''def _drawn_of_chain(pieces, data, given):
    """Points of a chain of arcs and lines for a picture, first all x, then all y."""
    values, (closed, _, turns) = pieces(*ca.vertsplit(given)), data
    points, steps = [], max(25, 150//max(sum(map(abs, turns)), 1))
    for k, turn in enumerate(turns):
        ax, ay, bx, by, cx, cy = values[6*k : 6*k + 6]
        ux, uy, vx, vy = ax - cx, ay - cy, bx - cx, by - cy
        angle = ca.atan2(turn*(ux*vy - uy*vx), ux*vx + uy*vy)
        angle = turn*(angle + 2*ca.pi*(angle <= 0))
        for j in range(steps if turn else 1):
            c, s = ca.cos(angle*j/steps), ca.sin(angle*j/steps)
            points.append((cx + ux*c - uy*s, cy + ux*s + uy*c) if turn else (ax, ay))
    points.append(values[-4:-2] if not closed else points[0])
    return ca.vertcat(*(x for x, _ in points), *(y for _, y in points))''',
    "_heights_of_chain": '''def _heights_of_chain(data, rows, p):
    """Of each piece of a chain, then of each corner: whether a point is beside it, its signed distance, its normal there times a length, that.

    The solid of a corner is on the side of both pieces' normals; the end of an open chain has none.
    """
    closed, hole, turns = data
    side, found, count = -1 if hole else 1, [], len(turns)
    for k, turn in enumerate(turns):
        a, c, m, least, size = (rows[12*k + i : 12*k + j] for i, j in ((0, 2), (4, 6), (6, 8), (8, 9), (9, 10)))
        w = p - (c if turn else a)
        away, along, across = ca.sqrt(w[0]**2 + w[1]**2), w[0]*m[0] + w[1]*m[1], w[0]*m[1] - w[1]*m[0]
        if turn:
            found.append((along >= away*least, turn*side*(away - size), turn*side*w, away))
        else:
            found.append((ca.logic_and(along >= 0, along <= size**2), side*across/size, side*ca.vertcat(m[1], -m[0]), size))
    for k in range(count + (not closed)):
        w = p - (rows[12*k : 12*k + 2] if k < count else rows[-10:-8])
        away, sign = ca.sqrt(w[0]**2 + w[1]**2), 1
        if closed or 0 < k < count:
            sign = 1 - 2*(side*(w[0]*rows[12*k + 10] + w[1]*rows[12*k + 11]) < 0)
        found.append((1, sign*away, sign*w, away))
    return found''',
    "_on_chain": '''def _on_chain(pieces, data):
    """Function of a chain's rows, of one of its pieces or corners, and of a point beside it: what is found of the nearest."""
    if pieces not in _ON_CHAIN:
        closed, hole, turns = data
        side, count = -1 if hole else 1, len(turns)
        row, turn, corner, last, p = (ca.SX.sym("x", n) for n in (12, 1, 1, 1, 2))
        a, b, c, m, size, out = (row[i:j] for i, j in ((0, 2), (2, 4), (4, 6), (6, 8), (9, 10), (10, 12)))
        v = p - ca.if_else(last, b, a)
        sign = 1 - 2*ca.logic_and(side*(v[0]*out[0] + v[1]*out[1]) < 0, ca.logic_not(last))
        away = sign*ca.sqrt(v[0]**2 + v[1]**2)
        least = sign*ca.fmax(ca.fabs(away), 1e-300)
        of_corner = ca.vertcat(away, v/least, 1/least, 0, 0)
        w = p - a
        n = ca.vertcat(m[1], -m[0])/size
        of_line = ca.vertcat(side*(w[0]*n[0] + w[1]*n[1]), side*n, 0, (w[0]*m[0] + w[1]*m[1])/size**2, side/size)
        u, w, away = a - c, p - c, ca.sqrt((p[0] - c[0])**2 + (p[1] - c[1])**2)
        whole, part = (turn*ca.atan2(u[0]*x[1] - u[1]*x[0], u[0]*x[0] + u[1]*x[1]) for x in (b - c, w))
        whole, least, way = whole + 2*ca.pi*(whole <= 0), ca.fmax(away, 1e-12*size), turn*side
        share = ca.fmin((part + 2*ca.pi*(part < 0))/whole, 1)
        of_arc = ca.vertcat(way*(away - size), way*w/least, way/least, share, side/(least*whole))
        found = ca.if_else(corner, of_corner, ca.if_else(turn, of_arc, of_line))
        one = ca.Function("one", [row, turn, corner, last, p], [ca.densify(found)])
        rows, feature, p = ca.MX.sym("rows", 12*count), ca.MX.sym("feature"), ca.MX.sym("p", 2)
        piece = feature - count*(feature >= count)
        at = ca.fmin(piece, count - 1)
        open_end = 0 if closed else ca.logic_or(feature == count, feature == 2*count)
        found = one(ca.reshape(rows, 12, count)[:, at], ca.MX(ca.DM(turns))[at], feature >= count, piece == count, p)
        if not closed:  # its ends have no normals
            sign = ca.if_else(open_end, ca.sign(found[0]), 1)
            found = ca.vertcat(sign*found[0], sign*found[1], sign*found[2], sign*found[3], found[4:])
        found = ca.vertcat(found[:4], found[4] + piece, found[5])
        _ON_CHAIN[pieces] = ca.Function("on_chain", [rows, feature, p], [found])
    return _ON_CHAIN[pieces]


_ON_CHAIN: "dict[object, ca.Function]" = {}''',
    "_nearest_of_chain": '''def _nearest_of_chain(pieces, data, samples, given, point):
    """Signed distance of a point from a chain of arcs and lines, as of a curve; its parameter is the piece and the part of it.

    The least of the distances of all pieces, where the point is beside them, and of all corners, each in closed form. A
    function of its own, which is called; its derivatives are the results themselves.
    """
    if pieces not in _NEAREST_OF_CHAIN:
        rows, p = ca.SX.sym("samples", samples.numel()), ca.SX.sym("point", 2)
        far = (ca.if_else(beside, ca.fabs(h), 1e300) for beside, h, *_ in _heights_of_chain(data, rows, p))
        heights = ca.Function("heights", [rows, p], [ca.vertcat(*far)])
        rows, values, p = (ca.MX.sym("x", x.numel()) for x in (samples, given, point))
        far = heights(rows, p)
        result = _on_chain(pieces, data)(rows, ca.find(far <= ca.mmin(far)), p)

        def slope(_, o):
            t = ca.vertcat(-o[2], o[1])
            return ca.vertcat(o[1:3].T, o[3]*t@t.T, ca.SX(1, 2), o[5]*t.T)

        again = ca.Function("again", [rows, p], [result[:5]], {"never_inline": True})

        def shaped(rows, _, p, __):
            return ca.jacobian(again(rows, p), rows), None, ca.jacobian(again(rows, p), p)

        _NEAREST_OF_CHAIN[pieces] = _called("nearest", [rows, values, p], result, slope, shaped)
    return _NEAREST_OF_CHAIN[pieces](samples, given, point)


_NEAREST_OF_CHAIN: "dict[object, ca.Function]" = {}''',
    "_support_of_chain": '''def _support_of_chain(pieces, data, samples, given, direction):
    """Point of a chain of arcs and lines with the least component along a unit direction, as of a curve.

    Of an arc to the left that faces it, or a corner. A function of its own, which is called; its derivatives are the results.
    """
    if pieces not in _SUPPORT_OF_CHAIN:
        closed, _, turns = data
        rows, values, m = ca.SX.sym("samples", samples.numel()), ca.SX.sym("given", given.numel()), ca.SX.sym("direction", 2)
        points = [(rows[12*k : 12*k + 2], 0, 1, k, 0) for k in range(len(turns))]
        points += [] if closed else [(rows[-10:-8], 0, 1, len(turns), 0)]
        for k, turn in enumerate(turns):
            if turn > 0:
                a, b, c, way, least, radius = (rows[12*k + i : 12*k + j] for i, j in ((0, 2), (2, 4), (4, 6), (6, 8), (8, 9), (9, 10)))
                u, v = a - c, b - c
                whole, part = (ca.atan2(u[0]*x[1] - u[1]*x[0], u[0]*x[0] + u[1]*x[1]) for x in (v, -m))
                whole += 2*ca.pi*(whole <= 0)
                share = (part + 2*ca.pi*(part < 0))/whole
                points.append((c - radius*m, radius, -way[0]*m[0] - way[1]*m[1] >= least, k + share, 1/whole))
        best, result = 1e300, ca.SX.zeros(5)
        for foot, radius, faces, s, turned in points:
            here = ca.if_else(faces, foot[0]*m[0] + foot[1]*m[1], 1e300)
            result = ca.if_else(here < best, ca.vertcat(foot, radius, s, turned), result)
            best = ca.fmin(here, best)

        def slope(towards, o):
            t = ca.vertcat(-towards[1], towards[0])
            return ca.vertcat(-o[2]*t@t.T, ca.SX(1, 2), o[4]*t.T)

        again = ca.Function("again", [rows, m], [result[:4]])

        def shaped(rows, _, m, __):
            return ca.jacobian(again(rows, m), rows), None, ca.jacobian(again(rows, m), m)

        _SUPPORT_OF_CHAIN[pieces] = _called("support", [rows, values, m], result, slope, shaped)
    return _SUPPORT_OF_CHAIN[pieces](samples, given, direction)


_SUPPORT_OF_CHAIN: "dict[object, ca.Function]" = {}''',
    "_seen_from_chain": '''def _seen_from_chain(chain, data, rows, other, other_data, other_rows, pose, points, counted):
    """Where corners and round arcs of a chain, which is at a pose against another, are nearest to that.

    `points` are the numbers of the corners and arcs that count, `counted` those of the other that count elsewhere. A corner is as
    far as the nearest piece or corner. An arc is as far as its centre, less the radius, from what it faces, and which it has
    entered by no more than half of how thick that is; of a corner that counts elsewhere it says nothing, as near another corner
    that is less deep. A vector: distance; normal out of the other, distance of the centre,
    curvature of the other's parallel curve through it; the centre and the radius in its chain; both parameters, and their change
    along either.
    """
    (corners, arcs, _), count, other_count = points, len(data[2]), len(other_data[2])
    deep = -counted[2]*sum(ca.vertsplit(other_rows)[9::12])
    o, p, m, bound = (ca.SX.sym("x", n) for n in (other_rows.numel(), 2, 2, 3))  # bound: least part along m, radius, depth

    def to_arc():  # distances of what the arc faces
        for k, (beside, h, n, size) in enumerate(_heights_of_chain(other_data, o, p)):
            if k not in counted[1] and k - other_count not in counted[0]:
                faces = ca.logic_and(-n[0]*m[0] - n[1]*m[1] >= size*bound[0], h > ca.fmax(bound[1] + bound[2], 0))
                yield ca.if_else(ca.logic_and(beside, faces), h, 1e300)
            else:
                yield ca.SX(1e300)

    near = [(ca.if_else(beside, h, 1e300), h) for beside, h, *_ in _heights_of_chain(other_data, o, p)]
    of_corner = ca.Function("of_corner", [o, p], [ca.vertcat(*(ca.fabs(h) for h, _ in near))])
    of_arc = ca.Function("of_arc", [o, p, m, bound], [ca.vertcat(*to_arc())])
    out, within = 1e300, 1e300
    for h, _ in near:
        out, within = ca.fmin(out, ca.if_else(h < 0, 1e300, h)), ca.fmin(within, ca.if_else(h < 0, -h, 1e300))
    corner = ca.Function("corner", [o, p], [ca.if_else(within < out, -within, out)])
    arc = ca.Function("arc", [o, p, m, bound], [ca.mmin(of_arc(o, p, m, bound)) - bound[1]])

    x, y, c, s = ca.vertsplit(pose)
    turn = ca.vertcat(ca.horzcat(c, -s), ca.horzcat(s, c))

    def placed(v):
        return turn@v + ca.vertcat(x, y)

    columns = [ca.vertcat(rows[12*k : 12*k + 2] if k < count else rows[-10:-8], ca.MX.zeros(4)) for k in corners]
    columns += [rows[12*k + 4 : 12*k + 10] for k in arcs]
    far = [corner(other_rows, placed(column[:2])) for column in columns[: len(corners)]]
    far += [arc(other_rows, placed(row[:2]), turn@row[2:4], ca.vertcat(row[4:], deep)) for row in columns[len(corners) :]]
    far = ca.vertcat(*far)
    chosen = ca.find(far <= ca.mmin(far))
    column, number = ca.horzcat(*columns)[:, chosen], ca.MX(ca.DM([*corners, *arcs]))[chosen]
    p, round_ = placed(column[:2]), chosen >= len(corners)
    near = of_corner(other_rows, p)
    if arcs:
        near = ca.if_else(round_, of_arc(other_rows, p, turn@column[2:4], ca.vertcat(column[4:], deep)), near)
    h, nx, ny, bend, at, along = ca.vertsplit(_on_chain(other, other_data)(other_rows, ca.find(near <= ca.mmin(near)), p))
    own = ca.vertcat(number, 0)
    if arcs:
        foot = column[:2] - column[5]*(turn.T@ca.vertcat(nx, ny))
        own = ca.if_else(round_, _on_chain(chain, data)(rows, number, foot)[4:], own)
    gap = h - column[5]
    gap = ca.if_else(ca.mmin(far) < 1e290, gap, ca.fabs(gap))
    return ca.vertcat(gap, nx, ny, h, bend, column[:2], column[5], own[0], at, own[1], along/ca.if_else(along == 0, 1, 1 - h*bend))''',
    "_between_of_chain": '''def _between_of_chain(first, data, second, other_data, samples, others, given, other_given, pose, points, other_points):
    """Signed distance of two chains of arcs and lines, and what else is found between two curves, in closed form.

    The least distance from the other chain of the corners and round arcs of both that count; no more than half of how thick the
    other's solid is, is an arc within it. A function of its own, which is called; its derivatives are the results themselves.
    """
    key = first, second, points, other_points
    if key not in _BETWEEN_OF_CHAIN:
        rows, other_rows, *values, place = (ca.MX.sym("x", x.numel()) for x in (samples, others, given, other_given, pose))
        x, y, c, s = ca.vertsplit(place)
        found = []
        if points[0] or points[1]:
            h, nx, ny, far, bend, px, py, radius, *parameters = ca.vertsplit(
                _seen_from_chain(first, data, rows, second, other_data, other_rows, place, points, (other_points[0], (), other_points[2]))
            )
            px, py, share = x + c*px - s*py - far*nx, y + s*px + c*py - far*ny, 1 - far*bend
            found.append(ca.vertcat(h, nx, ny, px, py, share, far*share, bend, *parameters))
        if other_points[0] or other_points[1]:
            back = ca.vertcat(-c*x - s*y, s*x - c*y, c, -s)
            h, nx, ny, far, bend, px, py, radius, two, one, other, own = ca.vertsplit(
                _seen_from_chain(second, other_data, other_rows, first, data, rows, back, other_points, points)
            )
            nx, ny, share = s*ny - c*nx, -s*nx - c*ny, radius*bend
            found.append(ca.vertcat(h, nx, ny, px + radius*nx, py + radius*ny, share, radius*(1 - share), bend, one, two, own, other))
        result = found[0] if len(found) == 1 else ca.if_else(found[0][0] <= found[1][0], *found)

        again = ca.Function("again", [rows, other_rows, place], [result[:10]], {"never_inline": True})

        def shaped(rows, other_rows, _, __, place, ___):
            first, second, moved = (ca.jacobian(again(rows, other_rows, place), x) for x in (rows, other_rows, place))
            return first, second, None, None, moved

        _BETWEEN_OF_CHAIN[key] = _called("between", [rows, other_rows, *values, place], result, _slope_between, shaped)
    return _BETWEEN_OF_CHAIN[key](samples, others, given, other_given, pose)


_BETWEEN_OF_CHAIN: "dict[object, ca.Function]" = {}''',
}
