/* One rigid body, a sphere's surface of it against a plane, with Coulomb friction that sticks and slips: an oracle in extended precision.

State y: mass centre x (3), unit quaternion q (4), velocity v (3), angular velocity w in the body's axes (3). The sphere of radius R has
its centre at x + A o, its lowest point at rho = A o - R n from the mass centre; n is the plane's normal, the plane contains the origin:

    penetration  d = R - n.(x + A o),   its rate  d' = -n.(v + w x A o),   sliding velocity  s = (1 - n n')(v + w x rho)
    s' = b + W f,   W f = f/m + (J^-1 (rho x f)) x rho,   b = (1 - n n')(a + alpha x rho + w x (w x A o))  without friction

Sticking, f holds s' = 0 while |f| <= mu_s N; sliding, f = -mu_k N s/|s|. At the onset of slip s' = alpha e, f = -mu_k N e, so that
(alpha + mu_k N W) e = b with |e| = 1, alpha > 0: one solution, by a secular equation. Normal forces: see `elastic` and `normal_force`.

Between events the motion is smooth and is integrated by Gragg's extrapolated midpoint rule; an event is where a function of the state
vanishes at the end of a step, whose length is the unknown (regula falsi). In space the direction of sliding relaxes without bound as |s|
grows from zero: there s is a state of its own in a Radau collocation, which Newton's method solves for.

    gcc -O2 body_on_plane.c -lm           long double
    gcc -O2 -DQUAD body_on_plane.c -lquadmath -lm
    gcc -O2 -DDOUBLE body_on_plane.c -lm  double: what its rounding leaves

Standard input: a body a line, see `read_body`. Standard output: events `e TIME KIND APPROACH_SPEED`; at requested times `s` with the time, the
state and its rates; then `f` with the final state, the
final mode, the number of steps, the least |s| that was passed without rest, and 0, or what went wrong (1: too many steps, 2: step too small). */

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef QUAD
#include <quadmath.h>
typedef __float128 real;
#define sqrtl sqrtq
#define fabsl fabsq
#define powl powq
#define EPS FLT128_EPSILON
#define TOLERANCE 1e-27Q
#define REST 3e-24Q
#define COLUMNS 13
#elif defined(DOUBLE)
typedef double real;
#define EPS DBL_EPSILON
#define TOLERANCE 3e-14
#define REST 1e-12
#define COLUMNS 7
#else
typedef long double real;
#define EPS LDBL_EPSILON
#define TOLERANCE 3e-17L
#define REST 1e-15L
#define COLUMNS 9
#endif

enum { STATES = 13, STAGES = 7, FUNCTIONS = 3 };
enum { FLIGHT, STICK, SLIP, PULL, RELEASED };
enum { BEGINS, BREAKS, RESTS };
enum { ELASTIC, HYSTERESIS, SECANT, SECANT_APPROACHING, TANGENT, POWER };
static const char *KIND[] = {"opens", "sticks", "slips", "pulls", "released"};

typedef struct {
    int plane, law;
    real m, J[3], o[3], R, n[3], g[3], K, p, c, r, floor, mu_k, mu_s, t_end;
    long most, stops, stop;
    real *at; /* times at which the state is printed, rising */
    /* where it is */
    int mode, approaching;
    real v0, speed, way[3]; /* speed: of the last approach; way: direction of sliding while |s| has none; in plane motion the sign along the tangent */
    real least;
    long steps;
} Body;

/* -- vectors */
static real dot(const real *a, const real *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static void cross(const real *a, const real *b, real *c) {
    real x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
    c[0] = x, c[1] = y, c[2] = z;
}
static real size(const real *a) { return sqrtl(dot(a, a)); }
static real most(real a, real b) { return a > b ? a : b; }
static real least(real a, real b) { return a < b ? a : b; }
static void tangential(const real *n, real *a) {
    real along = dot(n, a);
    for (int i = 0; i < 3; i++) a[i] -= along * n[i];
}

/* -- geometry, forces */
typedef struct {
    real A[3][3], c[3], rho[3], w[3], d, v, s[3];
} Place;

static void place(const Body *B, const real *y, Place *P) {
    const real *q = y + 3;
    real u = 1 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]), at[3];
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        P->A[i][i] = 1 - 2 * u * (q[1 + j] * q[1 + j] + q[1 + k] * q[1 + k]);
        P->A[i][j] = 2 * u * (q[1 + i] * q[1 + j] - q[0] * q[1 + k]);
        P->A[i][k] = 2 * u * (q[1 + i] * q[1 + k] + q[0] * q[1 + j]);
    }
    for (int i = 0; i < 3; i++) {
        P->c[i] = dot(P->A[i], B->o), P->w[i] = dot(P->A[i], y + 10);
        P->rho[i] = P->c[i] - B->R * B->n[i], at[i] = y[i] + P->c[i];
    }
    P->d = B->R - dot(B->n, at);
    real rate[3];
    cross(P->w, P->c, rate);
    for (int i = 0; i < 3; i++) rate[i] += y[7 + i];
    P->v = -dot(B->n, rate);
    cross(P->w, P->rho, P->s);
    for (int i = 0; i < 3; i++) P->s[i] += y[7 + i];
    tangential(B->n, P->s);
}

/* J^-1 of a vector of the ground's axes */
static void inverse_inertia(const Body *B, const Place *P, const real *a, real *b) {
    real own[3], found[3];
    for (int i = 0; i < 3; i++) own[i] = (P->A[0][i] * a[0] + P->A[1][i] * a[1] + P->A[2][i] * a[2]) / B->J[i];
    for (int i = 0; i < 3; i++) found[i] = dot(P->A[i], own);
    memcpy(b, found, sizeof found);
}

static void mobility(const Body *B, const Place *P, const real *f, real *a) {
    real turn[3];
    cross(P->rho, f, turn);
    inverse_inertia(B, P, turn, turn);
    cross(turn, P->rho, turn);
    for (int i = 0; i < 3; i++) a[i] = f[i] / B->m + turn[i];
    tangential(B->n, a);
}

/* K d^p, whole powers continued to d < 0, so that the end of a contact is smooth */
static real powered(real d, real p) {
    if (p == 0) return 1;
    if (p == 1) return d;
    if (p == 2) return d * d;
    if (d <= 0) return 0;
    if (p == 0.5) return sqrtl(d);
    if (p == 1.5) return d * sqrtl(d);
    return powl(d, p);
}

static real resistance(const Body *B, real d, real v) {
    switch (B->law) {
    case HYSTERESIS: return B->K * powered(d, B->p) * B->c * v / B->v0;
    case SECANT_APPROACHING:
        if (!B->approaching) return 0; /* fall through */
    case SECANT: return B->c * sqrtl(most(B->m * B->K * powered(d, B->p - 1), 0)) * v;
    case TANGENT: return B->c * B->K * B->p * powered(d, B->p - 1) * v;
    case POWER: return B->c * powered(d, B->r) * v;
    }
    return 0;
}

static real normal_force(const Body *B, const Place *P) { return B->K * powered(P->d, B->p) + resistance(B, P->d, P->v); }

/* positive while a law that ends at F = 0 presses; it does not vanish with d */
static real presses(const Body *B, const Place *P) {
    real d = P->d, v = P->v;
    switch (B->law) {
    case HYSTERESIS: return 1 + B->c * v / B->v0;
    case TANGENT: return d + B->c * B->p * v;
    case POWER:
        return B->p >= B->r ? B->K * powered(d, B->p - B->r) + B->c * v : B->K + B->c * powered(d, B->r - B->p) * v;
    }
    return 1;
}

/* accelerations a and alpha (both in the ground's axes) under a force at the lowest point; no contact: N = f = 0 */
static void accelerate(const Body *B, const real *y, const Place *P, real N, const real *f, real *a, real *alpha) {
    real moment[3], push[3], L[3], gyro[3];
    for (int i = 0; i < 3; i++) push[i] = N * B->n[i] + f[i], a[i] = B->g[i] + push[i] / B->m;
    cross(P->rho, push, moment); /* the normal force has the same arm from the centre of the sphere */
    for (int i = 0; i < 3; i++) L[i] = B->J[i] * y[10 + i];
    cross(y + 10, L, gyro);
    for (int i = 0; i < 3; i++) moment[i] -= dot(P->A[i], gyro);
    inverse_inertia(B, P, moment, alpha);
}

static void drift(const Body *B, const real *y, const Place *P, real N, real *b) {
    real none[3] = {0}, a[3], alpha[3], turn[3];
    accelerate(B, y, P, N, none, a, alpha);
    cross(alpha, P->rho, b);
    cross(P->w, P->c, turn);
    cross(P->w, turn, turn);
    for (int i = 0; i < 3; i++) b[i] += a[i] + turn[i];
    tangential(B->n, b);
}

/* two tangents; in plane motion the one in the plane of motion, z x n, alone */
static int tangents(const Body *B, real t[2][3]) {
    real z[3] = {0, 0, 1}, x[3] = {1, 0, 0};
    if (B->plane) {
        cross(z, B->n, t[0]);
        return 1;
    }
    cross(fabsl(B->n[2]) < 0.7 ? z : x, B->n, t[0]);
    real l = size(t[0]);
    for (int i = 0; i < 3; i++) t[0][i] /= l;
    cross(B->n, t[0], t[1]);
    return 2;
}

/* W and b along the tangents */
static int along(const Body *B, const Place *P, const real *b, real t[2][3], real W[2][2], real *b2) {
    int n = tangents(B, t);
    for (int j = 0; j < n; j++) {
        real a[3];
        mobility(B, P, t[j], a);
        for (int i = 0; i < n; i++) W[i][j] = dot(t[i], a);
        b2[j] = dot(t[j], b);
    }
    return n;
}

/* f = -W^-1 b: what holds */
static void holding(const Body *B, const Place *P, const real *b, real *f) {
    real t[2][3], W[2][2], b2[2], x[2] = {0};
    int n = along(B, P, b, t, W, b2);
    if (n == 1)
        x[0] = -b2[0] / W[0][0];
    else {
        real det = W[0][0] * W[1][1] - W[0][1] * W[1][0];
        x[0] = -(W[1][1] * b2[0] - W[0][1] * b2[1]) / det, x[1] = -(W[0][0] * b2[1] - W[1][0] * b2[0]) / det;
    }
    for (int i = 0; i < 3; i++) f[i] = t[0][i] * x[0] + (n > 1 ? t[1][i] * x[1] : 0);
}

/* direction e in which slip begins */
static void begins(const Body *B, const Place *P, const real *b, real limit, real *e) {
    real t[2][3], W[2][2], b2[2], x[2] = {0, 0};
    int n = along(B, P, b, t, W, b2);
    if (n == 1)
        x[0] = b2[0] > 0 ? 1 : -1;
    else {
        real low = 0, high = sqrtl(b2[0] * b2[0] + b2[1] * b2[1]);
        for (int k = 0; k < 8 * (int)sizeof(real) + 20; k++) {
            real alpha = (low + high) / 2, a = alpha + limit * W[0][0], d = alpha + limit * W[1][1], c = limit * W[0][1], det = a * d - c * c;
            x[0] = (d * b2[0] - c * b2[1]) / det, x[1] = (a * b2[1] - c * b2[0]) / det;
            if (x[0] * x[0] + x[1] * x[1] > 1) low = alpha; else high = alpha;
        }
        real l = sqrtl(x[0] * x[0] + x[1] * x[1]);
        x[0] /= l, x[1] /= l;
    }
    for (int i = 0; i < 3; i++) e[i] = t[0][i] * x[0] + (n > 1 ? t[1][i] * x[1] : 0);
}

/* rates of the state under given friction, or with f = NULL that of the mode */
static void rates(const Body *B, const real *y, const real *given, real *dy) {
    Place P;
    real f[3] = {0}, a[3], alpha[3], N = 0;
    place(B, y, &P);
    if (B->mode == STICK || B->mode == SLIP || B->mode == PULL) N = normal_force(B, &P);
    if (given)
        memcpy(f, given, sizeof f);
    else if (B->mode == STICK) {
        real b[3];
        drift(B, y, &P, N, b);
        holding(B, &P, b, f);
    } else if (B->mode == SLIP) {
        real l = size(P.s), limit = -B->mu_k * N;
        for (int i = 0; i < 3; i++) f[i] = limit * (B->plane || l < REST / 100 ? B->way[i] : P.s[i] / l);
    }
    accelerate(B, y, &P, N, f, a, alpha);
    const real *q = y + 3, *w = y + 10;
    for (int i = 0; i < 3; i++) {
        dy[i] = y[7 + i], dy[7 + i] = a[i];
        dy[10 + i] = P.A[0][i] * alpha[0] + P.A[1][i] * alpha[1] + P.A[2][i] * alpha[2];
    }
    dy[3] = -dot(q + 1, w) / 2;
    cross(q + 1, w, dy + 4);
    for (int i = 0; i < 3; i++) dy[4 + i] = (dy[4 + i] + q[0] * w[i]) / 2;
}

static real scale_of(const Body *B, int i) { return i < 3 ? B->R / 10 : i < 7 ? 1 : i < 10 ? 1 : 1 / B->R; }

/* -- one step by extrapolation; the column that sufficed, 0 if none did */
static int extrapolate(const Body *B, const real *y, real h, real *out) {
    real table[COLUMNS][STATES], f0[STATES], before = 1;
    rates(B, y, NULL, f0);
    for (int k = 0; k < COLUMNS; k++) {
        int n = 2 * (k + 1);
        real step = h / n, a[STATES], b[STATES], f[STATES];
        for (int i = 0; i < STATES; i++) a[i] = 0, b[i] = step * f0[i]; /* changes, so that little is lost */
        for (int j = 1; j < n; j++) {
            real at[STATES];
            for (int i = 0; i < STATES; i++) at[i] = y[i] + b[i];
            rates(B, at, NULL, f);
            for (int i = 0; i < STATES; i++) {
                real next = a[i] + 2 * step * f[i];
                a[i] = b[i], b[i] = next;
            }
        }
        real at[STATES], error = 0;
        for (int i = 0; i < STATES; i++) at[i] = y[i] + b[i];
        rates(B, at, NULL, f);
        real fresh[STATES];
        for (int i = 0; i < STATES; i++) fresh[i] = (b[i] + a[i] + step * f[i]) / 2;
        for (int j = 0; j < k; j++) {
            real ratio = (real)(k + 1) / (k - j);
            for (int i = 0; i < STATES; i++) {
                real better = fresh[i] + (fresh[i] - table[j][i]) / (ratio * ratio - 1);
                table[j][i] = fresh[i];
                if (j == k - 1) error = most(error, fabsl(better - fresh[i]) / scale_of(B, i));
                fresh[i] = better;
            }
        }
        memcpy(table[k], fresh, sizeof fresh);
        if (k > 2 && !(error > TOLERANCE)) {
            for (int i = 0; i < STATES; i++) out[i] = y[i] + fresh[i];
            return k + 1;
        }
        if (k > 3 && error > 1e3 * before) return 0;
        before = error;
    }
    return 0;
}

/* -- one step by Radau's collocation where slip begins in space */
static real NODE[STAGES], WEIGHT[STAGES][STAGES];

static void solve(int n, real *a, real *b) { /* a (n, n) by rows */
    for (int k = 0; k < n; k++) {
        int p = k;
        for (int i = k; i < n; i++) if (fabsl(a[i * n + k]) > fabsl(a[p * n + k])) p = i;
        for (int j = 0; j < n; j++) { real x = a[k * n + j]; a[k * n + j] = a[p * n + j], a[p * n + j] = x; }
        real x = b[k]; b[k] = b[p], b[p] = x;
        for (int i = k + 1; i < n; i++) {
            real f = a[i * n + k] / a[k * n + k];
            for (int j = k; j < n; j++) a[i * n + j] -= f * a[k * n + j];
            b[i] -= f * b[k];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n; j++) b[k] -= a[k * n + j] * b[j];
        b[k] /= a[k * n + k];
    }
}

static real legendre(int n, real x) {
    real a = 1, b = x;
    if (n == 0) return a;
    for (int k = 1; k < n; k++) { real c = ((2 * k + 1) * x * b - k * a) / (k + 1); a = b, b = c; }
    return b;
}

/* nodes: zeros of P_s - P_(s-1) on (-1, 1], by bisection between sign changes */
static void prepare(void) {
    int found = 0, parts = 400;
    for (int k = 0; k < parts && found < STAGES - 1; k++) {
        real low = -1 + 2 * (real)k / parts, high = -1 + 2 * (real)(k + 1) / parts;
        real f = legendre(STAGES, low) - legendre(STAGES - 1, low), g = legendre(STAGES, high) - legendre(STAGES - 1, high);
        if (k == parts - 1 || (f < 0) == (g < 0)) continue;
        for (int j = 0; j < 8 * (int)sizeof(real); j++) {
            real x = (low + high) / 2, v = legendre(STAGES, x) - legendre(STAGES - 1, x);
            if ((v < 0) == (f < 0)) low = x; else high = x;
        }
        NODE[found++] = (1 + low) / 2;
    }
    NODE[STAGES - 1] = 1;
    for (int i = 0; i < STAGES; i++) { /* sum_j a_ij c_j^k = c_i^(k+1)/(k+1) */
        real a[STAGES * STAGES], b[STAGES], up = 1;
        for (int k = 0; k < STAGES; k++) {
            up *= NODE[i], b[k] = up / (k + 1);
            for (int j = 0; j < STAGES; j++) { real x = 1; for (int l = 0; l < k; l++) x *= NODE[j]; a[k * STAGES + j] = x; }
        }
        solve(STAGES, a, b);
        memcpy(WEIGHT[i], b, sizeof b);
    }
}

static int collocate(const Body *B, const real *y, real h, real *out) {
    enum { N2 = 2 * STAGES };
    Place P;
    real t[2][3], F[STAGES][STATES], s0[2], s[STAGES][2], e[STAGES][2], before[STATES];
    place(B, y, &P);
    tangents(B, t);
    real l = size(P.s);
    for (int k = 0; k < 2; k++) s0[k] = l > REST ? dot(t[k], P.s) : 0;
    for (int i = 0; i < STAGES; i++) {
        rates(B, y, NULL, F[i]);
        for (int k = 0; k < 2; k++) e[i][k] = l > REST ? s0[k] / l : dot(t[k], B->way), s[i][k] = s0[k];
    }
    for (int sweep = 0; sweep < 60; sweep++) {
        real b[STAGES][2], W[STAGES][2][2], limit[STAGES], change = 0;
        real Y[STAGES][STATES];
        for (int i = 0; i < STAGES; i++) {
            real d[3];
            for (int k = 0; k < STATES; k++) {
                Y[i][k] = y[k];
                for (int j = 0; j < STAGES; j++) Y[i][k] += h * WEIGHT[i][j] * F[j][k];
            }
            place(B, Y[i], &P);
            real N = normal_force(B, &P);
            drift(B, Y[i], &P, N, d);
            along(B, &P, d, t, W[i], b[i]);
            limit[i] = B->mu_k * N;
        }
        if (sweep == 0) /* the size of s under the first direction */
            for (int i = 0; i < STAGES; i++) {
                real pace = 0;
                for (int j = 0; j < STAGES; j++)
                    for (int k = 0; k < 2; k++)
                        pace += h * WEIGHT[i][j] * e[i][k] * (b[j][k] - limit[j] * (W[j][k][0] * e[j][0] + W[j][k][1] * e[j][1]));
                pace = most(pace, 1e-3 * h * limit[i] * W[i][0][0]);
                for (int k = 0; k < 2; k++) s[i][k] = s0[k] + pace * e[i][k];
            }
        for (int turn = 0; turn < 60; turn++) {
            real a[N2 * N2], x[N2], D[STAGES][2][2], off = 0;
            for (int j = 0; j < STAGES; j++) {
                real r = sqrtl(s[j][0] * s[j][0] + s[j][1] * s[j][1]);
                if (!(r > 0)) return 0;
                for (int k = 0; k < 2; k++) e[j][k] = s[j][k] / r;
                for (int k = 0; k < 2; k++) for (int m = 0; m < 2; m++) D[j][k][m] = ((k == m) - e[j][k] * e[j][m]) / r;
            }
            for (int i = 0; i < STAGES; i++)
                for (int k = 0; k < 2; k++) {
                    real *row = a + (2 * i + k) * N2;
                    x[2 * i + k] = s0[k] - s[i][k];
                    for (int j = 0; j < STAGES; j++) {
                        x[2 * i + k] += h * WEIGHT[i][j] * (b[j][k] - limit[j] * (W[j][k][0] * e[j][0] + W[j][k][1] * e[j][1]));
                        for (int m = 0; m < 2; m++)
                            row[2 * j + m] = (i == j && k == m) + h * WEIGHT[i][j] * limit[j] * (W[j][k][0] * D[j][0][m] + W[j][k][1] * D[j][1][m]);
                    }
                }
            solve(N2, a, x);
            for (int j = 0; j < STAGES; j++) {
                real r = sqrtl(s[j][0] * s[j][0] + s[j][1] * s[j][1]), part = 1;
                real ahead = (s[j][0] * (s[j][0] + x[2 * j]) + s[j][1] * (s[j][1] + x[2 * j + 1])) / r;
                if (ahead < 0.1 * r) part = 0.9 * r / (r - ahead);
                for (int k = 0; k < 2; k++) off = most(off, fabsl(part * x[2 * j + k])), s[j][k] += part * x[2 * j + k];
                if (!(off < 1e3)) return 0;
            }
            if (off < EPS) break;
        }
        for (int i = 0; i < STAGES; i++) {
            real f[3], r = sqrtl(s[i][0] * s[i][0] + s[i][1] * s[i][1]);
            for (int k = 0; k < 3; k++) f[k] = -limit[i] * (t[0][k] * s[i][0] + t[1][k] * s[i][1]) / r;
            rates(B, Y[i], f, F[i]);
        }
        for (int k = 0; k < STATES; k++) {
            out[k] = y[k];
            for (int j = 0; j < STAGES; j++) out[k] += h * WEIGHT[STAGES - 1][j] * F[j][k];
            if (sweep) change = most(change, fabsl(out[k] - before[k]) / scale_of(B, k));
            before[k] = out[k];
        }
        if (sweep && change < 20 * EPS) return 1;
    }
    return 0;
}

/* 1 if one step and two halves agree */
static int collocate_twice(const Body *B, const real *y, real h, real *out) {
    real once[STATES], half[STATES], off = 0;
    if (!collocate(B, y, h, once) || !collocate(B, y, h / 2, half) || !collocate(B, half, h / 2, out)) return 0;
    for (int i = 0; i < STATES; i++) off = most(off, fabsl(out[i] - once[i]) / scale_of(B, i));
    return off < 30 * TOLERANCE;
}

/* -- events: functions that are positive until they happen, and the mode that each leads to */
static int functions(const Body *B, const real *y, real *g, int *to) {
    Place P;
    place(B, y, &P);
    int n = 0;
    switch (B->mode) {
    case FLIGHT: g[n] = -P.d, to[n++] = SLIP; return n;
    case RELEASED:
        g[n] = P.d, to[n++] = FLIGHT;
        g[n] = -P.v, to[n++] = SLIP;
        return n;
    }
    g[n] = P.d, to[n++] = FLIGHT;
    real N = normal_force(B, &P);
    if (B->law == SECANT) {
        real F = sqrtl(most(B->K * powered(P.d, B->p - 1), 0)); /* of F/d^((p+1)/2), which does not vanish with d; p = 1: F */
        real sign = F * P.d + B->c * sqrtl(B->m) * P.v; /* goes on beyond the opening: a step may end there */
        g[n] = B->mode == PULL ? -sign : sign, to[n++] = B->mode == PULL ? SLIP : PULL;
    } else if (B->law == SECANT_APPROACHING)
        g[n] = B->approaching ? P.v : -P.v, to[n++] = STICK; /* a kink of the force, no change of mode */
    else if (B->law != ELASTIC)
        g[n] = presses(B, &P), to[n++] = RELEASED;
    if (B->mode == STICK) {
        real b[3], f[3];
        drift(B, y, &P, N, b);
        holding(B, &P, b, f);
        g[n] = B->mu_s * N - size(f), to[n++] = SLIP;
    } else if (B->mode == SLIP && B->plane)
        g[n] = dot(P.s, B->way), to[n++] = STICK;
    return n;
}

/* stick, slip or pull from the state, at an onset, where the pair breaks loose, or at rest in space */
static void decide(Body *B, real *y, int why) {
    Place P;
    real b[3], f[3];
    place(B, y, &P);
    real N = normal_force(B, &P), speed = size(P.s);
    if (B->law == SECANT && N < 0 && B->mode != PULL) { B->mode = PULL; return; } /* what ceases to pull does, but for rounding */
    N = most(N, 1e-9 * B->m); /* without force neither the direction of slip nor whether it sticks is known: as just behind the onset */
    int was = B->mode;
    B->mode = SLIP;
    if (why == BEGINS && speed > REST && !(was == SLIP && B->plane)) {
        for (int i = 0; i < 3; i++) B->way[i] = P.s[i] / speed;
        return;
    }
    drift(B, y, &P, N, b);
    holding(B, &P, b, f);
    if (why != BREAKS && size(f) <= most(B->mu_s * N, 100 * EPS * B->m)) B->mode = STICK;
    else begins(B, &P, b, B->mu_k * N, B->way);
    holding(B, &P, P.s, f); /* the impulse that takes what is left of s */
    real turn[3];
    cross(P.rho, f, turn);
    inverse_inertia(B, &P, turn, turn);
    for (int i = 0; i < 3; i++) y[7 + i] += f[i] / B->m;
    for (int i = 0; i < 3; i++) y[10 + i] += P.A[0][i] * turn[0] + P.A[1][i] * turn[1] + P.A[2][i] * turn[2];
}

static void onset(Body *B, real *y, int latch) {
    Place P;
    place(B, y, &P);
    if (latch) B->speed = P.v, B->v0 = most(P.v, B->floor);
    B->approaching = P.v >= 0;
    if (B->mode != PULL) B->mode = FLIGHT;
    decide(B, y, BEGINS);
}

/* longest step: a share of the time in which anything of the contact changes */
static real longest(const Body *B, const real *y) {
    Place P;
    place(B, y, &P);
    real turn[3], spin = size(P.w), h = 0.4 / (spin + 4);
    if (B->mode == FLIGHT || B->mode == RELEASED) return h;
    cross(P.rho, B->n, turn);
    real arm[3];
    memcpy(arm, turn, sizeof arm);
    inverse_inertia(B, &P, turn, turn);
    real free = 1 / B->m + dot(arm, turn);
    real d = most(most(P.d, 0), powl((B->p + 1) * P.v * P.v / (2 * B->K * free), 1 / (B->p + 1)));
    if (d > 0) h = least(h, 0.4 / sqrtl(B->K * B->p * powered(d, B->p - 1) * free));
    return h;
}

static int advance(const Body *B, const real *y, real h, int stiff, real *out) {
    return stiff ? collocate_twice(B, y, h, out) : extrapolate(B, y, h, out);
}

/* a step without the error's control, for events: its parts are those of an accepted step */
static void part_of(const Body *B, const real *y, real h, int stiff, real *out) {
    if (stiff ? collocate(B, y, h, out) : extrapolate(B, y, h, out)) return;
    real half[STATES];
    part_of(B, y, h / 2, stiff, half), part_of(B, half, h / 2, stiff, out);
}

static real value(const Body *B, const real *y, real h, int stiff, int which, real *out) {
    real g[FUNCTIONS];
    int to[FUNCTIONS];
    if (h == 0) memcpy(out, y, STATES * sizeof(real)); else part_of(B, y, h, stiff, out);
    functions(B, out, g, to);
    return g[which];
}

static real slope(const Body *B, const real *y, real h, int which) {
    real f[STATES], at[STATES], g[FUNCTIONS], low;
    int to[FUNCTIONS];
    rates(B, y, NULL, f);
    for (int i = 0; i < STATES; i++) at[i] = y[i] - h * f[i];
    functions(B, at, g, to), low = g[which];
    for (int i = 0; i < STATES; i++) at[i] = y[i] + h * f[i];
    functions(B, at, g, to);
    return (g[which] - low) / (2 * h);
}

/* zero of a function between 0 (positive) and h (not): Illinois, and bisection where that is slow */
static real zero(const Body *B, const real *y, real h, int stiff, int which, real start, real end) {
    real low = 0, high = h, f = start, g = end, at[STATES];
    for (int k = 0; k < 300 && high - low > 4 * EPS * h && g != 0; k++) {
        real x = k % 3 == 2 ? (low + high) / 2 : high - g * (high - low) / (g - f);
        if (!(x > low && x < high)) x = (low + high) / 2;
        real v = value(B, y, x, stiff, which, at);
        if (v > 0) { low = x, f = v; if (k % 3 != 2) g /= 2; } else { high = x, g = v; if (k % 3 != 2) f /= 2; }
    }
    return high;
}

static void print_state(const real *y) {
    for (int i = 0; i < STATES; i++) printf(" %.21Lg", (long double)y[i]);
}

static int simulate(Body *B, real *y) {
    real t = 0, h = 1e-7;
    Place P;
    place(B, y, &P);
    B->mode = FLIGHT;
    if (P.d > 0 || (P.d == 0 && P.v > 0)) {
        onset(B, y, 1);
        place(B, y, &P);
        if (B->law != SECANT && P.d > 0 && presses(B, &P) < 0) B->mode = RELEASED;
    }
    printf("e %.21Lg %s %.21Lg\n", (long double)t, B->mode == FLIGHT ? "flight" : KIND[B->mode], (long double)B->speed);
    for (B->steps = 0; B->steps < B->most; B->steps++) {
        for (; B->stop < B->stops && t >= B->at[B->stop]; B->stop++) {
            real f[STATES];
            rates(B, y, NULL, f);
            printf("s %.21Lg", (long double)B->at[B->stop]), print_state(y), print_state(f), printf("\n");
        }
        if (t >= B->t_end) return 0;
        real until = B->stop < B->stops ? least(B->at[B->stop], B->t_end) : B->t_end;
        real g0[FUNCTIONS], g1[FUNCTIONS], out[STATES], slid = 0, cut = least(h, longest(B, y));
        int to[FUNCTIONS], n = functions(B, y, g0, to), stiff = 0, last = 0;
        if (cut >= until - t) cut = until - t, last = 1;
        if (B->mode == SLIP && !B->plane) {
            real b[3], f[3], rate, N;
            place(B, y, &P);
            N = normal_force(B, &P), slid = rate = size(P.s);
            drift(B, y, &P, N, b);
            for (int i = 0; i < 3; i++) f[i] = -B->mu_k * N * (rate > REST ? P.s[i] / rate : B->way[i]);
            real a[3], along_s = 0;
            mobility(B, &P, f, a);
            for (int i = 0; i < 3; i++) along_s += (a[i] + b[i]) * (rate > REST ? P.s[i] / rate : B->way[i]);
            /* the direction relaxes quickly and |s| does not fall: a step that need not resolve it */
            if (along_s < 0 && rate > REST) cut = least(cut, 0.7 * rate / -along_s), last = 0; /* so that no step passes over rest */
            stiff = N > 0 && size(a) * cut > 2 * rate && !(along_s < 0 && rate < -10 * along_s * cut);
        }
        int column = advance(B, y, cut, stiff, out);
        if (!column) {
            h = cut * (stiff ? 0.3 : 0.4);
            if (h < 1e-6 * REST) return 2;
            continue;
        }
        /* the first event of the step */
        real when = cut;
        int which = -1;
        functions(B, out, g1, to);
        for (int i = 0; i < n; i++) {
            real end = cut, value_there = g1[i], start = g0[i];
            real tiny = 1e-16 * (to[i] == FLIGHT || B->mode == FLIGHT ? 1e-2 : 1);
            if (g1[i] > 0) {
                real s0 = slope(B, y, 1e-6 * cut, i), s1 = slope(B, out, 1e-6 * cut, i);
                if (!(s0 < 0 && s1 > 0) || (g0[i] + cut * s0 / 3 > 0 && g1[i] - cut * s1 / 3 > 0)) continue;
                real low = 0, high = cut, at[STATES];
                for (int k = 0; k < 60; k++) { /* the least value */
                    end = (low + high) / 2, value_there = value(B, y, end, stiff, i, at);
                    if (value_there < 0) break;
                    if (slope(B, at, 1e-6 * cut, i) < 0) low = end; else high = end;
                }
                if (value_there > 0) continue;
            }
            if (start <= tiny) { /* it has just happened, and goes the other way: rounding, or at once again */
                if (value_there > -tiny || start < -tiny) continue;
                when = 0, which = i;
                continue;
            }
            real x = zero(B, y, end, stiff, i, start, value_there);
            if (x < when * (which < 0 ? 1 : 1 - 1e-9)) when = x, which = i; /* what sticks lets go as N vanishes: the contact ends */
        }
        if (which < 0) {
            memcpy(y, out, sizeof out);
            t = last ? until : t + cut;
            real next = cut * (stiff ? 1.7 : column <= COLUMNS - 4 ? 2 : column <= COLUMNS - 2 ? 1.2 : 0.8);
            h = last ? most(h, next) : next;
            real l = sqrtl(y[3] * y[3] + y[4] * y[4] + y[5] * y[5] + y[6] * y[6]);
            for (int i = 3; i < 7; i++) y[i] /= l;
            if (B->mode == SLIP && !B->plane) { /* rest in space: |s| falls to nothing */
                real b[3], f[3];
                place(B, y, &P);
                real N = normal_force(B, &P), l = size(P.s), rate = 0;
                drift(B, y, &P, N, b);
                for (int i = 0; i < 3; i++) f[i] = -B->mu_k * N * P.s[i] / most(l, EPS * EPS);
                mobility(B, &P, f, f);
                for (int i = 0; i < 3; i++) rate += P.s[i] * (b[i] + f[i]);
                if (rate < 0) B->least = least(B->least, l);
                holding(B, &P, b, f);
                int passed = l < 100 * REST && l > slid && size(f) < B->mu_k * N; /* what holds does not speed up: a step went over rest */
                if (passed || (l < REST && rate < 0)) {
                    real left = passed ? 0 : l * l / -rate, F[STATES]; /* no step resolves what is left: it is a straight line */
                    rates(B, y, NULL, F);
                    for (int i = 0; i < STATES; i++) y[i] += left * F[i];
                    t += left;
                    decide(B, y, RESTS);
                    h = 1e-9;
                    if (B->mode == STICK) printf("e %.21Lg sticks %.21Lg\n", (long double)t, (long double)B->speed);
                }
            }
            continue;
        }
        if (when > 0) value(B, y, when, stiff, which, out), memcpy(y, out, sizeof out), t += when;
        int from = B->mode, target = to[which];
        h = 1e-9;
        if (from == FLIGHT)
            onset(B, y, 1);
        else if (target == FLIGHT || target == RELEASED)
            B->mode = target;
        else if (from == RELEASED || from == PULL)
            onset(B, y, 0);
        else if (target == PULL)
            B->mode = PULL;
        else if (target == STICK && B->law == SECANT_APPROACHING && which == 1)
            B->approaching = !B->approaching; /* the kink */
        else
            decide(B, y, from == STICK ? BREAKS : BEGINS);
        if (B->law == SECANT_APPROACHING && which == 1 && from != FLIGHT && from != RELEASED) continue;
        const char *kind = from == FLIGHT ? "touches" : from == RELEASED && target == SLIP ? "resumes" : KIND[B->mode];
        if (from == SLIP && B->mode == SLIP) kind = "reverses";
        printf("e %.21Lg %s %.21Lg\n", (long double)t, kind, (long double)B->speed);
        if (from == FLIGHT && B->mode == STICK) printf("e %.21Lg sticks %.21Lg\n", (long double)t, (long double)B->speed);
    }
    return 1;
}

static int number(real *x) {
    double given;
    if (scanf("%lf", &given) != 1) return 0;
    *x = given;
    return 1;
}

static int numbers(int n, real *x) {
    for (int i = 0; i < n; i++) if (!number(x + i)) return 0;
    return 1;
}

/* plane law most  perturbation  m J[3] o[3] R n[3] g[3] K p c r floor mu_k mu_s t_end  x[3] q[4] v[3] w[3]  stops times; numbers as doubles, hexadecimal too */
static int read_body(Body *B, real *y) {
    real by = 0;
    memset(B, 0, sizeof *B);
    if (scanf("%d %d %ld", &B->plane, &B->law, &B->most) != 3) return 0;
    int read = number(&by) && number(&B->m) && numbers(3, B->J) && numbers(3, B->o) && number(&B->R) && numbers(3, B->n) && numbers(3, B->g) &&
               number(&B->K) && number(&B->p) && number(&B->c) && number(&B->r) && number(&B->floor) && number(&B->mu_k) && number(&B->mu_s) &&
               number(&B->t_end) && numbers(STATES, y) && scanf("%ld", &B->stops) == 1;
    if (!read || !(B->at = malloc((B->stops + 1) * sizeof(real))) || !numbers(B->stops, B->at)) return 0;
    real l = size(B->n), turn = 0;
    for (int i = 0; i < 3; i++) B->n[i] /= l;
    for (int i = 3; i < 7; i++) turn += y[i] * y[i];
    for (int i = 3; i < 7; i++) y[i] /= sqrtl(turn);
    for (int i = 0; i < STATES; i++) y[i] *= 1 + (i % 3 - 1 ? by : -by) * (1 + i % 2); /* each by another share, with another sign */
    B->least = 1;
    return 1;
}

int main(void) {
    Body B;
    real y[STATES];
    prepare();
    while (read_body(&B, y)) {
        int wrong = simulate(&B, y);
        printf("f"), print_state(y);
        printf(" %d %ld %.3Lg %d\n", B.mode, B.steps, (long double)B.least, wrong);
        fflush(stdout), free(B.at);
    }
    return 0;
}
