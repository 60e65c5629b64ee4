"""Every reader refuses what it cannot read by its one documented error, in bounded time: mutated and random texts, odd values, altered files."""

import random
import shutil
import signal
import string
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from calls import calls_of

from hertzwerk.derive.audit.audit_text import audit_expression, declarations
from hertzwerk.derive.common.execute_file import names_defined_by
from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.derive.common.units import UnitError, parse_quantity, parse_unit
from hertzwerk.derive.exchange.user_files.law_file import audit_laws_as_written, laws_from
from hertzwerk.derive.expressions.algebra.splines import Table
from hertzwerk.derive.expressions.dimension.expression import TextError
from hertzwerk.derive.expressions.dimension.reader import read as read_expression
from hertzwerk.runtime import Solution, load, simulate, simulate_many
from hertzwerk.runtime.analysis.validation.scenario import load_scenario
from hertzwerk.runtime.cli.target_options import assignments
from hertzwerk.runtime.engine.integration.loop import automatic_compilation
from hertzwerk.runtime.engine.model.binding import read_time
from hertzwerk.runtime.engine.run.output_times import times_of

PATIENCE = 30  # s of processor time for one text: no measurement, an end to what has none

LAWS = """[[law]]
name = "foam"
kind = "stiffness"
form = "any"
title = "Foam pad"
source = "measured, 2024"
force = "K*d**n*exp(d/h)"
exponent = "n"
symbols.K = { unit = "N/m^n", meaning = "stiffness", limits = "(0, inf)" }
symbols.n = { unit = "1", meaning = "exponent", limits = "[1, 3]", default = 1.5 }
symbols.h = { unit = "mm", meaning = "thickness", default = 20 }
definitions = [{ symbol = "E_eff", unit = "Pa", meaning = "...", expression = "1e9*K/K" }]
ranges.dR = { defined = "[5e-6, 1 mm]" }

[[law]]
name = "rub"
kind = "friction"
title = "rubbing"
source = "measured"
force = "mu*N*tanh(s/v_s)"
symbols.mu = { unit = "1", meaning = "coefficient", limits = "[0, 2]" }
symbols.v_s = { unit = "m/s", meaning = "speed", limits = "(0, inf)" }
"""
SCENARIO = """scene = "soft_ball"
duration = "1 s"
accuracy = 1e-6
[parameters]
drop_height = "0.5 m"
[[checks]]
quantity = "impacts.0.speed"
expected = "3.132092 m/s"
tolerance = 1e-6
source = "sqrt(2 g h)"
"""
EXPRESSIONS = [
    "K*d**n", "2/5*K*d**2.5", "min(d, max(h, 0.1*d), n)", "where(d > 0, K*d**1.5, 0)", "cos(cos(1*pi/7)*pi/7)", "diff(K*d**n, d, 2)",
    "integrate(K*d**n, d, 0, h)", "[[d, 0], [0, h]] @ [d, h]", "sqrt(abs(d - h))/(1 + exp(-d/h))", "K*(d + h)**(n + 1)/(n + 1)",
    "det([[d, h], [h, d]])",
]  # fmt: skip
UNITS = ["N/m^1.5", "kg m^2", "N s/m", "rpm", "N/m^(n+1)", "1", "µm", "m**(3/2)", "W/(m K)", "mm²"]
QUANTITIES = ["0.2 mm", "24 ms", "5000 rpm", "1e-3", "-3.5e4 N/m^1.5", "1 1/s", "−1 mm", "10 %", "0.1"]
PIECES = [
    *("cos(", "min(", "max(", "sqrt(", ")", "((", "**", "^", "9", "1e308", "1e-320", ".5", "inf", "nan", "pi",
      "*pi/7", "/0", "-", "+", "=", "==", "%"),
    *("[", "]", "{", "}", "'", '"', '"""', "\\", "\n", "\x00", "\ud800", "\u202e", "²", "−", "µ", "٣", "ﬁ", "a.b.c.",
      "é", " ", "\t", ",", ";", "#", "_"),
    *("N/m^q", "K", "d", "n", "true", "9" * 300, "9" * 5000, "a" * 200, "lambda", "class",
      "__import__", "1979-05-27", "0x1F", "1_0", "{}", "[[law]]"),
    *("__import__('os')", "open('hertzwerk_fuzz','w')", "exec('x')", "().__class__", "lambda:", "[d for d in d]", "print(1)",
      "9**9**9", "where(d > 0, ", "diff(d, d", " if ", " else ", " and ", "not ", ":=", "//", "@", "<", ">="),
]  # fmt: skip


def mutated(rng: random.Random, seeds: list[str]) -> str:
    """A seed with some of its characters cut, doubled, exchanged or something put between; now and then nested or wholly random."""
    text = rng.choice(seeds)
    kind = rng.random()
    if kind < 0.1:
        return "".join(rng.choices(PIECES if kind < 0.06 else string.printable, k=rng.randrange(1, 60)))
    if kind < 0.2:
        opening, closing = rng.choice(
            [
                ("cos(", "*pi/7)"), ("min(d,", ")"), ("(", ")"), ("[", "]"), ("max(h, min(d, n,", "), 1)"), ("-", ""),
                ("{a=", "}"),
            ]
        )  # fmt: skip
        depth = rng.choice([3, 10, 18, 40, 100, 1000])
        return opening * depth + text[: rng.choice([10, 2000])] + closing * depth
    for _ in range(rng.randrange(1, 6)):
        i, j = sorted(rng.randrange(len(text) + 1) for _ in range(2))
        how = rng.randrange(4)
        text = (
            text[:i] + text[j:] if how == 0 and j - i < len(text) // 2
            else text[:i] + text[i:j] * 2 + text[j:] if how == 1 and len(text) < 5000
            else text[:i] + rng.choice(PIECES) + text[i:] if how == 2
            else text[:i] + rng.choice(PIECES) + text[i + 1 :]
        )  # fmt: skip
    return text


@contextmanager
def patience(what: str) -> Iterator[None]:
    """An AssertionError in what takes processor time without end."""

    def out_of_patience(*_: object) -> None:
        raise AssertionError(f"no end after {PATIENCE} s: {what}")

    before = signal.signal(signal.SIGPROF, out_of_patience)
    signal.setitimer(signal.ITIMER_PROF, PATIENCE)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def refuses(read: Callable[[str], object], text: str, *allowed: type[Exception]) -> bool:
    """Whether a text is refused, by the documented error, whose message can be written anywhere."""
    with patience(ascii(text)[:3000]):
        try:
            read(text)
        except allowed as error:
            str(error).encode("utf-8", "strict" if isinstance(error, InputError) else "replace")
            assert not isinstance(error, InputError) or error.faults
            return True
        except Exception as error:
            raise AssertionError(f"{type(error).__name__}: {error}\nof {ascii(text)[:3000]}") from error
        return False


def in_file(path: Path, read: Callable[[Path], object]) -> Callable[[str], object]:
    def of(text: str) -> object:
        path.write_text(text, encoding="utf-8", errors="surrogatepass", newline="")
        return read(path)

    return of


def as_time(text: str) -> None:
    faults: list[Fault] = []
    read_time("duration", text, "a time", faults)
    times_of(text, 10.0, faults)
    assignments("--set", [f"x={text}"], faults)
    if faults:
        raise InputError("options", faults)


def options(text: str) -> None:
    declarations([f"K={text}"], [f"n={text}"])


KNOWN = {"K": "N/m^1.5", "d": "m", "h": "m", "n": "1"}
WATCHED = 800  # texts of readers that need nothing but the text
EXECUTES = ("exec", "import", "open", "os", "subprocess", "socket", "code", "ctypes")
READERS: dict[str, tuple[list[str], Callable[[Path], Callable[[str], object]], tuple[type[Exception], ...]]] = {
    "unit": (UNITS, lambda _: parse_unit, (UnitError,)),
    "quantity": (QUANTITIES, lambda _: parse_quantity, (UnitError,)),
    "expression": (EXPRESSIONS, lambda _: read_expression, (TextError,)),
    "duration, output, --set": (["24 ms", "0.1 s", "1e-3 s", "+.5 ms"], lambda _: as_time, (InputError,)),
    "--unit, --value": (["3/2", "1.5", "sqrt(2)*pi", "-(1 + 2)**3"], lambda _: options, (InputError,)),
    "--expr": (EXPRESSIONS, lambda _: lambda text: audit_expression(text, KNOWN, {"n": 1.5}, "N"), (InputError,)),
    "laws": ([LAWS], lambda folder: in_file(folder / "laws.toml", laws_from), (InputError,)),
    "laws as written": ([LAWS], lambda folder: in_file(folder / "laws.toml", audit_laws_as_written), (InputError,)),
    "scenario": ([SCENARIO], lambda folder: in_file(folder / "s.toml", load_scenario), (InputError,)),
}  # fmt: skip
SOME = 60


@contextmanager
def watching(executed: list[str]) -> Iterator[None]:
    """Collect what Python tells its audit hooks of that it executes, imports or opens; hooks stay, so this one then sleeps."""
    awake = True

    def hook(event: str, _: object) -> None:
        if awake and event.split(".")[0] in EXECUTES:
            executed.append(event)

    sys.addaudithook(hook)
    try:
        yield
    finally:
        awake = False


@pytest.mark.parametrize("name", READERS)
def test_a_reader_refuses_by_one_error_what_it_cannot_read(name, tmp_path):
    seeds, made, allowed = READERS[name]
    read, rng, executed = made(tmp_path), random.Random(name), []
    for seed in seeds:
        assert not refuses(read, seed, *allowed), seed
    watched = name in ("unit", "quantity", "expression")
    texts = [mutated(rng, seeds) for _ in range(WATCHED if watched else SOME)]
    with watching(executed):
        refused = sum(refuses(read, text, *allowed) for text in texts)
    assert len(texts) // 4 < refused
    if watched:
        assert not executed
        assert refused < len(texts) - 20  # the pieces do make good texts
        assert max(calls_of(partial(refuses, read, text, *allowed)) for text in texts[::5]) < 600_000  # 57,000 measured


NESTED = ["1"]
for _ in range(25):
    NESTED.append(f"cos({NESTED[-1]}*pi/7)")


def branched(depth: int) -> str:
    """min and max of each other, four by four."""
    inner = (
        [f"{'dhn'[k % 3]}*{k}" for k in range(4)]
        if depth == 1
        else [branched(depth - 1).replace("*", f"*{k + 2}*") for k in range(4)]
    )
    return f"{'min' if depth % 2 else 'max'}({', '.join(inner)})"


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("laws.toml", LAWS.replace("exp(d/h)", NESTED[18])), ("laws.toml", LAWS.replace("exp(d/h)", NESTED[25])),
        ("laws.toml", LAWS.replace("exp(d/h)", f"exp({branched(3)}/h)")), ("laws.toml", LAWS.replace("default = 20", f"default = {'9' * 300}")),
        ("laws.toml", LAWS.replace("default = 20", f"default = {'9' * 5000}")), ("laws.toml", LAWS.replace('unit = "Pa"', 'unit = "N/m^q"')),
        ("laws.toml", LAWS.replace('unit = "mm"', 'unit = "N/m^q"')), ("laws.toml", LAWS + ".".join("a" * 400_000) + " = 1\n"),
        ("laws.toml", LAWS + "x = " + "[" * 30_000), ("s.toml", SCENARIO + ".".join("a" * 400_000) + " = 1\n"),
        ("s.toml", SCENARIO + "x = " + "[" * 30_000), ("s.toml", SCENARIO + "x = " + "{a=" * 20_000),
        ("s.toml", SCENARIO.replace("impacts.0", "impacts.²")), ("s.toml", SCENARIO.replace("impacts.0", f"impacts.{'9' * 5000}")),
        ("s.toml", SCENARIO.replace("1e-6", "9" * 5000)), ("s.toml", "\x00" + SCENARIO),
    ],
    ids=range(16),
)  # fmt: skip
def test_small_files_take_no_long_time_and_end_in_one_error(file, text, tmp_path):
    """Each took 27 s to for ever, or ended in an error of Python's."""
    path = tmp_path / file
    read = in_file(path, load_scenario if file == "s.toml" else laws_from)
    refused = refuses(read, text, InputError)
    assert refused or "cos(" in text or "9" * 300 in text, text[:200]  # which are numbers


@pytest.mark.parametrize(
    "table",
    [
        ("t", (0, 1), (0, 1), 5), ("t", 5, (0, 1), ("s", "m")), ("t", (0, 1), None, ("s", "m")), ("t", (0, 1), (0, 1), ("s", 5)),
        ("t", (0, 1), (0, 1), ("s", "m"), (1e308, -1e308)), ("t", (0, 1), (0, 1), ("s", "m"), 5), ("t", (0, 1e-300), (0, 1), ("s", "m")),
        ("t", (0, 10**400), (0, 1), ("s", "m")), ("t", ("a", "b"), (0, 1), ("s", "m")), ("t", (0, 1), (0, 1), ("s",)),
        (5, (0, 1), (0, 1), ("s", "m")),
    ],
)  # fmt: skip
def test_a_bad_table_is_a_fault_and_no_exception(table):
    assert [fault for fault in Table(*table).faults() if str(fault)]


@pytest.mark.parametrize(
    "text", ["(" * 5000, "x = " + "[" * 90_000, "\x00", "x = " + "-" * 200_000 + "1", "x = " + "9" * 5000]
)
def test_a_scene_file_that_python_cannot_compile_is_refused(text, tmp_path):
    path = tmp_path / "scene.py"
    path.write_text(text)
    assert refuses(lambda _: names_defined_by(path), text, InputError)


class Unspeakable:
    """What has no text of its own."""

    def __repr__(self) -> str:
        raise RuntimeError("nothing to show")


ODD: list[Any] = [
    None, 5, -1, 0, 10**400, 10**5000, True, 1j, b"x", object(), type, Unspeakable(), float("nan"), float("inf"), 1e308, "", "x", "\x00", "\ud800",
    "−1 mm", "9" * 500 + " s", [], [1], (), {}, {"a": 1}, {1: 2}, set(), range(3), np.array([1, 2]), np.array("x"), np.float64("nan"),
    {"mass": Unspeakable()}, {"mass": 10**5000}, {"mass": ("1", "kg")}, {"mass": (1, 2, 3)}, {Unspeakable(): 1},
]  # fmt: skip
ARGUMENTS = (
    "duration", "accuracy", "tolerance", "method", "parameters", "initial", "grid", "compiled", "max_steps",
    "max_events", "wall_time",
)  # fmt: skip


@pytest.mark.parametrize("name", ARGUMENTS)
def test_simulate_refuses_by_one_error_what_it_is_given(name):
    model = load("soft_ball")
    refused = 0
    for value in ODD:
        given = {"duration": 0.01, "tolerance": 1e-4, "wall_time": 0.05} | {name: value}
        if name == "accuracy":
            del given["tolerance"]
        try:
            simulate(model, **given)
        except InputError as error:
            refused += 1
            str(error).encode()
    assert refused > len(ODD) // 2


@pytest.mark.parametrize("name", ["target", "without", "laws", "coordinates"])
def test_load_refuses_by_one_error_what_it_is_given(name):
    for value in ODD:
        given = {"target": "soft_ball"} | {name: value}
        if name != "target" and (value is None or (isinstance(value, list | tuple | dict) and not value)):
            continue
        with pytest.raises(InputError) as caught:
            load(given.pop("target"), **given)
        str(caught.value).encode()


@pytest.fixture(scope="module")
def saved(tmp_path_factory) -> tuple[Solution, bytes]:
    run = simulate(load("soft_ball"), duration="0.5 s", tolerance=1e-5, grid=20)
    path = tmp_path_factory.mktemp("saved") / "run.npz"
    run.save(path)
    return run, path.read_bytes()


def altered(rng: random.Random, content: bytes) -> bytes:
    """A file with bytes changed, cut, doubled or put in."""
    how, i = rng.randrange(5), rng.randrange(len(content))
    if how == 0:
        return content[:i]
    if how == 1:
        return content[:i] + content[i + rng.randrange(1, 50) :]
    if how == 2:
        return content[:i] + rng.randbytes(rng.randrange(1, 50)) + content[i:]
    changed = bytearray(content)
    for _ in range(rng.randrange(1, 5)):
        changed[rng.randrange(len(changed))] = rng.randrange(256)
    return bytes(changed)


@pytest.mark.parametrize("count", [150, pytest.param(100_000, marks=[pytest.mark.exhaustive, pytest.mark.timeout(0)])])
def test_an_altered_file_of_a_run_is_refused_or_means_the_same(saved, tmp_path, count):
    """936 of 2500 were loaded, with other numbers; the rest ended in a dozen kinds of error. What stands in no entry may change."""
    run, content = saved
    rng, path, refused = random.Random(0), tmp_path / "run.npz", 0
    path.write_bytes(content)
    assert np.array_equal(
        Solution.load(path)["ball_fall" if "ball_fall" in run else next(iter(run))], run[next(iter(run))]
    )
    for _ in range(count):
        path.write_bytes(altered(rng, content))
        try:
            with patience("an altered file"):
                actual = Solution.load(path)
        except InputError as error:
            refused += 1
            str(error).encode()
        else:
            assert all(np.array_equal(actual[name], run[name]) for name in ("t", *run))
            assert actual.impacts == run.impacts
            assert actual.outcome == run.outcome
    assert refused > count // 2


@pytest.mark.parametrize("path", ["nothing.npz", ".", "text.npz", "other.npz", "\x00"])
def test_a_file_that_is_no_saved_run_is_refused(path, own_folder):
    Path("text.npz").write_text("no archive")
    np.savez("other.npz", t=np.arange(3))
    with pytest.raises(InputError):
        Solution.load(path)


def test_rows_of_a_batch_that_are_nothing_are_refused(tmp_path):
    for rows in (5, None, [5], [None], [[("mass", 1)]], "mass", {"mass": 1}):
        with pytest.raises(InputError) as caught:
            simulate_many(load("soft_ball"), rows, duration=0.01, tolerance=1e-4)  # type: ignore[arg-type]
        str(caught.value).encode()


@pytest.mark.parametrize(
    "cc", [pytest.param("gcc -m64 -g0", marks=pytest.mark.slow), "true", "cat", 'gcc "', "no-such-compiler", "gcc -fno-such-option"],
)  # fmt: skip
def test_cc_is_a_command_as_a_shell_reads_it_and_one_that_makes_nothing_is_reported(cc, monkeypatch, tmp_path):
    """`CC=true` compiled nothing without a word, `CC="gcc -m64"` was passed over."""
    from hertzwerk.runtime.engine.integration.loop import c_compilation

    if cc.startswith("gcc") and not shutil.which("gcc"):
        pytest.skip("no gcc")
    monkeypatch.setenv("CC", cc)
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path))
    c_compilation._compiler.cache_clear()
    try:
        model = load("soft_ball")
        if cc.startswith("gcc -m64"):
            assert c_compilation._compiler()[1:] == ("-m64", "-g0")
            assert simulate(model, duration=0.1, tolerance=1e-4, compiled=True, method="dopri5").settings.compiled
            return
        with pytest.raises(InputError, match="C compiler"):
            simulate(model, duration=0.1, tolerance=1e-4, compiled=True, method="dopri5")
        monkeypatch.setattr(automatic_compilation, "LOOK", 0.0)
        monkeypatch.setattr(automatic_compilation, "SURE", 0.0)
        monkeypatch.setattr(c_compilation, "compile_seconds", lambda _: 0.0)
        run = simulate(model, duration=3.0, tolerance=1e-10, method="dopri5")
        assert run.outcome.finished
        assert not run.settings.compiled
        assert [text for text in run.warnings if text.startswith("not compiled")]
    finally:
        c_compilation._compiler.cache_clear()


@pytest.mark.parametrize("closed", ["sys.stdout = None; os.close(1)", "sys.stderr = None; os.close(2)"])
def test_a_command_runs_with_a_stream_closed(closed):
    """`hertzwerk list >&-` was a traceback; a file that is opened next must not get what is printed."""
    code = f"import os, sys; {closed}\nfrom hertzwerk.runtime.cli import main\nmain(['list'])"
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert ended.returncode == 0
    assert ("bouncing_ball" in ended.stdout) == ("stderr" in closed)
    assert not ended.stderr
