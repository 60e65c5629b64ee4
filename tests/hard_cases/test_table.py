"""Every hard case with every method that claims it, in both paths; and that the table holds what it must."""

import pytest
from each import each

from hertzwerk.runtime.analysis.hard_cases import runner
from hertzwerk.runtime.analysis.hard_cases.case import METHODS
from hertzwerk.runtime.analysis.hard_cases.case_table import BY_NAME, CASES
from hertzwerk.runtime.analysis.hard_cases.tried_steps import TRIES
from hertzwerk.runtime.engine.run.run_request import METHOD
from hertzwerk.runtime.loading import engine_model

SLOW = {case.name for case in CASES if case.long}
# in CI by dop853: to build the default's two methods takes many seconds
ONE_ENGINE = {"boxes_corner_over_corner", "falling_chain_of_3", "locking_disc_at_speed", "rocking_block"}
LASTING = {("thin_friction_layer", "rodas")}  # seconds
REFERENCES = ("cvodes", "idas")  # slow, and outside the graph: there is no C of them
PAIRS = [(case, method) for case in CASES for method in case.methods]
# in CI as C, which takes long to compile
IN_CI = {"impact_e001_exact": "esdirk", "edge_slider_crank_crank_mass_lower": "dop853"}


def by_turns(case, method):
    """Whether CI runs it: the default of every case, and one of its other methods where it is one case of six."""
    if case.name in ONE_ENGINE:
        return method == "dop853"
    others = [other for other in case.methods if other != METHOD]
    turn, first = divmod(CASES.index(case), 6)
    return method == METHOD or (others and not first and method == others[turn % len(others)])


def marked(case, method, *, native):
    """Seconds: slow; minutes, or what another method's stands for: exhaustive, as `hertzwerk hardcases --all` is."""
    if case.name in SLOW or not (IN_CI.get(case.name) == method if native else by_turns(case, method)):
        marks = [pytest.mark.exhaustive]
    else:
        marks = [pytest.mark.slow] if native or (case.name, method) in LASTING or method in REFERENCES else []
    return pytest.param(case, method, id=f"{case.name}-{method}", marks=marks)


def check(result):
    case = BY_NAME[result.case]
    failing = [f"{row.name}: {row.value} > {row.limit}: {row.note}" for row in result.measured if not row.holds]
    known = any(method == result.method for method, _ in case.failures)
    assert result.verdict == (runner.KNOWN if known else runner.PASSED), (result.outcome, failing)


@pytest.mark.parametrize(("case", "method"), [marked(case, method, native=False) for case, method in PAIRS])
def test_in_the_virtual_machine(case, method):
    check(runner.result(case, method, native=False))


@pytest.mark.parametrize(
    ("case", "method"), [marked(case, method, native=True) for case, method in PAIRS if method not in REFERENCES]
)
def test_as_c_bitwise_the_same(case, method):
    result = runner.result(case, method)
    check(result)
    assert result.measured[-1].name == runner.SAME
    assert result.compiled_wall_s is not None


def test_names_steps_and_known_failures_of_the_table():
    assert len(BY_NAME) == len(CASES)
    assert {name: set(row) for name, row in TRIES.items()} == {case.name: set(case.methods) for case in CASES}
    for method in METHODS:
        assert sum(method in case.methods for case in CASES) > 0.9 * len(CASES)
    for case in CASES:
        assert {method for method, _ in case.failures} <= set(case.methods)
        assert all(case.failures.values())
        assert set(case.theory) <= set(case.methods)


@pytest.mark.parametrize("scene", ["bouncing_ball", "two_spheres", "slider_crank"])
def test_every_edge_of_every_defined_range_has_its_case(scene):
    """The lower and the upper end of each; a bound that does not exist has no edge."""
    wanted = set()
    for name, kind, low, high, *_ in engine_model(scene).module.LIMITS:
        if kind == "defined":
            wanted |= {
                f"edge_{scene}_{name}_{side}" for side, end in (("lower", low), ("upper", high)) if end is not None
            }
    assert wanted == {name for name in BY_NAME if name.startswith(f"edge_{scene}_")}


@each("case", [case for case in CASES if case.name.startswith("edge_")])
def test_edges_are_at_the_end_or_a_millionth_of_the_default_from_it(case):
    _, _, rest = case.name.partition("edge_")
    scene, _, parameter = rest.removesuffix("_lower").removesuffix("_upper").partition(f"{case.source.scene}_")
    model = engine_model(case.source.scene)
    rows = [row for row in model.module.LIMITS if row[0] == parameter and row[1] == "defined"]
    assert not scene
    value, default = model.bind(case.parameters)[parameter], model.bind()[parameter]
    for _, _, low, high, open_left, open_right, _ in rows:
        end, is_open = (low, open_left) if case.name.endswith("lower") else (high, open_right)
        if end is None:
            continue
        if is_open or parameter == "rod_length" or parameter == "bush_radius":
            assert 0 < abs(value - end) <= 0.06 * default or parameter in ("rod_length", "bush_radius")
        else:
            assert value == end
