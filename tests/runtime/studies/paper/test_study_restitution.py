"""The restitution study: the engine against the exact relation (reference/closed_forms.py), scaling, and published expansions."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from hertzwerk.runtime.engine.model.build import build, impact_trials
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.studies.paper.plot_page import figure
from hertzwerk.runtime.studies.paper.study_restitution import GRID, Impact, own_unit, page_of, returned, simulated
from reference.closed_forms import FACTORS, exact_factor, factor, restitution

TRIALS = {trial.law.name: trial for trial in impact_trials()}


@pytest.fixture
def study(restitutions):
    return restitutions


def expected(name, e):
    """Restitution out, from formulas retyped here."""
    e = float(e)
    if name in FACTORS:
        return restitution(repr(factor(name, repr(e))))
    if name == "exact":
        return restitution(repr(exact_factor(repr(e))))
    if name == "safaeifar_farshidianfar":
        return restitution(repr(5 * (1 - e) / (4 * e)))
    if name == "jankowski":
        xi = 9 * math.sqrt(5) / 2 * (1 - e**2) / (e * (e * (9 * math.pi - 16) + 16))
        zeta = 2 * xi / math.sqrt(5)
        angle = math.acos(zeta) / math.sqrt(1 - zeta**2) if zeta < 1 else math.acosh(zeta) / math.sqrt(zeta**2 - 1)
        return math.exp(-zeta * angle)
    return e  # tsuji, kelvin_voigt: exact, as the contact ends at d = 0


def test_the_study_covers_every_damping_law_and_agrees_as_its_worst_does(study):
    assert {law.law for law in study} == set(TRIALS)
    assert {law.law for law in study if law.recommended is None} == {"ristow", "kuwabara_kono", "power_damping"}
    assert (GRID[0], GRID[-1]) == (0.05, 0.99)
    assert all(np.isfinite(law.simulated).all() for law in study)
    assert max(np.max(np.abs(law.simulated - law.closed)) for law in study if law.closed is not None) < 1e-10
    assert [v.holds for v in page_of(study).verdicts] == [True, True, None]
    k = next(k for k, law in enumerate(study) if law.closed is not None)
    for fault, holds in ((math.nan, [False, False, None]), (2e-9, [False, True, None])):
        changed = replace(study[k], simulated=study[k].simulated + fault)
        assert [v.holds for v in page_of([*study[:k], changed, *study[k + 1 :]]).verdicts] == holds


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("name", [name for name in TRIALS if name not in ("ristow", "kuwabara_kono", "power_damping")])
def test_the_engine_returns_the_closed_form(study, name):
    actual = next(c for c in study if c.law == name)
    known = [expected(name, e) for e in actual.prescribed]
    assert np.max(np.abs(actual.simulated - known)) < 1e-9
    assert np.max(np.abs(actual.closed - known)) < 1e-12


def test_power_damping_of_m_equal_n_is_hysteresis_and_kuwabara_and_kono_s_expansion_holds(study):
    """chi = h K/v0 returns what the exact relation has for h."""
    result = next(c for c in study if c.law == "power_damping")
    assert result.parameter == "chi*v0/K"
    known = [restitution(float(h)) for h in result.prescribed]
    assert np.max(np.abs(result.simulated - known)) < 1e-9
    # e = 1 - C1 x + (3/5) C1^2 x^2 + O(x^(5/2)), x = (3/2) A (K/m)^(2/5) v0^(1/5): Ramirez, Poeschel, Brilliantov, Schwager, PRE 60 (1999) 4465.
    # Released where the force vanishes, before the gap opens, a little more comes out, of order x^(5/2): Schwager, Poeschel, PRE 78 (2008) 051304.
    found = next(c for c in study if c.law == "kuwabara_kono")
    x = 1.5 * found.prescribed
    C1 = math.sqrt(math.pi) * math.gamma(0.6) / (2**0.2 * 5**0.4 * math.gamma(2.1))
    assert pytest.approx(1.15345, abs=5e-6) == C1  # contact-laws.md
    small = x < 0.1
    remainder = (found.simulated - (1 - C1 * x + 0.6 * C1**2 * x**2))[small]
    assert np.all((remainder > 0) & (remainder < 0.27 * x[small] ** 2.5))


@pytest.mark.parametrize(
    ("name", "drag"),
    [
        ("ristow", lambda d, v, x: x * v),
        ("kuwabara_kono", lambda d, v, x: 1.5 * x * math.sqrt(d) * v),
        ("power_damping", lambda d, v, x: x * d**1.5 * v),
    ],
)
def test_laws_without_e_against_another_integrator(study, name, drag):
    """d'' = -(d^1.5 + drag), with m = K = v0 = 1, from d = 0 until the force vanishes, by SciPy."""
    found = next(c for c in study if c.law == name)
    for x, out in list(zip(found.prescribed, found.simulated, strict=True))[::5]:

        def force(d, v, x=x):
            return max(d, 0.0) ** 1.5 + drag(max(d, 0.0), v, x)

        def end(_, y):
            return 1.0 if y[1] > 0 else force(*y)

        end.terminal, end.direction = True, -1
        run = solve_ivp(
            lambda _, y: (y[1], -force(*y)), (0, 1000), (1e-13, 1.0), "DOP853", events=end, rtol=1e-12, atol=1e-15, max_step=0.05,
        )  # fmt: skip
        assert out == pytest.approx(-run.y_events[0][0][1], rel=1e-8)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("flores", 0.3), ("tsuji", 0.6), ("jankowski", 0.2), ("kuwabara_kono", 0.3), ("ristow", 0.5),
        ("power_damping", 0.4),
    ],
)  # fmt: skip
def test_mass_speed_and_stiffness_do_not_matter(name, value):
    """Five decades of stiffness, three of mass, one of speed: the same comes out, for the same e or the same number of the law's own."""
    trial = TRIALS[name]
    model = EngineModel(build(trial.scene))
    result = []
    for impact in (Impact(), Impact(mass=0.02, speed=7.0, stiffness=3e10), Impact(mass=40, speed=0.3, stiffness=5e4)):
        unit = 1.0 if trial.recommended is not None else own_unit(trial, impact)
        result.append(simulated(model, trial, value * unit, impact))
    assert max(result) - min(result) < 1e-10


def test_tables_panels_and_the_worst_of_the_recommended_range(study):
    ln = next(law for law in study if law.law == "lankarani_nikravesh")
    e, deviation = ln.worst(inside=True)
    assert (e, deviation) == (0.8, pytest.approx(restitution("0.27") - 0.8, abs=1e-9))  # h = 3 (1 - .64)/4
    assert ln.worst(inside=False)[0] == 0.05
    page = page_of(study)
    taking, impacts = page.tables
    order = [next(law for law in study if law.law == name) for name in taking.column("law")]
    everywhere = [round(abs(law.worst(inside=False)[1]), 9) for law in order]
    assert everywhere == sorted(everywhere) and len(order) == 15
    assert len(impacts.rows) == sum(len(law.prescribed) for law in study)
    assert all(closed is None for name, *_, closed in impacts.rows if name == "ristow")
    panels, *together = page.charts
    assert [panel.title for panel in panels.panels] == [f"{law.law} ({law.grade})" for law in order]
    assert list(panels.panels[0].curves[-1].y) == list(order[0].deviation)
    (deviated,) = (panel for panel in panels.panels if panel.title.startswith("lankarani"))
    assert [x for x, _ in deviated.marks] == [end for end in ln.recommended if 0 < end < 1]
    assert [len(figure(chart).axes[0].lines) for chart in together] == [16, 3]


def test_a_quick_study_takes_fewer_values():
    assert returned(TRIALS["flores"], every=7).prescribed.tolist() == GRID[::7].tolist()
