// Contact regularised (DESIGN section 6): carried are s = sqrt(d) and t, the independent variable is sigma with dt = s dsigma, so that
// ds/dsigma = d'/2 and the force K s^3 (...) is analytic from the onset, s = 0, to the separation, s = 0. Flight is as it was.
//
// Three things make it work. The error is measured at fixed time: an error along the trajectory, (dy, dt) parallel to (y', 1), is none,
// and counting it costs half as many steps again. The last step has s itself for its variable, so that it lands on s = 0 without a search.
// The distance of the centres is c + s^2, which spares a root in the longest chain of the evaluation.
#pragma once

template <bool Friction>
class Regularised : public Simulation<Dop853, Friction> {
  using Table = Dop853;
  using Base = Simulation<Dop853, Friction>;
  using Long = std::array<Real, 6>;  // theta, x, theta', x', s, t

 public:
  using Base::Base;

  void advance(Real t_end) {
    while (this->t < t_end) {
      if (this->is(Mode::Contact)) {
        cross(t_end);
      } else {
        this->attempt(t_end);
        if (this->is(Mode::Contact)) touch();
      }
    }
  }

 private:
  enum Variable { Sigma = -1, S = 4, T = 5 };  // of a step: the latter two are components

  static constexpr Real FIRST = 0.8L, SAFETY = 0.8L, GROW = 1.6L;  // tried: 0.6 to 1.5, 0.7 to 0.9, 1.5 to 3
  static constexpr Real S_WEIGHT = 0.3L;                           // of the error of d = s^2 beside that of the positions
  Long Y, rate, k[Table::stages];
  Real step_memory = 0;
  bool fresh = false;

  // dY/dsigma; `f` is dy/dt, which has no 0/0 where s is zero.
  Long slope(const Long& at, State<Real>& f) {
    ++this->evaluations, ++this->contact_evaluations;
    const Mechanism<Real>& m = this->m;
    const auto a = m.angles(at[5], {at[0]});
    const Real s = at[4], per_eps = 1 / (m.c + s * s);
    const Real nx = (m.r * a.cos_phi + m.l * a.cos_theta - at[1]) * per_eps, ny = (m.r * a.sin_phi + m.l * a.sin_theta) * per_eps;
    const Real vx = -m.rw * a.sin_phi - m.l * at[2] * a.sin_theta - at[3], vy = m.rw * a.cos_phi + m.l * at[2] * a.cos_theta;
    const Real d_rate = nx * vx + ny * vy;
    const Real force = m.K * s * s * s * (1 + this->h_per_v0 * d_rate);
    Real moment = force * m.l * (ny * a.cos_theta - nx * a.sin_theta), push = force * nx;
    if constexpr (Friction) {
      const Real slip = nx * vy - ny * vx + m.pin_radius * at[2];
      const Real friction = m.mu * force * (1 - 2 / (std::exp(m.per_friction_speed * slip) + 1));
      moment += friction * (m.l * (nx * a.cos_theta + ny * a.sin_theta) + m.pin_radius);
      push -= friction * ny;
    }
    f = {at[2], at[3], m.swing(a) - m.per_I * moment, m.per_slider * push};
    return {s * f[0], s * f[1], s * f[2], s * f[3], d_rate / 2, s};
  }

  template <Variable variable>
  static Long over(Long f) {
    if constexpr (variable != Sigma) {
      const Real per = 1 / f[variable];
      for (Real& x : f) x *= per;
    }
    return f;
  }

  template <Variable variable, std::size_t... row>
  Long stages(Real h, std::index_sequence<row...>) {
    State<Real> f;
    k[0] = over<variable>(rate);
    ((k[row + 1] = over<variable>(slope(combine<Table, row + 1>(Y, h, k, std::make_index_sequence<row + 1>{}), f))), ...);
    return combine<Table, Table::stages>(Y, h, k, std::make_index_sequence<Table::stages>{});
  }

  Real error(Real h, const Long& end, const Long& end_rate, const State<Real>& f) const {
    Long e{}, e3{};
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < Table::stages; ++j) {
        e[i] += Real(Table::error[j]) * k[j][i];
        e3[i] += Real(Table::a[Table::stages][j] - Table::third[j]) * k[j][i];
      }
    }
    const Real two_s = 2 * std::max(Y[4], end[4]);
    const auto square = [&](const Long& e) {
      const Real depth = (two_s * e[4] - 2 * end_rate[4] * e[5]) * this->weight[1] * S_WEIGHT;
      Real sum = depth * depth;
      for (int i = 0; i < 4; ++i) {
        const Real part = (e[i] - f[i] * e[5]) * this->weight[i];
        sum += part * part;
      }
      return sum;
    };
    const Real fifth = square(e), both = fifth + square(e3) / 100;
    return both > 0 ? std::abs(h) * fifth / std::sqrt(4 * both) : 0;
  }

  static Real factor(Real err, Real most) {
    return std::min(most, std::max(Real(0.2L), SAFETY * std::pow(std::max(err, Real(1e-10L)), Real(-1 / 8.0L))));
  }

  void touch() {
    const Real v0 = std::max(-this->now.dG, this->m.approach_floor);
    Y = {this->y[0], this->y[1], this->y[2], this->y[3], 0, this->t};
    rate = {0, 0, 0, 0, v0 / 2, 0};
    const Real duration = this->m.hertz_duration(this->t, this->y, v0);
    step_memory = FIRST * std::pow(this->accuracy, Real(1 / 8.0L)) * std::sqrt(Real(2.9432751843L) * duration / v0);
    fresh = true;
  }

  // One step of a contact: towards t_end, or onto s = 0.
  void cross(Real t_end) {
    const auto rows = std::make_index_sequence<Table::stages - 1>{};
    const Real h = step_memory, rise = std::max(Real(0), h * rate[4]);
    const bool leaves = !fresh && rate[4] < 0 && Y[4] + h * rate[4] <= 0;
    const bool arrives = !fresh && !leaves && Y[5] + Real(1.2L) * h * (Y[4] + rise) >= t_end;
    const Real taken = leaves ? -Y[4] : arrives ? t_end - Y[5] : h;
    const Long end = leaves ? stages<S>(taken, rows) : arrives ? stages<T>(taken, rows) : stages<Sigma>(taken, rows);
    State<Real> f;
    const Long end_rate = slope(end, f);
    const Real err = error(taken, end, end_rate, f);
    const bool beyond = !leaves && (end[4] <= 0 || (!arrives && end[5] > t_end));
    if (!(err <= 1) || beyond) {
      ++this->rejected;
      const Real tried = leaves ? std::min(h, -Y[4] / rate[4]) : arrives ? std::min(h, taken / Y[4]) : h;
      step_memory = tried * (err <= 1 ? Real(0.5L) : factor(err, 1));
      return;
    }
    ++this->steps;
    if (!leaves && !arrives) step_memory = h * factor(err, GROW);
    fresh = false;
    Y = end, rate = end_rate;
    this->y = {Y[0], Y[1], Y[2], Y[3]};
    this->t = arrives ? t_end : Y[5];
    if (leaves) separate();
  }

  // s^2 and the penetration drift apart by local errors: the end is put back on the surface, by the shortest way.
  void separate() {
    const Mechanism<Real>& m = this->m;
    this->change(Mode::Flight);
    for (int n = 0; n < 3 && std::abs(this->now.G) > this->landing; ++n) {
      const auto a = m.angles(this->t, this->y);
      const Real ex = m.r * a.cos_phi + m.l * a.cos_theta - this->y[1], ey = m.r * a.sin_phi + m.l * a.sin_theta;
      const Real along = (ex * a.sin_theta - ey * a.cos_theta) / m.c, across = ex / m.c;  // of G to l theta and to x
      const Real part = this->now.G / (along * along + across * across);
      this->y[0] -= part * along / m.l, this->y[1] -= part * across;
      this->now = m.template at<Friction>(Mode::Flight, this->t, this->y, this->h_per_v0);
      ++this->evaluations;
    }
    this->on_surface = true;
    if (this->now.dG <= 0) this->change(Mode::Contact), touch();
  }
};
