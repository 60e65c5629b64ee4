
/* -- the driver: what hertzwerk's loop does beside the functions above ------------------------------------------------ */

struct @n@ {
    double parameters[ROOM(N_PARAMETERS)], starts[ROOM(N_STARTS)], pieces[ROOM(N_PIECES)];
    double duration, tolerance, max_steps, max_events;
    double controls[N_CONTROLS], state[N_STATE], next[N_STATE], tally[ROOM(N_TALLY)];
    @n@_contact contacts[ROOM(N_PAIRS)];
    int is_given[ROOM(N_STARTS)];
    int changed, outcome, moved, new_inputs, choosing;
    double matrix[ROOM(N_ROWS * N_UNKNOWNS)], triangle[ROOM(N_UNKNOWNS * N_UNKNOWNS)];
    double phi[ROOM(N_LOOPS)], rate[ROOM(N_LOOPS)], by_q[ROOM(N_LOOPS * N_Q)], by_u[ROOM(N_LOOPS * N_U)];
    double residual[ROOM(N_ROWS)], sizes[ROOM(N_ROWS)], step[ROOM(N_UNKNOWNS)], scales[N_Q + N_U + 1];
    int column[ROOM(N_UNKNOWNS)];
    casadi_int iw[ROOM(SIZE_IW)];
    double w[ROOM(SIZE_W)];
};

typedef int function(const casadi_real **arg, casadi_real **res, casadi_int *iw, casadi_real *w, int mem);

static int call(@n@ *s, function *f, int inputs, const double *const *given, int results, double *const *found)
{
    const double *arg[SIZE_ARG];
    double *res[SIZE_RES];
    int i;
    for (i = 0; i < SIZE_ARG; ++i) arg[i] = i < inputs ? given[i] : NULL;
    for (i = 0; i < SIZE_RES; ++i) res[i] = i < results ? found[i] : NULL;
    return f(arg, res, s->iw, s->w, 0);
}

static int is_number(double x) { return x - x == 0; }

size_t @n@_size(void) { return sizeof(@n@); }

@n@ *@n@_create(void *memory, size_t size)
{
    @n@ *s = memory;
    int i;
    if (!memory || size < sizeof *s || (size_t)memory % sizeof(double)) return NULL;
    memset(s, 0, sizeof *s);
    for (i = 0; i < N_PARAMETERS; ++i) s->parameters[i] = parameter_rows[i].value;
    for (i = 0; i < N_STARTS; ++i) {
        s->starts[i] = start_rows[i].value;
        s->is_given[i] = was_given[i];
    }
    for (i = 0; i < N_INPUTS; ++i) s->pieces[WIDTH * i + 1] = input_rows[i].value;
    s->tolerance = TOLERANCE;
    s->max_steps = MAX_STEPS;
    s->max_events = MAX_EVENTS;
    s->outcome = @N@_NOT_STARTED;
    return s;
}

static const row *row_of(int table, int index)
{
    if (table < 0 || table > @N@_PAIR || index < 0 || index >= tables[table].count) return NULL;
    return tables[table].rows + index;
}

int @n@_find(int table, const char *name)
{
    int i;
    if (table < 0 || table > @N@_PAIR || !name) return -1;
    for (i = 0; i < tables[table].count; ++i)
        if (!strcmp(tables[table].rows[i].name, name)) return i;
    return -1;
}

const char *@n@_name(int table, int index)
{
    const row *found = row_of(table, index);
    return found ? found->name : NULL;
}

const char *@n@_unit(int table, int index)
{
    const row *found = row_of(table, index);
    return found ? found->unit : NULL;
}

const char *@n@_meaning(int table, int index)
{
    const row *found = row_of(table, index);
    return found ? found->meaning : NULL;
}

double @n@_default(int table, int index)
{
    const row *found = row_of(table, index);
    return found ? found->value : 0;
}

int @n@_set_parameter(@n@ *s, int index, double value)
{
    if (!row_of(@N@_PARAMETER, index) || !is_number(value)) return @N@_BAD_ARGUMENT;
    if (s->parameters[index] != value) s->changed = 1;
    s->parameters[index] = value;
    return @N@_OK;
}

int @n@_set_start(@n@ *s, int index, double value)
{
    if (!row_of(@N@_START, index) || !is_number(value)) return @N@_BAD_ARGUMENT;
    s->changed = 1;
    s->starts[index] = value;
    s->is_given[index] = 1;
    return @N@_OK;
}

int @n@_set_tolerance(@n@ *s, double tolerance)
{
    if (!(tolerance >= LEAST_TOLERANCE && tolerance <= 0.1)) return @N@_BAD_ARGUMENT;
    s->tolerance = s->controls[AT_TOLERANCE] = tolerance;
    return @N@_OK;
}

int @n@_set_limits(@n@ *s, double steps, double events)
{
    if (!(steps >= 1 && events >= 1)) return @N@_BAD_ARGUMENT;
    s->max_steps = steps;
    s->max_events = events;
    return @N@_OK;
}

int @n@_set_input(@n@ *s, int index, double value, double rate)
{
    double *piece;
    double now = s->outcome == @N@_NOT_STARTED ? 0 : s->state[AT_T];
    if (!row_of(@N@_INPUT, index) || !is_number(value) || !is_number(rate)) return @N@_BAD_ARGUMENT;
    piece = s->pieces + WIDTH * index;
    if (piece[1] != value || piece[2] != rate || (rate != 0 && piece[0] != now)) {
        piece[0] = now;
        piece[1] = value;
        piece[2] = rate;
        s->new_inputs = 1;
    }
    return @N@_OK;
}

/* -- start -- */

static int within_limits(const double *p)
{
    int i;
    for (i = 0; i < N_LIMITS; ++i) {
        double x = p[limits[i].parameter];
        if (!(limits[i].is_open & 1 ? x > limits[i].lower : x >= limits[i].lower)) return 0;
        if (!(limits[i].is_open & 2 ? x < limits[i].upper : x <= limits[i].upper)) return 0;
    }
    return 1;
}

/* Solve matrix x = residual in the least squares sense, columns by their size; return the rank. */
static int solve(@n@ *s, int rows, int columns, double *x)
{
    double largest = 0;
    int i, j, k, rank = columns;
    for (j = 0; j < columns; ++j) s->column[j] = j;
    for (k = 0; k < columns; ++k) {
        double best = -1, norm;
        int at = k;
        for (j = k; j < columns; ++j) {
            const double *a = s->matrix + rows * s->column[j];
            for (norm = 0, i = 0; i < rows; ++i) norm += a[i] * a[i];
            if (norm > best) best = norm, at = j;
        }
        norm = sqrt(best);
        if (!k) largest = norm;
        if (!(norm > RANK * largest)) {
            rank = k;
            break;
        }
        j = s->column[k], s->column[k] = s->column[at], s->column[at] = j;
        for (j = 0; j < k; ++j) { /* what was computed moves with its column */
            double moved = s->triangle[j * columns + k];
            s->triangle[j * columns + k] = s->triangle[j * columns + at];
            s->triangle[j * columns + at] = moved;
        }
        {
            double *q = s->matrix + rows * s->column[k], along;
            for (i = 0; i < rows; ++i) q[i] /= norm;
            s->triangle[k * columns + k] = norm;
            for (j = k + 1; j < columns; ++j) {
                double *a = s->matrix + rows * s->column[j];
                for (along = 0, i = 0; i < rows; ++i) along += q[i] * a[i];
                for (i = 0; i < rows; ++i) a[i] -= along * q[i];
                s->triangle[k * columns + j] = along;
            }
            for (along = 0, i = 0; i < rows; ++i) along += q[i] * s->residual[i];
            for (i = 0; i < rows; ++i) s->residual[i] -= along * q[i];
            x[s->column[k]] = along;
        }
    }
    for (k = rank; k < columns; ++k) x[s->column[k]] = 0;
    for (k = rank - 1; k >= 0; --k) {
        double value = x[s->column[k]];
        for (j = k + 1; j < rank; ++j) value -= s->triangle[k * columns + j] * x[s->column[j]];
        x[s->column[k]] = value / s->triangle[k * columns + k];
    }
    return rank;
}

static void evaluate_loops(@n@ *s, const double *q, const double *u)
{
    double t = 0;
    const double *given[4];
    double *found[4];
    given[0] = &t, given[1] = q, given[2] = u, given[3] = s->controls;
    found[0] = s->phi, found[1] = s->rate, found[2] = s->by_q, found[3] = s->by_u;
    call(s, loops, 4, given, 4, found);
}

/* Find what counts as closed of each constraint, as `runtime/engine/start/assembly.py` does; return whether all are. */
static int is_closed(@n@ *s, int rows, const double *jacobian, int columns, const double *values, const double *least,
                     const double *value)
{
    double largest[2] = {1e-9, 1e-9};
    int i, j, closed = 1;
    for (i = 0; i < rows; ++i)
        for (j = 0; j < columns; ++j) {
            double size = fmax(fabs(values[j]), least ? least[j] : 0);
            size = fabs(jacobian[i + N_LOOPS * j]) * fmax(size, 1);
            if (size > largest[loop_is_length[i]]) largest[loop_is_length[i]] = size;
        }
    for (i = 0; i < rows; ++i) {
        s->sizes[i] = CLOSED * largest[loop_is_length[i]];
        if (!(fabs(value[i]) <= s->sizes[i])) closed = 0;
    }
    return closed;
}

/* Move what is not given so that `rows` constraints hold: coordinates by Gauss-Newton steps, or speeds by one. */
static int close_loops(@n@ *s, int rows, int of_speeds, double *q, double *u)
{
    int n = of_speeds ? N_U : N_Q, first = of_speeds ? N_Q : 0, round, i, j, k, columns, moving, rank;
    double *x = of_speeds ? u : q, *jacobian = of_speeds ? s->by_u : s->by_q, *value = of_speeds ? s->rate : s->phi;
    for (round = 0; round < ITERATIONS; ++round) {
        evaluate_loops(s, q, u);
        if (is_closed(s, rows, jacobian, n, x, of_speeds ? s->scales + N_Q : NULL, value)) return 1;
        if (of_speeds && round == 2) return 0;
        k = rows + (of_speeds ? 0 : N_QUATERNIONS);
        for (columns = moving = 0, j = 0; j < n; ++j)
            if (!s->is_given[first + j] && !is_stated[first + j]) {
                double *a = s->matrix + k * columns++, scale = s->scales[first + j], reach = 0;
                for (i = 0; i < rows; ++i) {
                    a[i] = jacobian[i + N_LOOPS * j] * scale / s->sizes[i];
                    reach = fmax(reach, fabs(a[i]));
                }
                for (i = rows; i < k; ++i) {
                    int at = quaternions[i - rows];
                    a[i] = j >= at && j < at + 4 ? q[j] * scale / CLOSED : 0;
                }
                moving += reach > 0;
            }
        for (i = 0; i < k; ++i) s->residual[i] = i < rows ? -value[i] / s->sizes[i] : 0;
        rank = solve(s, k, columns, s->step);
        if (rank < moving) return 0; /* more is to be said of the start */
        for (columns = 0, j = 0; j < n; ++j)
            if (!s->is_given[first + j] && !is_stated[first + j]) x[j] += s->scales[first + j] * s->step[columns++];
        for (i = 0; i < N_QUATERNIONS && !of_speeds; ++i) {
            double *part = q + quaternions[i];
            double norm = sqrt(part[0] * part[0] + part[1] * part[1] + part[2] * part[2] + part[3] * part[3]);
            for (j = 0; j < 4; ++j) part[j] /= norm;
        }
    }
    return 0;
}

/* The start of the joints under the parameters, with loops closed and journals centred. */
static int find_start(@n@ *s, double *q, double *u)
{
    const double *given[1];
    double *found[2], kept[N_Q + N_U + 1];
    int i, j, n = N_Q + N_U;
    if (!CAN_ASSEMBLE) return 0;
    given[0] = s->parameters, found[0] = kept, found[1] = kept + N_Q;
    call(s, start, 1, given, 2, found);
    for (i = 0; i < n; ++i) { /* what neither the scene nor the caller says begins where it was closed */
        if (s->is_given[i] || (N_LOOPS && !is_stated[i])) kept[i] = s->starts[i];
        if (!is_number(kept[i])) return 0;
    }
    memcpy(q, kept, sizeof(double) * N_Q);
    memcpy(u, kept + N_Q, sizeof(double) * N_U);
    for (i = 0; i < N_QUATERNIONS; ++i) {
        double *part = q + quaternions[i];
        double norm = sqrt(part[0] * part[0] + part[1] * part[1] + part[2] * part[2] + part[3] * part[3]);
        if (!(norm > 0)) return 0;
        for (j = 0; j < 4; ++j) part[j] /= norm;
    }
    if (!N_LOOPS) return 1;
    if (!close_loops(s, N_LOOPS, 0, q, u)) { /* pins need not be in the middle of their bushes */
        memcpy(q, kept, sizeof(double) * N_Q);
        if (N_CLOSED == N_LOOPS || !close_loops(s, N_CLOSED, 0, q, u)) return 0;
    }
    memcpy(u, kept + N_Q, sizeof(double) * N_U);
    if (close_loops(s, N_LOOPS, 1, q, u)) return 1;
    memcpy(u, kept + N_Q, sizeof(double) * N_U);
    return N_CLOSED < N_LOOPS && close_loops(s, N_CLOSED, 1, q, u);
}

static void note_contacts(@n@ *s, int first)
{
    int j;
    for (j = 0; j < N_PAIRS; ++j) {
        @n@_contact *contact = s->contacts + j;
        double mode = s->state[AT_MODE + j], force = s->state[AT_FORCE + j], speed = -s->state[AT_GAP_RATE + j];
        if (mode == CONTACT && !contact->touching) {
            contact->count++;
            contact->begin = s->state[AT_T];
            contact->approach_speed = speed > 0 ? speed : 0;
            contact->largest_force = 0;
        }
        if (contact->touching || mode == CONTACT) {
            contact->end = s->state[AT_T];
            if (force > contact->largest_force) contact->largest_force = force;
        }
        if (first || mode != RELEASED) contact->touching = mode == CONTACT;
    }
}

static int begins(const @n@ *s, double *const modes)
{
    int j, found = 0;
    for (j = 0; j < N_PAIRS; ++j) {
        found |= s->contacts[j].count != (int)modes[j];
        modes[j] = s->contacts[j].count;
    }
    return found;
}

static int begin_motion(@n@ *s, double t_end)
{
    double t = 0, latches[ROOM(N_LATCHES)] = {0}, q[ROOM(N_Q_ALL)], u[ROOM(N_U_ALL)];
    const double *given[5];
    double *found[2];
    s->controls[AT_T_END] = t_end;
    memcpy(s->controls + N_C - N_PIECES, s->pieces, sizeof(double) * N_PIECES);
    given[0] = &t, given[1] = s->starts, given[2] = s->starts + N_Q, given[3] = s->controls;
    if (IS_PLACED) {
        found[0] = q, found[1] = u;
        call(s, placed, 4, given, 2, found);
        given[1] = q, given[2] = u;
    }
    given[3] = latches, given[4] = s->controls, found[0] = s->state;
    return call(s, begin, 5, given, 1, found);
}

int @n@_start(@n@ *s, double duration)
{
    double q[ROOM(N_Q)], u[ROOM(N_U)], stated[N_Y + 4];
    const double *given[2];
    double *found[4];
    int i;
    s->outcome = @N@_NOT_STARTED;
    if (!(duration > 0) || !is_number(duration)) return @N@_BAD_ARGUMENT;
    if (!within_limits(s->parameters)) return @N@_BAD_PARAMETERS;
    memset(s->controls, 0, sizeof s->controls);
    memset(s->contacts, 0, sizeof s->contacts);
    given[0] = s->parameters, found[0] = s->controls;
    call(s, constants, 1, given, 1, found);
    for (i = 0; i < N_C - N_PIECES; ++i)
        if (!is_number(s->controls[i])) return @N@_BAD_PARAMETERS;
    found[0] = stated, found[1] = stated + N_Q_ALL, found[2] = found[1] + N_U_ALL, found[3] = stated + N_Y;
    call(s, scales_of, 1, given, 4, found);
    for (i = 0; i < N_Y + 4; ++i) /* where the scene states none, those of the run that the export made */
        s->controls[AT_SCALE + i] = stated[i] > 0 && is_number(stated[i]) ? stated[i] : fallback_scales[i];
    if (N_SPEED_LIMITS) {
        for (i = 0; i < N_SPEED_LIMITS; ++i) s->controls[AT_SPEED_LIMITS + i] = HUGE_VAL;
    }
    if (s->changed) {
        found[0] = s->scales, found[1] = s->scales + N_Q, found[2] = NULL, found[3] = NULL;
        call(s, joint_scales, 1, given, 4, found);
        if (!find_start(s, q, u)) return @N@_START_NOT_CLOSED;
        memcpy(s->starts, q, sizeof(double) * N_Q);
        memcpy(s->starts + N_Q, u, sizeof(double) * N_U);
    }
    s->duration = duration;
    s->controls[AT_TOLERANCE] = s->tolerance;
    s->controls[AT_H_MAX] = duration / LEAST_STEPS;
    s->controls[AT_FLOOR] = FLOOR_PARAMETER < 0 ? APPROACH_FLOOR : s->parameters[ROOM(FLOOR_PARAMETER + 1) - 1];
    s->controls[AT_MAX_EVENTS] = s->max_events;
    s->controls[AT_MAX_STEPS] = s->max_steps;
    for (i = 0; i < N_INPUTS; ++i) s->pieces[WIDTH * i] = 0;
    if (begin_motion(s, duration)) return @N@_NOT_FINITE;
    for (i = 0; i < N_PAIRS && s->changed; ++i) /* what the caller changed may press surfaces into each other */
        if (s->state[AT_GAP + i] < -DEEP * s->controls[AT_SCENE]) return @N@_START_NOT_CLOSED;
    s->moved = s->new_inputs = s->choosing = 0;
    note_contacts(s, 1);
    if (N_TALLY) {
        given[0] = s->state, given[1] = s->controls, found[0] = s->tally;
        call(s, tallied, 2, given, 1, found);
    }
    s->outcome = s->state[AT_STATUS] == NOT_FINITE          ? @N@_NOT_FINITE
                 : s->state[AT_STATUS] == OUTSIDE_LAW_RANGE ? @N@_OUTSIDE_LAW_RANGE
                                                            : @N@_OK;
    return s->outcome;
}

/* -- motion -- */

static int locks(@n@ *s)
{
    const double *given[2];
    double *found[1], least = 1;
    if (!HAS_MARGINS) return 0;
    given[0] = s->state, given[1] = s->controls, found[0] = &least;
    return !call(s, least_margin, 2, given, 1, found) && least <= CLOSE;
}

static int ended(@n@ *s, int status)
{
    static const int outcomes[] = {@N@_OK,         @N@_OK,
                                   @N@_STEP_TOO_SMALL, @N@_NOT_FINITE,
                                   @N@_CONSTRAINT_LOST, @N@_OUTSIDE_LAW_RANGE,
                                   @N@_EVENT_LIMIT, @N@_TOO_MANY_STEPS};
    s->outcome = outcomes[status];
    if ((status == STEP_TOO_SMALL || status == NOT_FINITE || status == OUTSIDE_LAW_RANGE) && locks(s))
        s->outcome = @N@_FRICTION_LOCKS;
    return s->outcome;
}

static double in_vain(const @n@ *s) { return s->state[AT_REJECTED] + s->state[AT_RETAKEN]; }

/* Go on from a state where steps ended, or under other inputs: what depends on them is evaluated anew. */
static int go_on(@n@ *s, double t_end)
{
    const double *given[2];
    double *found[1];
    int failed;
    s->controls[AT_T_END] = t_end;
    s->state[AT_STATUS] = RUNNING;
    memcpy(s->state + AT_PIECES, s->pieces, sizeof(double) * N_PIECES);
    if (N_INPUTS) s->state[AT_STOP] = t_end;
    given[0] = s->state, given[1] = s->controls, found[0] = s->next;
    failed = call(s, enter, 2, given, 1, found);
    memcpy(s->state, s->next, sizeof s->state);
    note_contacts(s, 0);
    return failed;
}

int @n@_advance(@n@ *s, double t, int stop_at_impact)
{
    const double *given[3];
    double *found[2], counts[ROOM(N_PAIRS)] = {0}, vain;
    int status;
    if (s->outcome < 0) return s->outcome;
    if (!is_number(t) || t < s->state[AT_T]) return @N@_BAD_ARGUMENT;
    if (t == s->state[AT_T]) return @N@_OK;
    if (!s->moved) {
        if (begin_motion(s, t)) return ended(s, NOT_FINITE);
        if (s->state[AT_H] > t) s->state[AT_H] = t;
    } else {
        s->controls[AT_MAX_EVENTS] = s->max_events + s->state[AT_EVENTS];
        s->controls[AT_MAX_STEPS] = s->max_steps + s->state[AT_STEPS];
        if ((s->new_inputs || t != s->controls[AT_T_END] || s->state[AT_STATUS] != RUNNING) && go_on(s, t))
            return ended(s, NOT_FINITE);
    }
    s->moved = 1;
    s->new_inputs = 0;
    vain = in_vain(s) + s->max_steps;
    begins(s, counts);
    while ((status = (int)s->state[AT_STATUS]) <= RUNNING) {
        if (status < RUNNING) { /* other steps are to go on: those that choose between methods, or explicit ones alone */
            s->choosing = status == SUSPECT;
            s->state[AT_STATUS] = RUNNING;
            s->state[AT_PRESSURE] = s->choosing ? PATIENCE - 1 : 0;
        }
        given[0] = s->state, given[1] = s->controls, found[0] = s->next;
        if (call(s, s->choosing ? attempt_choosing : attempt, 2, given, 1, found)) return ended(s, NOT_FINITE);
        memcpy(s->state, s->next, sizeof s->state);
        if (N_TALLY) {
            given[0] = s->tally, given[1] = s->state, given[2] = s->controls, found[0] = s->next;
            call(s, tally, 3, given, 1, found);
            memcpy(s->tally, s->next, sizeof(double) * N_TALLY);
        }
        note_contacts(s, 0);
        if (in_vain(s) > vain) return ended(s, TOO_MANY_STEPS);
        if (begins(s, counts) && stop_at_impact && s->state[AT_STATUS] <= RUNNING) return @N@_IMPACT;
    }
    return ended(s, status);
}

/* -- readings -- */

double @n@_time(const @n@ *s) { return s->outcome == @N@_NOT_STARTED ? 0 : s->state[AT_T]; }

double @n@_value(const @n@ *s, int table, int index)
{
    if (!row_of(table, index)) return 0;
    if (table == @N@_PARAMETER) return s->parameters[index];
    if (table == @N@_START) return s->starts[index];
    if (table == @N@_STATE) return s->outcome == @N@_NOT_STARTED ? 0 : s->state[AT_Y + index];
    if (table == @N@_INPUT) {
        const double *piece = s->pieces + WIDTH * index;
        return piece[1] + piece[2] * (@n@_time(s) - piece[0]);
    }
    return 0;
}

int @n@_states(const @n@ *s, double *states)
{
    if (s->outcome == @N@_NOT_STARTED) return s->outcome;
    memcpy(states, s->state + AT_Y, sizeof(double) * N_Y);
    return @N@_OK;
}

int @n@_outputs(@n@ *s, double *outputs)
{
    const double *given[3];
    double *found[1];
    if (s->outcome == @N@_NOT_STARTED) return s->outcome;
    if (N_INPUTS) memcpy(s->state + AT_PIECES, s->pieces, sizeof(double) * N_PIECES);
    given[0] = s->state, given[1] = s->controls, given[2] = s->parameters, found[0] = outputs;
    return N_OUTPUTS > 0 && call(s, observed, 3, given, 1, found) ? @N@_NOT_FINITE : @N@_OK;
}

int @n@_latest(const @n@ *s, int pair, @n@_contact *contact)
{
    if (!row_of(@N@_PAIR, pair)) return @N@_BAD_ARGUMENT;
    *contact = s->contacts[pair];
    return @N@_OK;
}

int @n@_counts(const @n@ *s, double *counts)
{
    if (s->outcome == @N@_NOT_STARTED) return s->outcome;
    counts[0] = s->state[AT_STEPS], counts[1] = in_vain(s), counts[2] = s->state[AT_EVALUATIONS];
    return @N@_OK;
}

int @n@_balance(const @n@ *s, double *balance)
{
    if (s->outcome == @N@_NOT_STARTED) return s->outcome;
    balance[0] = AT_ERROR < 0 ? 0 : s->tally[ROOM(AT_ERROR + 1) - 1];
    balance[1] = AT_MOVED < 0 ? 0 : s->tally[ROOM(AT_MOVED + 1) - 1];
    balance[2] = AT_SIZE < 0 ? 0 : s->tally[ROOM(AT_SIZE + 1) - 1];
    return @N@_OK;
}

const char *@n@_text(int code)
{
    switch (code) {
    case @N@_OK: return "good";
    case @N@_IMPACT: return "an impact began";
    case @N@_NOT_STARTED: return "not started: call the start function first, with a duration";
    case @N@_BAD_ARGUMENT: return "an argument that cannot be: an index, a number that is not finite, a time before now";
    case @N@_BAD_PARAMETERS: return "parameters outside their limits, or so far apart in size that a constant is not finite";
    case @N@_START_NOT_CLOSED:
        return "the start cannot be assembled: loops stay open, surfaces overlap, or more is to be said of it; state other coordinates";
@texts@
    default: return "no code of this library";
    }
}
