// First root of the quintic that meets a function's value, rate and second rate at both ends of a step.
#pragma once

#include <array>

// p is positive inside the mode; the quintic's Bernstein coefficients bound it. `on_surface`: p(0) = 0 up to the landing
// tolerance and p leaves it, so the root at 0 is no event and is divided out.
// Returns the first theta in (0, 1] at which p falls through zero, or 2.
template <class Real>
Real first_fall(Real p0, Real dp0, Real ddp0, Real p1, Real dp1, Real ddp1, Real h, bool on_surface) {
  std::array<Real, 6> b = {p0,
                           p0 + h * dp0 / 5,
                           p0 + 2 * h * dp0 / 5 + h * h * ddp0 / 20,
                           p1 - 2 * h * dp1 / 5 + h * h * ddp1 / 20,
                           p1 - h * dp1 / 5,
                           p1};
  int n = 5;
  if (on_surface) {
    for (int i = 0; i < 5; ++i) b[i] = b[i + 1] * 5 / (i + 1);
    n = 4;
  }
  const auto value = [&](Real theta) {  // de Casteljau
    std::array<Real, 6> v = b;
    for (int k = n; k > 0; --k)
      for (int i = 0; i < k; ++i) v[i] += theta * (v[i + 1] - v[i]);
    return v[0];
  };
  bool positive = true;
  for (int i = 0; i <= n; ++i) positive = positive && b[i] > 0;
  if (positive) return 2;
  constexpr int parts = 16;  // only steps that may hold an event come here
  Real left = 0, p_left = b[0];
  for (int part = 1; part <= parts; ++part) {
    Real right = Real(part) / parts, p_right = value(right);
    if (p_right <= 0) {
      if (p_left <= 0) return right;
      for (int i = 0; i < 60 && right - left > Real(1e-12L); ++i) {  // Illinois
        Real theta = right - p_right * (right - left) / (p_right - p_left);
        const Real p = value(theta);
        if (p <= 0) {
          if (right - theta < Real(1e-12L)) return theta;
          right = theta, p_right = p, p_left /= 2;
        } else {
          if (theta - left < Real(1e-12L)) return theta;
          left = theta, p_left = p, p_right /= 2;
        }
      }
      return right;
    }
    left = right, p_left = p_right;
  }
  return 2;
}
