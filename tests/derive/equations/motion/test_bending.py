"""Flexible rods: shapes against SciPy, mass matrix against quadrature of the kinetic energy, equations against energy."""

from functools import cache

import casadi as ca
import numpy as np
import pytest
from derived import Derived, energy_balance

import hertzwerk.derive as hd
from hertzwerk.derive import GROUND, FlexibleRod, Parameter, X, Y, Z
from hertzwerk.derive.expressions.algebra.bending_shapes import BendingShapes
from reference.elastic_rods import POINTS, WEIGHTS, kinetic_energy, root, shapes

LENGTH, SHORT = Parameter("length", "m", 0.8), Parameter("short", "m", 0.5)
MASS, LIGHT = Parameter("mass", "kg", 0.9), Parameter("light", "kg", 0.4)
STIFF, SOFT, TWIST = (
    Parameter("stiff", "N m^2", 30.0), Parameter("soft", "N m^2", 20.0), Parameter("twist", "kg m^2", 1e-3),
)  # fmt: skip
OUT, TILT = Parameter("out", "m", 0.1), Parameter("tilt", "rad", 0.4)


def body(name, mass, inertia, centre):
    x, y, z = (Parameter(f"{name}_{axis}", "m", value) for axis, value in zip("xyz", centre, strict=True))
    J = tuple(Parameter(f"{name}_J{axis}", "kg m^2", value) for axis, value in zip("xyz", inertia, strict=True))
    return hd.Body(name, Parameter(f"{name}_mass", "kg", mass), J, (x, y, z))


HUB = body("hub", 2.0, (0.01, 0.02, 0.025), (0.03, -0.02, 0.0))
TIP = body("tip", 0.7, (4e-3, 5e-3, 6e-3), (0.05, 0.04, 0.0))
ROD = FlexibleRod("rod", LENGTH, MASS, STIFF)
PINNED = FlexibleRod("rod", LENGTH, MASS, STIFF, ends=("pinned", "pinned"))
ROUND = FlexibleRod(
    "rod", LENGTH, MASS, STIFF, stiffness_z=SOFT, ends=("clamped", "clamped"), cubics=True, modes=1, twist_inertia=TWIST
)
ARM = FlexibleRod("arm", SHORT, LIGHT, STIFF, modes=1, cubics=True)
ROUND_ARM = FlexibleRod("arm", SHORT, LIGHT, STIFF, stiffness_z=SOFT, modes=1, twist_inertia=TWIST)
HINGE, TILTED = hd.Revolute("hinge", GROUND, HUB, Z), hd.Weld("seat", HUB.at(OUT, 0, 0).turned(X, TILT), ROD.start)
JOINTS = {
    "hinged": (hd.Revolute("hinge", GROUND, PINNED.start, Z), PINNED),
    "on a hub, turned": (HINGE, hd.Weld("seat", HUB.at(OUT, OUT, 0).turned(Z, TILT), ROD.start), ROD, hd.Weld("load", ROD.end, TIP)),
    "two in a row": (HINGE, hd.Revolute("elbow", HUB.at(OUT, 0, 0), ROD.start, Z), ROD, hd.Revolute("wrist", ROD.end, ARM.start, Z),
                     ARM, hd.Revolute("hand", ARM.end, TIP, Z)),
    "across its spin": (hd.Revolute("hinge", GROUND, ROD.start, Y), ROD),
    "free in space": (hd.Free("base", GROUND, ROUND.start), ROUND),
    "in space, two in a row": (hd.Revolute("hinge", GROUND, HUB, hd.Direction((1, 2, -1))), TILTED, ROD,
                               hd.Universal("wrist", ROD.end, ROUND_ARM.start), ROUND_ARM, hd.Weld("load", ROUND_ARM.end, TIP)),
}  # fmt: skip


def scene(name, coordinates="tree"):
    gravity = hd.Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y)
    scales = hd.Scales(length=LENGTH, speed=Parameter("pace", "m/s", 1), arm=LENGTH)
    return hd.Scene(hd.Mechanism("rods", JOINTS[name]), (gravity, hd.EnergyLedger()), scales, coordinates=coordinates)


@cache
def derived_of(name, coordinates="tree"):
    return Derived(scene(name, coordinates))


def state(derived, bent):
    """Random coordinates and speeds, those of the shapes times `bent`."""
    rng = np.random.default_rng(1)
    tables = derived.COORDINATES, derived.SPEEDS
    sides = [np.array([bent if ".bend_" in name else 1.0 for name, _ in table]) for table in tables]
    q, u = (rng.uniform(-1, 1, side.size) * side for side in sides)
    return derived.of_norm_one(q), u


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("name", JOINTS)
def test_kinetic_energy_is_that_of_the_sections_to_second_order(name, coordinates):
    """Of what is left, an error of third order falls by 8 as the deflections halve."""
    derived = derived_of(name, coordinates)
    rods = [joint for joint in JOINTS[name] if isinstance(joint, FlexibleRod)]
    exact = kinetic_energy(derived, rods, [part for part in (HUB, TIP) if part.name in derived.BODIES])
    errors = []
    for bent in (0.004, 0.002):
        q, u = state(derived, bent)
        energy = derived.call("energy", q=q, u=u)[0][0]
        errors.append(abs(energy - float(exact(q, u))) / energy)
    assert errors[0] < 2e-5
    assert errors[1] < errors[0] / 4 or errors[1] < 1e-9


@pytest.mark.parametrize("name", JOINTS)
def test_equations_keep_the_energy_and_invert_the_mass_matrix(name):
    derived = derived_of(name)
    q, u = state(derived, 0.01)
    force = np.random.default_rng(2).uniform(-1, 1, derived.nu)
    assert energy_balance(derived, 0.0, q, u, force, force @ u) < 1e-12
    at = ca.SX.sym("u", derived.nu)
    kinetic = ca.SX(derived.results("energy", {"q": q, "u": at})[0])
    mass = ca.Function("M", [at], [ca.hessian(kinetic, at)[0]])(u).full()
    inverse = derived.jacobian("accelerations", "f", q=q, u=u, f=np.zeros(derived.nu))
    assert np.allclose(mass @ inverse, np.eye(derived.nu), atol=1e-8)


@pytest.mark.parametrize("name", [name for name in JOINTS if "free" not in name])
def test_accelerations_are_those_of_lagrange_for_that_energy(name):
    """Gyroscopic forces, which do no work, are among them."""
    derived = derived_of(name)
    q, u = state(derived, 0.01)
    force = np.random.default_rng(3).uniform(-1, 1, derived.nu)
    a, _ = derived.call("accelerations", q=q, u=u, f=derived.call("applied", q=q, u=u) + force)
    x, v = ca.SX.sym("q", derived.nq), ca.SX.sym("u", derived.nu)
    kinetic, potential, _ = derived.results("energy", {"q": x, "u": v})
    momentum = ca.gradient(ca.SX(kinetic), v)
    left = ca.jtimes(momentum, v, a) + ca.jtimes(momentum, x, v) - ca.gradient(ca.SX(kinetic - potential), x) - force
    size = ca.jtimes(momentum, v, a)
    residual, moving = (part.full().ravel() for part in ca.Function("L", [x, v], [left, size])(q, u))
    assert np.max(np.abs(residual)) < 1e-9 * np.max(np.abs(moving))


@pytest.mark.parametrize("ends", [("clamped", "free"), ("clamped", "clamped"), ("pinned", "pinned")])
def test_shapes_are_those_of_the_textbook(ends):
    made, of = BendingShapes(ends, 3, True), shapes(ends, 3, True)
    values = np.array([[shape(x) for shape, _ in of] for x in POINTS])
    slopes = np.array([[slope(x) for _, slope in of] for x in POINTS])
    signs = np.sign(np.array(made.at(0.1, 0), float) * [shape(0.1) for shape, _ in of])
    values, slopes = values * signs, slopes * signs
    assert np.allclose(made.roots, [root(ends, k) for k in (1, 2, 3)], rtol=1e-13)
    assert np.allclose(np.array(made.products(0), float), (values.T * WEIGHTS) @ values, atol=1e-11)
    turning = (slopes.T * (WEIGHTS * (1 - POINTS**2) / 2)) @ slopes
    assert np.allclose(np.array(made.products(1, lambda x: (1 - x**2) / 2), float), turning, atol=1e-10)
    assert np.allclose(np.array(made.integrals(1), float), values.T @ (WEIGHTS * POINTS), atol=1e-12)
    assert np.allclose(np.array(made.at(1, 1), float), [slope(1.0) for _, slope in of] * signs, atol=1e-10)


@pytest.mark.parametrize(
    ("ends", "roots"),
    [
        (("clamped", "free"), (1.87510406871, 4.69409113297, 7.85475743824)), (("clamped", "pinned"), (3.92660231205, 7.06858274563, 10.2101761228)),
        (("free", "free"), (4.73004074486, 7.85320462410, 10.9956078380)), (("free", "pinned"), (3.92660231205, 7.06858274563, 10.2101761228)),
    ],
)  # fmt: skip
def test_roots_are_those_of_blevins(ends, roots):
    """Formulas for Natural Frequency and Mode Shape (1979), table 8-1."""
    assert np.allclose(BendingShapes(ends, 3, False).roots, roots, rtol=1e-11)
