"""The oracles against each other: two derivations, two precisions, closed forms against integration and print."""

import math
from decimal import Decimal

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from reference import closed_forms, ideal_slider_crank
from reference.slider_crank import SliderCrank, reference

MECHANISM = SliderCrank()


def newton_euler(m: SliderCrank, t: float, state: np.ndarray, F: float, f: float) -> tuple[float, float]:
    """Free-body equations of rod and slider, all reactions kept: a second derivation of the accelerations.

    Unknowns: rod centre (a_x, a_y), theta'', slider x'', crank-pin force (P_x, P_y) on the rod, guide force N on the
    slider.
    """
    theta, _, dtheta, _ = state
    phi = m.w * t
    e = np.array(m.journal(t, state)[:2])
    n = e / np.linalg.norm(e)
    on_rod = -F * n - f * np.array([-n[1], n[0]])
    to_pin = -m.s * np.array([math.cos(theta), math.sin(theta)])  # from the rod's centre
    to_contact = (m.l - m.s) * np.array([math.cos(theta), math.sin(theta)]) + m.R_pin * n
    A, b = np.zeros((7, 7)), np.zeros(7)
    A[0, [0, 4]], b[0] = (m.m_rod, -1), on_rod[0]
    A[1, [1, 5]], b[1] = (m.m_rod, -1), on_rod[1] - m.m_rod * m.g
    A[2, [2, 4, 5]] = m.J_rod, to_pin[1], -to_pin[0]
    b[2] = to_contact[0] * on_rod[1] - to_contact[1] * on_rod[0]
    A[3, 3], b[3] = m.m_slider, -on_rod[0]
    A[4, 6], b[4] = 1, m.m_slider * m.g + on_rod[1]
    # The rod's material point at the crank pin moves with the crank.
    A[5, [0, 2]] = 1, -to_pin[1]
    b[5] = -m.r * m.w**2 * math.cos(phi) + dtheta**2 * to_pin[0]
    A[6, [1, 2]] = 1, to_pin[0]
    b[6] = -m.r * m.w**2 * math.sin(phi) + dtheta**2 * to_pin[1]
    solution = np.linalg.solve(A, b)
    return solution[2], solution[3]


@pytest.mark.parametrize("friction", [False, True])
def test_two_derivations_agree(friction):
    random = np.random.default_rng(2)
    for _ in range(100):
        t = random.uniform(0, 0.024)
        phi = MECHANISM.w * t
        turn = random.uniform(0, 2 * math.pi)
        d = 10 ** random.uniform(-7, -3.5)
        e_x, e_y = ((MECHANISM.c + d) * trig(turn) for trig in (math.cos, math.sin))
        theta = math.asin((e_y - MECHANISM.r * math.sin(phi)) / MECHANISM.l)
        x = MECHANISM.r * math.cos(phi) + MECHANISM.l * math.cos(theta) - e_x
        state = np.array([theta, x, random.uniform(-300, 300), random.uniform(-30, 30)])
        F, f, _ = MECHANISM.contact(t, state, 2.0, friction)
        got = MECHANISM.accelerations(t, state, v0=2.0, friction=friction)
        largest = abs(F) / MECHANISM.m_slider + MECHANISM.r * MECHANISM.w**2
        np.testing.assert_allclose(got, newton_euler(MECHANISM, t, state, F, f), rtol=1e-12, atol=1e-12 * largest)


@pytest.mark.parametrize("friction", [False, True])
def test_double_precision_meets_the_quadruple_digits(friction):
    """SciPy's DOP853 on the Python equations: the first three impacts and the state at 1 ms."""
    truth = reference(friction)

    def gap(t, y):
        return (MECHANISM.c**2 - sum(e**2 for e in MECHANISM.journal(t, y)[:2])) / (2 * MECHANISM.c)

    gap.terminal = True
    t, state, v0, onsets = 0.0, np.array(MECHANISM.start), None, []
    while t < 1e-3:
        gap.direction = -1 if v0 is None else 1
        run = solve_ivp(
            lambda s, y, v0=v0: (*y[2:], *MECHANISM.accelerations(s, y, v0=v0, friction=friction)),
            (t, 1e-3), state, method="DOP853", rtol=1e-12, atol=1e-15, events=gap, max_step=2e-6,
        )  # fmt: skip
        t, state = run.t[-1], run.y[:, -1]
        if run.status == 1 and v0 is None:
            e_x, e_y, v_x, v_y = MECHANISM.journal(t, state)
            v0 = (e_x * v_x + e_y * v_y) / math.hypot(e_x, e_y)
            onsets.append((t, v0, MECHANISM.effective_mass(t, state)))
        else:
            v0 = None
    expected = [(i.onset, i.speed, i.effective_mass) for i in truth.impacts if i.onset < 1e-3]
    assert len(onsets) == len(expected) >= 3
    np.testing.assert_allclose(onsets, expected, rtol=1e-8)
    assert truth.error(0.001, tuple(state)) < 1e-8


@pytest.mark.parametrize("friction, depth", [(False, 7.795e-5), (True, 7.817e-5)])
def test_published_first_impact(friction, depth):
    """Independent numbers of issue 2 ("Scenarios"): onset, effective mass, approach, penetration."""
    hit = reference(friction).impacts[0]
    assert hit.onset == pytest.approx(2.2728e-4, abs=5e-9)
    assert hit.effective_mass == pytest.approx(0.14013, abs=5e-6)
    assert hit.speed == pytest.approx(4.38583, abs=5e-6)
    assert hit.depth == pytest.approx(depth, rel=1e-4)


@pytest.mark.parametrize("friction", [False, True])
def test_reference_is_converged(friction):
    truth = reference(friction)
    assert max(truth.uncertainty.values()) < 1e-17
    assert list(truth.states) == [ms / 1000 for ms in range(1, 25)]
    ends = [hit.end for hit in truth.impacts[:-1]]
    assert all(end <= hit.onset for end, hit in zip(ends, truth.impacts[1:], strict=True))


# contact-laws.md, section 2: h that gives e exactly, and the limits of two laws.
EXACT = {
    "0.95": ".078927", "0.9": ".166482", "0.8": ".373146", "0.7": ".634828", "0.6": ".974872", "0.5": "1.432751",
    "0.4": "2.082498", "0.3": "3.087082", "0.2": "4.919167", "0.1": "9.998159",
}  # fmt: skip


@pytest.mark.parametrize("e, printed", EXACT.items())
def test_exact_factor(e, printed):
    h = closed_forms.exact_factor(e)
    assert round(Decimal(h), 6) == Decimal(printed)
    assert closed_forms.restitution(h) == pytest.approx(float(e), rel=1e-15)


def test_limits_of_the_factors():
    assert closed_forms.restitution(closed_forms.factor("lankarani_nikravesh", 0)) == pytest.approx(0.6630, abs=5e-5)
    assert closed_forms.restitution(closed_forms.factor("hunt_crossley", 0)) == pytest.approx(0.4877, abs=5e-5)
    assert closed_forms.restitution(1e-9) == pytest.approx(1 - 2e-9 / 3, rel=1e-15)  # e_out = 1 - 2 h/3 + O(h^2)
    assert closed_forms.restitution(0) == 1
    assert closed_forms.exact_factor("0.01") == pytest.approx(100, rel=1e-15)


@pytest.mark.parametrize(
    "K, depth, force, duration",
    [("2.4e10", 2.53372286e-4, 96794.33, 1.6836060e-4), ("1.4e8", 1.98332e-3, 12365.6, 1.31787e-3)],
)
def test_elastic_impacts_of_scenarios(K, depth, force, duration):
    hit = closed_forms.collision(K, "1.5", 1, closed_forms.drop_speed(1, "9.81"))
    assert (hit.depth, hit.peak_force, hit.duration) == pytest.approx((depth, force, duration), rel=4e-6)
    assert hit.duration == pytest.approx(2.9432751843 * hit.depth / closed_forms.drop_speed(1, "9.81"), rel=1e-10)


def test_impact_under_gravity():
    v0 = closed_forms.drop_speed(1, "9.81")
    assert v0 == pytest.approx(4.42944692, rel=1e-9)
    assert closed_forms.depth_with_gravity("2.4e10", "1.5", 1, v0, "9.81") == pytest.approx(2.53398e-4, rel=2e-6)
    assert closed_forms.static_penetration("2.4e10", "1.5", 1, "9.81") == pytest.approx(5.5e-7, rel=2e-2)
    soft = closed_forms.depth_with_gravity("1.4e8", "1.5", 1, v0, "9.81")
    assert soft / closed_forms.collision("1.4e8", "1.5", 1, v0).depth - 1 == pytest.approx(7.9e-4, rel=1e-2)


@pytest.mark.by_turns(3)
@pytest.mark.parametrize("n", [1.0, 10 / 9, 1.5, 2.0])
@pytest.mark.parametrize("h", [0.0, 0.1425, 1.43])
def test_collision_against_integration(n, h):
    K, mass, v0 = 3e7, 0.4, 1.7
    hit = closed_forms.collision(K, n, mass, v0, h)

    def force(d, v):
        return K * max(d, 0.0) ** n * (1 + h * v / v0)

    def gap(t, y):
        return y[0]

    gap.terminal, gap.direction = True, -1
    run = solve_ivp(
        lambda t, y: (y[1], -force(*y) / mass), (0, 2 * hit.duration), (0, v0), method="DOP853", rtol=1e-12, atol=1e-16,
        events=gap, max_step=hit.duration / 500, dense_output=True,
    )  # fmt: skip
    d, v = run.sol(np.linspace(0, run.t[-1], 20001))
    got = (run.t[-1], -run.y[1, -1] / v0, d.max(), max(map(force, d, v)), mass * (v0**2 - run.y[1, -1] ** 2) / 2)
    expected = (hit.duration, hit.restitution, hit.depth, hit.peak_force, hit.dissipated)
    assert got == pytest.approx(expected, rel=1e-7, abs=1e-9)


@pytest.mark.parametrize(
    "e, printed",
    [("0.9", (9.090298887, 8.263743089, 7.512142692)), ("0.5", (6.629838391, 4.395155252, 2.913688144))],
)
def test_published_speeds_between_walls(e, printed):
    h = closed_forms.factor("hunt_crossley", e)
    rows = closed_forms.ball_between_walls(1e6, 1, "1.6", 10, h, 3, "0.5", 1)
    assert [row.rebound for row in rows] == pytest.approx(printed, rel=2e-4)
    assert rows[1].onset == pytest.approx(rows[0].onset + rows[0].duration + 1 / rows[0].rebound, rel=1e-15)
    assert rows[1].depth == pytest.approx(rows[0].depth * rows[0].rebound / rows[0].approach, rel=1e-14)  # n = 1


def test_two_spheres():
    assert closed_forms.two_spheres("0.3", closed_forms.exact_factor("0.7")) == pytest.approx((0.045, 0.255), rel=1e-14)


def test_ideal_slider_crank():
    """Derivatives by complex step, the dead centres' printed accelerations, and the gain by brute force."""
    r, l, w = MECHANISM.r, MECHANISM.l, MECHANISM.w
    phi, tiny = np.linspace(0, 2 * np.pi, 721), 1e-30
    turned = phi + 1j * w * tiny

    np.testing.assert_allclose(
        ideal_slider_crank.position(turned, r, l).imag / tiny, ideal_slider_crank.velocity(phi, w, r, l), atol=1e-12
    )
    np.testing.assert_allclose(
        ideal_slider_crank.velocity(turned, w, r, l).imag / tiny,
        ideal_slider_crank.acceleration(phi, w, r, l),
        atol=1e-9,
    )
    np.testing.assert_allclose(
        ideal_slider_crank.rod_angle(turned, r, l).imag / tiny, ideal_slider_crank.rod_speed(phi, w, r, l), atol=1e-10
    )
    ends = ideal_slider_crank.acceleration(np.array([0, np.pi]), w, r, l)
    assert ends == pytest.approx((-19419.3605, 7996.2073), rel=1e-8)

    size = 6e-4
    turn = np.linspace(0, 2 * np.pi, 721)[:, None]
    e_x, e_y = size * np.cos(turn), size * np.sin(turn)
    sine = (e_y - r * np.sin(phi)) / l
    x = r * np.cos(phi) + l * np.sqrt(1 - sine**2) - e_x
    worst = np.abs(x - ideal_slider_crank.position(phi, r, l)).max()
    assert ideal_slider_crank.gain(r, l) * size * 0.999 < worst <= ideal_slider_crank.gain(r, l, size) * size
