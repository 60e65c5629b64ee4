"""Accelerations of a robot in 50 digits, from the data of Pinocchio's model: by the Newton-Euler recursion and a full mass matrix.

Used by `compare_robots.py --exact`: two programs in double precision differ by the rounding of both, and this says by
whose. Joints that turn or slide about any axis, and a free base.
"""

import numpy as np
from mpmath import mp, mpf

DIGITS = 50
ZERO = [mpf(0)] * 3


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plus(*vectors):
    return [sum(parts) for parts in zip(*vectors, strict=True)]


def times(scale, vector):
    return [scale * part for part in vector]


def rotated(R, v):
    return [sum(R[i][k] * v[k] for k in range(3)) for i in range(3)]


def back(R, v):
    return [sum(R[k][i] * v[k] for k in range(3)) for i in range(3)]


def product(A, B):
    return [[sum(A[i][k] * B[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def rotation(axis, c, s):
    """Matrix of Rodrigues, from cosine and sine of the angle."""
    x, y, z = axis
    skew = [[0, -z, y], [z, 0, -x], [-y, x, 0]]
    return [[(c if i == k else 0) + axis[i] * axis[k] * (1 - c) + s * skew[i][k] for k in range(3)] for i in range(3)]


def of_quaternion(x, y, z, w):
    n = mp.sqrt(x * x + y * y + z * z + w * w)
    half = mp.sqrt(x * x + y * y + z * z) / n
    axis = [each / (n * half) for each in (x, y, z)] if half else [mpf(1), mpf(0), mpf(0)]
    return rotation(axis, 1 - 2 * half**2, 2 * half * w / n)


class Exact:
    """A model's accelerations; with a generator of random numbers its data are altered by their last digit."""

    def __init__(self, model, random=None):
        mp.dps = DIGITS
        self.model, self.number = (
            model,
            mpf if random is None else lambda x: mpf(x) * (1 + int(random.choice([-1, 1])) * mpf(2) ** -53),
        )
        of = lambda values: [self.number(float(x)) for x in values]  # noqa: E731
        self.places = [([of(row) for row in p.rotation], of(p.translation)) for p in model.jointPlacements]
        self.bodies = [
            (self.number(float(y.mass)), of(y.lever), [of(row) for row in y.inertia]) for y in model.inertias
        ]
        self.up = [-x for x in of(model.gravity.linear)]
        self.axes = [None, *map(self._axis, list(model.joints)[1:])]

    @staticmethod
    def _axis(joint):
        """Whether a joint turns, and its axis; None for a free base."""
        if joint.nv == 6:
            return None
        data, q = joint.createData(), [1.0] + [0.0] * (joint.nq - 1)
        joint.calc(data, np.array(q), np.array([1.0]))
        column = [mpf(float(x)) for x in np.ravel(data.S)]
        turns = any(column[3:])
        axis = column[3:] if turns else column[:3]
        return turns, times(1 / mp.sqrt(sum(x * x for x in axis)), axis)

    def _relative(self, i, q):
        """Axes and place of a joint in those of its parent."""
        (R, t), joint = self.places[i], self.model.joints[i]
        own = [self.number(float(x)) for x in q[joint.idx_q : joint.idx_q + joint.nq]]
        if joint.nv == 6:
            return product(R, of_quaternion(*own[3:])), plus(t, rotated(R, own[:3]))
        turns, axis = self.axes[i]
        if not turns:
            return R, plus(t, rotated(R, times(own[0], axis)))
        c, s = own if joint.nq == 2 else (mp.cos(own[0]), mp.sin(own[0]))
        return product(R, rotation(axis, c, s)), t

    def _forces(self, relative, v, a, up):
        """Generalised forces of a motion: out along the chain, and back."""
        model, n = self.model, self.model.njoints
        w, e, lin = [ZERO] * n, [ZERO] * n, [up] * n
        for i in range(1, n):
            (R, t), p, joint = relative[i], model.parents[i], model.joints[i]
            k = joint.idx_v
            w[i], e[i] = back(R, w[p]), back(R, e[p])
            lin[i] = back(R, plus(lin[p], cross(e[p], t), cross(w[p], cross(w[p], t))))
            if joint.nv == 6:
                w[i], e[i] = v[k + 3 : k + 6], a[k + 3 : k + 6]
                lin[i] = plus(lin[i], a[k : k + 3], cross(w[i], v[k : k + 3]))
                continue
            turns, axis = self.axes[i]
            rate, gain = times(v[k], axis), times(a[k], axis)
            if turns:
                e[i], w[i] = plus(e[i], gain, cross(w[i], rate)), plus(w[i], rate)
            else:
                lin[i] = plus(lin[i], gain, times(2, cross(w[i], rate)))
        force, moment, tau = [ZERO] * n, [ZERO] * n, [mpf(0)] * model.nv
        for i in range(n - 1, 0, -1):
            (mass, c, inertia), (R, t), joint = self.bodies[i], relative[i], model.joints[i]
            own = times(mass, plus(lin[i], cross(e[i], c), cross(w[i], cross(w[i], c))))
            force[i] = plus(force[i], own)
            spin = cross(w[i], rotated(inertia, w[i]))
            moment[i] = plus(moment[i], rotated(inertia, e[i]), spin, cross(c, own))
            k, p = joint.idx_v, model.parents[i]
            if joint.nv == 6:
                tau[k : k + 6] = [*force[i], *moment[i]]
            else:
                turns, axis = self.axes[i]
                tau[k] = sum(x * y for x, y in zip(axis, moment[i] if turns else force[i], strict=True))
            passed = rotated(R, force[i])
            force[p], moment[p] = plus(force[p], passed), plus(moment[p], rotated(R, moment[i]), cross(t, passed))
        return tau

    def accelerations(self, q, v):
        """Accelerations under gravity alone, rounded at the end."""
        n = self.model.nv
        relative = [None, *(self._relative(i, q) for i in range(1, self.model.njoints))]
        rest, still = [self.number(float(x)) for x in v], [mpf(0)] * n
        unit = [[mpf(int(i == k)) for i in range(n)] for k in range(n)]
        columns = [self._forces(relative, still, each, ZERO) for each in unit]
        forces = self._forces(relative, rest, still, self.up)
        return [float(x) for x in mp.lu_solve(mp.matrix(columns).T, -mp.matrix(forces))]
