/* @name@: @summary@
 *
 * Written by `hertzwerk export`@origin@. Everything is in SI: m, kg, s, rad, N, J.
 *
 * A simulation is a struct in memory of the caller's: as large as @n@_size() says, aligned as a double. Nothing else is
 * kept, nothing is allocated: simulations in several threads are independent, and a copy of the memory is a copy of the
 * simulation, also in mid-contact.
 *
 *     double memory[...];                                      or malloc(@n@_size())
 *     @n@ *s = @n@_create(memory, sizeof memory);
 *     @n@_set_parameter(s, @n@_find(@N@_PARAMETER, "@parameter@"), ...);
 *     if (@n@_start(s, @duration@) == @N@_OK)
 *         while (@n@_time(s) < @duration@ && @n@_advance(s, @n@_time(s) + @part@, 0) >= 0)
 *             @n@_outputs(s, outputs);
 *
 * Impacts and other events are located inside @n@_advance. One call to the end gives bitwise the states of
 * `hertzwerk.simulate(..., method="@method@", tolerance=...)`, compiled by the same compiler without contraction of
 * a*b + c (-ffp-contract=off) and with the same libm; calls to times between end steps there, and agree within the tolerance.
 */
#ifndef HERTZWERK_@N@_H
#define HERTZWERK_@N@_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct @n@ @n@;

/* Lengths of the tables below. */
enum {
@counts@
};

/* Tables of names: the first argument of @n@_find, @n@_name, @n@_unit, @n@_meaning. */
enum { @N@_PARAMETER, @N@_START, @N@_STATE, @N@_OUTPUT, @N@_INPUT, @N@_PAIR };

/* What functions return: negative where the simulation cannot go on. */
enum {
    @N@_OK = 0,
    @N@_IMPACT = 1,              /* stopped after an impact, as asked */
    @N@_NOT_STARTED = -1,        /* @n@_start comes first */
    @N@_BAD_ARGUMENT = -2,       /* an index that there is not, a number that is not finite, a time before now */
    @N@_BAD_PARAMETERS = -3,     /* outside their limits, or a constant that follows from them is not finite */
    @N@_START_NOT_CLOSED = -4,   /* the loops do not close at such a start, or surfaces overlap */
    @N@_STEP_TOO_SMALL = -5,     /* no step above rounding meets the tolerance */
    @N@_NOT_FINITE = -6,         /* the equations give infinite or undefined values */
    @N@_CONSTRAINT_LOST = -7,    /* no step leads to closed loops: the mechanism locks */
    @N@_OUTSIDE_LAW_RANGE = -8,  /* a contact law was left where it is not defined */
    @N@_EVENT_LIMIT = -9,        /* more contacts and events in one call than @n@_set_limits allows */
    @N@_TOO_MANY_STEPS = -10,    /* likewise of steps */
    @N@_FRICTION_LOCKS = -11     /* friction feeds the reaction that makes it: no motion is left, or more than one */
};

/* The latest impact of a pair. Times [s], speed [m/s], force [N]; of none, count is 0. */
typedef struct {
    int count;             /* impacts of the pair so far, this one included */
    int touching;          /* whether it goes on */
    double begin, end;     /* end: of one that goes on, the time now */
    double approach_speed;
    double largest_force;  /* at the ends of steps */
} @n@_contact;

/* Bytes that a simulation takes. */
size_t @n@_size(void);

/* Make a simulation with the defaults in memory of the caller's; NULL where that is too small or not aligned. */
@n@ *@n@_create(void *memory, size_t size);

/* Index of a name in a table, -1 where it has none; name, SI unit, meaning and default of an index. */
int @n@_find(int table, const char *name);
const char *@n@_name(int table, int index);
const char *@n@_unit(int table, int index);
const char *@n@_meaning(int table, int index);
double @n@_default(int table, int index);

/* Before the start: a parameter [SI]; a coordinate or speed of a joint at the start [SI], which is kept where loops are closed. */
int @n@_set_parameter(@n@ *s, int index, double value);
int @n@_set_start(@n@ *s, int index, double value);

/* Local tolerance, in the scene's scales (default @tolerance@); at any time. */
int @n@_set_tolerance(@n@ *s, double tolerance);

/* Most steps, accepted or rejected, and most contacts and events of one call of @n@_advance. */
int @n@_set_limits(@n@ *s, double steps, double events);

/* At any time: an input is value + rate (t - now) from now on. */
int @n@_set_input(@n@ *s, int index, double value, double rate);

/* Begin the motion at t = 0. duration [s]: of the whole, a tenth of which is the longest step in contact. */
int @n@_start(@n@ *s, double duration);

/* Go on until a time [s]; with stop_at_impact, at most until the next impact begins, and return @N@_IMPACT. */
int @n@_advance(@n@ *s, double t, int stop_at_impact);

/* A parameter, start, state or input as it is now [SI]. */
double @n@_value(const @n@ *s, int table, int index);

/* Now: time [s]; states (@N@_STATES); outputs (@N@_OUTPUTS); latest impact of a pair. */
double @n@_time(const @n@ *s);
int @n@_states(const @n@ *s, double *states);
int @n@_outputs(@n@ *s, double *outputs);
int @n@_latest(const @n@ *s, int pair, @n@_contact *contact);

/* So far: accepted steps, rejected steps, evaluations of the equations. */
int @n@_counts(const @n@ *s, double *counts);

/* Largest error of the energy balance, energy moved, largest energy [J]; zeros for a scene without a ledger. */
int @n@_balance(const @n@ *s, double *balance);

/* A code in words, with what to do about it. */
const char *@n@_text(int code);

#ifdef __cplusplus
}
#endif
#endif

/* Tables: index, name, SI unit, default, meaning.
 *
@listing@
 */
