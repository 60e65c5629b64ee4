/* Functional mock-up unit of @name@ for co-simulation, FMI @fmi@: the library beside it behind the functions of the standard.
 *
 * Value references: 0 is the time; then parameters, starts, states, outputs, inputs, and the rates of the inputs.
 * The motion begins at the start time. Compile with FMI=2 or FMI=3.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "@n@.h"

#ifndef FMI
#define FMI @fmi@
#endif
#define TOKEN "@token@"
#if defined _WIN32 || defined __CYGWIN__
#define EXPORTED __declspec(dllexport)
#elif defined __GNUC__
#define EXPORTED __attribute__((visibility("default")))
#else
#define EXPORTED
#endif

enum {
    AT_PARAMETERS = 1,
    AT_STARTS = AT_PARAMETERS + @N@_PARAMETERS,
    AT_STATES = AT_STARTS + @N@_STARTS,
    AT_OUTPUTS = AT_STATES + @N@_STATES,
    AT_INPUTS = AT_OUTPUTS + @N@_OUTPUTS,
    AT_RATES = AT_INPUTS + @N@_INPUTS,
    AT_END = AT_RATES + @N@_INPUTS,
    OBSERVED = @N@_STATES + @N@_OUTPUTS
};
enum { OK = 0, DISCARD = 2, ERROR = 3 };

typedef void message(void *instance, int status, const char *category, const char *text);

/* What a state of the unit has; behind it in memory the simulation now, and as it was before the last step. */
typedef struct {
    char token[sizeof TOKEN];
    double offset, duration, stepped_to;
    double inputs[@N@_INPUTS + 1], rates[@N@_INPUTS + 1];
    int started, stepped, new_inputs;
} kept;

typedef struct {
    kept *now; /* followed by two simulations */
    void *spare;
    double *observed, *plus, *minus;
    int logs_errors, logs_events, early_return;
    char *name;
    void *environment;
    void *logger;
} unit;

static size_t size_of_simulation(void) { return (@n@_size() + 15) / 16 * 16; }
static size_t size_of_head(void) { return (sizeof(kept) + 15) / 16 * 16; }
static size_t size_of_state(void) { return size_of_head() + 2 * size_of_simulation(); }
static @n@ *simulation(const unit *m) { return (@n@ *)(void *)((char *)m->now + size_of_head()); }
static @n@ *before(const unit *m) { return (@n@ *)(void *)((char *)m->now + size_of_head() + size_of_simulation()); }
static message say;

static int fail(unit *m, int status, const char *text)
{
    if (m->logs_errors) say(m, status, "logStatusError", text);
    return status;
}

static int told(unit *m, int code)
{
    char text[400];
    if (code >= 0) return OK;
    snprintf(text, sizeof text, "t = %.9g s: %s", m->now->offset + @n@_time(simulation(m)), @n@_text(code));
    return fail(m, ERROR, text);
}

static void reset(unit *m)
{
    int i;
    memset(m->now, 0, size_of_state());
    memcpy(m->now->token, TOKEN, sizeof TOKEN);
    m->now->duration = @duration@;
    @n@_create(simulation(m), @n@_size());
    for (i = 0; i < @N@_INPUTS; ++i) m->now->inputs[i] = @n@_default(@N@_INPUT, i);
}

static void release(unit *m)
{
    if (!m) return;
    free(m->now), free(m->spare), free(m->observed), free(m->name), free(m);
}

static unit *instantiate(const char *name, const char *token, void *logger, void *environment, int logging)
{
    unit *m = calloc(1, sizeof *m);
    if (!m) return NULL;
    m->logger = logger, m->environment = environment;
    m->logs_errors = logger != NULL, m->logs_events = logger && logging;
    m->name = malloc(strlen(name ? name : "") + 1);
    m->now = malloc(size_of_state());
    m->spare = malloc(size_of_simulation());
    m->observed = calloc(3 * (OBSERVED + 1), sizeof(double));
    if (m->name) strcpy(m->name, name ? name : "");
    if (!m->name || !m->now || !m->spare || !m->observed || !token || strcmp(token, TOKEN)) {
        if (m->name) fail(m, ERROR, "no memory, or the token of another unit: the description belongs to other code");
        release(m);
        return NULL;
    }
    m->plus = m->observed + OBSERVED + 1, m->minus = m->plus + OBSERVED + 1;
    reset(m);
    return m;
}

static int set_up(unit *m, int has_tolerance, double tolerance, double start, int has_stop, double stop)
{
    if (m->now->started) return fail(m, ERROR, "the experiment is set up before the motion begins: reset the unit");
    if (has_tolerance && @n@_set_tolerance(simulation(m), tolerance)) return fail(m, ERROR, "a tolerance beyond 1e-13..0.1");
    m->now->offset = start;
    if (has_stop && !(stop > start)) return fail(m, ERROR, "a stop time that is not after the start time");
    if (has_stop) m->now->duration = stop - start;
    return OK;
}

/* Pass the inputs on, and begin the motion where it has not begun. */
static int current(unit *m)
{
    int i, code = 0;
    if (m->now->new_inputs || !m->now->started)
        for (i = 0; i < @N@_INPUTS; ++i) @n@_set_input(simulation(m), i, m->now->inputs[i], m->now->rates[i]);
    m->now->new_inputs = 0;
    if (!m->now->started) {
        code = @n@_start(simulation(m), m->now->duration);
        m->now->started = code >= 0;
    }
    return told(m, code);
}

static int observe(@n@ *s, double *values)
{
    int code = @n@_states(s, values);
    return code < 0 ? code : @n@_outputs(s, values + @N@_STATES);
}

static int get(unit *m, const unsigned *references, size_t count, double *values)
{
    int read = 0, status;
    size_t i;
    for (i = 0; i < count; ++i) {
        int at = (int)references[i];
        if (at < 0 || at >= AT_END) return fail(m, ERROR, "a value reference that there is not");
        if (at == 0) values[i] = m->now->offset + @n@_time(simulation(m));
        else if (at < AT_STARTS) values[i] = @n@_value(simulation(m), @N@_PARAMETER, at - AT_PARAMETERS);
        else if (at < AT_STATES) values[i] = @n@_value(simulation(m), @N@_START, at - AT_STARTS);
        else if (at < AT_INPUTS) {
            if (!read && (status = current(m))) return status;
            if (!read && (status = told(m, observe(simulation(m), m->observed)))) return status;
            read = 1;
            values[i] = m->observed[at - AT_STATES];
        } else if (at < AT_RATES) values[i] = m->now->inputs[at - AT_INPUTS];
        else values[i] = m->now->rates[at - AT_RATES];
    }
    return OK;
}

static int within(int at, int first, int end) { return at >= first && at < end; }

static int set(unit *m, const unsigned *references, size_t count, const double *values)
{
    size_t i;
    for (i = 0; i < count; ++i) {
        int at = (int)references[i], code = 0;
        if (within(at, AT_INPUTS, AT_END)) {
            if (values[i] - values[i] != 0) return fail(m, ERROR, "an input that is not finite");
            (at < AT_RATES ? m->now->inputs - AT_INPUTS : m->now->rates - AT_RATES)[at] = values[i];
            m->now->new_inputs = 1;
            continue;
        }
        if (!within(at, AT_PARAMETERS, AT_STATES)) return fail(m, ERROR, "a variable that cannot be set");
        if (m->now->stepped) return fail(m, ERROR, "parameters and starts are fixed once steps are done");
        m->now->started = 0;
        if (at < AT_STARTS) code = @n@_set_parameter(simulation(m), at - AT_PARAMETERS, values[i]);
        else if (@n@_value(simulation(m), @N@_START, at - AT_STARTS) != values[i]) /* as it is, it is not given */
            code = @n@_set_start(simulation(m), at - AT_STARTS, values[i]);
        if (code) return told(m, code);
    }
    return OK;
}

static int impacts(const unit *m)
{
    int i, count = 0;
    for (i = 0; i < @N@_PAIRS; ++i) {
        @n@_contact contact;
        @n@_latest(simulation(m), i, &contact);
        count += contact.count;
    }
    return count;
}

static int do_step(unit *m, double point, double length, int *is_early, double *reached)
{
    double now = m->now->offset + @n@_time(simulation(m)), end = point + length;
    int code, status = current(m), count = impacts(m);
    char text[200];
    *is_early = 0, *reached = now;
    if (status) return status;
    if (!(length > 0)) return fail(m, ERROR, "a communication step that is not positive");
    if (fabs(point - now) > 1e-6 * length) return fail(m, ERROR, "a communication point that is not where the last step ended");
    memcpy(before(m), simulation(m), @n@_size());
    m->now->stepped = 1;
    m->now->stepped_to = end - m->now->offset;
    code = @n@_advance(simulation(m), end - m->now->offset, m->early_return);
    *reached = m->now->offset + @n@_time(simulation(m));
    *is_early = code == @N@_IMPACT;
    m->now->stepped_to = @n@_time(simulation(m));
    if (code >= 0 && !*is_early) *reached = end;
    if (m->logs_events && impacts(m) > count) {
        snprintf(text, sizeof text, "t = %.9g s: %d impacts began in the last step", *reached, impacts(m) - count);
        say(m, OK, "logEvents", text);
    }
    return told(m, code);
}

/* Values at the end of the last step had the inputs been others: those of the seed, times a size. */
static int perturbed(unit *m, const unsigned *knowns, size_t count, const double *seed, double size, double *values)
{
    @n@ *s = m->spare;
    double changes[2 * @N@_INPUTS + 1] = {0};
    int i, code = 0;
    size_t k;
    memcpy(s, m->now->stepped ? before(m) : simulation(m), @n@_size());
    for (k = 0; k < count; ++k) changes[(int)knowns[k] - AT_INPUTS] += size * seed[k];
    for (i = 0; i < @N@_INPUTS; ++i)
        @n@_set_input(s, i, @n@_value(s, @N@_INPUT, i) + changes[i], m->now->rates[i] + changes[@N@_INPUTS + i]);
    @n@_set_tolerance(s, @derivative_tolerance@);
    if (m->now->stepped) code = @n@_advance(s, m->now->stepped_to, 0);
    return told(m, code < 0 ? code : observe(s, values));
}

/* Central differences of the last step, done again with steps so tight that their own changes do not show. */
static int derivative(unit *m, const unsigned *unknowns, size_t n, const unsigned *knowns, size_t count,
                      const double *seed, double *sensitivity)
{
    double size = 0, scale = 1;
    int status = current(m);
    size_t i;
    if (status) return status;
    for (i = 0; i < count; ++i) {
        if (!within((int)knowns[i], AT_INPUTS, AT_END))
            return fail(m, ERROR, "a known variable of a derivative that is no input");
        if ((int)knowns[i] < AT_RATES) scale = fmax(scale, fabs(m->now->inputs[(int)knowns[i] - AT_INPUTS]));
        size = fmax(size, fabs(seed[i]));
    }
    for (i = 0; i < n; ++i)
        if (!within((int)unknowns[i], AT_STATES, AT_INPUTS))
            return fail(m, ERROR, "an unknown variable of a derivative that is no output");
    for (i = 0; i < n; ++i) sensitivity[i] = 0;
    if (!(size > 0)) return OK;
    size = @derivative_step@ * scale / size;
    if ((status = perturbed(m, knowns, count, seed, size, m->plus))) return status;
    if ((status = perturbed(m, knowns, count, seed, -size, m->minus))) return status;
    for (i = 0; i < n; ++i) {
        int at = (int)unknowns[i] - AT_STATES;
        sensitivity[i] = (m->plus[at] - m->minus[at]) / (2 * size);
    }
    return OK;
}

static int keep(unit *m, void **state)
{
    if (!*state) *state = malloc(size_of_state());
    if (!*state) return fail(m, ERROR, "no memory for a state");
    memcpy(*state, m->now, size_of_state());
    return OK;
}

static int take_back(unit *m, const void *state)
{
    if (!state) return fail(m, ERROR, "no state");
    memcpy(m->now, state, size_of_state());
    return OK;
}

static int release_state(void **state)
{
    if (state) free(*state), *state = NULL;
    return OK;
}

static int serialize(unit *m, const void *state, void *bytes, size_t size)
{
    if (!state || size < size_of_state()) return fail(m, ERROR, "no state, or too few bytes for one");
    memcpy(bytes, state, size_of_state());
    return OK;
}

static int deserialize(unit *m, const void *bytes, size_t size, void **state)
{
    if (size != size_of_state() || memcmp(bytes, TOKEN, sizeof TOKEN)) return fail(m, ERROR, "bytes that are no state of this unit");
    if (!*state) *state = malloc(size);
    if (!*state) return fail(m, ERROR, "no memory for a state");
    memcpy(*state, bytes, size);
    return OK;
}

static int set_logging(unit *m, int on, size_t count, const char *const *categories)
{
    size_t i;
    if (!count) {
        m->logs_errors = m->logs_events = on && m->logger;
        return OK;
    }
    for (i = 0; i < count; ++i) {
        if (!strcmp(categories[i], "logStatusError")) m->logs_errors = on && m->logger;
        else if (!strcmp(categories[i], "logEvents")) m->logs_events = on && m->logger;
        else return fail(m, ERROR, "a log category that there is not");
    }
    return OK;
}

/* -- the functions of the standard; its names, types and order of arguments --------------------------------------------- */

@standard@
