"""Absolute coordinates against joint coordinates: the same mechanism, at random states, moves, stores and is driven in the same way."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
import sympy as sp
from derived import Derived, rate_along
from kane import TURNED, Tree, chain, line, link

import hertzwerk.derive as hd
from hertzwerk.derive.equations.derivation import derivation_of
from hertzwerk.derive.equations.module.equation_system import System
from hertzwerk.derive.equations.motion import equations_of_motion
from hertzwerk.derive.equations.motion.absolute_coordinates import absolute
from hertzwerk.derive.laws import smooth_coulomb
from hertzwerk.derive.scenes.slider_crank import scene as slider_crank

P = hd.Parameter
K, REST, D, MU, V, R, N, F = (
    P(*row) for row in (("k_turn", "N m/rad", 3.0), ("rest", "rad", 0.3), ("d_turn", "N m s/rad", 0.7), ("mu", "1", 0.2), ("v_s", "m/s", 0.1),
                        ("journal", "m", 0.03), ("load", "N", 40.0), ("push", "N", 5.0))
)  # fmt: skip
KS, DS, FREQUENCY, SWING = (
    P("k_slide", "N/m", 20.0), P("d_slide", "N s/m", 0.4), P("frequency", "1/s", 3.0), P("swing", "rad", 0.6),
)  # fmt: skip


def names(tree: Tree) -> list[str]:
    return [joint.name for joint in tree.scene().mechanism.joints]


def loaded(tree: Tree, *effects) -> hd.Scene:
    """A scene of the tree with more effects."""
    scene = tree.scene()
    return replace(scene, effects=(*scene.effects, *effects))


def hung(*bodies: tuple[hd.Body, hd.Direction, tuple], name: str = "hung", last: tuple = ()) -> hd.Scene:
    """A chain under gravity: each body on a hinge about an axis at a point of the one before."""
    joints, before = [], hd.GROUND
    for body, axis, place in bodies:
        joints.append(hd.Revolute(f"at_{body.name}", before.at(*place), body, axis=axis))
        before = body
    effects = (hd.Gravity("gravity", P("g", "m/s^2", 9.81), -hd.Y), hd.EnergyLedger())
    return hd.Scene(hd.Mechanism(name, (*joints, *last)), effects, hd.Scales(LENGTH, P("pace", "m/s", 1.0), LENGTH))


LENGTH, MASS, ACROSS = P("reach", "m", 0.7), P("mass", "kg", 1.3), P("J_across", "kg m^2", 0.04)
ORIGIN, ALONG_X, ALONG_Y = (0, 0, 0), (LENGTH, 0, 0), (0, LENGTH, 0)
HALF_X, HALF_Y = (LENGTH / 2, 0, 0), (0, LENGTH / 2, 0)


def bobs(n: int) -> hd.Scene:
    """Points with a mass on strings that stay straight."""
    return hung(
        *((hd.Body(f"bob{i}", MASS, centre=ALONG_X), hd.Z, ALONG_X if i else ORIGIN) for i in range(n)), name="bobs"
    )


def rods() -> hd.Scene:
    """Slender rods and, between two of them, a cross without any mass."""
    one, two = (
        hd.Body("one", MASS, (0, ACROSS, ACROSS), centre=HALF_X),
        hd.Body("two", MASS, (ACROSS, 0, ACROSS), centre=HALF_Y),
    )
    cross, three = hd.Body("cross", 0), hd.Body("three", MASS, (0, ACROSS, ACROSS), centre=HALF_X)
    return hung((one, hd.Z, ORIGIN), (two, hd.X, ALONG_X), (cross, hd.Z, ALONG_Y), (three, hd.Y, ORIGIN), name="rods")


PLANE = Tree(
    (
        link("R", "+Z", -1, 1, plane=True), link("P", "-X", 0, 2, plane=True, turned=(("+Z", 0.4), ("-Z", 0.7))),
        link("R", "-Z", 1, 3, plane=True, turned=(("-Z", 0.3), None)), link("L", "+Z", 0, 4, plane=True), link("R", "+Z", 2, 5, plane=True),
    )
)  # fmt: skip
A, B, C, D_, E = names(PLANE)
TURN = hd.coordinate_of(C)
SCENES = {
    "plane": PLANE.scene(),
    "plane, across X": line("R+X", "P+Y", "R-X").scene(),
    "plane, with springs, friction, forces": loaded(
        PLANE,
        hd.JointSpring("torsion", C, K, REST),
        hd.JointSpring("axial", B, KS),
        hd.JointDamper("oil", C, D),
        hd.JointDamper("drag", B, DS),
        hd.JointFriction("rub", C, smooth_coulomb(MU, V), N, R),
        hd.JointForce("push_it", B, F * sp.cos(hd.coordinate_of(A)) - DS * hd.speed_of(B)),
        hd.Potential("stored", K * (1 - sp.cos(TURN - hd.coordinate_of(E)))),
        hd.JointSpring("sideways", f"{D_}.x", KS),
    ),
    "plane, driven at the ground": loaded(PLANE, hd.ConstantSpeed("motor", A, P("motor_pace", "rad/s", 2.0))),
    "plane, driven within": loaded(PLANE, hd.Drive("motor", C, position=SWING * sp.sin(FREQUENCY * hd.T)), hd.JointDamper("oil", C, D)),
    "plane, a driven slide": loaded(PLANE, hd.Drive("press", B, position=P("stroke", "m", 0.2) * sp.sin(FREQUENCY * hd.T))),
    "plane, integrated drive": loaded(
        PLANE, hd.Drive("motor", C, speed=P("motor_pace", "rad/s", 2.0) * sp.cos(FREQUENCY * hd.T), start=REST)
    ),
    "spatial": line("R+Z", "P-X", "C+Y", "S", "U+X", "R-Y").scene(),
    "turned points": line("R+Z", "U+Y", "C-X", second="+X", turned=TURNED).scene(),
    "free, with a tail": line("F", "R+Y", "S").scene(),
    "points with a mass": bobs(3),
    "slender rods and a cross without mass": rods(),
    "welded": line("R+Y", "W", "R+X").scene(),
    "spatial, driven within": loaded(
        line("R+Z", "R+X", "C+Y"),
        hd.Drive("motor", names(line("R+Z", "R+X", "C+Y"))[1], position=SWING * sp.sin(FREQUENCY * hd.T)),
        hd.JointDamper("oil", names(line("R+Z", "R+X", "C+Y"))[1], D),
        hd.JointSpring("axial", f"{names(line('R+Z', 'R+X', 'C+Y'))[2]}.travel", KS),
    ),
}  # fmt: skip


def both(scene: hd.Scene) -> tuple[Derived, Derived]:
    return Derived(scene), Derived(scene.with_coordinates("absolute"))


def joints_state(tree: Derived, seed: int = 0):
    """A random state by the joints."""
    rng = np.random.default_rng(seed)
    q, u = rng.uniform(-1, 1, tree.nq), rng.uniform(-2, 2, tree.nu)
    for i in getattr(tree, "QUATERNIONS", ()) if "QUATERNIONS" in tree.names else ():
        q[i : i + 4] /= np.linalg.norm(q[i : i + 4])
    return q, u


def state(tree: Derived, absolute: Derived, seed: int = 0):
    """A random state by the joints, and the same by the bodies."""
    q, u = joints_state(tree, seed)
    return q, u, *absolute.call("placed", t=0.3, joints=q, joint_speeds=u)


VARIED = {  # others like them are in CI
    *("plane, across X", "plane, driven at the ground", "plane, a driven slide", "plane, integrated drive"),
    *("points with a mass", "welded", "spatial, driven within"),
}


@pytest.fixture(
    scope="module", params=[pytest.param(name, marks=[pytest.mark.exhaustive] * (name in VARIED)) for name in SCENES]
)
def pair(request):
    return both(SCENES[request.param])


@pytest.mark.by_turns(3)
def test_bodies_are_placed_where_the_joints_put_them(pair):
    tree, absolute = pair
    q, _, Q, U = state(*pair)
    for actual, expected in zip(absolute.call("poses", t=0.3, q=Q), tree.call("poses", t=0.3, q=q), strict=True):
        assert actual == pytest.approx(expected, abs=1e-13)
    phi, rate = absolute.call("constraints", t=0.3, q=Q, u=U)
    assert np.max(np.abs(phi)) < 1e-13
    assert np.max(np.abs(rate)) < 1e-12


@pytest.mark.by_turns(6)
def test_motion_energy_and_drives_are_the_same(pair):
    """Accelerations of the bodies: the rates of their speeds as the joints have them, by derivatives of `placed`."""
    tree, absolute = pair
    q, u, Q, U = state(*pair)
    options, there = {"t": 0.3, "q": q, "u": u}, {"t": 0.3, "q": Q, "u": U}
    f, F = tree.call("applied", **options), absolute.call("applied", **there)
    a, reactions = tree.call("accelerations", **options, f=f)
    actual, supplied, _ = absolute.call("accelerations", **there, f=F)
    here = {"t": 0.3, "joints": q, "joint_speeds": u}
    expected = (
        absolute.jacobian("placed", "t", 1, **here)[:, 0]
        + absolute.jacobian("placed", "joints", 1, **here) @ tree.call("coordinate_rates", **options)
        + absolute.jacobian("placed", "joint_speeds", 1, **here) @ a
    )
    assert actual == pytest.approx(expected, rel=1e-9, abs=1e-9 * np.max(np.abs(expected)))
    assert supplied == pytest.approx(reactions, rel=1e-8, abs=1e-8)
    for one, other in zip(absolute.call("energy", **there)[:2], tree.call("energy", **options)[:2], strict=True):
        assert one == pytest.approx(other, rel=1e-12)
    powers = absolute.call("ledger", **there, reactions=supplied), tree.call("ledger", **options, reactions=reactions)
    assert powers[0] == pytest.approx(powers[1], rel=1e-8, abs=1e-9)


@pytest.mark.by_turns(3)
def test_constraints_rates_and_accelerations_belong_together(pair):
    """d(phi)/dt is the rate, and under the accelerations found the rates stay as they are; at a state with open loops for the first."""
    _, absolute = pair
    _, _, Q, U = state(*pair)
    there = {"t": 0.3, "q": Q, "u": U}
    f = absolute.call("applied", **there)
    a, _, _ = absolute.call("accelerations", **there, f=f)
    assert rate_along(absolute, "constraints", 0, **there, a=a) == pytest.approx(
        absolute.call("constraints", **there)[1], abs=1e-11
    )
    assert np.max(np.abs(rate_along(absolute, "constraints", 1, **there, a=a))) < 1e-7


def test_joints_are_measured_where_that_can_be_done(pair):
    tree, absolute = pair
    q, u, Q, U = state(*pair)
    outputs = dict(zip((name for name, _ in absolute.OUTPUTS), absolute.call("outputs", t=0.3, q=Q, u=U), strict=True))
    known = dict(zip((name for name, _ in (*tree.COORDINATES, *tree.SPEEDS)), (*q, *u), strict=True))
    for name in outputs.keys() & known.keys():
        assert outputs[name] == pytest.approx(known[name], abs=1e-12)
    measured = {name.rsplit(".", 1)[0] for name in outputs}
    assert measured or not {name for name in known if name.endswith((".angle", ".travel"))}


def test_mass_matrix_is_diagonal_in_blocks():
    """What a force on one body does to it alone is what it does: without constraints nothing else moves. Seen in the columns of a chain."""
    program = derivation_of(chain(4, "Z").scene().with_coordinates("absolute"))
    masses = [symbol.name for symbol in program.tape.assignments if symbol.name.startswith(("M_", "L_body"))]
    assert not [name for name in masses if name.startswith("M_") and name.count("body") > 1]


def test_cost_is_linear_in_the_length_of_a_chain_with_inertias_or_without():
    counts = [
        dict(Derived(chain(n, "Z").scene(ledger=False).with_coordinates("absolute")).OPERATIONS)["accelerations"]
        for n in (2, 4, 8)
    ]
    assert counts[2] - counts[1] == 2 * (counts[1] - counts[0])
    counts = [dict(Derived(bobs(n).with_coordinates("absolute")).OPERATIONS)["accelerations"] for n in (3, 4, 5)]
    assert counts[2] - counts[1] == counts[1] - counts[0]
    wanted = [
        "one.moment_x", "two.moment_y", *(f"cross.{k}" for k in "xyz"), *(f"cross.moment_{k}" for k in "xyz"), "three.moment_x",
    ]  # fmt: skip
    assert lent(rods()) == wanted
    assert lent(chain(3, "ZYX").scene()) == []


def lent(scene: hd.Scene) -> list[str]:
    """Rows that a mass or an inertia is lent to."""
    return list(System(absolute(scene)).equations.artificial_inertia)


# -- long paths in joint coordinates -----------------------------------------------------------------------------------


def quick_return() -> hd.Scene:
    """A loop with a slot block without mass, to which inertia is lent."""
    crank, block, rocker = (
        hd.Body("crank", MASS, ACROSS), hd.Body("block", 0), hd.Body("rocker", MASS, ACROSS, centre=HALF_X),
    )  # fmt: skip
    joints = (
        hd.Revolute("main", hd.GROUND, crank, axis=hd.Z), hd.Revolute("pin", crank.at(*ALONG_X), block, axis=hd.Z),
        hd.Revolute("swing", hd.GROUND.at(0, -LENGTH, 0), rocker, axis=hd.Z), hd.Prismatic("slot", rocker, block, axis=hd.X),
    )  # fmt: skip
    return hd.Scene(hd.Mechanism("quick_return", joints), (), hd.Scales(LENGTH, P("pace", "m/s", 1.0), LENGTH))


@pytest.mark.by_turns(3)
@pytest.mark.parametrize(
    "name", ["spatial", "turned points", "free, with a tail", "slender rods and a cross without mass", "quick return"]
)
def test_articulated_bodies_accelerate_as_elimination_has_it(name, monkeypatch):
    result = []
    for longest in (0, 1000):
        monkeypatch.setattr(equations_of_motion, "LONG_PATH", longest)
        result.append(Derived(quick_return() if name == "quick return" else SCENES[name]))
    q, u = joints_state(result[0])
    one, other = (each.call("accelerations", t=0.3, q=q, u=u, f=np.arange(1.0, len(u) + 1))[0] for each in result)
    assert one == pytest.approx(other, rel=1e-8, abs=1e-9 * np.max(np.abs(other)))
    assert result[0].OPERATIONS != result[1].OPERATIONS  # two ways


@pytest.mark.parametrize(("axes", "lengths"), [("Z", (11, 12, 13)), ("ZYX", (12, 15, 18))])
def test_steps_in_joint_coordinates_are_linear_in_the_length_of_a_chain(axes, lengths):
    """Each further link about the same axis takes as many assignments as the one before."""
    counts = []
    for n in lengths:
        program = derivation_of(chain(n, axes).scene(ledger=False))
        counts += [len(function.body) for function in program.functions if function.name == "accelerations"]
    assert counts[2] - counts[1] == counts[1] - counts[0]


# -- which coordinates -------------------------------------------------------------------------------------------------


def trestle(n: int) -> hd.Scene:
    """A beam of n hinged spans, with a leg under each second hinge: every loop is in the path of those beyond it."""
    spans, legs = ([hd.Body(f"{what}{i}", MASS, ACROSS, centre=HALF_X) for i in range(n)] for what in ("span", "leg"))
    joints, before = [], hd.GROUND.at(*ORIGIN)
    for i, (span, leg) in enumerate(zip(spans, legs, strict=True)):
        joints.append(hd.Revolute(f"hinge{i}", before, span, axis=hd.Z))
        before = span.at(*ALONG_X)
        if i % 2:
            foot = hd.GROUND.at((i + 1) * LENGTH, -LENGTH, 0)
            joints += (
                hd.Revolute(f"knee{i}", before, leg, axis=hd.Z),
                hd.Revolute(f"foot{i}", foot, leg.at(*ALONG_X), axis=hd.Z),
            )
    return hd.Scene(hd.Mechanism("trestle", tuple(joints)), (), hd.Scales(LENGTH, P("pace", "m/s", 1.0), LENGTH))


def test_auto_keeps_the_cheaper_or_what_can_be_had():
    short, long = (Derived(scene.with_coordinates("auto")) for scene in (chain(2, "Z").scene(ledger=False), trestle(8)))
    assert short.JOINT_COORDINATES is None
    assert "Coordinates: of the joints, as the cheaper" in short.text
    assert long.JOINT_COORDINATES
    assert "Coordinates: absolute, as the cheaper" in long.text
    text = Derived(
        hung(
            (hd.Body("one", MASS, ACROSS), hd.Z, ORIGIN), (hd.Body("two", MASS, ACROSS), hd.X, ALONG_X)
        ).with_coordinates("auto")
    ).text
    assert "Coordinates: of the joints; the bodies' own cannot be had: body one, inertia" in text


def test_names_of_absolute_coordinates():
    result = Derived(slider_crank.with_coordinates("absolute"))
    assert [name for name, _ in result.COORDINATES] == ["rod.x", "rod.y", "rod.angle", "slider.x", "slider.y"]
    body = hd.Body("pin", P("mass", "kg", 1.0))
    length, speed = P("reach", "m", 1.0), P("pace", "m/s", 1.0)
    scene = hd.Scene(
        hd.Mechanism("one", (hd.Prismatic("pin", hd.GROUND, body, hd.X),)), (), hd.Scales(length, speed), coordinates="absolute",
    )  # fmt: skip
    assert [name for name, _ in Derived(scene).COORDINATES] == ["pin_base.x", "pin_base.y"]


# -- bad input ---------------------------------------------------------------------------------------------------------


def faults_of(scene: hd.Scene) -> dict[str, str]:
    with pytest.raises(hd.InputError) as error:
        Derived(scene.with_coordinates("absolute"))
    return {fault.where: fault.found for fault in error.value.faults}


def test_unknown_inertias_are_reported_all_at_once():
    nothing, full = P("nothing", "kg m^2", 0.0), (ACROSS, ACROSS, ACROSS)
    one, two, three = (
        hd.Body("one", 0), hd.Body("two", MASS, ACROSS), hd.Body("three", MASS, (nothing, ACROSS, ACROSS), centre=HALF_Y),
    )  # fmt: skip
    thin = hd.Body("thin", MASS, (0, ACROSS, ACROSS))
    chained = (one, hd.Z, ORIGIN), (two, hd.X, ALONG_X), (three, hd.X, ALONG_X), (thin, hd.Z, ORIGIN)
    tips = [hd.Body("tip", MASS, inertia) for inertia in ((ACROSS, 0, ACROSS), full)]
    result, other = (faults_of(hung(*chained, last=(hd.Weld("glued", thin.at(*ALONG_X), tip),))) for tip in tips)
    assert result == {
        "body two, inertia": "J_across, about the joint's axis alone",
        "body three, inertia": "(nothing, J_across, J_across), zero at the defaults",
        "body thin, inertia": "(0, J_across, J_across), and welded to it tip, without one about every axis",
    }
    assert other.keys() == result.keys() - {"body thin, inertia"}


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_a_body_without_a_mass_at_the_end_of_a_chain_is_refused(coordinates):
    with pytest.raises(hd.InputError, match="body cross, mass: found 0 kg at the end of a chain"):
        hung(
            (hd.Body("one", MASS, (0, ACROSS, ACROSS), centre=HALF_X), hd.Z, ORIGIN),
            (hd.Body("cross", 0), hd.X, ALONG_X),
        ).with_coordinates(coordinates)


@dataclass(frozen=True, init=False)
class Wrist(hd.Joint):
    """Three turns about one point: where the bodies are, their angles follow by convention only."""

    @property
    def freedoms(self):
        return tuple(self.turn(axis, f"t{k}") for k, axis in enumerate((hd.Z, hd.X, hd.Y)))


def test_coordinates_that_cannot_be_measured_are_refused_all_at_once():
    arm, hand = (hd.Body(name, MASS, (ACROSS, ACROSS, ACROSS), centre=HALF_Y) for name in ("arm", "hand"))
    hung_hand = replace(
        hung((arm, hd.Z, ORIGIN)),
        mechanism=hd.Mechanism("wrist", (hd.Revolute("axle", hd.GROUND, arm, hd.Z), Wrist("wrist", arm, hand))),
    )
    effects = (
        hd.JointSpring("torsion", "wrist.t1", K, REST), hd.JointDamper("oil", "wrist.t0", D),
        hd.JointForce("twist", "axle", K * sp.sin(hd.coordinate_of("wrist.t2"))), hd.JointForce("tug", "axle", K * sp.sin(hd.coordinate_of("axle"))),
    )  # fmt: skip
    result = faults_of(replace(hung_hand, effects=(*hung_hand.effects, *effects)))
    assert result == {
        f"effect {effect}": f"wrist.{turn}, of a wrist joint"
        for effect, turn in (("torsion", "t1"), ("oil", "t0"), ("twist", "t2"))
    }


def test_an_arm_is_needed_where_bodies_turn():
    m, J, length, w = P("mass", "kg", 1.0), P("inertia", "kg m^2", 0.1), P("reach", "m", 1.0), P("pace", "rad/s", 1.0)
    arm, bead = hd.Body("arm", m, J), hd.Body("bead", m, J)
    joints = (hd.Revolute("axle", hd.GROUND, arm, hd.Z), hd.Prismatic("rail", arm, bead, hd.X))
    scene = hd.Scene(hd.Mechanism("rail", joints), (hd.ConstantSpeed("motor", "axle", w), hd.Gravity("gravity", P("g", "m/s^2", 9.81), -hd.Y)),
                  hd.Scales(length, length * w), hd.Start({"rail": length}))  # fmt: skip
    assert faults_of(scene) == {"scales": "no arm"}


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("mass", [0, MASS])
def test_axes_that_coincide_with_no_inertia_between_them_are_refused(coordinates, mass):
    hub, cross, one = (
        hd.Body("hub", MASS, (ACROSS, ACROSS, ACROSS)), hd.Body("cross", mass), hd.Body("one", MASS, (ACROSS, ACROSS, ACROSS), centre=HALF_Y),
    )  # fmt: skip
    with pytest.raises(hd.InputError, match=r"axes that coincide: .* together move no mass; .* without one: cross"):
        Derived(hung((hub, hd.Z, ORIGIN), (cross, hd.X, ORIGIN), (one, hd.X, ORIGIN)).with_coordinates(coordinates))
