"""C text as files that compile fast: the same bits whatever is parted, and what runs seldom apart."""

import re
from dataclasses import replace

import casadi as ca
import numpy as np
import pytest

from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.integration.loop import c_compilation, c_files
from hertzwerk.runtime.engine.integration.loop.attempt import integrator
from hertzwerk.runtime.engine.integration.loop.c_compilation import Program, c_text
from hertzwerk.runtime.engine.integration.loop.chunk import chunk
from hertzwerk.runtime.engine.integration.tableaux.methods import METHODS
from hertzwerk.runtime.engine.run.built_engine import compile_together
from hertzwerk.runtime.loading import engine_model


@pytest.fixture
def small(monkeypatch, tmp_path):
    """Parts and files far smaller than they are."""
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path / "cache"))
    for name, value in (("LONG", 3_000), ("PART", 3_000), ("FILE", 30_000), ("BESIDE", 600), ("CHOICES", 5)):
        monkeypatch.setattr(c_files, name, value)


@pytest.fixture(scope="module")
def loop():
    """The function of a crank's attempts by a method."""
    model = engine_model("slider_crank_frictionless")

    def made(method, called="chunk"):
        return chunk(integrator(model, tuple(table() for table in METHODS[method])), called=called)

    return made


@pytest.fixture(scope="module")
def text(loop):
    """The C of a crank by dop853."""
    return c_text([loop("dop853")])


@pytest.mark.parametrize("method", ["dop853", "esdirk"])
def test_many_parts_in_many_files_give_the_same_bits(small, method):
    model = engine_model("slider_crank_frictionless")
    settings = {"duration": "24 ms", "tolerance": 1e-7, "method": method}
    machine = simulate(model, compiled=False, **settings)
    native = simulate(model, compiled=True, **settings)
    assert len(native.impacts) > 1
    assert np.array_equal(machine.engine.history.rows.view(np.uint64), native.engine.history.rows.view(np.uint64))


def test_the_loop_in_c_gives_the_bits_of_every_attempt(loop):
    """Up to the end of the run, whose status the last column has; the arguments stay as they are."""
    run = simulate("slider_crank_frictionless", duration="2 ms", tolerance=1e-6, method="dop853", compiled=False)
    history, made = run.engine.history, loop("dop853")
    (native,) = Program(made).load()
    given = [np.array(history.rows[-20]), history.controls, np.zeros(made.numel_in(2))]
    expected, actual = ([np.array(part) for part in function.call(given)] for function in (made, native))
    end = 1 + int(np.argmax(expected[0][made.status] != 0))
    assert 1 < end < expected[0].shape[1] / 2
    assert actual[0][made.status, -1] == expected[0][made.status, -1]
    for one, other in zip(expected, actual, strict=True):
        assert one[:, :end].tobytes() == other[:, :end].tobytes()
    assert "for (i = 0; i < 256 && !failed" in c_text([made])


def test_small_parts_are_made_of_the_text(small, text):
    files = c_files.c_files(text)
    assert len(files) > 4
    assert sum(len(re.findall(r"\) void casadi_f\d+_\d+\(", file.text)) for file in files) > 50
    for file in files:
        longest = max(len(body) for body in file.text.split("\n}\n") if "casadi_real a" in body)
        assert longest < 4 * c_files.LONG  # with what a part takes and hands on


def test_conditions_are_masks_that_give_the_same_bits(monkeypatch, tmp_path):
    """Of a condition that is not a number, a value that is none, and zeros of either sign."""
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path / "cache"))
    x = ca.SX.sym("x", 2)
    function = ca.Function("f", [x], [ca.if_else(x[0], x[1], 0)])
    special = [0.0, -0.0, np.nan, np.inf, -3.0, 5e-324]
    monkeypatch.setattr(c_files, "CHOICES", 0)
    program = Program(function)
    assert "=casadi_chosen(" in program._files[0].text
    (native,) = program.load()
    for condition in special:
        for value in special:
            bits = [np.array(f([condition, value])[0]).view(np.uint64) for f in (function, native)]
            assert np.array_equal(*bits), (condition, value)


def _random_vectors(rng, name):
    """A function of vectors with numbers, parts, and values that are read later, more than once, or in place."""
    x, h = ca.MX.sym("x", 9), ca.MX.sym("h")
    known = [x, x[1:8].T.T, -x]
    for _ in range(30):
        a, b = (known[-1 - min(int(rng.exponential(3)), len(known) - 1)] for _ in range(2))
        n = min(a.numel(), b.numel())
        a, b = (part[:n] if rng.random() < 0.8 else part[part.numel() - n :] for part in (a, b))
        number = float(rng.normal())
        made = [
            a + b, a - number * b, h * a + b, a * number, b / (2 + a * a), ca.fmax(a, b), ca.if_else(a < b, number * a, b),
        ]  # fmt: skip
        known.append(made[rng.integers(len(made))])
    return ca.Function(name, [x, h], [*known[-3:], ca.vertcat(*(part[:2] for part in known[::7]))])


@pytest.mark.parametrize("scalars", [False, True])
def test_operations_are_written_into_their_reader_and_give_the_same_bits(scalars, monkeypatch, tmp_path):
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path / "cache"))
    rng, named = np.random.default_rng(3), c_files._named
    functions = [_random_vectors(rng, f"vectors_{i}") for i in range(5)]
    if scalars:
        functions = [function.expand() for function in functions]

    def written():
        files = c_files.c_files(c_text(functions))
        return sum(len(re.findall(r"^  a\d+=|EACH \(i", file.text, re.MULTILINE)) for file in files)

    def differ():
        given = rng.normal(size=9), 0.1
        native = Program(*functions).load()
        pairs = (
            (np.array(a), np.array(b))
            for f, g in zip(functions, native, strict=True)
            for a, b in zip(f(*given), g(*given), strict=True)
        )
        return sum(not np.array_equal(a.view(np.uint64), b.view(np.uint64)) for a, b in pairs)

    less = written()
    assert differ() == 0
    monkeypatch.setattr(c_files._Line, "changes", lambda line, names: False)

    def one_name(rows, again):
        return [[re.sub(r"\ba\d$", "a0", part) for part in row] for row in named(rows, again=again)]

    monkeypatch.setattr(c_files, "_named", one_name)
    assert differ() > 0
    monkeypatch.setattr(c_compilation, "fused", lambda text: text)
    monkeypatch.setattr(c_files, "NESTED", 0)
    assert less < 0.6 * written()


def test_arguments_and_results_may_be_absent(small):
    """0 for an argument without entries, nothing for a result that nobody reads; in parts as well."""
    x, y, nothing = ca.SX.sym("x", 3), ca.SX.sym("y", 2), ca.MX(2, 1)
    terms = [ca.sin(x[i % 3] * i) + y[i % 2] for i in range(300)]
    inner = ca.Function("inner", [x, y], [ca.vertcat(*terms), sum(terms)])
    u = ca.MX.sym("u", 3)
    outer = ca.Function("outer", [u], [inner(u, nothing)[1], inner(2 * u, u[:2])[0]])
    (native,) = Program(outer).load()
    for value in ([0.1, -2.0, 3.0], [1e-9, 5.0, -7.0]):
        for expected, actual in zip(outer(value), native(value), strict=True):
            assert np.array_equal(np.array(expected), np.array(actual))


def test_functions_for_events_are_apart_call_the_right_hand_side_and_are_less_optimised(text, monkeypatch):
    """Of the functions that are long; what runs in every attempt is not among them."""
    often, *others = c_files.c_files(text)
    assert often.level == c_files.OFTEN
    assert [file.level for file in others] == [c_files.SELDOM]
    said = [set(re.findall(r"^/\* (\w+):", file.text, re.MULTILINE)) for file in (often, *others)]
    assert {"advance_in_contact", "advance_in_flight"} <= said[0]
    assert {"decide", "chunk", "moved"} <= said[1]  # the last two hold loops; `locate` is short, and calls
    assert not said[0] & said[1]
    # It runs seldom: the ends of a step are one function of every move and change of modes, not written into each.
    functions = {found["name"]: found for found in c_files._FUNCTION.finditer(text)}
    (ends,) = (name for name, found in functions.items() if found["said"] == "ends")
    callers = [found["said"] for found in functions.values() if f"{ends}(" in found["body"]]
    assert {"moved", "switch", "cut"} <= set(callers)
    monkeypatch.setattr(c_files, "LARGE", len(text) // 2)
    assert {file.level for file in c_files.c_files(text)} == {c_files.SELDOM}


@pytest.mark.parametrize("seen", [True, False])
def test_loops_around_scalars_are_less_optimised_than_loops_that_scalars_call(seen, monkeypatch):
    """The latter as well where nothing is known of scalars, which is the seeded fault."""
    x, s = ca.MX.sym("x", 20), ca.SX.sym("s", 20)
    inner = ca.Function("inner", [x], [ca.sin(x) * x])
    scalars = ca.Function("scalars", [s], [ca.dot(s, inner.call([s], False, True)[0])])
    outer = ca.Function("outer", [x], [x * scalars.call([x], False, True)[0]])
    if not seen:
        monkeypatch.setattr(c_files, "_VARIABLE", re.compile("nothing"))
    levels = {
        said: file.level
        for file in c_files.c_files(c_text([outer]))
        for said in re.findall(r"^/\* (\w+):", file.text, re.M)
    }
    assert levels == {
        "outer": c_files.SELDOM,
        "scalars": c_files.OFTEN,
        "inner": c_files.OFTEN if seen else c_files.SELDOM,
    }


@pytest.mark.exhaustive
def test_a_variable_that_is_not_handed_on_is_noticed(small, monkeypatch):
    """The seeded fault of the first test: the last variable of each part is lost."""
    parts = c_files._parts

    def lossy(body):
        found, size = parts(body)
        return [re.sub(r"  v\[\d+\]=a\d+;\n\Z", "", part) for part in found], size

    monkeypatch.setattr(c_files, "_parts", lossy)
    with pytest.raises(AssertionError):
        test_many_parts_in_many_files_give_the_same_bits(None, "dop853")


def test_methods_share_a_program_and_each_is_as_optimised_as_alone(loop, text, monkeypatch):
    """What the method of the short program needs is -O3, what only the long one needs -O1."""
    implicit = c_text([loop("esdirk")])
    both = c_text([loop("dop853", "explicit"), loop("esdirk", "implicit")])
    assert len(both) < 0.9 * (len(text) + len(implicit))
    monkeypatch.setattr(c_files, "LARGE", 0.8 * len(text))
    assert {file.level for file in c_files.c_files(implicit)} == {c_files.SELDOM}
    first, *others = c_files.c_files(both)
    assert first.level == c_files.OFTEN
    steps = {file.level for file in others if "/* advance_in_contact:" in file.text}
    assert "/* advance_in_contact:" in first.text  # of the explicit method
    assert steps == {c_files.SELDOM}  # of the implicit one


def test_compiling_together_gives_the_same_bits_and_happens_once(monkeypatch, tmp_path):
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path / "cache"))
    made, compile_files = [], c_compilation.compile_files
    monkeypatch.setattr(c_compilation, "compile_files", lambda *given: made.append(1) or compile_files(*given))
    model, settings = engine_model("slider_crank_frictionless"), {"duration": "24 ms", "tolerance": 1e-7}
    machine = {method: simulate(model, method=method, compiled=False, **settings) for method in ("dopri5", "dop853")}
    compile_together([(model, method) for method in machine])
    for method, run in machine.items():
        native = simulate(model, method=method, compiled=True, **settings)
        assert native.settings.compiled
        assert len(native.impacts) > 1
        assert np.array_equal(run.engine.history.rows.view(np.uint64), native.engine.history.rows.view(np.uint64))
    assert len(made) == 1


def test_a_symbol_that_is_nowhere_is_an_error_of_the_linker(monkeypatch, tmp_path):
    """Without it the library loads, and the first call of the symbol ends the process."""
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path / "cache"))
    x = ca.SX.sym("x")
    program = Program(ca.Function("f", [x], [ca.sin(x)]))
    program._files = [replace(file, text=file.text.replace("sin(", "sine(")) for file in program._files]
    with pytest.raises(c_compilation.BrokenCompilerError, match="sine"):
        program.load()
