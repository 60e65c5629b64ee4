// The slider-crank with a clearance joint between rod and slider: one right-hand side per mode, written by hand.
// Derivation, data and sign conventions: tests/reference/slider_crank.py. State: theta [rad], x [m], theta', x'.
#pragma once

#include <array>
#include <cmath>

template <class Real>
using State = std::array<Real, 4>;

enum class Mode { Flight, Contact, Released };  // Released: overlapping, but the law would pull; no force until the gap opens

// What an accepted step needs at its end: the derivative and the gap's event function G = (c^2 - e.e)/(2 c), G', G''.
template <class Real>
struct Instant {
  State<Real> rate;
  Real G, dG, ddG;
};

template <class Real>
struct Mechanism {
  Real r = 0.05L, l = 0.12L, w = 5000 * 2 * 3.14159265358979323846264338328L / 60;
  Real rod_mass = 0.21L, rod_inertia = 2.5e-4L, s = 0.06L, slider_mass = 0.14L, g = 9.81L;
  Real bush_radius = 0.01L, c = 5e-4L, E = 207e9L, nu = 0.3L, restitution = 0.9L;
  Real mu = 0.1L, friction_speed = 0.1L, approach_floor = 1e-3L;

  // Constants of the parameters, computed once.
  Real pin_radius, K, h, I, drive, weight, per_I, per_slider, per_friction_speed, rw, rww, half_per_c;

  explicit Mechanism(Real clearance) : c(clearance) {
    pin_radius = bush_radius - c;
    K = 4 * E / (6 * (1 - nu * nu)) * std::sqrt(bush_radius * pin_radius / c);  // Hertz, ball in socket
    h = 3 * (1 - restitution * restitution) / 4;                                // Lankarani & Nikravesh
    I = rod_inertia + rod_mass * s * s;                                         // about the crank pin
    per_I = 1 / I, per_slider = 1 / slider_mass, per_friction_speed = 2 / friction_speed, half_per_c = 1 / (2 * c);
    rw = r * w, rww = rw * w;
    drive = rod_mass * s * rww / I, weight = rod_mass * s * g / I;
  }

  State<Real> start() const { return {0, r + l, -rw / l, 0}; }

  State<Real> scales() const { return {c / l, c, rw / l, rw}; }

  struct Angles {
    Real sin_phi, cos_phi, sin_theta, cos_theta;
  };

  Angles angles(Real t, const State<Real>& y) const {
    const Real phi = w * t;
    return {std::sin(phi), std::cos(phi), std::sin(y[0]), std::cos(y[0])};
  }

  Real swing(const Angles& a) const {  // theta'' of the free rod on its turning pin
    return drive * (a.sin_phi * a.cos_theta - a.cos_phi * a.sin_theta) - weight * a.cos_theta;
  }

  State<Real> flight(const Angles& a, const State<Real>& y) const { return {y[2], y[3], swing(a), 0}; }

  template <bool Friction>
  State<Real> contact(const Angles& a, const State<Real>& y, Real h_per_v0) const {
    const Real ex = r * a.cos_phi + l * a.cos_theta - y[1], ey = r * a.sin_phi + l * a.sin_theta;
    const Real vx = -rw * a.sin_phi - l * y[2] * a.sin_theta - y[3], vy = rw * a.cos_phi + l * y[2] * a.cos_theta;
    const Real eps = std::sqrt(ex * ex + ey * ey), per_eps = 1 / eps;
    const Real nx = ex * per_eps, ny = ey * per_eps;
    const Real d = eps - c;
    if (!(d > 0)) return flight(a, y);
    const Real force = K * d * std::sqrt(d) * (1 + h_per_v0 * (nx * vx + ny * vy));
    Real moment = force * l * (ny * a.cos_theta - nx * a.sin_theta), push = force * nx;
    if constexpr (Friction) {
      const Real slip = nx * vy - ny * vx + pin_radius * y[2];
      const Real friction = mu * force * (1 - 2 / (std::exp(per_friction_speed * slip) + 1));  // tanh(slip/friction_speed)
      moment += friction * (l * (nx * a.cos_theta + ny * a.sin_theta) + pin_radius);
      push -= friction * ny;
    }
    return {y[2], y[3], swing(a) - per_I * moment, per_slider * push};
  }

  template <Mode mode, bool Friction>
  State<Real> rate(Real t, const State<Real>& y, Real h_per_v0) const {
    const Angles a = angles(t, y);
    if constexpr (mode == Mode::Contact) return contact<Friction>(a, y, h_per_v0);
    return flight(a, y);
  }

  template <bool Friction>
  Instant<Real> at(Mode mode, Real t, const State<Real>& y, Real h_per_v0) const {
    const Angles a = angles(t, y);
    const State<Real> f = mode == Mode::Contact ? contact<Friction>(a, y, h_per_v0) : flight(a, y);
    const Real ex = r * a.cos_phi + l * a.cos_theta - y[1], ey = r * a.sin_phi + l * a.sin_theta;
    const Real vx = -rw * a.sin_phi - l * y[2] * a.sin_theta - y[3], vy = rw * a.cos_phi + l * y[2] * a.cos_theta;
    const Real turn = y[2] * y[2];
    const Real ax = -rww * a.cos_phi - l * (f[2] * a.sin_theta + turn * a.cos_theta) - f[3];
    const Real ay = -rww * a.sin_phi + l * (f[2] * a.cos_theta - turn * a.sin_theta);
    const Real per_c = 2 * half_per_c;
    return {f, (c * c - ex * ex - ey * ey) * half_per_c, -(ex * vx + ey * vy) * per_c,
            -(ex * ax + ey * ay + vx * vx + vy * vy) * per_c};
  }

  // Duration of the elastic impact at the approach speed v0 [s]: the scale of a contact's first step.
  Real hertz_duration(Real t, const State<Real>& y, Real v0) const {
    const Angles a = angles(t, y);
    const Real ex = r * a.cos_phi + l * a.cos_theta - y[1], ey = r * a.sin_phi + l * a.sin_theta;
    const Real lever = l * (ey * a.cos_theta - ex * a.sin_theta) / c, nx = ex / c;
    const Real mass = 1 / (nx * nx * per_slider + lever * lever * per_I);
    return Real(2.9432751843L) / v0 * std::pow(5 * mass * v0 * v0 / (4 * K), Real(0.4L));
  }
};
