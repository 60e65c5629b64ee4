// Slider-crank with a clearance joint between rod and slider, in quadruple precision (113 bits, about 34 digits).
//
// Equations: derived by hand in slider_crank.py beside this file. Integrator: Gragg-Bulirsch-Stoer extrapolation of the
// modified midpoint rule, columns 2, 4, ..., 20 (order 20; Hairer, Norsett & Wanner, Solving ODEs I, II.9), with error control.
// Every onset, separation, release, peak and output time is the end of a step of its own, found by a bracketed
// root search that integrates from the start of the step, so that no interpolation limits the digits.
//
//   g++ -O2 slider_crank_quad.cpp -lquadmath -o slider_crank_quad
//   ./slider_crank_quad TOLERANCE MAX_STEP FRICTION(0|1) CLEARANCE RPM TIME...
//
// prints, tab separated, 30 digits, SI:
//   state   t theta x dtheta dx                                    at every TIME; the last one ends the run
//   impact  onset speed m_eff t_depth depth t_force force end kind  kind: separated | released | unfinished
#include <quadmath.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

using Real = __float128;
using State = std::array<Real, 4>;  // theta [rad], x [m], dtheta [rad/s], dx [m/s]

static Real parse(const char* text) { return strtoflt128(text, nullptr); }

struct Mechanism {
  Real r = parse("0.05"), l = parse("0.12"), w = 5000 * 2 * M_PIq / 60;
  Real m_rod = parse("0.21"), J_rod = parse("2.5e-4"), s = parse("0.06"), m_slider = parse("0.14"), g = parse("9.81");
  Real R_bush = parse("0.01"), c = parse("5e-4"), E = parse("207e9"), nu = parse("0.3"), e = parse("0.9");
  Real mu = parse("0.1"), v_s = parse("0.1"), floor = parse("1e-3");
  bool friction = true;
  Real R_pin, K, h, I_A;  // I_A: rod about the crank pin

  void finish() {
    R_pin = R_bush - c;
    const Real E_eff = E / (2 * (1 - nu * nu));  // both of one material
    K = 4 * E_eff / 3 * sqrtq(R_bush * R_pin / c);
    h = 3 * (1 - e * e) / 4;
    I_A = J_rod + m_rod * s * s;
  }
};

enum Mode { Flight, Contact, Released };

// Everything the events and the equations need at one instant.
struct Instant {
  Real G, dG;              // event function (c^2 - e.e)/(2 c) [m] and its rate
  Real d, dd, ddd;         // penetration and its two derivatives (contact only)
  Real R, F, dF;           // 1 + h dd/v0, normal force, its rate
  Real n_x, n_y, lever_n;  // normal and the rod's partial velocity along it
  State rate;
};

struct System {
  Mechanism m;
  Mode mode = Flight;
  Real v0 = 0;

  Instant at(Real t, const State& y) const {
    Instant o{};
    const Real theta = y[0], x = y[1], dtheta = y[2], dx = y[3], phi = m.w * t;
    Real sin_phi, cos_phi, sin_theta, cos_theta;
    sincosq(phi, &sin_phi, &cos_phi);
    sincosq(theta, &sin_theta, &cos_theta);
    const Real ex = m.r * cos_phi + m.l * cos_theta - x, ey = m.r * sin_phi + m.l * sin_theta;
    const Real vx = -m.r * m.w * sin_phi - m.l * dtheta * sin_theta - dx, vy = m.r * m.w * cos_phi + m.l * dtheta * cos_theta;
    const Real ee = ex * ex + ey * ey;
    o.G = (m.c * m.c - ee) / (2 * m.c);
    o.dG = -(ex * vx + ey * vy) / m.c;

    Real moment = m.m_rod * m.s * (m.r * m.w * m.w * (sin_phi * cos_theta - cos_phi * sin_theta) - m.g * cos_theta);
    Real force = 0;
    Real eps = 0;
    if (mode == Contact) {
      eps = sqrtq(ee);
      o.n_x = ex / eps, o.n_y = ey / eps;
      o.lever_n = m.l * (o.n_y * cos_theta - o.n_x * sin_theta);
      o.d = eps - m.c;
      o.dd = o.n_x * vx + o.n_y * vy;
      o.R = 1 + m.h * o.dd / v0;
      if (o.d > 0) o.F = m.K * o.d * sqrtq(o.d) * o.R;
      Real f = 0;
      const Real lever_t = m.l * (o.n_x * cos_theta + o.n_y * sin_theta);  // partial velocity of the pin centre along t = (-n_y, n_x)
      if (m.friction) {
        const Real v_t = o.n_x * vy - o.n_y * vx + m.R_pin * dtheta;
        f = m.mu * o.F * tanhq(v_t / m.v_s);
      }
      moment -= o.F * o.lever_n + f * (lever_t + m.R_pin);
      force = o.F * o.n_x - f * o.n_y;
    }
    const Real ddtheta = moment / m.I_A, ddx = force / m.m_slider;
    o.rate = {dtheta, dx, ddtheta, ddx};
    if (mode == Contact) {
      const Real ax = -m.r * m.w * m.w * cos_phi - m.l * (ddtheta * sin_theta + dtheta * dtheta * cos_theta) - ddx;
      const Real ay = -m.r * m.w * m.w * sin_phi + m.l * (ddtheta * cos_theta - dtheta * dtheta * sin_theta);
      o.ddd = o.n_x * ax + o.n_y * ay + (vx * vx + vy * vy - o.dd * o.dd) / eps;
      if (o.d > 0) o.dF = m.K * sqrtq(o.d) * (3 * o.dd * o.R / 2 + o.d * m.h * o.ddd / v0);
    }
    return o;
  }
};

// One extrapolated step; returns the error estimate relative to `scale`.
static constexpr int Columns = 10;

static Real step(const System& f, const State& scale, Real t, const State& y, const State& rate, Real H, State& out) {
  State table[Columns];
  Real error = 0;
  for (int j = 0; j < Columns; ++j) {
    const int n = 2 * (j + 1);
    const Real h = H / n;
    State before = y, now, next;
    for (int i = 0; i < 4; ++i) now[i] = y[i] + h * rate[i];
    for (int k = 1; k < n; ++k) {
      const State k_rate = f.at(t + k * h, now).rate;
      for (int i = 0; i < 4; ++i) next[i] = before[i] + 2 * h * k_rate[i];
      before = now;
      now = next;
    }
    const State end_rate = f.at(t + H, now).rate;
    State column;
    for (int i = 0; i < 4; ++i) column[i] = (now[i] + before[i] + h * end_rate[i]) / 2;
    for (int k = 0; k < j; ++k) {  // Aitken-Neville in h^2
      const Real ratio = Real(n) / (2 * (j - k));
      const State last = table[k];
      table[k] = column;
      for (int i = 0; i < 4; ++i) column[i] += (column[i] - last[i]) / (ratio * ratio - 1);
    }
    if (j == Columns - 1) {
      for (int i = 0; i < 4; ++i) {
        const Real part = fabsq(column[i] - table[j - 1][i]) / scale[i];
        if (!(part <= error)) error = part;
      }
    }
    table[j] = column;
  }
  out = table[Columns - 1];
  return error;
}

// Root of phi in (a, b] given phi(a) < 0 <= phi(b) (or reverse): secant inside a shrinking bracket, else bisection.
static Real root(const std::function<Real(Real)>& phi, Real a, Real b, Real pa, Real pb) {
  for (int i = 0; i < 200 && pb != 0; ++i) {
    Real x = b - pb * (b - a) / (pb - pa);  // regula falsi with the Illinois weight
    if (!(x > fminq(a, b) && x < fmaxq(a, b))) x = (a + b) / 2;
    const Real px = phi(x);
    const Real width = fabsq(b - a);
    if ((px < 0) == (pb < 0)) {
      pa /= 2;
    } else {
      a = b, pa = pb;
    }
    const Real moved = fabsq(x - b);
    b = x, pb = px;
    if (moved < Real(1e-30Q) * width || width < 1e-36Q || moved < 1e-36Q) break;
  }
  return b;
}

static void print(Real value) {
  char text[64];
  quadmath_snprintf(text, sizeof text, "%.30Qe", value);
  std::printf("\t%s", text);
}

struct Impact {
  Real onset, speed, m_eff, t_depth = 0, depth = 0, t_force = 0, force = 0, end = 0;
  const char* kind = "unfinished";
};

int main(int count, char** arg) {
  if (count < 7) return std::fputs("usage: slider_crank_quad TOLERANCE MAX_STEP FRICTION CLEARANCE RPM TIME...\n", stderr), 2;
  const Real tolerance = parse(arg[1]), max_step = parse(arg[2]);
  System f;
  f.m.friction = std::atoi(arg[3]) != 0;
  f.m.c = parse(arg[4]);
  f.m.w = 2 * M_PIq * parse(arg[5]) / 60;
  f.m.finish();
  const Mechanism& m = f.m;
  const State scale = {m.c / m.l, m.c, m.r * m.w / m.l, m.r * m.w};

  Real t = 0, h = 1e-8Q;
  State y = {0, m.r + m.l, -m.w * m.r / m.l, 0};
  std::vector<Impact> impacts;
  long steps = 0;
  int next_output = 6;
  while (next_output < count) {
    const Real t_output = parse(arg[next_output]);
    const Instant start = f.at(t, y);
    bool lands = false;
    if (h > max_step) h = max_step;
    if (t + h >= t_output) h = t_output - t, lands = true;
    State end;
    const Real error = step(f, scale, t, y, start.rate, h, end);
    if (!(error <= tolerance)) {
      h *= error < 1e10Q ? fmaxq(0.1Q, 0.9Q * powq(tolerance / error, 1.0Q / 19)) : 0.1Q;
      continue;
    }
    ++steps;
    Instant finish = f.at(t + h, end);

    // What ends the step early: phi's first sign change. All re-integrate from (t, y).
    State trial;
    const auto probe = [&](Real tau) {
      step(f, scale, t, y, start.rate, tau, trial);
      return f.at(t + tau, trial);
    };
    Real taken = h;
    Mode next = f.mode;
    const auto gap = [&](Real tau) { return probe(tau).G; };
    const auto gap_rate = [&](Real tau) { return probe(tau).dG; };
    const Real sign = f.mode == Flight ? 1 : -1;  // sign of G inside the mode
    // Turning point of G against the mode's boundary: the bracket's inner end, and the graze test.
    Real inner = 0, inner_G = start.G;
    if (sign * start.dG > 0 && sign * finish.dG < 0 && sign * finish.G < 0) {
      inner = root(gap_rate, 0, h, start.dG, finish.dG), inner_G = gap(inner);
    }
    bool crosses = sign * finish.G < 0;
    Real outer = h, outer_G = finish.G;
    if (!crosses && sign * start.dG < 0 && sign * finish.dG > 0) {
      const Real graze = root(gap_rate, 0, h, start.dG, finish.dG), graze_G = gap(graze);
      if (sign * graze_G < 0) crosses = true, outer = graze, outer_G = graze_G;
    }
    if (crosses) {
      taken = root(gap, inner, outer, inner_G, outer_G);
      next = f.mode == Flight ? Contact : Flight;
    }
    if (f.mode == Contact) {  // release where the law would begin to pull
      const Instant last = probe(taken);
      if (last.R < 0) {
        taken = root([&](Real tau) { return probe(tau).R; }, 0, taken, start.R, last.R);
        next = Released;
      }
    }
    if (taken != h) lands = false;
    if (f.mode == Contact) {
      Impact& hit = impacts.back();
      const Instant last = probe(taken);
      if (start.dd > 0 && last.dd <= 0) {
        const Real tau = root([&](Real a) { return probe(a).dd; }, 0, taken, start.dd, last.dd);
        const Real depth = probe(tau).d;
        if (depth > hit.depth) hit.depth = depth, hit.t_depth = t + tau;
      }
      if (start.dF > 0 && last.dF <= 0) {
        const Real tau = root([&](Real a) { return probe(a).dF; }, 0, taken, start.dF, last.dF);
        const Real force = probe(tau).F;
        if (force > hit.force) hit.force = force, hit.t_force = t + tau;
      }
    }
    const Instant last = probe(taken);
    y = trial;
    t = lands ? t_output : t + taken;
    if (next != f.mode) {
      if (next == Contact) {
        f.mode = Contact;
        f.v0 = fmaxq(-last.dG, m.floor);
        const Instant o = f.at(t, y);
        impacts.push_back({t, -last.dG, 1 / (o.n_x * o.n_x / m.m_slider + o.lever_n * o.lever_n / m.I_A)});
        h = 1e-9Q;
      } else {
        if (f.mode == Contact) impacts.back().end = t, impacts.back().kind = next == Flight ? "separated" : "released";
        f.mode = next;
        h = next == Flight ? 1e-7Q : 1e-9Q;
      }
    } else if (!lands) {
      const Real grow = error > 0 ? 0.9Q * powq(tolerance / error, 1.0Q / 19) : 3;
      h *= fminq(3, fmaxq(0.3Q, grow));
    }
    if (lands) {
      std::printf("state");
      print(t);
      for (const Real& value : y) print(value);
      std::printf("\n");
      ++next_output;
      h = 1e-8Q;
    }
  }
  for (const Impact& hit : impacts) {
    std::printf("impact");
    for (const Real value : {hit.onset, hit.speed, hit.m_eff, hit.t_depth, hit.depth, hit.t_force, hit.force, hit.end}) print(value);
    std::printf("\t%s\n", hit.kind);
  }
  std::fprintf(stderr, "%ld accepted steps\n", steps);
  return 0;
}
