"""Velocities of SymPy models that contradict their positions and axes, by the angular velocities that textbooks have."""

import pytest
import sympy as sp
import sympy_models as models
from sympy.physics.mechanics import KanesMethod, Point, ReferenceFrame, RigidBody, dynamicsymbols, inertia

from hertzwerk.derive import InputError, Parameter, Scales, Start, from_sympy
from hertzwerk.runtime import load, simulate

UNITS = {"m": "kg", "l": "m", "r": "m", "J": "kg m^2", "g": "m/s^2", "k": "N/m"}
VALUES = {"m": 0.7, "l": 0.4, "r": 0.25, "J": 0.02, "g": 9.81, "k": 300}
m, l, r, J, g, k = map(sp.Symbol, VALUES)


def taken(kane, origin, units, names="m l g", **given):
    """A model with values for the constants of these names."""
    values = {name: VALUES[name] for name in names.split()}
    return from_sympy(kane, units=UNITS | units, values=values, origin=origin, **given)


def refused(*given, **named):
    """What is refused, by place: as it was set, and what follows."""
    with pytest.raises(InputError) as caught:
        taken(*given, **named)
    return {fault.where: (fault.found, fault.expected) for fault in caught.value.faults}


def conical(turning):
    """PyDy's three-link conical pendulum, with numbers of its own: each link turned by two angles about fixed axes."""
    alpha, beta, omega, delta = (dynamicsymbols(f"{name}:3") for name in ("alpha", "beta", "omega", "delta"))
    frames, joints, bodies, loads = [ReferenceFrame("I")], [Point("O")], [], []
    I, O = frames[0], joints[0]
    O.set_vel(I, 0)
    for i, name in enumerate("ABC"):
        link = ReferenceFrame(name)
        link.orient(frames[-1], "Space", [alpha[i], beta[i], 0], "ZXY")
        frames.append(link)
    for i in range(3):
        turning(frames, i, omega[i], delta[i], beta[i])
    for i, link in enumerate(frames[1:]):
        ends = [joints[-1].locatenew(f"{name}{i}", -part * link.y) for name, part in (("P", l), ("C", l / 2))]
        for end in ends:
            end.v2pt_theory(joints[-1], I, link)
        bodies.append(RigidBody(f"link{i}", ends[1], link, m, (inertia(link, J, J / 9, J), ends[1])))
        loads.append((ends[1], -m * g * I.y))
        joints.append(ends[0])
    rates = [speed - angle.diff() for speed, angle in zip(omega + delta, alpha + beta, strict=True)]
    kane = KanesMethod(I, alpha + beta, omega + delta, kd_eqs=rates)
    kane.kanes_equations(bodies, loads)
    return kane, O, dict.fromkeys(map(str, (f.func for f in alpha + beta)), "rad")


def test_pydys_conical_pendulum_turns_otherwise_than_its_axes_say():
    def as_pydy(frames, i, omega, delta, beta):
        frames[i + 1].set_ang_vel(frames[0], omega * frames[0].z + delta * frames[0].x)

    found = refused(*conical(as_pydy), names="m l g J")
    assert list(found) == [
        f"angular velocity of {link} in I" for link in "ABC"
    ]  # no point, for these follow the frames
    was_set, follows = found["angular velocity of A in I"]
    assert was_set.startswith("delta0(t)*I.x + omega0(t)*I.z,")
    assert follows.startswith("delta0(t)*I.x - omega0(t)*sin(beta0(t))*I.y + omega0(t)*cos(beta0(t))*I.z,")

    def as_its_axes_say(frames, i, omega, delta, beta):
        """Turned by alpha about z first, then by beta about the fixed x: the former axis turns with the latter angle."""
        turns = delta * frames[i].x + omega * (sp.cos(beta) * frames[i].z - sp.sin(beta) * frames[i].y)
        frames[i + 1].set_ang_vel(frames[i], turns)

    assert len(taken(*conical(as_its_axes_say), names="m l g J").bodies) == 3


def test_a_contradiction_that_is_taken_as_given_is_named_wherever_the_model_goes():
    method, at, units, values = models.pendulum()
    A, N = at["A"], method._inertial
    A.set_ang_vel(N, -A.ang_vel_in(N))
    model = from_sympy(method, units=units, values=values, origin=at["O"], kinematics="as given")
    length = model.parameters["l"]
    scales = Scales(length=length, speed=Parameter("pace", "m/s", 1), arm=length)
    loaded = load(model.scene(scales=scales, start=Start(position={"q": Parameter("q0", "rad", 0.5)})))
    ((where, why),) = loaded.module.CONTRADICTIONS
    assert where == "angular velocity of A in N"
    assert why.startswith("- u(t)*N.z, as it was set; it would be u(t)*N.z,")
    assert "AGAINST ITS OWN POSITIONS: angular velocity of A in N" in loaded.module.__doc__
    assert any(where in warning and "as given" in warning for warning in simulate(loaded, duration=0.01).warnings)
    sound, at, units, values = models.pendulum()
    model = from_sympy(sound, units=units, values=values, origin=at["O"], kinematics="as given")
    assert load(model.scene(scales=scales)).module.CONTRADICTIONS == ()
    with pytest.raises(InputError, match="as given"):
        from_sympy(sound, units=units, values=values, kinematics="unchecked")
