"""Helper function of generated modules that shares a direction among the sectors of a circle."""

SECTOR_HELPERS = {
    "_shares": '''def _shares(n, order, x, y):
    """Shares of n sectors, a power of 2, in the direction (x, y) of length 1: smooth, not negative, and 1 in all.

    Jackson's kernel, the fourth power of sin(n a/4)/sin(a/2) by the angle a from a sector's middle: a polynomial of cos(a) whose
    degree is below n, so that its samples have a constant sum. Order 1, 2: derivatives by the direction's angle. Functions of
    vectors, which are called: a loop over the sectors, where scalars would be thousands of operations.
    """
    if n not in _SHARES:
        towards, middles = ca.MX.sym("towards", 2), ca.DM(range(n))*(2*ca.pi/n)
        cosine, sine = ca.cos(middles), ca.sin(middles)
        w, dw = cosine*towards[0] + sine*towards[1], sine*towards[0] - cosine*towards[1]
        value, slope, bend, ddw, half = 1, 0, 0, -w, n//2
        while half > 1:
            f, df, ddf = (1 + w)/2, dw/2, ddw/2
            value, slope, bend = value*f, slope*f + value*df, bend*f + 2*slope*df + value*ddf
            w, dw, ddw, half = 2*w**2 - 1, 4*w*dw, 4*(dw**2 + w*ddw), half//2
        shares = [3/(4 + 8/n**2)*each for each in (value**2, 2*value*slope, 2*(slope**2 + value*bend))]
        _SHARES[n] = [ca.Function("shares", [towards], [each], {"never_inline": True}) for each in shares]
    return _SHARES[n][order](ca.vertcat(x, y))


_SHARES: "dict[int, list[ca.Function]]" = {}''',
}
