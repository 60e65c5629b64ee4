"""Robots of URDF files: mass matrices of public robots by a second derivation, and every fault of a file at once.

Ten structures that occur in example-robot-data stand here with numbers of our own; `compare_robots.py` reads such a
collection beside Pinocchio.
"""

from dataclasses import replace
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
import sympy as sp
from scipy.spatial.transform import Rotation

import hertzwerk.derive as hd
from hertzwerk.derive.exchange.user_files.urdf import Robot
from hertzwerk.runtime import simulate
from hertzwerk.runtime.loading import engine_model
from reference.robots import NONE, ROBOTS, Row, urdf

SCALES = hd.Scales(
    length=hd.Parameter("size", "m", 0.1), speed=hd.Parameter("pace", "m/s", 1), arm=hd.Parameter("arm", "m", 0.1)
)
GRAVITY = hd.Gravity("gravity", hd.Parameter("g", "m/s^2", 9.81), direction=-hd.Z)


def written(folder: Path, text: str) -> Path:
    path = folder / "robot.urdf"
    path.write_text(text, encoding="utf-8")
    return path


def robot_of(folder: Path, name: str) -> tuple[Robot, list[Row]]:
    rows = ROBOTS[name]()
    return hd.from_urdf(written(folder, urdf(name, rows)), "floating" if name == "solo" else "fixed"), rows


def mass_matrix(model, q, u):
    """Second derivative of the kinetic energy by the speeds, exact."""
    energy, c = model.function("energy"), model.bind().c
    symbol = ca.SX.sym("u", len(u))
    hessian = ca.Function("M", [symbol], [ca.hessian(energy(0, q, symbol, c)[0], symbol)[0]])
    return np.array(hessian(u))


def textbook_mass_matrix(rows: list[Row], q: np.ndarray, floating: bool) -> np.ndarray:
    """Sum of J_v^T m J_v + J_w^T J J_w over the links, by geometric Jacobians (Spong, Robot Modeling and Control, 7.2)."""
    moving = [row.joint for row in rows if row.kind == "revolute"]
    start = 6 if floating else 0
    size = start + len(moving)
    pose: dict[str, tuple] = {}
    M = np.zeros((size, size))
    for row in rows:
        if not row.joint:
            R, p = Rotation.from_quat(np.roll(q[3:7], -1)).as_matrix(), q[:3]
            columns = {k: (np.eye(3)[k], None, None) for k in range(3)} | {3 + k: (None, R[:, k], p) for k in range(3)}
        else:
            R, p, columns = pose.get(row.parent, (np.eye(3), np.zeros(3), {}))
            p, R = p + R @ row.xyz, R @ Rotation.from_euler("xyz", row.rpy).as_matrix()  # about fixed axes
            if row.joint in moving:
                k = moving.index(row.joint)
                columns = {**columns, start + k: (None, R @ row.axis, p)}
                R = R @ Rotation.from_rotvec(q[start + floating + k] * np.array(row.axis)).as_matrix()
        pose[row.child] = (R, p, columns)
        xx, xy, xz, yy, yz, zz = row.inertia
        inertia = R @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ R.T
        Jv, Jw = np.zeros((3, size)), np.zeros((3, size))
        for k, (along, about, at) in columns.items():
            Jv[:, k] = along if about is None else np.cross(about, p + R @ row.centre - at)
            Jw[:, k] = 0 if about is None else about
        M += row.mass * Jv.T @ Jv + Jw.T @ inertia @ Jw
    return M


def state_of(robot: Robot, seed: int):
    rng = np.random.default_rng(seed)
    q = np.concatenate([rng.uniform(-1, 1, len(freedom.coordinates)) for freedom in robot.mechanism.freedoms])
    if robot.mechanism.freedoms[3:] and robot.mechanism.freedoms[3].kind == "ball":
        q[3:7] /= np.linalg.norm(q[3:7])
    return q, rng.normal(size=sum(len(freedom.speeds) for freedom in robot.mechanism.freedoms))


def test_mass_matrices_of_public_robots_by_a_second_derivation(tmp_path):
    for name in ROBOTS:
        robot, rows = robot_of(tmp_path, name)
        model = engine_model(robot.scene(GRAVITY, hd.EnergyLedger(), scales=SCALES))
        for seed in range(3):
            q, u = state_of(robot, seed)
            expected = textbook_mass_matrix(rows, q, name == "solo")
            assert np.abs(mass_matrix(model, q, u) - expected).max() < 1e-13 * np.abs(expected).max(), name


LINK = (
    '<link name="{}"><inertial><origin xyz="{}" rpy="{}"/><mass value="2"/>'
    '<inertia ixx="0.02" iyy="0.03" izz="0.04" ixy="0.001" ixz="0.002" iyz="0.003"/></inertial>{}</link>'
)


def robot_with(*joints: str, links: str = "abc", solid: str = "", rpy: str = "0 0 0") -> str:
    made = "".join(LINK.format(link, "0.1 0.02 0.03", rpy, solid) for link in links)
    return f'<robot name="arm"><link name="base"/>{made}{"".join(joints)}</robot>'


def joint(name: str, kind: str, parent: str, child: str, more: str = "") -> str:
    return f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{more}</joint>'


def test_an_inertia_in_turned_axes_is_that_of_the_turned_tensor(tmp_path):
    angles = (0.3, -0.4, 0.5)
    text = robot_with(joint("j", "floating", "base", "a"), links="a", rpy=" ".join(map(str, angles)))
    body = hd.from_urdf(written(tmp_path, text)).bodies["a"]
    R = Rotation.from_euler("xyz", angles).as_matrix()
    expected = R @ [[0.02, 0.001, 0.002], [0.001, 0.03, 0.003], [0.002, 0.003, 0.04]] @ R.T
    actual = np.array([[float(value.default) for value in row] for row in body.tensor])
    assert np.abs(actual - expected).max() < 1e-16
    assert np.abs(actual - R.T @ actual @ R).max() > 1e-3  # turned the other way it would be another
    text = robot_with(joint("j", "continuous", "base", "a", '<origin rpy="0.3 -0.4 0.5"/>'), links="a")
    axes = hd.from_urdf(written(tmp_path, text)).mechanism.joints[0].parent.axes
    turns = {symbol: symbol.si for row in axes for value in row for symbol in sp.sympify(value).free_symbols}
    assert np.abs(np.array(sp.Matrix(axes).xreplace(turns), dtype=float) - R).max() < 1e-15


def test_joints_of_every_type_limits_and_dampers(tmp_path):
    text = robot_with(
        joint("turn", "continuous", "base", "a", '<axis xyz="0 0 2"/><dynamics damping="0.5" friction="0.1"/>'),
        joint("slide", "prismatic", "a", "b", '<axis xyz="0 1 1"/><limit lower="-0.1" upper="0.2" effort="20" velocity="0.3"/>'
              '<mimic joint="turn" multiplier="0.01" offset="0.05"/>'),
        joint("sheet", "planar", "b", "c", '<axis xyz="0 1 0"/>'),
        joint("glued", "fixed", "c", "d"),
        joint("loose-end", "floating", "base", "e"),
        links="abcde",
    )  # fmt: skip
    robot = hd.from_urdf(written(tmp_path, text))
    assert [type(j).__name__ for j in robot.mechanism.joints] == ["Revolute", "Prismatic", "Planar", "Weld", "Free"]
    assert robot.mechanism.joints[-1].name == "loose_end"
    assert robot.mechanism.joints[2].normal == hd.Y
    assert (robot.limits["slide"].upper, robot.limits["slide"].effort) == (0.2, 20)
    assert robot.friction == {"turn": 0.1}
    run = simulate(
        engine_model(robot.scene(hd.EnergyLedger(), scales=SCALES, start=hd.Start({"turn": 0}, {"turn": hd.Parameter("w", "rad/s", 2)}))),
        duration="0.3 s", accuracy=1e-8,
    )  # fmt: skip
    assert run.outcome.name == "finished"
    assert np.abs(run["slide.travel"] - 0.01 * run["turn.angle"] - 0.05).max() < 1e-9
    assert run["turn_damper.dissipated"][-1] > 0.1
    assert run["turn_damper.power"] == pytest.approx(0.5 * run["turn.speed"] ** 2)


FOOT = '<collision><origin xyz="0 0 -0.1"/><geometry><sphere radius="0.02"/></geometry></collision>'
MESH = '<collision><geometry><mesh filename="package://foot.stl"/></geometry></collision>'


BOX = '<collision><geometry><box size="0.1 0.2 0.3"/></geometry></collision>'
ROD = '<collision><geometry><cylinder radius="0.02" length="0.5"/></geometry></collision>'


def test_solids_have_the_sizes_of_the_file(tmp_path):
    text = robot_with(joint("drop", "prismatic", "base", "a"), links="a", solid=BOX + ROD)
    box, rod = hd.from_urdf(written(tmp_path, text)).collisions["a"]
    assert {what: size.si for what, size in box.sizes.items()} == {"x": 0.1, "y": 0.2, "z": 0.3}
    assert {what: size.si for what, size in rod.sizes.items()} == {"radius": 0.02, "length": 0.5}


def test_a_foot_of_the_file_falls_on_a_floor(tmp_path):
    text = robot_with(joint("drop", "prismatic", "base", "a", '<axis xyz="0 0 1"/>'), links="a", solid=FOOT + MESH)
    robot = hd.from_urdf(written(tmp_path, text))
    assert robot.left_out == ("meshes, of a: their contact is for pairs of the scene to declare",)
    (foot,) = robot.collisions["a"]
    assert foot.kind == "sphere"
    floor = hd.SphereOnPlane("floor", foot.at, foot.sizes["radius"], hd.GROUND.at(0, 0, 0), normal=hd.Z)
    law = hd.laws.power(hd.Parameter("K", "N/m^1.5", 1e8), 1.5)
    height = hd.Parameter("height", "m", 0.62)  # 0.5 m above contact
    scene = robot.scene(
        GRAVITY, hd.Contact("floor", law), pairs=(floor,), scales=SCALES, start=hd.Start({"drop": height})
    )
    run = simulate(engine_model(scene), duration="0.4 s")
    assert run.impacts[0].t == pytest.approx((2 * 0.5 / 9.81) ** 0.5, rel=1e-6)
    assert run.impacts[0].speed == pytest.approx((2 * 0.5 * 9.81) ** 0.5, rel=1e-6)


def test_a_floating_base_falls(tmp_path):
    robot, _ = robot_of(tmp_path, "solo")
    run = simulate(engine_model(robot.scene(GRAVITY, hd.EnergyLedger(), scales=SCALES)), duration="0.2 s")
    assert run["floating_base.z"][-1] == pytest.approx(-9.81 * 0.2**2 / 2, rel=1e-9)


def faults_of(folder: Path, text: str, base: str = "fixed") -> str:
    with pytest.raises(hd.InputError) as caught:
        hd.from_urdf(written(folder, text), base)
    return str(caught.value)


def test_every_fault_of_elements_and_between_them_is_reported_at_once(tmp_path):
    said = faults_of(
        tmp_path,
        '<robot name="r"><link name="a"><inertial><mass value="heavy"/><inertia ixx="1" iyy="nan" izz="1"/></inertial>'
        '<collision><geometry><sphere radius="-1"/></geometry></collision></link><link/>'
        + joint("j", "hinge", "a", "b", '<axis xyz="0 1"/>') + '<joint name="k" type="fixed"><child link="a"/></joint></robot>',
    )  # fmt: skip
    for part in (
        "link a, inertial.mass.value: found 'heavy'; expected a mass of at least 0 kg",
        "link a, inertial.inertia.iyy: found 'nan'; expected a finite number",
        "link a, collision.0.geometry.sphere.radius: found '-1'; expected a positive number", "link 2, name: found none; expected a name",
        "joint j, type: found 'hinge'; expected revolute, continuous, prismatic, fixed, floating or planar",
        "joint j, axis.xyz: found none; expected three numbers", "joint k, parent: found none; expected reference to a link",
    ):  # fmt: skip
        assert part in said, said
    said = faults_of(
        tmp_path,
        '<robot name="r"><link name="base"/><link name="a"/>'
        + "".join(LINK.format(link, "0 0 0", "0 0 0", "") for link in ("b", "c", "c-1", "c_1"))
        + joint("j", "revolute", "base", "a", '<axis xyz="0 0 0"/>')
        + joint("k", "planar", "a", "b", '<axis xyz="0 1 1"/>')
        + joint("l", "floating", "b", "nowhere", '<mimic joint="j"/>')
        + joint("m", "revolute", "b", "c", '<mimic joint="none"/>')
        + joint("n", "fixed", "a", "c") + joint("o", "fixed", "a", "c-1") + joint("p", "fixed", "a", "c_1") + "</robot>",
    )  # fmt: skip
    for part in (
        "link c_1: found 2 of this name", "joint j, axis: found 0 0 0", "joint k, axis: found (0.0, 1.0, 1.0); expected an axis of the joint's frame",
        "joint l, child: found nowhere, which is no link", "joint l, mimic: found l, a floating joint; expected a joint of one coordinate",
        "joint m, mimic: found none, which is no joint", "joint m, joint n: found c, which another joint carries too",
    ):  # fmt: skip
        assert part in said, said


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("<robot name='r'>", "expected a URDF file"),
        ("<sdf/>", "found the root element <sdf>"),
        ('<robot name="r"><link name="a"/><link name="b"/></robot>', "found 2 that no joint carries: a, b"),
        ('<robot name="r"/>', "found 0 that no joint carries"),
        ('<robot name="r">' + LINK.format("a", "0 0 0", "0 0 0", "") + joint("j", "fixed", "a", "a") + "</robot>", "0 that no joint carries"),
        ('<!DOCTYPE x [<!ENTITY f SYSTEM "file:///etc/hostname">]><robot name="&f;"><link name="a"/></robot>', "expected a URDF file"),
        ('<robot name="r"><link name="__import__(\'os\').system(\'x\')"/></robot>', "found the name '__import__"),
    ],
)  # fmt: skip
def test_a_file_that_is_no_robot_is_refused(tmp_path, text, message):
    assert message in faults_of(tmp_path, text)


def test_a_file_that_is_not_there_and_a_base_that_is_none(tmp_path):
    with pytest.raises(hd.InputError, match="no such file"):
        hd.from_urdf(tmp_path / "none.urdf")
    assert "expected 'fixed' or 'floating'" in faults_of(tmp_path, robot_with(links=""), base="loose")


SOUND = {"mass": 1.3, "centre": (0.02, -0.03, 0.1), "inertia": (0.02, 0.001, -0.002, 0.03, 0.003, 0.025)}
LAZY = (1e-5,) * 6  # principal values 0, 0 and 3e-5
LONG = (1e-3, 2e-4, 0, 1e-3, 0, 9e-3)  # one principal value above the sum of the others
NEGATIVE = (3e-5, 8e-5, 0, 3e-5, 0, 9e-5)
THIN = (1e-20, -3e-20, 0, 2e-20, 0, 4e-20)  # rounding, for a link of a kilogramme
BASE = Row("", "", "", "trunk", NONE, **SOUND)
HIP = Row("hip", "revolute", "trunk", "thigh", (0.1, 0.2, 0), (0.1, 0, 0.3), (0, 1, 0), **SOUND)
KNEE = Row("knee", "revolute", "thigh", "shin", (0, 0.05, -0.3), (0, 0.2, 0), (0, 0.6, 0.8), **SOUND)
TIP = Row("glue", "fixed", "shin", "foot", (0.02, 0, -0.2), (0.4, 0.5, 0.6), mass=0.2, centre=(0.01, 0.02, 0.03))
WHEEL = Row("axle", "revolute", "shin", "wheel", (0, 0.1, 0), axis=(0, 1, 0), mass=0.5)
SLED = Row("sled", "fixed", "trunk", "box", (0.3, 0, 0.1), (0, 0, 0.7), mass=0.4, inertia=LONG)

STRUCTURES: dict[str, tuple[str, list[Row], dict, tuple[str, ...]]] = {
    "names": ("2dof", [replace(HIP, parent="ground", child="lambda"), replace(KNEE, joint="1st", parent="lambda")], {},
              ("names: 2dof is robot_2dof, ground is link_ground, lambda is link_lambda, 1st is joint_1st",)),
    "names of a floating base": ("quadruped", [BASE, replace(SLED, joint="floating_base", inertia=(0,) * 6), HIP], {"base": "floating"},
                                 ("names: floating_base is joint_floating_base", "masses without inertia, taken as point masses: box")),
    "an inertia without a mass": ("biped", [HIP, KNEE, replace(TIP, mass=0, inertia=(5.7e-3, 1e-4, 0, 8.4e-3, 0, 5.3e-3))], {}, ()),
    "a point mass on the axis": ("arm", [HIP, KNEE, replace(TIP, xyz=(0, 0.3, 0.4), centre=(0, 0, 0))], {},
                                 ("masses without inertia, taken as point masses: foot",)),
    "a negative inertia on a sound link": ("arm", [HIP, KNEE, replace(TIP, inertia=NEGATIVE)], {},
                                           ("impossible inertias, added to that of shin, to which the links are welded: foot",)),
    "a lazy base": ("quadruped", [replace(BASE, mass=1e-6, centre=(0, 0, 0), inertia=LAZY), replace(SLED, inertia=SOUND["inertia"]), HIP],
                    {"base": "floating"}, ("impossible inertias, added to that of trunk, to which the links are welded: box",)),
    "an impossible one fixed to the ground": ("lift", [SLED, HIP], {},
                                              ("impossible inertias, added to that of ground, to which the links are welded: box",)),
    "rounding, and links without inertia": (
        "humanoid", [replace(HIP, inertia=(0,) * 6), replace(KNEE, inertia=THIN), replace(WHEEL, **SOUND)], {},
        ("masses without inertia, taken as point masses: thigh", "inertias impossible by rounding, their rounding errors set to zero: shin"),
    ),
    "a locked joint": ("gripper", [HIP, KNEE, replace(WHEEL, mass=0)], {"locked": {"knee": 0.4, "axle": 0}}, ()),
}  # fmt: skip


@pytest.mark.parametrize("name", STRUCTURES)
def test_repairs_are_listed_and_change_nothing(tmp_path, name):
    title, rows, options, repairs = STRUCTURES[name]
    robot = hd.from_urdf(written(tmp_path, urdf(title, rows)), **options)
    assert robot.repairs == repairs
    for joint, angle in options.get("locked", {}).items():
        row = next(row for row in rows if row.joint == joint)
        turned = Rotation.from_euler("xyz", row.rpy) * Rotation.from_rotvec(angle * np.array(row.axis))
        rows = [replace(row, kind="fixed", rpy=tuple(turned.as_euler("xyz"))) if each == row else each for each in rows]
    model = engine_model(robot.scene(GRAVITY, hd.EnergyLedger(), scales=SCALES))
    q, u = state_of(robot, 1)
    expected = textbook_mass_matrix(rows, q, options.get("base") == "floating")
    assert np.abs(mass_matrix(model, q, u) - expected).max() < 1e-13 * np.abs(expected).max()


def test_a_joint_locked_at_a_value_takes_those_that_mimic_it_with_it(tmp_path):
    text = robot_with(
        joint("turn", "continuous", "base", "a", '<axis xyz="0 0 1"/>'),
        joint("slide", "prismatic", "a", "b", '<origin xyz="0 0 0.5" rpy="0 0 1.5"/><axis xyz="3 0 4"/><limit effort="1" velocity="1"/>'
              '<dynamics damping="1" friction="2"/>'),
        joint("finger", "prismatic", "b", "c", '<axis xyz="0 1 0"/><mimic joint="slide" multiplier="2" offset="0.1"/>'),
        joint("nail", "fixed", "c", "d", '<mimic joint="slide"/>'),
        links="abcd",
    )  # fmt: skip
    robot = hd.from_urdf(written(tmp_path, text), locked={"slide": 0.05})
    assert robot.repairs == (
        "mimic of joints that are fixed, left out: nail",
        "joint finger mimics slide, which is fixed: fixed at 0.2",
    )
    assert not robot.effects and not robot.limits and not robot.friction
    assert [type(j).__name__ for j in robot.mechanism.joints] == ["Revolute", "Weld", "Weld", "Weld"]
    result = [
        float(sp.sympify(x).xreplace({p: p.si for p in sp.sympify(x).free_symbols}))
        for x in robot.mechanism.joints[1].parent.position
    ]
    along = Rotation.from_euler("z", 1.5).apply([0.03, 0, 0.04])
    assert result == pytest.approx(np.array([0, 0, 0.5]) + along, abs=1e-15)


def test_a_robot_that_only_floats(tmp_path):
    path = written(tmp_path, urdf("drone", [BASE, SLED]))
    with pytest.raises(hd.InputError, match=r"no joint that can move; .*\n.* from_urdf\(\.\.\., base='floating'\)"):
        hd.from_urdf(path).scene(GRAVITY, scales=SCALES)
    robot = hd.from_urdf(path, "floating")
    model = engine_model(robot.scene(GRAVITY, hd.EnergyLedger(), scales=SCALES))
    q, u = state_of(robot, 2)
    expected = textbook_mass_matrix([BASE, SLED], q, True)
    assert np.abs(mass_matrix(model, q, u) - expected).max() < 1e-13 * np.abs(expected).max()


@pytest.mark.parametrize("inertia", [LONG, NEGATIVE, LAZY, (-1e-3, 0, 0, -2e-3, 0, -1e-3)])
def test_an_inertia_that_no_body_has_or_the_nearest_possible_one(tmp_path, inertia):
    """A projection onto a convex cone: the residual is perpendicular to it, and no rod's inertia lies along it."""
    path = written(tmp_path, urdf("arm", [HIP, replace(KNEE, inertia=inertia)]))
    with pytest.raises(hd.InputError, match=r'link shin, inertia: found principal values .*\n.*inertia="nearest"'):
        hd.from_urdf(path)
    robot = hd.from_urdf(path, inertia="nearest")
    xx, xy, xz, yy, yz, zz = inertia
    given = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    result = np.array([[float(getattr(value, "si", value)) for value in row] for row in robot.bodies["shin"].tensor])
    values, axes = np.linalg.eigh(result)
    size = np.abs(given).max()
    assert values[0] >= 0 and values[2] <= values[0] + values[1] + 1e-9 * size
    rest = given - result
    assert abs(np.sum(rest * result)) < 1e-8 * size**2
    for axis in (*axes.T, *np.random.default_rng(3).normal(size=(50, 3))):
        assert np.sum(rest * (np.eye(3) - np.outer(axis, axis) / (axis @ axis))) < 1e-8 * size
    (repair,) = robot.repairs
    assert (
        f"at a distance of {np.linalg.norm(rest):.3g} kg m^2, {100 * np.linalg.norm(rest) / np.linalg.norm(given):.2g} %"
        in repair
    )


def test_likely_causes_and_ways_out_of_files_that_contradict_themselves(tmp_path):
    drone = robot_with(joint("top", "fixed", "base", "b2"), joint("side", "fixed", "base", "a"), links="ab")
    assert (
        "joint top, child: found b2, which is no link; expected one of base, a, b\n      No joint carries base and b: one may be meant."
        in faults_of(tmp_path, drone)
    )
    hand = robot_with(
        joint("left_thumb", "revolute", "base", "a"), joint("left_index", "revolute", "a", "b", '<mimic joint="thumb"/>'), links="ab",
    )  # fmt: skip
    assert (
        "joint left_index, mimic: found thumb, which is no joint; expected another joint\n      did you mean left_thumb?"
        in faults_of(tmp_path, hand)
    )
    assert "No <link>: is the macro of an .xacro not called?" in faults_of(tmp_path, '<robot name="r"/>')
    gripper = '<robot name="r"><link name="base"/><link name="a"/>' + joint("j", "revolute", "base", "a") + "</robot>"
    assert 'from_urdf(..., locked={"j": 0}) welds it' in faults_of(tmp_path, gripper)
    text = robot_with(
        joint("glue", "fixed", "base", "a"), joint("loose", "floating", "base", "b", '<mimic joint="glue"/>'), links="ab",
    )  # fmt: skip
    assert "joint loose, mimic: found loose, a floating joint; expected a joint of one coordinate" in faults_of(
        tmp_path, text
    )
    text = '<robot name="r"><link name="base"/><link name="a"/><link name="tool"/>'
    said = faults_of(
        tmp_path, text + joint("j", "revolute", "base", "a") + joint("k", "fixed", "a", "tool") + "</robot>"
    )
    assert "link a: found no <inertial>, and joint j moves it" in said


def test_every_fault_of_options_is_reported_at_once(tmp_path):
    path = written(
        tmp_path, robot_with(joint("turn", "continuous", "base", "a"), joint("glue", "fixed", "a", "b"), links="ab")
    )
    with pytest.raises(hd.InputError, match=r"inertia: found 'best'") as caught:
        hd.from_urdf(path, "loose", locked="turn", inertia="best")
    assert len(caught.value.faults) == 3
    with pytest.raises(hd.InputError) as caught:
        hd.from_urdf(path, locked={"turm": 0, "turn": "0.1", "glue": float("nan")})
    reported = str(caught.value)
    for part in (
        "locked, turm: found no joint of this name", "did you mean turn?", "locked, turn: found '0.1'; expected a finite number, in rad or m",
        "locked, glue: found a fixed joint; expected a joint of one coordinate", "locked, glue: found nan",
    ):  # fmt: skip
        assert part in reported, reported
