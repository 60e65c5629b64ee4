"""The oracle of a body on a plane against published times, restitutions in closed form, itself in quadruple precision, and with faults put in."""

import math
from dataclasses import replace

import numpy as np
import pytest
from bodies_on_planes import body_of

from reference.body_on_plane import HYSTERESIS_FACTORS, SOURCE, Body, motions, program

pytestmark = pytest.mark.exhaustive  # the oracle is C of its own, compiled several times
BALL = Body(
    plane=True,
    damping="elastic",
    exponent=1.5,
    mass=1.0,
    inertia=(1e-3, 1e-3, 1e-3),  # 2/5 m R^2
    offset=(0.0, 0.0, 0.0),
    radius=0.05,
    tilt=math.pi / 4,
    turn=0.0,
    stiffness=1e7,
    known={},
    mu_k=0.3,
    mu_s=0.3,
    duration=0.4,
    x=(0.0, 0.3, 0.0),
    q=(1.0, 0.0, 0.0, 0.0),
    angle=0.0,
    v=(0.0, 0.0, 0.0),
    w=(0.0, 0.0, 0.0),
    depth=1e-4,
    pace=1.0,
)
DOWN_Z = replace(BALL, plane=False, x=(0.0, 0.0, 0.3))  # the same in space, whose gravity is along -Z
PUBLISHED = [("touches", 0.216208323), ("sticks", 0.218505028), ("slips", 0.220873891), ("opens", 0.220924463)]
LEVEL = replace(BALL, tilt=0.0, exponent=1, gravity=0.0, x=(0.0, 0.05, 0.0), v=(0.0, -1.0, 0.0), duration=0.01)


def happened(motion, kind):
    """Times of the events of a kind."""
    return [t for t, found, _ in motion.events if found == kind]


@pytest.mark.parametrize("body", [BALL, DOWN_Z], ids=["plane", "space"])
def test_published_times_of_the_first_ball(body):
    (motion,) = motions([body])
    assert [(kind, pytest.approx(t, abs=6e-10)) for kind, t in PUBLISHED] == [
        (kind, t) for t, kind, _ in motion.events if kind != "flight"
    ]


def test_in_space_and_in_the_plane_alike():
    one, other = motions([BALL, DOWN_Z])
    assert not one.wrong and not other.wrong
    for (t, kind, v0), (u, other_kind, w0) in zip(one.events, other.events, strict=True):
        assert kind == other_kind and abs(t - u) < 1e-16 and abs(v0 - w0) < 1e-15
    x, y = one.state[:2]
    np.testing.assert_allclose(other.state[:3], (x, 0, y), rtol=0, atol=3e-15)
    np.testing.assert_allclose(other.state[7:10], (one.state[7], 0, one.state[8]), rtol=0, atol=3e-15)
    assert abs(other.state[11] + one.state[12]) < 1e-13  # about Y in place of Z


@pytest.mark.parametrize("law", HYSTERESIS_FACTORS)
@pytest.mark.parametrize("exponent", [1, 1.5, 2])
def test_hysteresis_gives_the_restitution_of_its_relation(law, exponent):
    """h (1 + e) = ln((1 + h)/(1 - h e)), whatever the elastic law."""
    e = 0.6
    h = HYSTERESIS_FACTORS[law](e)
    (motion,) = motions([replace(LEVEL, damping=law, known={"restitution": e}, exponent=exponent, duration=0.1)])
    out = motion.state[8]
    assert 0 < h * out < 1
    assert h * (1 + out) == pytest.approx(math.log((1 + h) / (1 - h * out)), rel=1e-13)
    if law == "exact":
        assert out == pytest.approx(e, rel=1e-13)


@pytest.mark.parametrize("law", ["kelvin_voigt", "tsuji"])
def test_every_linear_contact_that_is_damped_pulls_before_it_opens(law):
    """However near that is to the opening: a step that ended beyond both passed over the pull."""
    bodies = [replace(BALL, damping=law, exponent=1, known={"restitution": e}, duration=2.0) for e in (0.7, 0.74, 0.82)]
    for motion in motions(bodies):
        assert len(happened(motion, "pulls")) == len(happened(motion, "opens")) > 0


HARD = replace(
    DOWN_Z, mass=1.74036, inertia=(2.6354e-4, 3.10187e-4, 3.28556e-4), offset=(0.00665304, 0.0, 0.0), radius=0.0449658, tilt=0.434577,
    stiffness=1.50019e7, damping="lee_wang", known={"restitution": 0.570645}, mu_k=0.471913, mu_s=0.471913, x=(0.0, 0.0, 0.513057),
    v=(0.222066, 0.0, 0.0), w=(-7.35237, 0.697269, 0.0), duration=0.66,
)  # fmt: skip


def test_quadruple_precision_agrees():
    """A body in space that sticks and slips, with an offset mass centre and unlike moments."""
    bodies = [BALL, HARD, replace(HARD, mu_s=0.5)]
    for one, other in zip(motions(bodies), motions(bodies, quad=True), strict=True):
        assert len(happened(one, "sticks")) == len(happened(one, "slips")) == 1
        for (t, kind, _), (u, other_kind, _) in zip(one.events, other.events, strict=True):
            assert kind == other_kind and abs(t - u) < 3e-16
        np.testing.assert_allclose(one.state, other.state, rtol=1e-13, atol=1e-14)


def times(body, seed, draw):
    """Random times of a body's motion."""
    random = np.random.default_rng(seed)
    *_, at = (np.sort(random.uniform(0, body.duration, random.integers(5, 100))) for _ in range(draw))
    return [*at.tolist(), body.duration]


MANY_AT_ONCE = {  # bodies of the generator: times at which their states are asked for
    355: [],  # rest in space, which steps jumped over to and fro
    21: times(body_of(21), 7, 3),  # slip that begins without speed, and slows down by rounding: no step was left
    647: np.linspace(0, 0.48855, 6)[1:].tolist(),  # a contact that begins at rest and without force
    694: [0.2971167710801966],  # what sticks lets go as its normal force runs out: the contact ends, else its law pulls
}


@pytest.mark.parametrize("i", MANY_AT_ONCE)
def test_events_at_one_time_are_distinguished(i):
    of = [motions([body_of(i)], by, at=MANY_AT_ONCE[i]) for by in (0.0, 1e-16)]
    (one,), (other,) = of
    assert not one.wrong and not other.wrong
    assert [kind for _, kind, _ in one.events] == [kind for _, kind, _ in other.events]
    np.testing.assert_allclose(one.state, other.state, atol=1e-11)


def test_a_contact_that_fades_is_released_before_its_gap_opens():
    """N = K d (d + 2 c d') falls with d < 2 c |d'| however slowly the body is lifted: here one that rolls off by its own offset."""
    fading = Body(
        plane=True, damping="kuwabara_kono", exponent=2, mass=0.0204732442856557,
        inertia=(1.5504163834065456e-06, 1.7583096928891264e-06, 2.827982835111447e-06), offset=(0.0009563564834474709, -0.004836018390749881, 0.0),
        radius=0.01669144111644585, tilt=-0.29969991772840937, turn=0.0, stiffness=287717444167.12976, known={"material_time": 4.678677502281178e-05},
        mu_k=0.4531678840645099, mu_s=0.5859044704646458, duration=0.46, x=(-0.008950603865184377, 0.013097539208504979, 0.0),
        q=(0.5437594592327791, 0.0, 0.0, 0.8392411158271952), angle=1.9917721815948815, v=(-0.19122123690956322, -0.05908879317079496, 0.0),
        w=(0.0, 0.0, 10.181649532020174), depth=5.62410596149923e-06, pace=0.05,
    )  # fmt: skip
    one, other = motions([fading])[0], motions([fading], quad=True)[0]
    assert [kind for _, kind, _ in one.events[-3:]] == ["slips", "released", "opens"]
    np.testing.assert_allclose(one.state, other.state, rtol=0, atol=1e-13)


FAULTS = {
    "slip is found late": ("g[n] = B->mu_s * N - size(f)", "g[n] = 1.001 * B->mu_s * N - size(f)"),
    "an arm of the friction force": ("P->rho[i] = P->c[i] - B->R", "P->rho[i] = P->c[i] - (B->R - 1e-6)"),
    "friction a millionth too large": ("limit = -B->mu_k * N;", "limit = -1.000001L * B->mu_k * N;"),
    "the latched speed": ("B->v0 = most(P.v, B->floor);", "B->v0 = most(P.v, B->floor) * 1.000001L;"),
    "the centripetal term": ("b[i] += a[i] + turn[i];", "b[i] += a[i] + 1.000001L * turn[i];"),
    "the gyroscopic moment": ("moment[i] -= dot(P->A[i], gyro);", "moment[i] += 0 * dot(P->A[i], gyro);"),
}  # fmt: skip


@pytest.mark.parametrize("fault", FAULTS)
def test_a_seeded_fault_moves_the_end(fault, tmp_path):
    """Of the body in space; by more than a thousand times what the precisions differ by."""
    right, wrong = FAULTS[fault]
    text = SOURCE.read_text(encoding="utf-8")
    assert right in text
    spoilt = tmp_path / "spoilt.c"
    spoilt.write_text(text.replace(right, wrong), encoding="utf-8")
    (true,), (false,) = motions([HARD]), motions([HARD], by=program(source=spoilt))
    assert max(abs(a - b) for a, b in zip(true.state, false.state, strict=True)) > 1e-10


STOPS = """
0.0 0.032868228008091 0.08403610975587594 0.08404379433668263 0.08406915992852397 0.0841322640330508
0.084262949416714 0.08450766906786869 0.08495464695629078 0.08541271235940102 0.08559826757850243 0.08604265644190325
0.08647766890361967 0.08691852700784274 0.0874347252545708 0.0880211754901504 0.08854728580743033 0.08900507837507005
0.08920868430487917 0.0892799738587073 0.08932816701288204 0.08933607412560794 0.20829803651330348 0.23034163751707334
0.230354675664947 0.2303919348326366 0.2304784907025392 0.23065153664460172 0.23097740715139117 0.23146059019167295
0.23196929873439784 0.23249269673774411 0.23289092523195132 0.23328616508975852 0.23381634209306149 0.2342163361535596
0.23472259058960798 0.23532661332152 0.2356613358184905 0.23578163640241606 0.23586699857029794
"""


def test_slip_that_rounding_begins_is_no_event_again():
    """Body 700 with these stops: at .2357816 s the holding force exceeds the limit by 2e-17, and sliding by 1e-20 reversed without end."""
    (motion,) = motions([body_of(700)], 1e-16, at=[float(t) for t in STOPS.split()])
    assert not motion.wrong and len(motion.events) == 21
