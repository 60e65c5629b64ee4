"""A pair of surfaces in a tree of bodies: declared, and its contact force by hand, for tests of virtual work."""

from functools import cache

import numpy as np
import pytest
from derived import Derived, energy_balance
from kane import complex_step, rows

from hertzwerk.derive import GROUND, Contact, Friction, Parameter, PinInBush, SphereOnPlane, SphereOnSphere, X, Y, Z
from hertzwerk.derive.laws import flores, power, smooth_coulomb

K, E, MU, VS, V0 = 2e3, 0.6, 0.3, 0.4, 1.7


class Touching:
    """A pair in a tree: its hertzwerk declaration, and its geometry by hand."""

    def __init__(self, kind, tree, first, second, axis="+Z", sizes=(0.4, 0.3)):
        self.kind, self.tree, self.first, self.second, self.sizes = kind, tree, first, second, sizes
        self.axis = np.eye(3)["XYZ".index(axis[1])] * (1 if axis[0] == "+" else -1)
        one, two = (
            (GROUND if body < 0 else tree.bodies[body]).at(
                *(Parameter(f"{what}_{k}", "m", v) if v else 0 for k, v in zip("xyz", local, strict=True))
            )
            for what, (body, local) in (("first", first), ("second", second))
        )
        direction = {"X": X, "Y": Y, "Z": Z}[axis[1]] if axis[0] == "+" else -{"X": X, "Y": Y, "Z": Z}[axis[1]]
        big, small = Parameter("big", "m", sizes[0]), Parameter("small", "m", sizes[1])
        self.pair = self.declared(one, two, direction, big, small)

    def declared(self, one, two, direction, big, small):
        return {
            "sphere_on_plane": lambda: SphereOnPlane("touch", one, big, two, direction),
            "sphere_on_sphere": lambda: SphereOnSphere("touch", one, two, big, small),
            "pin_in_bush": lambda: PinInBush("touch", one, two, direction, big, small),
        }[self.kind]()

    @cache  # noqa: B019  # a dozen module-level objects
    def derive(self, friction):
        contact = Contact("touch", power(Parameter("K", "N/m^1.5", K), 1.5), flores(Parameter("restitution", "1", E)))
        rub = Friction("rub", "touch", smooth_coulomb(Parameter("mu", "1", MU), Parameter("v_s", "m/s", VS)))
        return Derived(self.tree.scene(contact, *([rub] if friction else []), pairs=[self.pair]))

    def geometry(self, q):
        """Penetration, unit vector that pushes the first body, contact point, at all coordinates q."""
        a, b = self.tree.point(*self.first, q), self.tree.point(*self.second, q)
        along = self.tree.pose(self.second[0], q)[1] @ self.axis
        big, small = self.sizes
        if self.kind == "sphere_on_plane":
            return big - along @ (a - b), along, a - big * along
        e = a - b
        if self.kind == "pin_in_bush":
            e = e - (e @ along) * along
            distance = np.sqrt(e @ e)
            return distance - small, -e / distance, a + (big - small) * e / distance
        distance = np.sqrt(e @ e)
        return big + small - distance, e / distance, a - big * e / distance

    def event(self, q):
        """The gap as it is declared to be: exact where it is small, of round pairs (e.e - reach^2)/(2 reach)."""
        depth, (big, small) = self.geometry(q)[0], self.sizes
        if self.kind == "sphere_on_sphere":
            return -depth + depth**2 / (2 * (big + small))
        return -depth - depth**2 / (2 * small) if self.kind in ("pin_in_bush", "ball_in_socket") else -depth

    def by_hand(self, q, u, friction):
        """Generalised forces on all joints, normal force, sliding speed, dissipated powers (normal, friction)."""
        depth, normal, point = self.geometry(q)
        assert depth > 0
        turning = self.tree.rates(q)
        rate = complex_step(lambda x: self.geometry(x)[0], q) @ turning @ u
        elastic = K * depth**1.5
        force = elastic * (1 + 8 * (1 - E) / (5 * E) * rate / V0)
        jacobian = np.zeros((3, q.size))  # of the coordinates first, then of the speeds
        for sign, body in ((1, self.first[0]), (-1, self.second[0])):
            origin, turn = self.tree.pose(body, q)
            local = turn.T @ (point - origin)
            jacobian += sign * complex_step(lambda x, body=body, local=local: self.tree.point(body, local, x), q)
        jacobian = jacobian @ turning
        slip = jacobian @ u
        slip = slip - (slip @ normal) * normal
        speed = np.sqrt(slip @ slip)
        drag = MU * force * np.tanh(speed / VS) if friction else 0.0
        total = jacobian.T @ (force * normal - drag * slip / speed)
        return total, force, speed, ((force - elastic) * rate, drag * speed)

    def check_forces(self, friction):
        """The derived forces do the virtual work of those by hand, dissipate as much, and keep the energy."""
        derived = self.derive(friction)
        for t, q, u in self.states(derived):
            f, dz, normal_force, sliding, in_range = derived.call("contact_touch", t=t, q=q, u=u, m=[V0])
            full = self.tree.whole(t, q, speeds=False), self.tree.whole(t, u, speeds=True)
            total, force, speed, powers = self.by_hand(*full, friction)
            assert normal_force == pytest.approx([force], rel=1e-10)
            assert f == pytest.approx(rows(self.tree, total), rel=1e-9, abs=1e-10 * np.max(np.abs(total)))
            assert np.abs(sliding) == pytest.approx([speed] if friction else [], rel=1e-10)
            power = dict(zip([entry for entry, _ in derived.MEMORY], dz, strict=True))
            assert power["touch.dissipated"] == pytest.approx(powers[0], rel=1e-9)
            if friction:
                assert power["rub.dissipated"] == pytest.approx(powers[1], rel=1e-9)
            assert in_range == [1]
            assert energy_balance(derived, t, q, u, f, 0.0, dz) < 1e-12

    def states(self, derived, count=3):
        """Random states in contact: (t, q, u)."""
        rng = np.random.default_rng(5)
        for _ in range(count):
            t = rng.uniform(0, 1)
            q = derived.with_gap(t, rng.uniform(-1, 1, derived.nq), 0, -0.2 * min(self.sizes))
            yield t, q, rng.uniform(-1, 1, derived.nu)
