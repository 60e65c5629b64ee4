"""A joint of one's own, in one file: run as a tree joint, as a loop closure and in absolute coordinates, and against built-in joints."""

from dataclasses import replace

import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.derive.common.execute_file import names_defined_by
from hertzwerk.runtime import simulate
from hertzwerk.runtime.loading import engine_model

FILE = '''
from dataclasses import dataclass

from hertzwerk.derive import Direction, Joint


@dataclass(frozen=True, init=False)
class Chain(Joint):
    """Slides (s) and turns (t) about given axes, and balls (b), in the order of a word such as "st"."""

    word: str
    axes: tuple[Direction, ...]

    def __init__(self, name, parent, child, word, *axes):
        super().__init__(name, parent, child, word=word, axes=axes)

    @property
    def freedoms(self):
        axes = iter(self.axes)
        return tuple(
            self.ball() if letter == "b" else {"s": self.slide, "t": self.turn}[letter](next(axes), f"{letter}{i}")
            for i, letter in enumerate(self.word)
        )
'''
SKEW, OTHER, THIRD = hd.Direction((1, 2, -1)), hd.Direction((1, 1, 2)), hd.Direction((2, -1, 1))
CHAINS = {
    "along and about one axis": ("st", SKEW, SKEW), "slide, then turn": ("st", SKEW, OTHER), "turn, then slide": ("ts", SKEW, OTHER),
    "two slides, then a turn": ("sst", hd.X, OTHER, SKEW), "slides on both sides of a turn": ("sts", hd.X, OTHER, SKEW),
    "slides on both sides of two turns": ("stts", hd.X, OTHER, hd.Z, SKEW), "slide between two turns": ("tst", hd.Z, SKEW, OTHER),
    "two slides between two turns": ("tsst", hd.Z, SKEW, hd.Y, OTHER), "slides on and between two turns": ("stst", SKEW, hd.Z, THIRD, OTHER),
    "three turns on a slide": ("sttt", SKEW, hd.Z, OTHER, hd.X), "ball on a slide": ("sb", SKEW),
}  # fmt: skip
FAST = {"along and about one axis", "slide, then turn", "turn, then slide", "slide between two turns"}
MASS, SIZE = hd.Parameter("mass", "kg", 0.9), hd.Parameter("size", "m", 0.3)
INERTIA = tuple(hd.Parameter(f"J_{k}", "kg m^2", value) for k, value in zip("xyz", (0.07, 0.05, 0.03), strict=True))
BODY = hd.Body("body", MASS, INERTIA, (SIZE / 3, 0, SIZE / 5))
PLACES = hd.GROUND.at(SIZE, 0, -SIZE), BODY.at(0, SIZE, 0)
SCALES = hd.Scales(SIZE, hd.Parameter("pace", "m/s", 1.0), SIZE)
FALL = hd.Gravity("gravity", hd.Parameter("g", "m/s^2", 9.81), hd.Direction((1, -3, 1))), hd.EnergyLedger()
TIMES = np.linspace(0, 0.3, 7)


@pytest.fixture(scope="module")
def chain(tmp_path_factory):
    file = tmp_path_factory.mktemp("own") / "chain.py"
    file.write_text(FILE)
    return names_defined_by(file)["Chain"]


def speeds_of(letters):
    return [0.7 - 0.3 * i + 0.2 * (letter == "t") for i, letter in enumerate(letters)]


def scene(*joints, speed, position=None, effects=FALL):
    return hd.Scene(hd.Mechanism("own", joints), effects, SCALES, hd.Start(position or {}, speed))


def numbers(word, names, away):
    """Speeds by name, and where the slides are `away` from zero their travels."""
    units = ["m/s" if letter == "s" else "rad/s" for letter in word]
    values = zip(names, units, speeds_of(word), strict=True)
    travels = [name for letter, name in zip(word, names, strict=True) if letter == "s" and away]
    return {
        "speed": {name: hd.Parameter(f"v{i}", unit, value) for i, (name, unit, value) in enumerate(values)},
        "position": {name.removesuffix("_speed"): SIZE / 2 for name in travels},
    }


def as_tree(chain, word, axes, away=False):
    """The joint carries the body."""
    joint = chain("own", *PLACES, word, *axes)
    return scene(joint, **numbers(word, [freedom.speeds[0].name for freedom in joint.freedoms], away))


def of_built_in(word, axes, away=False):
    """A chain of built-in joints through bodies without mass."""
    kinds, axes, joints, place = {"s": hd.Prismatic, "t": hd.Revolute}, iter(axes), [], PLACES[0]
    for i, letter in enumerate(word):
        child = PLACES[1] if i == len(word) - 1 else hd.Body(f"between{i}", 0)
        ball = letter == "b"
        joints.append(
            hd.Spherical("step", place, child) if ball else kinds[letter](f"step{i}", place, child, next(axes))
        )
        place = child
    names = ["step.angular_speed_x" if letter == "b" else f"step{i}" for i, letter in enumerate(word)]
    return scene(*joints, **numbers(word, names, away))


def as_closure(chain, word, axes, other=None):
    """The body is free, and the joint closes the loop; where all coordinates are zero the axes stand as they are declared."""
    linear, angular, given = np.zeros(3), np.zeros(3), iter(axes)
    for letter, value in zip(word, speeds_of(word), strict=True):
        unit = np.array([1.0, 0, 0]) if letter == "b" else np.array([float(x) for x in next(given).unit])
        (linear if letter == "s" else angular)[:] += value * unit
    names = [f"free.{kind}{k}{tail}" for kind, tail in (("", "_speed"), ("angular_speed_", "")) for k in "xyz"]
    values = [hd.Parameter(f"v{i}", "m/s" if i < 3 else "rad/s", v) for i, v in enumerate([*linear, *angular])]
    closing = chain("own", *PLACES, word, *axes) if other is None else other
    return scene(hd.Free("free", *PLACES), closing, speed=dict(zip(names, values, strict=True)))


def motion(declared):
    """Position and rotation of the body at TIMES."""
    model = engine_model(declared)
    run = simulate(model, duration=float(TIMES[-1]), tolerance=1e-12)
    assert run.outcome.name == "finished"
    assert run.energy_residual < 1e-9
    body = model.module.BODIES.index("body")
    positions, rotations = run.at(TIMES).map("poses", "t q")
    return np.hstack([positions[:, 3 * body :][:, :3], rotations[:, 9 * body :][:, :9]])


@pytest.mark.by_turns(12)
@pytest.mark.parametrize(
    "name", [name if name in FAST else pytest.param(name, marks=pytest.mark.exhaustive) for name in CHAINS]
)
def test_a_joint_of_ones_own_moves_alike_in_all_three_roles_and_as_built_in_joints_do(chain, name):
    word, *axes = CHAINS[name]
    wanted = motion(of_built_in(word, axes))
    tree = as_tree(chain, word, axes)
    assert np.max(np.ptp(wanted, axis=0)) > 0.05
    for declared in (tree, as_closure(chain, word, axes), tree.with_coordinates("absolute")):
        assert np.max(np.abs(motion(declared) - wanted)) < 1e-8


def test_a_slide_that_is_not_carried_along_would_be_noticed(chain):
    word, *axes = CHAINS["turn, then slide"]
    wrong = as_closure(chain, word, axes, other=chain("own", *PLACES, word[::-1], *axes[::-1]))
    assert np.max(np.abs(motion(wrong) - motion(of_built_in(word, axes)))) > 1e-3


# -- what has no rule --------------------------------------------------------------------------------------------------

UNRULED = {
    "turns about parallel axes": ("tst", hd.Z, hd.X, hd.Z),
    "a slide among three turns": ("ttst", hd.X, hd.Y, hd.Z, hd.Z),
    "a turn of a ball": ("bst", hd.Y, hd.X),
}


@pytest.mark.parametrize("name", UNRULED)
def test_joints_without_a_rule_run_as_trees_and_are_refused_in_loops(chain, name):
    word, *axes = UNRULED[name]
    tree = as_tree(chain, word, axes, away=True)
    assert np.max(np.abs(motion(tree) - motion(of_built_in(word, axes, away=True)))) < 1e-8
    with pytest.raises(
        hd.InputError,
        match=r"joint own: found .*: no rule gives the constraints of .* forbid where the joint closes a loop",
    ):
        as_closure(chain, word, axes)
    with pytest.raises(hd.InputError, match=r"joint own: found .*: no rule gives"):
        hd.generate(tree.with_coordinates("absolute"))


def test_freedoms_that_repeat_each_other_are_refused(chain):
    for word, *axes in (
        ("ss", hd.X, -hd.X), ("tt", SKEW, SKEW), ("stts", hd.X, hd.Y, hd.Y, hd.Z), ("tb", hd.X), ("ssss", hd.X, hd.Y, hd.Z, SKEW),
    ):  # fmt: skip
        with pytest.raises(hd.InputError, match="joint own: found redundant freedoms"):
            as_tree(chain, word, axes)


# -- what is measured and shown ----------------------------------------------------------------------------------------


def test_a_freedom_of_ones_own_is_measured_where_it_shows_and_else_refused(chain):
    spring = hd.JointSpring("spring", "own.s1", hd.Parameter("k", "N/m", 40.0), hd.Parameter("rest", "m", 0.1))
    word, *axes = CHAINS["turn, then slide"]
    tree = replace(as_tree(chain, word, axes), effects=(*FALL, spring))
    assert np.max(np.abs(motion(tree) - motion(tree.with_coordinates("absolute")))) < 1e-8
    hd.generate(replace(as_tree(chain, "sst", (hd.X, hd.Y, SKEW)), effects=(*FALL, spring), coordinates="absolute"))
    with pytest.raises(
        hd.InputError, match=r"effect spring: found own\.s1, of a chain joint; expected a freedom that the poses"
    ):
        hd.generate(
            replace(as_tree(chain, "sst", (SKEW, OTHER, hd.X)), effects=(*FALL, spring), coordinates="absolute")
        )


def test_a_joint_of_ones_own_is_drawn_as_the_joint_it_is_like(chain):
    like = {"st": "cylindrical", "s": "prismatic", "tt": "universal", "b": "spherical", "t": "revolute", "": "weld"}
    axes = {"st": (SKEW, SKEW), "tt": (hd.X, SKEW)}
    for word, kind in like.items():
        joint = chain("own", *PLACES, word, *axes.get(word, (hd.X,)))
        assert joint.symbol == kind
        assert [place for place, _, _ in joint.landmarks()] == ["parent", "child"]
