// The slider-crank with clearance through SUNDIALS CVODE, called as one calls it from C: the right-hand sides of mechanism.hpp,
// one per mode, the gap as root function, restarted at every root. It runs to each TIME [s] from the start.
//
//   g++ -O3 -march=native -std=c++17 slider_crank_cvode.cpp -L CASADI -lcasadi_integrator_cvodes -lcasadi_sundials_common
//   ./a.out FORMULA SOLVER TOLERANCE FRICTION REPEATS TIME...     FORMULA: adams | bdf, SOLVER: functional | newton, FRICTION: 0 | 1
//
// Prints one JSON object in SI units. TOLERANCE is as in slider_crank.cpp: local errors in the scene's scales. The library
// is the one inside CasADi's wheel, SUNDIALS 2.6 with serial vectors and double precision. CasADi ships no headers, so what is used
// of its interface is declared here, and no dense solver, so Newton's iteration solves its four equations by GMRES with CVODE's own
// difference quotients.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "mechanism.hpp"
#include "stopwatch.hpp"

extern "C" {
typedef struct _generic_N_Vector* N_Vector;
typedef int (*CVRhsFn)(double t, N_Vector y, N_Vector rate, void* data);
typedef int (*CVRootFn)(double t, N_Vector y, double* g, void* data);
N_Vector N_VMake_Serial(long length, double* data);
double* N_VGetArrayPointer(N_Vector v);
void N_VDestroy(N_Vector v);
void* CVodeCreate(int formula, int solver);
int CVodeInit(void* memory, CVRhsFn f, double t, N_Vector y);
int CVodeReInit(void* memory, double t, N_Vector y);
int CVodeSVtolerances(void* memory, double relative, N_Vector absolute);
int CVodeSetUserData(void* memory, void* data);
int CVodeSetStopTime(void* memory, double t);
int CVodeSetMaxNumSteps(void* memory, long steps);
int CVodeRootInit(void* memory, int count, CVRootFn g);
int CVodeSetRootDirection(void* memory, int* direction);
int CVSpgmr(void* memory, int preconditioning, int krylov_dimension);
int CVode(void* memory, double t_end, N_Vector y, double* t, int task);
void CVodeFree(void** memory);
}
constexpr int ADAMS = 1, BDF = 2, FUNCTIONAL = 1, NEWTON = 2, NORMAL = 1, STOPPED = 1, ROOT = 2;  // SUNDIALS's numbers

static void check(int flag, const char* what) {
  if (flag < 0) std::fprintf(stderr, "%s returned %d\n", what, flag), std::exit(1);
}

template <bool Friction>
class Simulation {
 public:
  Simulation(const Mechanism<double>& mechanism, double tolerance, int formula, int solver) : m(mechanism) {
    scales = m.scales();
    for (double& scale : scales) scale *= tolerance;
    y = m.start();
    state = N_VMake_Serial(4, y.data()), absolute = N_VMake_Serial(4, scales.data());
    memory = CVodeCreate(formula, solver);
    check(CVodeInit(memory, rate, 0, state), "CVodeInit");
    check(CVodeSVtolerances(memory, 0, absolute), "CVodeSVtolerances");
    check(CVodeSetUserData(memory, this), "CVodeSetUserData");
    check(CVodeSetMaxNumSteps(memory, 1000000), "CVodeSetMaxNumSteps");
    check(CVodeRootInit(memory, 1, gap), "CVodeRootInit");
    if (solver == NEWTON) check(CVSpgmr(memory, 0, 4), "CVSpgmr");
    enter(Mode::Flight);
  }
  Simulation(const Simulation&) = delete;
  ~Simulation() { CVodeFree(&memory), N_VDestroy(state), N_VDestroy(absolute); }

  void advance(double t_end) {
    check(CVodeSetStopTime(memory, t_end), "CVodeSetStopTime");
    while (true) {
      const int flag = CVode(memory, t_end, state, &t, NORMAL);
      check(flag, "CVode");
      if (flag != ROOT) return;
      if (mode == Mode::Flight) {
        const double v0 = std::max(-m.template at<Friction>(mode, t, y, 0).dG, m.approach_floor);
        h_per_v0 = m.h / v0;
        impacts.push_back(t);
        enter(Mode::Contact);
      } else {
        enter(Mode::Flight);
      }
      check(CVodeReInit(memory, t, state), "CVodeReInit");
      check(CVodeSetStopTime(memory, t_end), "CVodeSetStopTime");
    }
  }

  State<double> y;
  long evaluations = 0;
  std::vector<double> impacts;

 private:
  const Mechanism<double>& m;
  State<double> scales;
  Mode mode;
  double t = 0, h_per_v0 = 0;
  N_Vector state, absolute;
  void* memory;

  void enter(Mode next) {
    mode = next;
    int direction = mode == Mode::Flight ? -1 : 1;
    check(CVodeSetRootDirection(memory, &direction), "CVodeSetRootDirection");
  }

  static State<double> read(N_Vector v) {
    State<double> values;
    std::copy_n(N_VGetArrayPointer(v), 4, values.begin());
    return values;
  }

  static int rate(double t, N_Vector y, N_Vector result, void* data) {
    Simulation& s = *static_cast<Simulation*>(data);
    const State<double> now = read(y);
    const State<double> f = s.mode == Mode::Contact ? s.m.template rate<Mode::Contact, Friction>(t, now, s.h_per_v0)
                                                    : s.m.template rate<Mode::Flight, Friction>(t, now, 0);
    std::copy(f.begin(), f.end(), N_VGetArrayPointer(result));
    ++s.evaluations;
    return 0;
  }

  static int gap(double t, N_Vector y, double* g, void* data) {
    const Mechanism<double>& m = static_cast<Simulation*>(data)->m;
    const State<double> now = read(y);
    const auto a = m.angles(t, now);
    const double ex = m.r * a.cos_phi + m.l * a.cos_theta - now[1], ey = m.r * a.sin_phi + m.l * a.sin_theta;
    *g = (m.c * m.c - ex * ex - ey * ey) * m.half_per_c;
    return 0;
  }
};

template <bool Friction>
void run(int formula, int solver, double tolerance, int repeats, const std::vector<double>& times) {
  const Mechanism<double> mechanism(5e-4);
  const double seconds = median_seconds(repeats, [&] {
    Simulation<Friction> s(mechanism, tolerance, formula, solver);
    for (const double t : times) s.advance(t);
  });
  Simulation<Friction> s(mechanism, tolerance, formula, solver);
  std::printf("{\"states\": [");
  for (std::size_t i = 0; i < times.size(); ++i) {
    s.advance(times[i]);
    std::printf("%s[%.17g, %.17g, %.17g, %.17g]", i ? ", " : "", s.y[0], s.y[1], s.y[2], s.y[3]);
  }
  std::printf("], \"impacts\": [");
  for (std::size_t i = 0; i < s.impacts.size(); ++i) std::printf("%s%.17g", i ? ", " : "", s.impacts[i]);
  std::printf("], \"evaluations\": %ld, \"seconds\": %.9g}\n", s.evaluations, seconds);
}

int main(int count, char** arg) {
  const bool bdf = count > 6 && !std::strcmp(arg[1], "bdf"), newton = count > 6 && !std::strcmp(arg[2], "newton");
  if (count < 7 || (!bdf && std::strcmp(arg[1], "adams")) || (!newton && std::strcmp(arg[2], "functional"))) {
    return std::fputs("usage: slider_crank_cvode adams|bdf functional|newton TOLERANCE FRICTION REPEATS TIME...\n", stderr), 2;
  }
  const int formula = bdf ? BDF : ADAMS, solver = newton ? NEWTON : FUNCTIONAL, repeats = std::atoi(arg[5]);
  const double tolerance = std::atof(arg[3]);
  std::vector<double> times;
  for (int i = 6; i < count; ++i) times.push_back(std::atof(arg[i]));
  std::atoi(arg[4]) ? run<true>(formula, solver, tolerance, repeats, times)
                    : run<false>(formula, solver, tolerance, repeats, times);
}
