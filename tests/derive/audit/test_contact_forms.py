"""Forms of contact: a law of point contact where surfaces touch along a line is advised against once; the listed laws run."""

import json
from dataclasses import replace
from importlib import import_module

import pytest
from click.testing import CliRunner
from each import each

import hertzwerk.derive as hd
from hertzwerk.derive.audit.audit import advice_findings
from hertzwerk.derive.audit.contact_forms import advice, fitting_laws, form_of
from hertzwerk.derive.equations.derivation import audit_scene
from hertzwerk.derive.laws import LAWS, power
from hertzwerk.derive.laws.law import FilmLaw, StiffnessLaw, d
from hertzwerk.derive.scenes import NAMES
from hertzwerk.derive.scenes.slider_crank import scene as crank
from hertzwerk.derive.scenes.slider_crank import steel
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.cli import main
from hertzwerk.runtime.cli.line_wrapping import PROSE
from hertzwerk.runtime.cli.run_commands.run import _report
from hertzwerk.runtime.engine.model.build import scene_from
from hertzwerk.runtime.loading import engine_model

# what stands in the catalogue for a pin in a bush of some length, by the titles of the laws and the verdicts of their units
OF_PINS = (
    *("johnson", "hertz_cylinder", "radzimovsky", "goldsmith_m3", "dubowsky_freudenstein", "esdu_78035", "palmgren_si"),
    *("pereira_internal_si", "liu_with_length", "bai_zhao_repaired", "persson", "popov_line", "hertz_half_width"),
    *("wang_liu_internal", "wang_liu_half_width", "wang_liu_johnson", "wang_liu_secant"),
)
ADVISED = (
    *("slider_crank", "slider_crank_frictionless", "slider_crank_two_clearances", "slider_crank_three_clearances"),
    *("four_bar_clearance", "slider_crank_dc_motor"),
)


def test_the_flagship_s_law_of_another_contact_is_reported_with_laws_that_fit():
    (said,) = advice(crank)
    assert said == (
        "slider_pin: take a law of line contact (`hertzwerk laws --form line`). At slider_pin a pin in bush touches along a line, "
        "and hertz_point is a law of point contact"
    )
    first = [text.partition(". ")[0] for name in ADVISED for text in engine_model(name).module.ADVICE]
    assert max(map(len, first)) <= PROSE - len("advice        ")
    (pair,) = crank.mechanism.pairs
    assert set(fitting_laws("stiffness", pair, crank.geometry("slider_pin"))) == set(OF_PINS)
    listed = CliRunner().invoke(main, ["laws", "--form", "line", "--json"])
    rows = {row["law"]: row["made for"] for row in json.loads(listed.output)["laws"]}
    assert {name for name, pairs in rows.items() if pairs in ("line contact", "pin_in_bush")} >= set(OF_PINS)
    assert not {"hertz_point", "power", "goldsmith"} & set(rows)  # of points, of any form, inconsistent


@each("name", NAMES)
def test_scenes_are_advised_once_and_only_where_law_and_pair_differ(name):
    said = advice(scene_from(name))
    assert len(said) == (name in ADVISED)
    module = import_module(f"hertzwerk.generated.{name}")
    assert said == module.ADVICE


def test_advice_is_no_fault_and_laws_that_fit_get_none():
    findings = audit_scene(crank)
    assert [finding.verdict for finding in findings].count("advice") == 1
    assert all(finding.sound for finding in findings)
    assert advice(crank.with_law("slider_pin", "johnson")) == ()
    K = hd.Parameter("K", "N/m^1.5", 1e10)
    assert advice(crank.replace(slider_pin=hd.Contact("slider_pin", power(K, 1.5)))) == ()


def test_a_missing_form_raises():
    class Blob(hd.PinInBush):
        form = None

    (pair,) = crank.mechanism.pairs
    with pytest.raises(TypeError, match="pair slider_pin: found the form of contact None"):
        form_of(Blob(**vars(pair)))
    with pytest.raises(ValueError, match="law own: found no form of contact"):
        StiffnessLaw("own", "own", (), "test", "C", force=d)
    with pytest.raises(ValueError, match="found the forms of contact"):
        FilmLaw("own", "own", (), "test", "C", forms=("volume",))


def test_pairs_of_the_users_touch_by_their_length_which_is_checked():
    places = hd.Body("block", hd.Parameter("mass", "kg", 1)).at(0, 0, 0), hd.GROUND.at(0, 0, 0)
    point = hd.CustomPair("touch", *places, 0, (0, 1, 0), (0, 0, 0), radius=hd.Parameter("radius", "m", 0.1))
    line = replace(point, length=hd.Parameter("width", "m", 0.2))
    assert (form_of(point), form_of(line)) == ("point", "line")
    fitting = ("hertz_point", "galin_sneddon", "thornton", "kogut_etsion", "jackson_green")
    assert tuple(fitting_laws("stiffness", point, point.geometry)) == fitting
    assert "popov_line" in fitting_laws("stiffness", line, line.geometry)
    assert "johnson" not in fitting_laws("stiffness", line, line.geometry)  # which asks for R1 and R2 together
    from hertzwerk.derive import InputError

    (pair,) = crank.mechanism.pairs
    wrong = replace(pair, length=hd.Parameter("bush_length", "kg", 15))
    with pytest.raises(InputError, match="pair slider_pin, length"):
        replace(crank, mechanism=replace(crank.mechanism, pairs=(wrong,)))


# -- what the forms need -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["popov_line", "wang_liu_external"])
def test_a_cylinder_meets_a_plane_by_laws_of_line_contact(name):
    """F = (pi/4) E* L d: half a period pi sqrt(m/K) in contact, and the penetration v sqrt(m/K)."""
    m, v, L, E, nu = 2.0, 0.3, 0.05, 207e9, 0.3
    mass, radius, length = (
        hd.Parameter("mass", "kg", m), hd.Parameter("radius", "m", 0.1), hd.Parameter("length", "m", L),
    )  # fmt: skip
    roller, pace = hd.Body("roller", mass), hd.Parameter("pace", "m/s", v)
    pair = hd.CylinderOnPlane("touch", roller.at(0, 0, 0), hd.Z, radius, length, hd.GROUND.at(0, 0, 0), hd.Y)
    scene = hd.Scene(
        hd.Mechanism("roller", (hd.Prismatic("way", hd.GROUND, roller, hd.Y),), (pair,)),
        (hd.Contact("touch", LAWS[name](steel, steel)), hd.EnergyLedger()),
        hd.Scales(length=hd.Parameter("deep", "um", 10), speed=pace),
        hd.Start(position={"way": radius + hd.Parameter("gap", "mm", 1)}, speed={"way": -pace}),
    )
    assert advice(scene) == ()
    (impact,) = simulate(load(scene), duration="10 ms", tolerance=1e-10).impacts
    K = 3.141592653589793 / 4 * E / (2 * (1 - nu**2)) * L
    assert impact.duration == pytest.approx(3.141592653589793 * (m / K) ** 0.5, rel=1e-6)
    assert impact.peak_penetration == pytest.approx(v * (m / K) ** 0.5, rel=1e-6)


# -- the run and the command line ----------------------------------------------------------------------------------------


def test_a_run_of_the_slider_crank_has_a_line_for_each_finding(tmp_path, capsys):
    run = simulate(load("slider_crank"), duration="24 ms", tolerance=1e-8)
    theory, left, warning = run.warnings
    assert "8 of 25 conform (worst 1.8 times): take `persson`; 6 of 25 are short for waves" in theory
    assert "they are up to 1.5 times the approach speed v0 since t = 0.007822 s (4 contacts, 5% of" in left
    assert "25 of 25 impacts of slider_pin exceed the law's limit of 0.0515 m/s (worst 4.39 m/s)" in warning
    assert len(run.engine.advice) == 1
    _report(run)
    *_, details = lines = capsys.readouterr().out.splitlines()[-5:]
    assert [line.split()[0] for line in lines] == [*["warning"] * 3, "advice", "details"]
    assert "take `persson`" in lines[0] and "`hertzwerk report`" in details and max(map(len, lines)) <= PROSE
    run.save(tmp_path / "run.npz")
    assert type(run).load(tmp_path / "run.npz").engine.advice == run.engine.advice


def test_a_pair_without_a_contact_is_advice():
    """A ball fell through its floor without a word."""
    (finding,) = advice_findings(scene_from("bouncing_ball").without("floor"))
    assert "pair floor has no Contact" in finding.reason
    assert advice_findings(scene_from("bicycle")) == ()  # its wheels roll in place of a contact
