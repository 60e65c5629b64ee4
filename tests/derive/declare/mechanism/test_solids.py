"""Bodies of simple shapes, by quadrature, and inertias with products, by Euler's equations in principal axes."""

import re

import numpy as np
import pytest
import sympy as sp
from scipy.special import ellipj

import hertzwerk.derive as hd
from hertzwerk.runtime import load, simulate

RHO, R, H, L, B, C = (
    hd.Parameter(name, unit, value)
    for name, unit, value in (
        ("rho", "kg/m^3", 7800.0), ("r", "mm", 50.0), ("r_hole", "mm", 20.0), ("l", "mm", 70.0), ("b", "mm", 40.0),
        ("c", "mm", 90.0),
    )
)  # fmt: skip
OFF = (R, -B / 2, L)
SKEW = hd.Direction((1, -2, 2))
SIZES = hd.Scales(length=R, speed=hd.Parameter("pace", "m/s", 1), arm=R)
NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)


def value(expression) -> float:
    return float(sp.sympify(expression).xreplace({p: sp.Float(p.si, 17) for p in (RHO, R, H, L, B, C)}))


def points_of(kind, axis=(0, 0, 1), centre=(0, 0, 0)):
    """Quadrature points of a solid [m] and their volumes [m^3], by its textbook definition."""
    r, h, l, b, c = (p.si for p in (R, H, L, B, C))
    grid = np.array(np.meshgrid(NODES, NODES, NODES, indexing="ij")).reshape(3, -1)
    weights = np.prod(np.array(np.meshgrid(WEIGHTS, WEIGHTS, WEIGHTS, indexing="ij")).reshape(3, -1), axis=0)
    if kind == "box":
        return (grid * np.array([[l], [b], [c]]) / 2).T + centre, weights * l * b * c / 8
    s, turn, z = (grid[0] + 1) / 2, np.pi * grid[1], grid[2]
    if kind == "sphere":
        z, most = r * z, np.sqrt(r**2 - (r * z) ** 2)
        radius, volume = s * most, s * most**2 / 2 * np.pi * r
    elif kind == "cone":  # its base at z = 0
        z = l * (z + 1) / 2
        most = r * (1 - z / l)
        radius, volume = s * most, s * most**2 / 2 * np.pi * l / 2
        z = z - l / 4
    else:
        least = h if kind == "tube" else 0.0
        radius = least + s * (r - least)
        z, volume = z * l / 2, radius * (r - least) / 2 * np.pi * l / 2
    axis = np.array(axis, float) / np.linalg.norm(axis)
    side = np.cross(axis, [0.3, 0.5, -0.9])
    side /= np.linalg.norm(side)
    at = np.outer(radius * np.cos(turn), side) + np.outer(radius * np.sin(turn), np.cross(axis, side))
    return at + np.outer(z, axis) + centre, weights * volume


def moments(*solids):
    """Mass, mass centre and inertia about it of solids (points, volumes, sign)."""
    at = np.concatenate([points for points, _, _ in solids])
    mass = RHO.si * np.concatenate([sign * volumes for _, volumes, sign in solids])
    centre = mass @ at / mass.sum()
    arm = at - centre
    return (
        mass.sum(), centre, np.einsum("n,nij->ij", mass, (arm**2).sum(1)[:, None, None] * np.eye(3) - arm[:, :, None] * arm[:, None, :]),
    )  # fmt: skip


def agree(body, mass, centre, inertia):
    assert value(body.mass) == pytest.approx(mass, rel=1e-12)
    assert [value(c) for c in body.centre] == pytest.approx(centre, abs=1e-14)
    assert np.array([[value(J) for J in row] for row in body.tensor]) == pytest.approx(inertia, rel=1e-11, abs=1e-15)


STEEL = hd.Material(hd.Parameter("E", "GPa", 210), hd.Parameter("nu", "1", 0.3), RHO)
SOLIDS = {
    "box": lambda **k: hd.Body.box("it", L, B, C, **k), "sphere": lambda **k: hd.Body.sphere("it", R, **k),
    "cylinder": lambda **k: hd.Body.cylinder("it", R, L, axis=SKEW, **k), "tube": lambda **k: hd.Body.tube("it", R, H, L, axis=SKEW, **k),
    "cone": lambda **k: hd.Body.cone("it", R, L, axis=SKEW, **k),
}  # fmt: skip


@pytest.mark.parametrize("kind", SOLIDS)
def test_masses_and_inertias_of_solids_are_their_integrals(kind):
    points, volumes = points_of(kind, SKEW.components, [value(c) for c in OFF])
    expected = moments((points, volumes, 1))
    agree(SOLIDS[kind](density=STEEL, centre=OFF), *expected)
    agree(SOLIDS[kind](mass=RHO * value(1) * volumes.sum(), centre=OFF), *expected)


def test_a_rod_is_a_cylinder_without_a_radius():
    mass = hd.Parameter("m", "kg", 2)
    assert hd.Body.rod("it", L, mass=mass, axis=hd.X).inertia == (0, mass * L**2 / 12, mass * L**2 / 12)


def test_a_body_of_parts_and_holes_is_the_integral_over_what_is_left():
    bore = (L / 4, B / 4, 0)
    block = hd.Body.box("block", L, B, C, density=RHO)
    pin = hd.Body.cylinder("pin", R, L, density=RHO, axis=hd.X, centre=OFF)
    hole = hd.Body.cylinder("hole", H, L, density=RHO, centre=bore)
    body = hd.Body.of("it", block, pin, without=(hole,))
    drilled = points_of("tube", centre=[value(c) for c in bore])
    cut = points_of("cylinder", centre=[value(c) for c in bore])
    solids = (*points_of("box"), 1), (*points_of("cylinder", (1, 0, 0), [value(c) for c in OFF]), 1)
    agree(body, *moments(*solids, (*cut, -1), (*drilled, 1)))
    assert body.has_products
    assert [shape.hole for shape in body.shapes] == [False, False, True]
    mirrored = hd.Body.of(
        "it", pin, hd.Body.cylinder("other", R, L, density=RHO, axis=hd.X, centre=tuple(-c for c in OFF))
    )
    assert [value(c) for c in mirrored.centre] == [0, 0, 0]


def test_a_radius_changes_the_mass():
    """A disc on a torsional spring: omega^2 = k/J, and J goes with the fourth power of the radius."""
    disc = hd.Body.cylinder("disc", R, L, density=RHO)
    scene = hd.Scene(
        hd.Mechanism("torsion", (hd.Revolute("shaft", hd.GROUND, disc, axis=hd.Z),)),
        (hd.JointSpring("spring", "shaft", hd.Parameter("k", "N m/rad", 2.0)), hd.EnergyLedger()),
        SIZES,
        hd.Start(position={"shaft": hd.Parameter("lift", "rad", 0.2)}),
    )
    model = load(scene)
    for radius in (0.05, 0.04):
        rate = np.sqrt(2.0 / (RHO.si * np.pi * radius**4 * L.si / 2))
        run = simulate(model, duration="0.5 s", accuracy=1e-8, parameters={"r": f"{radius} m"})
        assert run["shaft.angle"][-1] == pytest.approx(0.2 * np.cos(rate * 0.5), abs=1e-8)


# -- products of inertia -----------------------------------------------------------------------------------------------

TURNED = np.array([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3  # principal axes in the body's, by columns
PRINCIPAL = np.array([1.0, 2.0, 2.6])


def tumbling(coordinates, tensor, spin):
    """A free body of a tensor, its angular velocity given in its own axes [rad/s]."""
    J = [
        [hd.Parameter(f"J_{min(i, k)}{max(i, k)}", "kg m^2", float(tensor[min(i, k), max(i, k)])) for k in range(3)]
        for i in range(3)
    ]
    body = hd.Body("body", hd.Parameter("m", "kg", 1), tuple(map(tuple, J)), centre=(R, L, B))
    speeds = {
        f"pivot.angular_speed_{k}": hd.Parameter(f"w_{k}", "rad/s", float(w)) for k, w in zip("xyz", spin, strict=True)
    }
    joint = hd.Spherical("pivot", hd.GROUND, body.at(R, L, B))
    return hd.Scene(
        hd.Mechanism("tumbling", (joint,)), (hd.EnergyLedger(),), SIZES, hd.Start(speed=speeds), coordinates=coordinates
    )


def euler(spin, t):
    """Angular velocity in principal axes from a start without a third component; Landau, Lifshitz, Mechanics, 37."""
    I1, I2, I3 = PRINCIPAL
    twice, square = PRINCIPAL @ spin**2, PRINCIPAL**2 @ spin**2
    assert square > twice * I2  # about the axis of the largest inertia
    rate = np.sqrt((I3 - I2) * (square - twice * I1) / (I1 * I2 * I3))
    modulus = (I2 - I1) * (twice * I3 - square) / ((I3 - I2) * (square - twice * I1))
    sn, cn, dn, _ = ellipj(rate * t, modulus)
    size = [
        np.sqrt((twice * I3 - square) / (I1 * (I3 - I1))),
        np.sqrt((twice * I3 - square) / (I2 * (I3 - I2))),
        np.sqrt((square - twice * I1) / (I3 * (I3 - I1))),
    ]
    return np.array([size[0] * cn, size[1] * sn, size[2] * dn])


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("spin", [(3.0, 0.0, 4.0), (3.0, 0.0, 2.9815)], ids=["tumbling", "Dzhanibekov"])
def test_a_free_body_with_products_of_inertia_turns_as_in_its_principal_axes(coordinates, spin):
    """Euler's equations; the second spin comes within 1e-3 of the intermediate axis, and turns over."""
    spin = np.array(spin)
    scene = tumbling(coordinates, TURNED @ np.diag(PRINCIPAL) @ TURNED.T, TURNED @ spin)
    run = simulate(load(scene), duration="6 s", accuracy=1e-8)
    name = "pivot" if coordinates == "tree" else "body"
    t = np.linspace(0, 6, 25)
    actual = np.array([run.at(t)[f"{name}.angular_speed_{k}"] for k in "xyz"])
    expected = np.array([TURNED @ euler(spin, time) for time in t]).T
    assert actual == pytest.approx(expected, abs=3e-6 * np.linalg.norm(spin))
    assert np.ptp(expected[1]) > 1


@pytest.mark.parametrize(
    ("tensor", "found"),
    [
        (((1.0, 2.0, 0.0), (2.0, 1.0, 0.0), (0.0, 0.0, 1.0)), "principal values -1, 1, 3 kg m^2; expected three positive ones"),
        (((1.0, 0.1, 0.0), (0.1, 1.0, 0.0), (0.0, 0.0, 4.0)), "principal values 0.9, 1.1, 4 kg m^2; expected none larger"),
    ],
)  # fmt: skip
def test_a_tensor_of_no_body_is_refused(tensor, found):
    with pytest.raises(hd.InputError, match=re.escape(f"body body, inertia: found {found}")):
        tumbling("tree", np.array(tensor), (1, 2, 3))


def test_faults_of_shapes_come_at_once():
    with pytest.raises(hd.InputError) as caught:
        hd.Body.cylinder("wheel", "5 mm", None, density=RHO, mass=RHO, centre=(0, 0))
    assert [fault.where for fault in caught.value.faults] == ["radius", "length", "mass", "centre"]
    with pytest.raises(hd.InputError, match="neither a density nor a mass"):
        hd.Body.sphere("ball", R)
    with pytest.raises(hd.InputError, match="part plain"):
        hd.Body.of("it", hd.Body("plain", RHO))
    one, other = hd.Parameter("J_1", "kg m^2", 1), hd.Parameter("J_2", "kg m^2", 0.1)
    skewed = hd.Body("skewed", hd.Parameter("m", "kg", 1), ((one, other, 0), (0, one, 0), (0, 0, one)))
    with pytest.raises(hd.InputError, match="inertia J_xy: found J_2 beside J_yx = 0; expected a symmetric tensor"):
        hd.Scene(hd.Mechanism("bad", (hd.Free("flight", hd.GROUND, skewed),)), (), SIZES)
    hollow = hd.Body.tube("tube", H, R, L, density=RHO)
    with pytest.raises(hd.InputError, match="body tube, mass"):
        hd.Scene(hd.Mechanism("bad", (hd.Free("flight", hd.GROUND, hollow),)), (), SIZES)
