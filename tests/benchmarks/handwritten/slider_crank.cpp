// The slider-crank with clearance as fast as one writes it by hand: the limit that generated code is measured against.
//
//   g++ -O3 -march=native -std=c++17 slider_crank.cpp -o slider_crank
//   ./slider_crank run METHOD TOLERANCE FRICTION CLEARANCE REPEATS TIME...   METHOD: dopri5 | dop853, FRICTION: 0 | 1
//   ./slider_crank bare                                                      time of one evaluation in each mode
//
// Both print one JSON object in SI units. TOLERANCE is the local error in the scene's scales: positions by the clearance (the
// rod angle by clearance/length), speeds by r w. The time is that of whole runs from the start to the last TIME, of the processor.
// -DREAL="long double" checks the program against the quadruple-precision reference.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

#include "mechanism.hpp"
#include "quintic.hpp"
#include "stopwatch.hpp"
#include "tables.hpp"

#ifndef REAL
#define REAL double
#endif
using Real = REAL;

// y + h (row . k) with the row known to the compiler: zeros vanish.
template <class Table, int row, std::size_t n, std::size_t... j>
inline std::array<Real, n> combine(const std::array<Real, n>& y, Real h, const std::array<Real, n>* k, std::index_sequence<j...>) {
  std::array<Real, n> sum{};
  const auto add = [&](auto index) {
    constexpr int J = decltype(index)::value;
    if constexpr (Table::a[row][J] != 0) {
      constexpr Real a = Real(Table::a[row][J]);
      for (std::size_t i = 0; i < n; ++i) sum[i] += a * k[J][i];
    }
  };
  (add(std::integral_constant<int, int(j)>{}), ...);
  for (std::size_t i = 0; i < n; ++i) sum[i] = y[i] + h * sum[i];
  return sum;
}

struct Impact {
  Real onset, speed, end;
};

template <class Table, bool Friction>
class Simulation {
 public:
  Simulation(const Mechanism<Real>& mechanism, Real tolerance) : m(mechanism), accuracy(tolerance) {
    const State<Real> scales = m.scales();
    for (int i = 0; i < 4; ++i) weight[i] = 1 / (scales[i] * accuracy);
    landing = std::max(Real(0.01L) * accuracy * m.c, 4 * EPS * (m.r + m.l));
    y = m.start();
    now = m.template at<Friction>(mode, t, y, 0);
    ++evaluations;
  }

  void advance(Real t_end) {
    while (t < t_end) attempt(t_end);
  }

  // One step towards t_end: accepted, rejected, or landed on an event.
  void attempt(Real t_end) {
    const Real sign = mode == Mode::Flight ? 1 : -1;
    Real h = step_memory();
    if (!on_surface) h = std::min(h, aim(sign * now.G, sign * now.dG, sign * now.ddG));
    const Real left = t_end - t;
    bool lands = false;
    if (h >= left) h = left, lands = true;
    else if (2 * h > left) h = left / 2;
    const bool shortened = h < step_memory();

    State<Real> end = step(h);
    Instant<Real> then = at_end(h, end);
    const Real err = error(h, then.rate) * roughness(now.G, then.G);
    if (!(err <= 1)) {
      ++rejected;
      step_memory() = h * factor(err, false);
      return;
    }
    ++steps;
    const Real grown = h * factor(err, true);
    if (!shortened || grown > step_memory()) step_memory() = grown;

    // Land on the gap's root: nudge the end if it is near, else retake the step, bracketed.
    const Real theta = first_fall<Real>(sign * now.G, sign * now.dG, sign * now.ddG, sign * then.G, sign * then.dG,
                                        sign * then.ddG, h, on_surface);
    const Real whole = h;
    Real before = 0, after = sign * then.G > 0 ? 2 * h : h;
    bool crosses = theta <= 1;
    if (crosses && sign * then.G > 0) {
      h *= theta, end = step(h), then = at_end(h, end);
      crosses = sign * then.G <= 0;  // else a graze of the quintic, not of the state: keep the shorter step
    } else if (crosses && !near_root(then, whole)) {
      h *= theta, end = step(h), then = at_end(h, end);
    }
    for (int i = 0; i < 40 && sign * then.dG < 0 && std::abs(then.G) > landing; ++i) {
      const bool near = near_root(then, whole);
      if (!crosses && !near) break;
      const Real delta = -then.G / then.dG;
      if (near) {
        end = nudge(h, end, then.rate, delta);
        h += delta;
      } else {
        (sign * then.G > 0 ? before : after) = h;
        h = h + delta > before && h + delta < after ? h + delta : (before + after) / 2;
        end = step(h);
      }
      then = at_end(h, end);
    }
    t = lands && h == whole ? t_end : t + h;
    y = end;
    now = then;
    on_surface = std::abs(now.G) <= landing;
    if (on_surface && sign * now.dG < 0) change(mode == Mode::Flight ? Mode::Contact : Mode::Flight);
    else if (mode == Mode::Contact && pulls()) change(Mode::Released);
  }

  Real now_at() const { return t; }

  bool is(Mode active) const { return mode == active; }

  State<Real> y;
  long evaluations = 0, contact_evaluations = 0, steps = 0, rejected = 0;
  std::vector<Impact> impacts;

 protected:
  static constexpr Real EPS = sizeof(Real) > 8 ? Real(1.1e-19L) : Real(2.2e-16L);
  const Mechanism<Real>& m;
  Real accuracy, landing;
  State<Real> weight;
  Mode mode = Mode::Flight;
  Real t = 0, h_per_v0 = 0;
  Real next_step[2] = {1e-6L, 1e-6L};  // flight (and released), contact: each remembers its own
  Real last_error = 1e-4L;
  bool on_surface = false;             // this step starts where the last one landed
  Instant<Real> now;
  State<Real> k[Table::stages];

  template <Mode active, std::size_t... row>
  State<Real> stages(Real h, std::index_sequence<row...>) {
    k[0] = now.rate;
    ((k[row + 1] = m.template rate<active, Friction>(
          t + h * Real(Table::c[row + 1]),
          combine<Table, row + 1>(y, h, k, std::make_index_sequence<row + 1>{}), h_per_v0)),
     ...);
    return combine<Table, Table::stages>(y, h, k, std::make_index_sequence<Table::stages>{});
  }

  State<Real> step(Real h) {
    evaluations += Table::stages - 1;
    if (mode != Mode::Contact) return stages<Mode::Flight>(h, std::make_index_sequence<Table::stages - 1>{});
    contact_evaluations += Table::stages - 1;
    return stages<Mode::Contact>(h, std::make_index_sequence<Table::stages - 1>{});
  }

  Instant<Real> at_end(Real h, const State<Real>& end) {
    ++evaluations;
    contact_evaluations += mode == Mode::Contact;
    return m.template at<Friction>(mode, t + h, end, h_per_v0);
  }

  // Local error over the tolerance, in the Euclidean mean of the four components.
  Real error(Real h, const State<Real>& end_rate) const {
    Real square = 0, third = 0;
    for (int i = 0; i < 4; ++i) {
      Real e = 0, e3 = 0;
      for (int j = 0; j < Table::stages; ++j) e += Real(Table::error[j]) * k[j][i];
      if constexpr (Table::error_needs_end) {
        e += Real(Table::error[Table::stages]) * end_rate[i];
      } else {
        for (int j = 0; j < Table::stages; ++j) {
          e3 += Real(Table::a[Table::stages][j] - Table::third[j]) * k[j][i];
        }
      }
      square += e * weight[i] * e * weight[i];
      third += e3 * weight[i] * e3 * weight[i];
    }
    if constexpr (Table::error_needs_end) return h * std::sqrt(square / 4);
    const Real both = square + third / 100;
    return both > 0 ? h * square / std::sqrt(4 * both) : 0;
  }

  // In contact the force is d^(3/2), whose distance from being smooth is d itself: where a step multiplies or divides d the
  // estimate, built for smooth functions, says less than the true error instead of a hundred times more.
  Real roughness(Real G0, Real G1) const {
    if (mode != Mode::Contact) return 1;
    const Real a = std::abs(G0), b = std::abs(G1), ratio = std::min(a, b) / std::max(a, b);
    return 1 / std::max(ratio * ratio, 1 / Real(32));
  }

  // Factor of the next step: elementary for the 8th order, with the last error's damping for the 5th (Hairer & Wanner).
  Real factor(Real err, bool accepted) {
    if constexpr (Table::order == 5) {
      const Real f = std::pow(std::max(err, Real(1e-10L)), Real(-0.17L)) * std::pow(last_error, Real(0.04L));
      if (accepted) last_error = std::max(err, Real(1e-4L));
      return std::min(Real(accepted ? 10 : 1), std::max(Real(0.2L), Real(0.9L) * f));
    }
    const Real f = std::pow(std::max(err, Real(1e-10L)), Real(-1 / 8.0L));
    return std::min(Real(accepted ? 3 : 1), std::max(Real(0.2L), Real(0.9L) * f));
  }

  Real& step_memory() { return next_step[mode == Mode::Contact]; }

  // Time to the gap's root by its value, rate and second rate: a good aim shortly before the event.
  Real aim(Real p, Real dp, Real ddp) const {
    if (dp >= 0 && ddp >= 0) return 1;
    const Real under = dp * dp - 2 * p * ddp;
    return under >= 0 ? 2 * p / (std::sqrt(under) - dp) : 1;
  }

  // From (t + h, end) along the mode's equations by a time so small that the classical Runge-Kutta method is exact enough.
  State<Real> nudge(Real h, const State<Real>& end, const State<Real>& k1, Real delta) {
    const auto rate = [&](const State<Real>& slope, Real part) {
      State<Real> at;
      for (int i = 0; i < 4; ++i) at[i] = end[i] + part * slope[i];
      ++evaluations;
      if (mode != Mode::Contact) return m.template rate<Mode::Flight, Friction>(t + h + part, at, h_per_v0);
      ++contact_evaluations;
      return m.template rate<Mode::Contact, Friction>(t + h + part, at, h_per_v0);
    };
    const State<Real> k2 = rate(k1, delta / 2), k3 = rate(k2, delta / 2), k4 = rate(k3, delta);
    State<Real> moved;
    for (int i = 0; i < 4; ++i) moved[i] = end[i] + delta / 6 * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]);
    return moved;
  }

  // Within 1/64 of a step: the nudge's error, its fifth power, is then below that of the step.
  static bool near_root(const Instant<Real>& at, Real h) { return 64 * std::abs(at.G) < h * std::abs(at.dG); }

  // 1 + h d'/v0 < 0 and still overlapping. d' = -G' to first order in the penetration.
  bool pulls() const { return 1 - h_per_v0 * now.dG < 0; }

  void change(Mode next) {
    if (next == Mode::Contact) {
      const Real v0 = std::max(-now.dG, m.approach_floor);
      h_per_v0 = m.h / v0;
      // d^(3/2) is not smooth at the onset: the first step's error grows like its 3.5th power.
      next_step[1] = Real(1.6L) * std::pow(accuracy, Real(2 / 7.0L)) * m.hertz_duration(t, y, v0);
      impacts.push_back({t, -now.dG, 0});
    } else if (mode == Mode::Contact) {
      impacts.back().end = t;
    }
    mode = next;
    last_error = 1e-4L;
    now = m.template at<Friction>(mode, t, y, h_per_v0);
    ++evaluations;
    contact_evaluations += mode == Mode::Contact;
  }
};

template <class Simulation>
void run(Real tolerance, Real clearance, int repeats, const std::vector<Real>& times) {
  const Mechanism<Real> mechanism(clearance);
  const double seconds = median_seconds(repeats, [&] {
    Simulation simulation(mechanism, tolerance);
    for (const Real t : times) simulation.advance(t);
  });
  Simulation simulation(mechanism, tolerance);
  std::printf("{\"states\": [");
  for (std::size_t i = 0; i < times.size(); ++i) {
    simulation.advance(times[i]);
    const State<Real>& y = simulation.y;
    std::printf("%s[%.21Lg, %.21Lg, %.21Lg, %.21Lg, %.21Lg]", i ? ", " : "", (long double)times[i], (long double)y[0],
                (long double)y[1], (long double)y[2], (long double)y[3]);
  }
  std::printf("], \"impacts\": [");
  for (std::size_t i = 0; i < simulation.impacts.size(); ++i) {
    const Impact& hit = simulation.impacts[i];
    std::printf("%s[%.21Lg, %.21Lg]", i ? ", " : "", (long double)hit.onset, (long double)hit.speed);
  }
  std::printf("], \"evaluations\": %ld, \"contact_evaluations\": %ld, \"steps\": %ld, \"rejected\": %ld, \"seconds\": %.9g}\n",
              simulation.evaluations, simulation.contact_evaluations, simulation.steps, simulation.rejected,
              seconds);
}

// Time of one evaluation at the states of a real run, each waiting for the last as the stages of a step do.
template <Mode mode, bool Friction>
double bare(const Mechanism<Real>& m) {
  std::vector<std::pair<Real, State<Real>>> states;
  Simulation<Dop853, Friction> simulation(m, Real(1e-6L));
  while (simulation.now_at() < Real(0.024L)) {
    if (simulation.is(mode)) states.emplace_back(simulation.now_at(), simulation.y);
    simulation.attempt(Real(0.024L));
  }
  constexpr int rounds = 200;
  Real last = 0;
  const double seconds = median_seconds(11, [&] {
    for (int i = 0; i < rounds; ++i) {
      for (auto [t, y] : states) {
        for (int j = 0; j < 4; ++j) y[j] += Real(1e-22L) * last;
        const State<Real> f = m.template rate<mode, Friction>(t + Real(1e-22L) * last, y, m.h);
        last = f[2] + f[3];
      }
    }
  });
  if (!(last > -1e30L)) std::abort();
  return seconds / (rounds * double(states.size()));
}

int main(int count, char** arg) {
  if (count == 2 && !std::strcmp(arg[1], "bare")) {
    const Mechanism<Real> m(5e-4L);
    std::printf("{\"flight\": %.4g, \"contact\": %.4g, \"friction\": %.4g}\n", bare<Mode::Flight, false>(m),
                bare<Mode::Contact, false>(m), bare<Mode::Contact, true>(m));
    return 0;
  }
  if (count < 8 || std::strcmp(arg[1], "run")) {
    std::fputs("usage: slider_crank bare | run METHOD TOLERANCE FRICTION CLEARANCE REPEATS TIME...\n", stderr);
    return 2;
  }
  const Real tolerance = std::strtold(arg[3], nullptr), clearance = std::strtold(arg[5], nullptr);
  const bool friction = std::atoi(arg[4]) != 0;
  const int repeats = std::atoi(arg[6]);
  std::vector<Real> times;
  for (int i = 7; i < count; ++i) times.push_back(std::strtold(arg[i], nullptr));
  using Run = void (*)(Real, Real, int, const std::vector<Real>&);
  struct Method {
    const char* name;
    Run frictionless, with_friction;
  };
  const Method methods[] = {{"dopri5", run<Simulation<Dopri5, false>>, run<Simulation<Dopri5, true>>},
                            {"dop853", run<Simulation<Dop853, false>>, run<Simulation<Dop853, true>>}};
  for (const Method& method : methods) {
    if (std::strcmp(arg[2], method.name)) continue;
    (friction ? method.with_friction : method.frictionless)(tolerance, clearance, repeats, times);
    return 0;
  }
  return std::fputs("METHOD is dopri5 or dop853\n", stderr), 2;
}
