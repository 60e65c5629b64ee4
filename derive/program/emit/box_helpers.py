"""Helper function of generated modules that finds the nearest features of two boxes."""

BOX_HELPERS = {
    "_features": '''def _features(n, slot, pose, *rates):
    """Gap, penetration, normal and point of the nearest of certain features of two boxes; with rates, their rates.

    Of boxes in n dimensions less their rounding. The pose is the vector from the second's middle to the first's, the axes of
    both row by row, half their sizes, and the reach, the sum of both radii; its rates are that vector's and both angular
    velocities, all along the ground's axes. Slots are the corners of the first box, each with its opposite, which never touch
    together, then those of the second, then edges: of the first in four sets of three that share no face, each with those of
    the second. The normal points to the first, the point is its feature's, from the second's middle. Edges that cross penetrate
    no more than they reach beyond, less a twentieth of the reach, within which corners carry; parallel ones cross nowhere.
    Functions of their own, which are called.
    """
    if (n, slot) not in _FEATURES:
        at, v, dv = ca.SX.sym("pose", 22 + 2*n), ca.SX.sym("rate", 9), ca.SX.sym("second_rate", 9)
        one, two = ca.reshape(at[3:12], 3, 3).T, ca.reshape(at[12:21], 3, 3).T
        a, b, reach = at[21 : 21 + n], at[21 + n : 21 + 2*n], at[-1]
        apart, turn = (two.T@at[:3])[:n], (two.T@one)[:n, :n]
        corners, best = 2**(n - 1), 1e300
        if slot < 2*corners:
            corner = ca.DM([1, *(1 - 2*(slot >> k & 1) for k in range(n - 1))])

            def between(sign):
                if slot < corners:
                    point = apart + turn@(sign*corner*a)
                    return point - ca.fmax(ca.fmin(point, b), -b), point
                inside = turn.T@(sign*corner*b - apart)
                w = turn@(ca.fmax(ca.fmin(inside, a), -a) - inside)
                return w, sign*corner*b + w

            w, point = between(ca.if_else(ca.sumsqr(between(1)[0]) < ca.sumsqr(between(-1)[0]), 1, -1))
        else:
            sets = [((0, (0, i, j)), (1, (i*j, 0, -j)), (2, (-i*j, -i, 0))) for i in (1, -1) for j in (1, -1)]
            of_first, of_second = divmod(slot - 2*corners, 4)
            axes = ca.DM.eye(3)

            def crossing(first, second, along, over):
                start, u = apart + turn@(first*a), turn@along
                d, cosine = start - second*b, ca.dot(u, over)
                sine = 1 - cosine**2
                s = (cosine*ca.dot(d, over) - ca.dot(u, d))/ca.fmax(sine, 1e-9)
                t = ca.dot(d, over) + s*cosine
                ends = ca.fmax(ca.fabs(s) - ca.dot(along, a), ca.fabs(t) - ca.dot(over, b)) + reach/20
                return d + s*u - t*over, start + s*u, ca.fmax(ends, reach*(1 - 1e4*sine))

            chosen = ca.SX.zeros(12)
            for k, first in sets[of_first]:
                for m, second in sets[of_second]:
                    these = ca.DM(first), ca.DM(second), axes[:, k], axes[:, m]
                    w, _, beyond = crossing(*these)
                    here = ca.fmax(ca.sqrt(ca.sumsqr(w)) - reach, beyond)
                    chosen, best = ca.if_else(here < best, ca.vertcat(*these), chosen), ca.fmin(here, best)
            w, point, beyond = crossing(*ca.vertsplit(chosen, 3))
        if slot == 0:  # it tells of boxes that overlap deeper than their rounding: no axis parts them
            axes = [*ca.horzsplit(ca.DM.eye(n)), *ca.horzsplit(turn)]
            axes += [ca.cross(ca.DM.eye(3)[:, i], turn[:, j]) for i in range(3) for j in range(3)] if n == 3 else []
            reaches = [ca.dot(ca.fabs(axis), b) + ca.dot(ca.fabs(turn.T@axis), a) for axis in axes]
            parted = [ca.fabs(ca.dot(axis, apart)) > far for axis, far in zip(axes, reaches, strict=True)]
            w = ca.if_else(ca.sum1(ca.vertcat(*parted)) > 0, w, 0)
        square = ca.sumsqr(w)
        length = ca.sqrt(ca.fmax(square, 1e-18*reach**2))
        gap, depth = (square - reach**2)/(2*reach), reach - length
        if slot >= 2*corners:
            gap = ca.fmax(-depth, beyond)
            depth = -gap
        found = ca.vertcat(gap, depth, two[:, :n]@w/length, two[:, :n]@point)
        turns = [ca.vec((ca.skew(w)@axes).T) for w, axes in ((v[3:6], one), (v[6:], two))]
        moves = ca.vertcat(v[:3], *turns, ca.SX.zeros(2*n + 1))
        rate = ca.jtimes(found, at, moves)
        second_rate = ca.jtimes(rate, ca.vertcat(at, v), ca.vertcat(moves, dv))
        results = zip(((at,), (at, v), (at, v, dv)), (found, rate, second_rate), strict=True)
        _FEATURES[n, slot] = [
            ca.Function("features", list(given), [ca.densify(value)], {"never_inline": True}) for given, value in results
        ]
    return _FEATURES[n, slot][len(rates)](pose, *rates)


_FEATURES: "dict[tuple[int, int], list[ca.Function]]" = {}''',
}
