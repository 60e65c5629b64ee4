"""Repeated sub-programs: a module that calls functions has every value of one that is written out, bit by bit."""

import random
from dataclasses import replace
from importlib import import_module
from keyword import iskeyword

import casadi as ca
import numpy as np
import pytest
from each import each
from kane import chain

from hertzwerk.derive.common.faults import InputError
from hertzwerk.derive.common.module_format import sealed
from hertzwerk.derive.equations.derivation import derive
from hertzwerk.derive.program.emit.module_text import emit
from hertzwerk.derive.program.emit.printer import function_text
from hertzwerk.derive.program.repetition import Block, share, step_of
from hertzwerk.derive.scenes import NAMES
from hertzwerk.runtime.engine.model.generated_text import module_of
from reference.scenes import balls

STATES = 16  # of which some have each pair in contact


def results(program, module):
    """Length of every function of a module, and its results at random states as bytes, by its name."""
    random_state = np.random.default_rng(36)
    sizes = {"t": 1, "c": sum(len(program.entries(symbol)) for symbol in program.constants)}
    for group in program.tape.inputs.values():
        if group not in sizes:
            sizes[group] = list(program.tape.inputs.values()).count(group)
    found = {}
    for function in program.functions:
        symbols = [ca.MX.sym(name, sizes.get(name, 0)) for name in function.arguments]
        states = [[random_state.uniform(0.1, 1.5, symbol.numel()) for symbol in symbols] for _ in range(STATES)]
        columns = getattr(module, function.name)(*symbols)
        columns = [ca.densify(ca.MX(column)) for column in (columns if isinstance(columns, tuple) else (columns,))]
        built = ca.Function(function.name, symbols, [ca.vertcat(*columns)])
        found[function.name] = built.n_instructions(), b"".join(np.asarray(built(*state)).tobytes() for state in states)
    return found


def written_out(program, text):
    """The module of a text, its builders replaced by those that call nothing."""
    functions = "\n\n".join(function_text(program, function) for function in program.functions)
    return module_of("written_out", sealed(f"{text}\n\n{functions}\n"))


def different(program, text):
    """Names of the functions that have other values in a text than written out, or more instructions."""
    called, plain = (results(program, module) for module in (module_of("called", text), written_out(program, text)))
    return [name for name in plain if plain[name][1] != called[name][1] or plain[name][0] < called[name][0]]


def derived(name, coordinates="tree"):
    """Audited program of a built-in scene."""
    scene = import_module(f"hertzwerk.derive.scenes.{name}").scene
    return derive(replace(scene, coordinates=coordinates))


@pytest.mark.by_turns(12)
@pytest.mark.parametrize("coordinates", ["tree", pytest.param("absolute", marks=pytest.mark.exhaustive)])
@pytest.mark.parametrize("name", NAMES)
def test_calls_change_no_bit(name, coordinates):
    try:
        program = derived(name, coordinates)
    except InputError as refused:
        pytest.skip(str(refused).splitlines()[-1])
    assert different(program, emit(program, "")) == []


@pytest.mark.parametrize(("n", "most"), [(3, 540), (5, 705), pytest.param(11, 1630, marks=pytest.mark.exhaustive)])
def test_a_further_pair_takes_few_lines(n, most):
    """522, 686 and 1,588 lines for 3, 10 and 55 pairs and the floor; without it 760, 1,592 and 7,297 when each pair was written out."""
    program = derive(balls(n))
    text = emit(program, "")
    assert len(text.splitlines()) <= most
    assert different(program, text) == []


def test_a_further_link_takes_few_lines():
    """Links of a chain in its joints' coordinates serve the same results: their names alone keep them apart. 60 lines when they did not."""
    texts = {}
    for n in (12, 20):
        program = derive(chain(n, "Z").scene())
        texts[n] = emit(program, "")
    assert different(program, texts[20]) == []
    assert len(texts[20].splitlines()) - len(texts[12].splitlines()) <= 8 * 46


@pytest.mark.parametrize(
    ("right", "wrong", "where"),
    [
        ("sphere_on_sphere_arm(q[2], u[2], length)", "sphere_on_sphere_arm(u[2], q[2], length)", "gaps"),
        ("return normal_force, normal_power,", "return normal_power, normal_force,", "contact_contact_2"),
        (" = first_speed*arm_x - second_speed*x1", " = second_speed*arm_x - first_speed*x1", "contact_contact_1"),
    ],
)  # fmt: skip
def test_two_leaves_that_changed_places_are_noticed(right, wrong, where):
    program = derived("newtons_cradle")
    text = emit(program, "")
    assert right in text
    assert where in different(program, sealed(text.replace(right, wrong)))


def block(name, code, results, inputs="a b c d e f g h"):
    """A block of assignments, one a line; results as `owner: name name`."""
    lines = [line.split(" = ") for line in code.split("\n") if line]
    places = {each: f"q[{k}]" for k, each in enumerate(inputs.split())}
    known = {*places, *(target.strip() for target, _ in lines)}
    steps = [step_of(target.strip(), text, known) for target, text in lines]
    owned = [(owner.strip(), names.split()) for owner, names in (each.split(":") for each in results.split(";"))]
    return Block(name, ("q",), steps, owned, places)


def values(blocks, shared, given):
    """Values of the results of blocks, whose functions and code run as Python."""
    lines = []
    for function in shared:
        lines += [f"def {function.name}({', '.join(function.parameters)}):"]
        lines += [f"    {step.targets[0]} = {step.text({})}" for step in function.steps]
        lines += [f"    return ({', '.join(function.returns)},)"]
    scope = {}
    exec("\n".join(lines), scope)
    found = []
    for one in blocks:
        here = dict(zip(one.inputs, given, strict=True))
        for step in one.steps:
            result = eval(step.text({}), scope, here)
            here.update(zip(step.targets, result, strict=True) if step.callee else [(step.targets[0], result)])
        found += [here[name] for _, names in one.results for name in names]
    return found


LINES = """
{0}_apart = {1} - {2}
{0}_square = {0}_apart*{0}_apart
{0}_reach = {0}_square + {3}
{0}_gap = {0}_reach*{4}
{0}_loss = {0}_gap*{0}_apart
{0}_rate = {0}_loss - {0}_gap
"""


def rows(*leaves, extra=""):
    """Blocks with the lines above for the leaves of each part."""
    parts = {f"pair_{k}": LINES.format(f"pair_{k}", *each.split()) for k, each in enumerate(leaves)}
    return block("rows", extra + "".join(parts.values()), ";".join(f"{part}: {part}_rate" for part in parts))


PARTS = {f"pair_{k}": "pair" for k in range(8)}
GIVEN = [0.3, 1.7, -0.2, 0.9, 1.1, 2.3, -1.9, 0.7]


def shared_and_same(one):
    """Functions found in a block, after its values were compared bit by bit."""
    plain = values([one], [], GIVEN)
    shared = share([one], PARTS, set())
    assert values([one], shared, GIVEN) == plain
    return shared


def test_equal_but_for_leaves_is_one_function():
    one = rows("a b c d", "b c d e", "c d e f", "d e f g")
    [actual] = shared_and_same(one)
    assert len(one.steps) == 4 and len(actual.steps) == 6
    assert actual.name == "pair_rate" and actual.returns == ("rate",)
    assert [step.targets for step in one.steps] == [(f"pair_{k}_rate",) for k in range(4)]


@pytest.mark.parametrize("role", ["rate", "lambda", "2"])
def test_names_are_identifiers_whatever_parts_and_kinds_are_called(role):
    code = LINES.replace("_rate", f"_{role}")
    leaves = ("a b c d", "b c d e", "c d e f", "d e f g")
    lines = "".join(code.format(f"pair_{k}", *each.split()) for k, each in enumerate(leaves))
    one = block("rows", lines, ";".join(f"pair_{k}: pair_{k}_{role}" for k in range(4)))
    plain = values([one], [], GIVEN)
    kinds = {f"pair_{k}": "no(); name" for k in range(4)} | {"gap": "", "loss": "2"}
    [actual] = share([one], kinds, {"pair_rate"})
    assert all(
        each.isidentifier() and not iskeyword(each) for each in (actual.name, *actual.parameters, *actual.returns)
    )
    assert values([one], [actual], GIVEN) == plain


def test_repetitions_that_save_nothing_or_differ_stay_written_out():
    one = rows("a b c d", "b c d e")
    assert shared_and_same(one) == [] and len(one.steps) == 12
    one = rows("a b c d", "b c d e", "c d e f", "d e f g")
    one.steps[3] = step_of("pair_0_gap", "pair_0_reach/d", {"pair_0_reach", "d"})
    [actual] = shared_and_same(one)
    assert len(actual.sites) == 3 or len(actual.steps) < 6


def test_values_that_another_part_or_a_leaf_reads_stay_outside_of_the_call():
    # A step of one pair that another reads cannot be within the call alone.
    one = rows("a b c d", "b c d e", "c d e f", "pair_0_apart e f g")
    [actual] = shared_and_same(one)
    assert "pair_0_apart" in [target for step in one.steps if not step.callee for target in step.targets]
    assert len(actual.sites) == 4
    # Where a leaf of one site is computed from a step inside of it, no call can have both.
    code = LINES.format("pair_3", "d", "e", "within", "g")
    one = rows("a b c d", "b c d e", "c d e f")
    last = block(
        "last", code.replace("pair_3_reach", "within = pair_3_square - a\npair_3_reach", 1), "pair_3: pair_3_rate"
    )
    plain = values([one, last], [], GIVEN)
    shared = share([one, last], PARTS, set())
    assert shared and values([one, last], shared, GIVEN) == plain


@each("seed", range(200))
def test_any_program_keeps_its_values(seed):
    """Parts that follow one recipe once to thrice, with few other steps, and read each other's."""
    draw = random.Random(seed)
    names, lines, results = list("abcdefgh"), [], []
    recipe = [
        (draw.choice("+-*"), draw.random() < 0.6, draw.randrange(3), draw.randrange(3))
        for _ in range(draw.randint(4, 8))
    ]
    for part in range(draw.randint(2, 7)):
        made = [draw.choice(names) for _ in range(3)]
        for round_ in range(draw.choice((1, 1, 2, 3))):
            for k, (sign, other, i, j) in enumerate(recipe):
                sign = draw.choice("+-*") if draw.random() < 0.03 else sign
                gap = " " * (sign != "*")
                second = made[-1 - j] if other else draw.choice(names)
                made.append(f"pair_{part}_s{round_}{k}")
                lines.append(f"{made[-1]} = {made[-2 - i]}{gap}{sign}{gap}{second}")
                names += [made[-1]] * (draw.random() < 0.1)
        results.append(f"pair_{part}: {made[-1]}" + (f" {draw.choice(made)}" if draw.random() < 0.5 else ""))
        if draw.random() < 0.3:
            results.append(f"total: {draw.choice(made)}")
    one = block("any", "\n".join(lines), ";".join(results))
    given = [draw.uniform(0.5, 2) for _ in GIVEN]
    plain = values([one], [], given)
    shared = share([one], PARTS, set())
    assert np.array(values([one], shared, given)).tobytes() == np.array(plain).tobytes()
    assert all(len(set(site.steps)) == len(site.steps) for actual in shared for site in actual.sites)
