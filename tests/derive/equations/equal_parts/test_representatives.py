"""Bodies and pairs that are alike: derived once, with the values, names and tables of a derivation of each."""

from dataclasses import replace
from functools import cache
from itertools import pairwise

import casadi as ca
import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.derive.equations.contact.pairs.on_sphere_or_cylinder import RoundTouch
from hertzwerk.derive.equations.derivation import derive, generate
from hertzwerk.derive.equations.equal_parts.equal_declarations import alike
from hertzwerk.derive.laws import coulomb, flores, power, smooth_coulomb
from hertzwerk.derive.program.emit.module_text import emit
from hertzwerk.runtime.engine.model.generated_text import module_of
from hertzwerk.runtime.engine.model.model import _INPUTS, EngineModel
from reference.scenes import balls, spheres_in_box

M, J, R = hd.Parameter("mass", "kg", 1), hd.Parameter("inertia", "kg m^2", 1e-3), hd.Parameter("radius", "m", 0.05)
HEAVY, E = hd.Parameter("heavy", "kg", 3), hd.Parameter("restitution", "1", 0.8)
SCALES = hd.Scales(length=R, arm=R, speed=hd.Parameter("pace", "m/s", 1))
GRAVITY = hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 9.81), direction=-hd.Y)
LAW = power(hd.Parameter("stiffness", "N/m^1.5", 1e7), n=1.5), flores(E)
SOFT = power(hd.Parameter("soft", "N/m", 1e5), n=1), flores(E)
RUB = smooth_coulomb(hd.Parameter("mu", "1", 0.3), hd.Parameter("creep", "m/s", 1e-3))


def scene(bodies, pairs, effects, joint=hd.Planar, joints=None):
    """Bodies on joints of their own, with pairs and effects beside gravity and a ledger."""
    joints = joints or tuple(joint(f"free_{i}", hd.GROUND, body) for i, body in enumerate(bodies))
    return hd.Scene(hd.Mechanism("many", joints, pairs), (GRAVITY, *effects, hd.EnergyLedger()), SCALES)


def two_masses():
    bodies = [hd.Body(f"ball_{i}", M if i < 4 else HEAVY, J) for i in range(1, 8)]
    effects = (
        hd.Contact("balls", *LAW), hd.Friction("rub", "balls", RUB), hd.RollingResistance("roll", "balls", R / 50, hd.Parameter("w", "rad/s", 1)),
    )  # fmt: skip
    return scene(bodies, hd.every_pair("balls", bodies, R), effects)


def one_exception():
    bodies = [hd.Body(f"ball_{i}", M, J) for i in range(1, 7)]
    return scene(bodies, hd.every_pair("balls", bodies, R), (hd.Contact("balls", *LAW), hd.Contact("balls_1_3", *SOFT)))


def off_centre():
    """Spheres in space about a point beside the mass centre, but for the last one's, and a floor of friction."""
    bodies = [hd.Body(f"ball_{i}", M, (J, 2 * J, 3 * J)) for i in range(1, 7)]
    places = [body.at(0, 0, R / (2 if i < 5 else 3)) for i, body in enumerate(bodies)]
    floor = [
        hd.SphereOnPlane(f"floor_{i}", place, R, plane=hd.GROUND.at(0, 0, 0), normal=hd.Y)
        for i, place in enumerate(places)
    ]
    effects = [
        hd.Contact("balls", *LAW),
        *(hd.Contact(pair.name, *LAW) for pair in floor),
        *(hd.Friction(f"{pair.name}_rub", pair.name, RUB) for pair in floor),
    ]
    return scene(bodies, (*hd.every_pair("balls", places, R), *floor), effects, hd.Free)


def two_links():
    """Double pendulums beside one another, with a sphere at each end."""
    joints, places = [], []
    for i in range(1, 7):
        upper, lower = hd.Body(f"upper_{i}", M, J, centre=(0, -R, 0)), hd.Body(f"lower_{i}", M, J, centre=(0, -R, 0))
        joints += [
            hd.Revolute(f"top_{i}", hd.GROUND, upper, axis=hd.Z),
            hd.Revolute(f"knee_{i}", upper.at(0, -4 * R, 0), lower, axis=hd.Z),
        ]
        places.append(lower.at(0, -4 * R, 0))
    return scene([], hd.every_pair("ends", places, R), (hd.Contact("ends", *LAW),), joints=tuple(joints))


def sticking():
    """Friction and rolling resistance with modes, of spheres and on a floor, in space."""
    bodies = [hd.Body(f"ball_{i}", M, (J, J, J)) for i in range(1, 6)]
    floor = [
        hd.SphereOnPlane(f"floor_{i}", body.at(0, 0, 0), R, plane=hd.GROUND.at(0, 0, 0), normal=hd.Y)
        for i, body in enumerate(bodies)
    ]
    dry = coulomb(hd.Parameter("kinetic", "1", 0.3), hd.Parameter("static", "1", 0.4))
    effects = [
        hd.Contact("balls", *LAW), hd.Friction("rub", "balls", dry), hd.RollingResistance("roll", "balls", R / 50),
    ]  # fmt: skip
    effects += [
        e for pair in floor for e in (hd.Contact(pair.name, *LAW), hd.Friction(f"{pair.name}_rub", pair.name, dry))
    ]
    return scene(bodies, (*hd.every_pair("balls", bodies, R), *floor), effects, hd.Free)


SCENES = {
    "sticking": sticking, "box": lambda: spheres_in_box(4), "plane": lambda: balls(4), "two_masses": two_masses, "one_exception": one_exception,
    "off_centre": off_centre, "two_links": two_links,
}  # fmt: skip
KINDS = {
    "sticking": ["balls", "floor"], "box": ["balls", "floor", "wall_1", "wall_2", "wall_3", "wall_4"], "plane": ["pair", "floor"],
    "two_masses": ["balls", "balls_2", "balls_3"], "one_exception": ["balls", "balls_1_3"], "off_centre": ["balls", "balls_2", "floor", "floor_5"],
    "two_links": ["ends"],
}  # fmt: skip


@cache
def models(name):
    """Model of the kinds, and that of all parts, each derived by itself."""
    made = SCENES[name]()
    found = alike(made)
    return EngineModel(module_of("kinds", generate(made))), EngineModel(
        module_of("each", emit(derive(found.scene), ""))
    )


def values(model, name, given, c):
    names = _INPUTS["contact" if name.startswith("contact_") else name].split()
    return model.evaluate(name, *(c if name == "c" else given[name] for name in names))


@pytest.mark.parametrize("name", SCENES)
def test_equal_parts_are_found_with_the_tables_of_a_derivation_of_each(name):
    assert [kind.name for kind in alike(SCENES[name]()).pairs] == KINDS[name]
    kinds, each = (model.module for model in models(name))
    tables = [table for table in vars(each) if table.isupper() and table not in OWN]
    assert len(tables) > 12
    assert {table: getattr(kinds, table) for table in tables} == {table: getattr(each, table) for table in tables}


OWN = ("CONSTANTS", "OPERATIONS", "SOURCE", "DIGEST", "FAMILIES")  # of how it is written


@pytest.mark.parametrize("name", SCENES)
def test_values_are_those_of_a_derivation_of_each(name):
    """But for the rounding of sums, whose terms SymPy orders by names, and of those over bodies."""
    kinds, each = models(name)
    random = np.random.default_rng(36)
    p = each.bind().p
    constants = [model.evaluate("constants", p)[0] for model in (kinds, each)]
    functions = [
        *(f for f in _INPUTS if each.has_function(f) and f != "constants"),
        *(f"contact_{pair}" for pair in each.pairs),
    ]
    touching = 0
    for _ in range(4):
        given = {name: random.uniform(-0.1, 0.1, each._size(name)) for name in ("q", "u", "z", "a", "f", "reactions")}
        given |= {"t": 0.0, "p": p, "m": random.uniform(0.1, 1, each.nm)}
        for function in functions:
            here, there = (values(model, function, given, c) for model, c in zip((kinds, each), constants, strict=True))
            for one, other in zip(here, there, strict=True):
                if name in ("box", "plane") and function != "energy":
                    assert one.tobytes() == other.tobytes(), function
                else:
                    assert one == pytest.approx(other, rel=1e-11, abs=1e-13), function
            touching += function.startswith("contact_") and here[2][0] != 0
    assert touching > 4


def test_the_text_grows_with_the_kinds():
    few, many = (generate(spheres_in_box(n)).count("\n") for n in (4, 12))
    assert many < few + 12  # 8 bodies and 100 pairs more


def test_functions_of_a_kind_take_own_entries_alone():
    """What FAMILIES says of rows is what `contact_<pair>` of the whole vectors reads and returns."""
    model, _ = models("box")
    random = np.random.default_rng(1)
    c, module = model.bind().c, model.module
    q, u, z, m = (random.uniform(-0.02, 0.02, model._size(name)) for name in "quzm")
    order = [name for _, members in module.FAMILIES for name, *_ in members]
    assert order == [*model.pairs]
    for family, members in module.FAMILIES:
        for name, of_q, of_u, of_z, of_m in members[-2:]:
            own = getattr(module, f"contact_of_{family}")
            given = (0.0, q[of_q], u[of_u], z[of_z], m[of_m], c)
            f, dz, force, *_ = (np.array(ca.DM(x)).ravel() for x in own(*(ca.DM(x) for x in given)))
            whole_f, whole_dz, whole_force, *_ = model.evaluate(f"contact_{name}", 0.0, q, u, z, m, c)
            assert whole_force == force
            assert np.array_equal(whole_f[of_u], f)
            assert np.count_nonzero(np.delete(whole_f, of_u)) == 0
            assert np.array_equal(whole_dz[of_z], dz)


def springs():
    made = one_exception()
    return replace(
        made, effects=(*made.effects, hd.JointSpring("hold", "free_0.x", stiffness=hd.Parameter("hold", "N/m", 10)))
    )


class ShyTouch(RoundTouch):
    """Its gap depends on the height of the first of all bodies, whichever it is on."""

    @property
    def gap(self):
        first = self.kin.mechanism.bodies[0]
        return super().gap + self.kin.point(first.at(0, 0, 0), "first")[0][1]


class Shy(hd.SphereOnSphere):
    def touch(self, kinematics):
        return ShyTouch(self, kinematics)


def shy():
    bodies = [hd.Body(f"ball_{i}", M, J) for i in range(1, 7)]
    pairs = tuple(
        Shy(f"shy_{i}", one.at(0, 0, 0), other.at(0, 0, 0), R, R)
        for i, (one, other) in enumerate(pairwise(bodies[1:]), 1)
    )
    return scene(bodies, pairs, tuple(hd.Contact(pair.name, *LAW) for pair in pairs))


def test_a_pair_that_reads_other_bodies_is_derived_by_itself():
    made = shy()
    assert len(alike(made).pairs) == 1
    assert generate(made) == emit(derive(made), "")


@pytest.mark.parametrize("made", [springs, lambda: balls(2), lambda: replace(balls(5), coordinates="absolute")])
def test_a_scene_of_other_ties_is_derived_in_full(made):
    made = made()
    assert alike(made) is None
    assert generate(made) == emit(derive(made), "")


def test_a_start_of_each_its_own_makes_no_kind():
    made = one_exception()
    start = hd.Start(position={"free_2.x": hd.Parameter("x", "m", 1)})
    assert len(alike(replace(made, start=start)).pairs) == 2
