"""Numbers of three public robots, and URDF text of them.

Retyped from the descriptions in Gepetto/example-robot-data (BSD-3-Clause): ur_description/urdf/ur5_robot.urdf (commit 20a90f2),
z1_description/urdf/z1.urdf (2a6ee26), solo_description/robots/solo.urdf (524dca6). SI.
"""

from dataclasses import dataclass

RIGHT = 1.57079632679  # as the file of the UR5 has it
NONE = (0, 0, 0)


@dataclass(frozen=True)
class Row:
    """A joint and the link that it carries: inertia ixx, ixy, ixz, iyy, iyz, izz about the mass centre."""

    joint: str
    kind: str
    parent: str
    child: str
    xyz: tuple[float, float, float]
    rpy: tuple[float, float, float] = NONE
    axis: tuple[float, float, float] = (0, 0, 1)
    mass: float = 0
    centre: tuple[float, float, float] = NONE
    inertia: tuple[float, float, float, float, float, float] = (0,) * 6
    damping: float = 0
    friction: float = 0


def _round(around: float, along: float) -> tuple[float, ...]:
    return (around, 0, 0, around, 0, along)


def ur5() -> list[Row]:
    """Universal Robots UR5."""
    return [
        Row("world_joint", "fixed", "world", "base_link", NONE, mass=4.0, inertia=_round(0.00443333156, 0.0072)),
        Row("shoulder_pan_joint", "revolute", "base_link", "shoulder_link", (0, 0, 0.089159), mass=3.7, inertia=_round(0.010267495893, 0.00666)),
        Row("shoulder_lift_joint", "revolute", "shoulder_link", "upper_arm_link", (0, 0.13585, 0), (0, RIGHT, 0), (0, 1, 0), 8.393, (0, 0, 0.28), _round(0.22689067591, 0.0151074)),
        Row("elbow_joint", "revolute", "upper_arm_link", "forearm_link", (0, -0.1197, 0.425), NONE, (0, 1, 0), 2.275, (0, 0, 0.25), _round(0.049443313556, 0.004095)),
        Row("wrist_1_joint", "revolute", "forearm_link", "wrist_1_link", (0, 0, 0.39225), (0, RIGHT, 0), (0, 1, 0), 1.219, NONE, _round(0.111172755531, 0.21942)),
        Row("wrist_2_joint", "revolute", "wrist_1_link", "wrist_2_link", (0, 0.093, 0), NONE, (0, 0, 1), 1.219, NONE, _round(0.111172755531, 0.21942)),
        Row("wrist_3_joint", "revolute", "wrist_2_link", "wrist_3_link", (0, 0, 0.09465), NONE, (0, 1, 0), 0.1879, NONE, _round(0.0171364731454, 0.033822)),
        Row("ee_fixed_joint", "fixed", "wrist_3_link", "ee_link", (0, 0.0823, 0), (0, 0, RIGHT)),
        Row("base_link-base_fixed_joint", "fixed", "base_link", "base", NONE, (0, 0, -3.14159265359)),
    ]  # fmt: skip


def z1() -> list[Row]:
    """Unitree Z1 with its gripper: products of inertia in every link."""
    return [
        Row("joint1", "revolute", "link00", "link01", (0, 0, 0.0585), NONE, (0, 0, 1), 0.67332551, (2.47e-06, -0.00025198, 0.02317169), (0.00128328, -6e-08, -4e-07, 0.00071931, 5e-07, 0.00083936), 1, 1),
        Row("joint2", "revolute", "link01", "link02", (0, 0, 0.045), NONE, (0, 1, 0), 1.19132258, (-0.11012601, 0.00240029, 0.00158266), (0.00102138, 0.00062358, 5.13e-06, 0.02429457, -2.1e-06, 0.02466114), 2, 2),
        Row("joint3", "revolute", "link02", "link03", (-0.35, 0, 0), NONE, (0, 1, 0), 0.83940874, (0.10609208, -0.00541815, 0.03476383), (0.00108061, -8.669e-05, -0.00208102, 0.00954238, -1.332e-05, 0.00886621), 1, 1),
        Row("joint4", "revolute", "link03", "link04", (0.218, 0, 0.057), NONE, (0, 1, 0), 0.56404563, (0.04366681, 0.00364738, -0.00170192), (0.00031576, 8.13e-05, 4.091e-05, 0.00092996, -5.96e-06, 0.00097912), 1, 1),
        Row("joint5", "revolute", "link04", "link05", (0.07, 0, 0), NONE, (0, 0, 1), 0.38938492, (0.03121533, 0, 0.00646316), (0.00017605, 4e-07, 5.689e-05, 0.00055896, -1.3e-07, 0.0005386), 1, 1),
        Row("joint6", "revolute", "link05", "link06", (0.0492, 0, 0), NONE, (1, 0, 0), 0.28875807, (0.0241569, -0.00017355, -0.00143876), (0.00018328, 1.22e-06, 5.4e-07, 0.0001475, 8e-08, 0.0001468), 1, 1),
        Row("gripperStator", "fixed", "link06", "gripperStator", (0.051, 0, 0), NONE, (0, 0, 1), 0.52603655, (0.04764427, -0.00035819, -0.00249162), (0.00038683, -0.00000359, 0.00007662, 0.00068614, 0.00000209, 0.00066293)),
        Row("jointGripper", "revolute", "gripperStator", "gripperMover", (0.049, 0, 0), NONE, (0, 1, 0), 0.27621302, (0.01320633, 0.00476708, 0.00380534), (0.00017716, 0.00001683, -0.00001786, 0.00026787, 0.00000262, 0.00035728), 1, 1),
    ]  # fmt: skip


def solo() -> list[Row]:
    """Solo of the Open Dynamic Robot Initiative: a floating base on four legs, of eight joints."""
    rows = [Row("", "", "", "base_link", NONE, mass=1.43315091, inertia=(0.00578574, 0, 0, 0.01938108, 0, 0.02476124))]
    for leg, x, s in (("FL", 0.19, 1), ("FR", 0.19, -1), ("HL", -0.19, 1), ("HR", -0.19, -1)):
        rows += [
            Row(f"{leg}_HFE", "revolute", "base_link", f"{leg}_UPPER_LEG", (x, s * 0.1046, 0), NONE, (0, 1, 0), 0.14853845, (s * 0.00001377, s * 0.01935853, -0.07870700), (0.00041107, 0, 0, 0.00041193, s * 0.00004671, 0.00003024)),
            Row(f"{leg}_KFE", "revolute", f"{leg}_UPPER_LEG", f"{leg}_LOWER_LEG", (0, s * 0.03745, -0.16), NONE, (0, 1, 0), 0.03070001, (0, s * 0.00787644, -0.08928215), (0.00012024, 0, 0, 0.00012029, s * 0.00000305, 0.00000216)),
            Row(f"{leg}_ANKLE", "fixed", f"{leg}_LOWER_LEG", f"{leg}_FOOT", (0, s * 0.008, -0.16), NONE, (0, 0, 1), 0.00693606, (0, 0, 0.00035767), (0.00000057, 0, 0, 0.00000084, 0, 0.00000053)),
        ]  # fmt: skip
    return rows


ROBOTS = {"ur5": ur5, "z1": z1, "solo": solo}


def urdf(name: str, rows: list[Row], more: str = "") -> str:
    """URDF text of a robot."""
    links = {row.child: row for row in rows}
    bare = [row.parent for row in rows if row.parent and row.parent not in links]
    text = [f'<link name="{link}"/>' for link in dict.fromkeys(bare)]
    for row in rows:
        names = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
        moments = " ".join(f'{key}="{value!r}"' for key, value in zip(names, row.inertia, strict=True))
        inertial = f'<inertial><origin xyz="{_triple(row.centre)}"/><mass value="{row.mass!r}"/><inertia {moments}/></inertial>'
        text.append(f'<link name="{row.child}">{inertial if row.mass or any(row.inertia) else ""}</link>')
        if row.joint:
            text.append(
                f'<joint name="{row.joint}" type="{row.kind}"><parent link="{row.parent}"/><child link="{row.child}"/>'
                f'<origin xyz="{_triple(row.xyz)}" rpy="{_triple(row.rpy)}"/><axis xyz="{_triple(row.axis)}"/>'
                f'<limit effort="30" velocity="3" lower="-3" upper="3"/>'
                f'<dynamics damping="{row.damping}" friction="{row.friction}"/></joint>'
            )
    return f'<?xml version="1.0"?>\n<robot name="{name}">{"".join(text)}{more}</robot>\n'


def _triple(values: tuple[float, float, float]) -> str:
    return " ".join(map(repr, values))
