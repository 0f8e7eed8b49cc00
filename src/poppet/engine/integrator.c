/* made from integrator.py, stepping.py, job.py, rosenbrock.py, sha256 e2a011bd484f385f4e5635c7af3fbbe24992e1657fde0dd134c4ac429d7c5b0d */
/* The adaptive integrator, translated from Python (tools/integrator_c.py); change it there.

   `integrate` takes one row of 64 bit numbers, addresses of functions and arrays and their lengths, and gives back how
   the run ended: 0 done, 1 stopped by a condition, 2 stalled, 3 too many attempts, 4 not finite, 5 interrupted.
   It allocates nothing, calls itself nowhere and keeps nothing. Not for -ffast-math: it asks what is finite. */

#include <math.h>
#include <stdint.h>

typedef void of_jacobian(const double *t, const double *x, const double *u, const double *slopes, const double *p, double *f, double *J, double *drift);
typedef void of_step(const double *th, const double *x, const double *us, const double *p, const double *f, const double *J, const double *drift, double *w, double *k, double *x1);
typedef void of_dense(const double *k, double *d);
typedef void of_outputs(const double *t, const double *x, const double *u, const double *p, double *y);
typedef void of_update(const double *t, const double *x, const double *u, const double *p, const double *fired, double *z);

typedef struct { double *at; int64_t size; } vector;
typedef struct { int64_t *at; int64_t size; } integers;
typedef struct { uint8_t *at; int64_t size; } flags;
typedef struct { double *at; int64_t rows, columns; } matrix;
typedef struct { int64_t *at; int64_t rows, columns; } integer_matrix;
typedef struct { double *at; int64_t sets, rows, columns; } cube;

static vector vector_at(int64_t address, int64_t size) {
  vector made;
  made.at = (double *)(intptr_t)address;
  made.size = size;
  return made;
}

static integers integers_at(int64_t address, int64_t size) {
  integers made;
  made.at = (int64_t *)(intptr_t)address;
  made.size = size;
  return made;
}

static flags flags_at(int64_t address, int64_t size) {
  flags made;
  made.at = (uint8_t *)(intptr_t)address;
  made.size = size;
  return made;
}

static matrix matrix_at(int64_t address, int64_t rows, int64_t columns) {
  matrix made;
  made.at = (double *)(intptr_t)address;
  made.rows = rows;
  made.columns = columns;
  return made;
}

static integer_matrix integer_matrix_at(int64_t address, int64_t rows, int64_t columns) {
  integer_matrix made;
  made.at = (int64_t *)(intptr_t)address;
  made.rows = rows;
  made.columns = columns;
  return made;
}

static cube cube_at(int64_t address, int64_t sets, int64_t rows, int64_t columns) {
  cube made;
  made.at = (double *)(intptr_t)address;
  made.sets = sets;
  made.rows = rows;
  made.columns = columns;
  return made;
}

static vector part_of(vector all, int64_t first, int64_t behind) {
  vector made;
  made.at = all.at + first;
  made.size = behind - first;
  return made;
}

static vector row_of(matrix all, int64_t row) {
  vector made;
  made.at = all.at + row * all.columns;
  made.size = all.columns;
  return made;
}

static matrix set_of(cube all, int64_t set) {
  matrix made;
  made.at = all.at + set * all.rows * all.columns;
  made.rows = all.rows;
  made.columns = all.columns;
  return made;
}

static double least(double a, double b) { return b < a ? b : a; }

static double most(double a, double b) { return b > a ? b : a; }

static int64_t least_integer(int64_t a, int64_t b) { return b < a ? b : a; }

static int is_finite(double a) { return a - a == 0.0; }

typedef struct {
  int64_t jacobian;
  int64_t step;
  int64_t dense;
  int64_t outputs;
  int64_t update;
  int64_t n_states;
  int64_t n_controlled;
  int64_t n_inputs;
  int64_t n_outputs;
  int64_t n_numbers;
  int64_t n_memory;
  int64_t n_timers;
  int64_t n_jacobian;
  int64_t n_scratch;
  int64_t scales;
  int64_t positive;
  int64_t acting;
  int64_t n_segments;
  int64_t n_courses;
  int64_t n_rows;
  int64_t n_conditions;
  int64_t n_script;
  int64_t x;
  int64_t p;
  int64_t starts;
  int64_t courses;
  int64_t coefficients;
  int64_t jumps;
  int64_t grid;
  int64_t limits;
  int64_t places;
  int64_t weights;
  int64_t table;
  int64_t books;
  int64_t watch;
  int64_t counts;
  int64_t memory;
  int64_t script;
} Job;

typedef struct {
  int64_t jacobian;
  int64_t step;
  int64_t dense;
  int64_t outputs;
  int64_t update;
} Functions;

typedef struct {
  vector p;
  vector z;
  flags acting;
  vector fired;
  vector after;
} Memory;

typedef struct {
  matrix tolerances;
  flags positive;
  double longest;
  double most;
  vector script;
  int replays;
} Control;

typedef struct {
  vector grid;
  matrix table;
  vector y;
} OutputRows;

typedef struct {
  integer_matrix places;
  matrix weights;
} Stops;

typedef struct {
  vector u;
  vector us;
  vector slopes;
  vector tt;
  vector rates;
  vector jacobian;
  vector drift;
  vector scratch;
  vector stages;
  vector estimate;
  vector new_x;
  vector dense;
  vector inside;
} Work;

typedef struct {
  Functions functions;
  Memory memory;
  Control control;
  OutputRows rows;
  Stops stops;
  Work work;
  vector x;
  vector books;
  vector watch;
  integers counts;
} RunState;

typedef struct {
  double start;
  double stop;
  matrix inputs;
} Segment;

typedef struct {
  double t;
  double h;
  double end;
  vector new_x;
} Step;

#define ACCEPTED 0
#define ATTEMPTS 1
#define COLUMN 2
#define CONDITION 3
#define DONE 0
#define GROWTH 6.0
static const double INPUT_TIMES[4] = {0.386, 0.21, 0.63, 1.0};
#define INTERNAL 0.25
#define INTERRUPTED 5
#define IN_WINDOW 4
#define SAFETY 0.9
#define SHRINK 0.15
#define STALLED 2
#define STALL_WINDOW 400
#define STOPPED 1
#define TOO_MANY 3

/* Return the arrays of a Job as the data of a run. Arrays without an address of their own are parts of the scratch
   memory of the job. */
static RunState do_run_of(const Job *job) {
  int64_t n = 0;
  int64_t n_c = 0;
  int64_t n_u = 0;
  int64_t n_y = 0;
  int64_t n_z = 0;
  int64_t n_m = 0;
  vector p;
  vector limits;
  matrix tolerances;
  int64_t of_model = 0;
  vector tail;
  vector vectors;
  vector u;
  vector us;
  vector slopes;
  vector tt;
  vector jacobian;
  vector scratch;
  vector fired;
  vector after;
  vector y;
  Work work;
  RunState made;
  n = job->n_states;
  n_c = job->n_controlled;
  n_u = job->n_inputs;
  n_y = job->n_outputs;
  n_z = job->n_memory;
  n_m = job->n_timers;
  p = vector_at(job->p, job->n_numbers + n_z);
  limits = vector_at(job->limits, 4);
  tolerances = matrix_at(job->memory, 3, n_c);
  of_model = 12 * n + 6 * n_u + n_y + n_z + n_m;
  tail = vector_at(job->memory + 24 * n_c, of_model + 2 + job->n_jacobian + job->n_scratch);
  vectors = part_of(tail, 0, 12 * n);
  tail = part_of(tail, 12 * n, tail.size);
  u = part_of(tail, 0, n_u);
  us = part_of(tail, n_u, 5 * n_u);
  slopes = part_of(tail, 5 * n_u, 6 * n_u);
  tail = part_of(tail, 6 * n_u, tail.size);
  tt = part_of(tail, 0, 2);
  jacobian = part_of(tail, 2, 2 + job->n_jacobian);
  tail = part_of(tail, 2 + job->n_jacobian, tail.size);
  scratch = part_of(tail, 0, job->n_scratch);
  tail = part_of(tail, job->n_scratch, tail.size);
  fired = part_of(tail, 0, n_m);
  after = part_of(tail, n_m, n_m + n_z);
  y = part_of(tail, n_m + n_z, tail.size);
  work.u = u;
  work.us = us;
  work.slopes = slopes;
  work.tt = tt;
  work.rates = part_of(vectors, 0, n);
  work.jacobian = jacobian;
  work.drift = part_of(vectors, n, 2 * n);
  work.scratch = scratch;
  work.stages = part_of(vectors, 6 * n, vectors.size);
  work.estimate = part_of(vectors, 11 * n, vectors.size);
  work.new_x = part_of(vectors, 2 * n, 3 * n);
  work.dense = part_of(vectors, 4 * n, 6 * n);
  work.inside = part_of(vectors, 3 * n, 4 * n);
  made.functions.jacobian = job->jacobian;
  made.functions.step = job->step;
  made.functions.dense = job->dense;
  made.functions.outputs = job->outputs;
  made.functions.update = job->update;
  made.memory.p = p;
  made.memory.z = part_of(p, job->n_numbers, p.size);
  made.memory.acting = flags_at(job->acting, n_z);
  made.memory.fired = fired;
  made.memory.after = after;
  made.control.tolerances = tolerances;
  made.control.positive = flags_at(job->positive, n_c);
  made.control.longest = limits.at[0];
  made.control.most = limits.at[1];
  made.control.script = vector_at(job->script, job->n_script);
  made.control.replays = limits.at[2] > 0.0;
  made.rows.grid = vector_at(job->grid, job->n_rows);
  made.rows.table = matrix_at(job->table, n_y, job->n_rows);
  made.rows.y = y;
  made.stops.places = integer_matrix_at(job->places, job->n_conditions, 2);
  made.stops.weights = matrix_at(job->weights, job->n_conditions, 3);
  made.work = work;
  made.x = vector_at(job->x, n);
  made.books = vector_at(job->books, 3 * n);
  made.watch = vector_at(job->watch, 2);
  made.counts = integers_at(job->counts, 5);
  return made;
}

/* Set the tolerances of the controlled states. They depend on the relative tolerance, on Kernel.scales and on the
   initial state x. */
static void do_set_tolerances(const Control *control, matrix scales, double relative, vector x) {
  int64_t s = 0;
  double initial = 0.0;
  double size = 0.0;
  for (s = 0; s < scales.columns; s++) {
    initial = fabs(x.at[s]);
    size = (control->positive.at[s] && (initial > 0.0)) ? initial : scales.at[2 * scales.columns + s];
    control->tolerances.at[0 * control->tolerances.columns + s] = INTERNAL * relative * scales.at[0 * scales.columns + s];
    control->tolerances.at[1 * control->tolerances.columns + s] = control->tolerances.at[0 * control->tolerances.columns + s] * scales.at[1 * scales.columns + s] * size;
    control->tolerances.at[2 * control->tolerances.columns + s] = size;
  }
}

/* Return the time difference below which two times count as equal [s]. */
static double do_rounding(double t) {
  return 1e-14 * t + 1e-15;
}

/* Return the earliest time at which a timer is due [s], or infinity. */
static double do_next_instant(const Memory *memory) {
  double first = 0.0;
  int64_t k = 0;
  first = HUGE_VAL;
  for (k = 0; k < memory->fired.size; k++) {
    first = least(first, memory->z.at[k]);
  }
  return first;
}

/* Return the phase of a wave without complete turns [rad]. Complete turns would reduce the accuracy at late times. c
   contains the coefficients of the segment, and dt is the time since its start. */
static double do_angle(vector c, double dt) {
  double turns = 0.0;
  turns = (c.at[3] + 0.5 * c.at[4] * dt) * dt;
  return 2.0 * 3.141592653589793 * (turns - floor(turns)) + c.at[5];
}

/* Write the inputs at the time t of a segment into u. */
static void do_inputs_at(double t, Segment segment, vector u) {
  matrix c;
  int64_t k = 0;
  double dt = 0.0;
  double value = 0.0;
  c = segment.inputs;
  for (k = 0; k < u.size; k++) {
    dt = t - c.at[k * c.columns + 6];
    value = c.at[k * c.columns + 0] + c.at[k * c.columns + 1] * dt;
    if (c.at[k * c.columns + 2] != 0.0) {
      value += (c.at[k * c.columns + 2] * sin(do_angle(row_of(c, k), dt)));
    }
    u.at[k] = value;
  }
}

/* Run all timers that are due at the time t, and return True if the rates have changed. A timer can be set to the same
   time again; the loop ends when no timer is due. */
static int do_act(const RunState *run, Segment segment, double t, vector x) {
  int changed = 0;
  const Work *w;
  const Memory *m;
  double due = 0.0;
  int64_t k = 0;
  changed = 0;
  w = &run->work;
  m = &run->memory;
  due = t + do_rounding(t);
  while (do_next_instant(m) <= due) {
    for (k = 0; k < m->fired.size; k++) {
      m->fired.at[k] = (m->z.at[k] <= due) ? 1.0 : 0.0;
    }
    w->tt.at[0] = t;
    do_inputs_at(t, segment, w->u);
    ((of_update *)(intptr_t)run->functions.update)(w->tt.at, x.at, w->u.at, m->p.at, m->fired.at, m->after.at);
    for (k = 0; k < m->z.size; k++) {
      if (m->acting.at[k] && (m->after.at[k] != m->z.at[k])) {
        changed = 1;
      }
      m->z.at[k] = m->after.at[k];
    }
  }
  return changed;
}

/* Compute and return the outputs for the state x at the time t of a segment. */
static vector do_outputs_at(const RunState *run, Segment segment, double t, vector x) {
  const Work *w;
  vector y;
  w = &run->work;
  y = run->rows.y;
  do_inputs_at(t, segment, w->u);
  w->tt.at[0] = t;
  ((of_outputs *)(intptr_t)run->functions.outputs)(w->tt.at, x.at, w->u.at, run->memory.p.at, y.at);
  return y;
}

/* Return the index of the first true stop condition for the state x at the time t, or -1. */
static int64_t do_stop_condition(const RunState *run, Segment segment, double t, vector x) {
  vector y;
  integer_matrix places;
  matrix weights;
  int64_t k = 0;
  double value = 0.0;
  int64_t j = 0;
  y = do_outputs_at(run, segment, t, x);
  places = run->stops.places;
  weights = run->stops.weights;
  for (k = 0; k < weights.rows; k++) {
    value = weights.at[k * weights.columns + 2];
    for (j = 0; j < 2; j++) {
      if (places.at[k * places.columns + j] >= 0) {
        value += (weights.at[k * weights.columns + j] * y.at[places.at[k * places.columns + j]]);
      }
    }
    if (value > 0.0) {
      return k;
    }
  }
  return -1;
}

/* Return True if an input changes within a segment. */
static int do_varies(Segment segment) {
  int64_t k = 0;
  for (k = 0; k < segment.inputs.rows; k++) {
    if ((segment.inputs.at[k * segment.inputs.columns + 1] != 0.0) || (segment.inputs.at[k * segment.inputs.columns + 2] != 0.0)) {
      return 1;
    }
  }
  return 0;
}

/* Compute the inputs at all solver stages of a step from t to t + h. */
static void do_stage_inputs(const RunState *run, Segment segment, double t, double h) {
  int64_t n = 0;
  int64_t i = 0;
  n = run->work.u.size;
  for (i = 0; i < 4; i++) {
    do_inputs_at(t + INPUT_TIMES[i & 3] * h, segment, part_of(run->work.us, i * n, (i + 1) * n));
  }
}

/* Write the time derivatives of the inputs at the time t of a segment into slopes. */
static void do_input_slopes_at(double t, Segment segment, vector slopes) {
  matrix c;
  int64_t k = 0;
  double slope = 0.0;
  double dt = 0.0;
  c = segment.inputs;
  for (k = 0; k < slopes.size; k++) {
    slope = c.at[k * c.columns + 1];
    if (c.at[k * c.columns + 2] != 0.0) {
      dt = t - c.at[k * c.columns + 6];
      slope += (2.0 * 3.141592653589793 * (c.at[k * c.columns + 3] + c.at[k * c.columns + 4] * dt) * c.at[k * c.columns + 2] * cos(do_angle(row_of(c, k), dt)));
    }
    slopes.at[k] = slope;
  }
}

/* Return a length of the first step, from the rates of the controlled states. No state changes by more than a
   twentieth of its size, and the step is at most a twentieth of span. */
static double do_first_step(const RunState *run, double span) {
  double fastest = 0.0;
  matrix tolerances;
  int64_t s = 0;
  fastest = 20.0 / span;
  tolerances = run->control.tolerances;
  for (s = 0; s < tolerances.columns; s++) {
    fastest = most(fastest, 20.0 * fabs(run->work.rates.at[s]) / (fabs(run->x.at[s]) + tolerances.at[2 * tolerances.columns + s]));
  }
  return 1.0 / fastest;
}

/* Compute rates, Jacobian and drift at the start of a step, and return the length of the step. If h is positive, it is
   the length. Otherwise, first_step selects the length; if h is negative, -h is the maximum. */
static double do_begin(const RunState *run, Segment segment, double t, double h) {
  const Work *w;
  double longest = 0.0;
  w = &run->work;
  w->tt.at[0] = t;
  do_inputs_at(t, segment, w->u);
  do_input_slopes_at(t, segment, w->slopes);
  ((of_jacobian *)(intptr_t)run->functions.jacobian)(w->tt.at, run->x.at, w->u.at, w->slopes.at, run->memory.p.at, w->rates.at, w->jacobian.at, w->drift.at);
  if (h > 0.0) {
    return h;
  }
  longest = do_first_step(run, segment.stop - t);
  return (h < 0.0) ? least(-h, longest) : longest;
}

/* Return the desired length of a step from t, and the latest time at which it can end. The latest end is the next
   sample instant or the end of the segment. Since the time calm, sample instants have not changed the rates. A step
   can therefore continue past instants for a further duration of t - calm, unless lands is True. The interpolant of
   the step then gives the state at these instants. */
static void do_reach(const RunState *run, Segment segment, double t, double h, double calm, int lands, double *r0, double *r1) {
  double desired = 0.0;
  double goal = 0.0;
  double instant = 0.0;
  desired = least(h, run->control.longest);
  goal = segment.stop;
  if (run->memory.fired.size > 0) {
    instant = do_next_instant(&run->memory);
    if (instant < (goal - do_rounding(goal))) {
      if (lands || ((instant - t) >= (t - calm))) {
        *r0 = desired;
        *r1 = instant;
        return;
      }
      desired = least(desired, t - calm);
    }
  }
  *r0 = desired;
  *r1 = goal;
  return;
}

/* Return the length of the next step of a run that repeats stored steps. script contains the lengths of the stored
   steps. If the stored length is not positive, or exceeds remaining, the step ends at the next instant. */
static double do_again(vector script, int64_t step, double remaining) {
  double h = 0.0;
  h = script.at[least_integer(step, script.size - 1)];
  return ((h <= 0.0) || (h >= remaining)) ? remaining : h;
}

/* Return the length of the next step, at most remaining. If the desired length is more than half of remaining, but not
   all of it, the result is half of remaining. This avoids a tiny last step. */
static double do_length(double desired, double remaining) {
  if (desired < (0.5 * remaining)) {
    return desired;
  }
  return (desired < remaining) ? (0.5 * remaining) : remaining;
}

/* Return the largest error of the controlled states in a step, relative to their tolerances. The result is infinite if
   a state is not finite, or is not positive although it must be. */
static double do_error(const RunState *run) {
  double worst = 0.0;
  matrix tolerances;
  int64_t s = 0;
  double value = 0.0;
  double e = 0.0;
  worst = 0.0;
  tolerances = run->control.tolerances;
  for (s = 0; s < tolerances.columns; s++) {
    value = run->work.new_x.at[s];
    if (!is_finite(value) || (run->control.positive.at[s] && (value <= 0.0))) {
      return HUGE_VAL;
    }
    e = fabs(run->work.estimate.at[s]) / (tolerances.at[1 * tolerances.columns + s] + tolerances.at[0 * tolerances.columns + s] * most(fabs(run->x.at[s]), fabs(value)));
    if (!(e <= worst)) {
      worst = e;
    }
  }
  return worst;
}

/* Write the state inside a completed step into x, which can be shorter than the state. theta is the position in the
   step, from 0 to 1. */
static void do_interpolate(const RunState *run, Step step, double theta, vector x) {
  double complement = 0.0;
  int64_t n = 0;
  vector dense;
  int64_t s = 0;
  complement = 1.0 - theta;
  n = run->x.size;
  dense = run->work.dense;
  for (s = 0; s < x.size; s++) {
    x.at[s] = complement * run->x.at[s] + theta * (step.new_x.at[s] + complement * (dense.at[s] + theta * dense.at[n + s]));
  }
}

/* Return the index of the first stop condition in a completed step, and its position theta. The index is -1 if no
   condition is true. Conditions are evaluated in the middle and at the end of the step. The state at theta, from 0
   to 1, is stored in inside. */
static void do_stop_inside(const RunState *run, Segment segment, Step step, int64_t *r0, double *r1) {
  double low = 0.0;
  double high = 0.0;
  int64_t event = 0;
  vector x;
  int64_t condition = 0;
  double theta = 0.0;
  low = 0.0;
  high = 0.5;
  event = -1;
  x = run->work.inside;
  for (;;) {
    do_interpolate(run, step, high, x);
    condition = do_stop_condition(run, segment, step.t + high * step.h, x);
    if ((event < 0) && (condition < 0)) {
      if (high == 1.0) {
        *r0 = -1;
        *r1 = 1.0;
        return;
      }
      low = 0.5;
      high = 1.0;
      continue;
    }
    if (condition >= 0) {
      event = condition;
      theta = high;
    } else {
      low = high;
    }
    high = 0.5 * (low + theta);
    if ((((theta - low) * step.h) <= (4e-16 * (step.t + step.h))) || (high <= low) || (high >= theta)) {
      do_interpolate(run, step, theta, x);
      *r0 = event;
      *r1 = theta;
      return;
    }
  }
}

/* Write the outputs for the state x at the time t into the next column of the output table. */
static void do_write_row(const RunState *run, Segment segment, double t, vector x) {
  vector y;
  int64_t column = 0;
  int64_t k = 0;
  y = do_outputs_at(run, segment, t, x);
  column = run->counts.at[COLUMN];
  for (k = 0; k < y.size; k++) {
    run->rows.table.at[k * run->rows.table.columns + column] = y.at[k];
  }
  run->counts.at[COLUMN] = column + 1;
}

/* Write the output rows inside a completed step before the time end. A row exactly at this time is written later,
   because it shows the values after an event. */
static void do_write_rows(const RunState *run, Segment segment, Step step, double end) {
  double limit = 0.0;
  vector grid;
  vector row;
  double t = 0.0;
  limit = end - do_rounding(end);
  grid = run->rows.grid;
  row = part_of(run->work.drift, 0, run->control.positive.size);
  while ((run->counts.at[COLUMN] < grid.size) && (grid.at[run->counts.at[COLUMN]] < limit)) {
    t = grid.at[run->counts.at[COLUMN]];
    do_interpolate(run, step, most(0.0, (t - step.t) / step.h), row);
    do_write_row(run, segment, t, row);
  }
}

/* Run the timers that are due inside a completed step, and return the end of the step. Output rows before each instant
   are written first. The step ends early, with its state in inside, at the first instant that changes the rates. */
static double do_act_inside(const RunState *run, Segment segment, Step step) {
  double instant = 0.0;
  for (;;) {
    instant = do_next_instant(&run->memory);
    if (instant >= (step.end - do_rounding(step.end))) {
      return step.end;
    }
    do_write_rows(run, segment, step, instant);
    do_interpolate(run, step, (instant - step.t) / step.h, run->work.inside);
    if (do_act(run, segment, instant, run->work.inside)) {
      return instant;
    }
  }
}

/* Replace the state by new, and update extremes and sums of |change| of all states. */
static void do_take(const RunState *run, vector new_x) {
  vector x;
  vector books;
  int64_t n = 0;
  int64_t s = 0;
  double value = 0.0;
  x = run->x;
  books = run->books;
  n = x.size;
  for (s = 0; s < n; s++) {
    value = new_x.at[s];
    books.at[2 * n + s] += fabs(value - x.at[s]);
    x.at[s] = value;
    books.at[s] = least(books.at[s], value);
    books.at[n + s] = most(books.at[n + s], value);
  }
  run->counts.at[ACCEPTED] += 1;
}

/* Accept a completed step, write its output rows, and return its end. The step ends early at a stop condition, or at
   an instant that changes the rates. counts[CONDITION] is then the index of the stop condition; otherwise it is -1. */
static double do_accept(const RunState *run, Segment segment, Step step) {
  const Memory *memory;
  integers counts;
  double end = 0.0;
  int passes = 0;
  int has_stops = 0;
  double reached = 0.0;
  int64_t event = 0;
  double theta = 0.0;
  memory = &run->memory;
  counts = run->counts;
  end = step.end;
  passes = (memory->fired.size > 0) && (do_next_instant(memory) < (end - do_rounding(end)));
  has_stops = run->stops.weights.rows > 0;
  reached = end;
  if (has_stops || passes || (run->rows.grid.at[counts.at[COLUMN]] < end)) {
    ((of_dense *)(intptr_t)run->functions.dense)(run->work.stages.at, run->work.dense.at);
  }
  if (has_stops) {
    do_stop_inside(run, segment, step, &event, &theta);
    counts.at[CONDITION] = event;
    reached = (event >= 0) ? (step.t + theta * step.h) : end;
  } else if (passes) {
    reached = do_act_inside(run, segment, step);
  }
  do_write_rows(run, segment, step, reached);
  do_take(run, ((counts.at[CONDITION] >= 0) || (reached < end)) ? run->work.inside : step.new_x);
  return reached;
}

/* Return the fourth root with identical bits on all machines, unlike the power function of a library. */
static double do_fourth_root(double value) {
  return sqrt(sqrt(value));
}

/* Return the factor on the step length after an accepted step (predictive control of Gustafsson). error and h are the
   error and the length of the step. error_before and step_before are the error and the length of the previous step. */
static double do_growth(double error, double h, double error_before, double step_before) {
  double factor = 0.0;
  factor = SAFETY / do_fourth_root(error);
  if (step_before > 0.0) {
    factor = least(factor, SAFETY * (h / step_before) * do_fourth_root(error_before / (error * error)));
  }
  return least(GROWTH, most(SHRINK, factor));
}

/* Return the status that ends a run after an attempted step, or DONE if the run continues. A run has stalled if it
   advances little in STALL_WINDOW attempts since the time window, unless timers have acted. */
static int64_t do_verdict(const RunState *run, double t, double window, int has_acted) {
  integers counts;
  double end = 0.0;
  int slow = 0;
  counts = run->counts;
  end = run->rows.grid.at[run->rows.grid.size - 1];
  if ((counts.at[ATTEMPTS] % STALL_WINDOW) == 0) {
    slow = ((t - window) < (0.0001 * (end - window))) && !has_acted;
    if (((counts.at[ACCEPTED] - counts.at[IN_WINDOW]) < (STALL_WINDOW * 7 / 10)) && slow) {
      return STALLED;
    }
    counts.at[IN_WINDOW] = counts.at[ACCEPTED];
  }
  if (counts.at[ATTEMPTS] >= run->control.most) {
    return TOO_MANY;
  }
  return (run->watch.at[1] != 0.0) ? INTERRUPTED : DONE;
}

/* Integrate over one segment of the inputs, and return status, end and next step length. If h is positive, it is the
   length of the first step. Otherwise the rates determine this length; if h is negative, -h is the maximum. */
static void do_over(const RunState *run, Segment segment, double h, int64_t *r0, double *r1, double *r2) {
  const Work *work;
  const Control *control;
  integers counts;
  const Memory *memory;
  vector script;
  double t = 0.0;
  double stop = 0.0;
  int has_timers = 0;
  double error_before = 0.0;
  double step_before = 0.0;
  int rejected = 0;
  int fresh = 0;
  int moves = 0;
  double window = 0.0;
  int lands = 0;
  double calm = 0.0;
  double first = 0.0;
  int has_changed = 0;
  int has_acted = 0;
  double desired = 0.0;
  double goal = 0.0;
  double end = 0.0;
  double error = 0.0;
  Step made1;
  int changes = 0;
  double factor = 0.0;
  int64_t status = 0;
  work = &run->work;
  control = &run->control;
  counts = run->counts;
  memory = &run->memory;
  script = run->control.script;
  t = segment.start;
  stop = segment.stop;
  has_timers = run->memory.fired.size > 0;
  error_before = 0.01;
  step_before = 0.0;
  rejected = 0;
  fresh = 1;
  moves = do_varies(segment);
  window = t;
  lands = (run->stops.weights.rows > 0) || (script.size > 0);
  calm = t;
  first = 0.0;
  has_changed = 1;
  has_acted = has_timers || (t > 0.0);
  do_stage_inputs(run, segment, t, 0.0);
  while (t < stop) {
    if (fresh) {
      h = do_begin(run, segment, t, h);
      fresh = 0;
    }
    do_reach(run, segment, t, h, calm, lands, &desired, &goal);
    h = control->replays ? do_again(script, counts.at[ACCEPTED], goal - t) : do_length(desired, goal - t);
    if (moves) {
      do_stage_inputs(run, segment, t, h);
    }
    end = (h >= ((goal - t) * (1.0 - 1e-12))) ? goal : (t + h);
    work->tt.at[0] = t;
    work->tt.at[1] = h;
    ((of_step *)(intptr_t)run->functions.step)(work->tt.at, run->x.at, work->us.at, memory->p.at, work->rates.at, work->jacobian.at, work->drift.at, work->scratch.at, work->stages.at, work->new_x.at);
    error = do_error(run);
    counts.at[ATTEMPTS] += 1;
    if ((error <= 1.0) || (control->replays && is_finite(error))) {
      if ((counts.at[ACCEPTED] < script.size) && !control->replays) {
        script.at[counts.at[ACCEPTED]] = (end == goal) ? -h : h;
      }
      made1.t = t;
      made1.h = h;
      made1.end = end;
      made1.new_x = work->new_x;
      t = do_accept(run, segment, made1);
      run->watch.at[0] = t;
      if (counts.at[CONDITION] >= 0) {
        *r0 = STOPPED;
        *r1 = t;
        *r2 = h;
        return;
      }
      fresh = 1;
      error = most(error, 1e-10);
      changes = t < end;
      factor = do_growth(error, h, error_before, step_before);
      step_before = h;
      error_before = most(0.01, error);
      if (has_changed) {
        first = h * least(2.0, most(0.5, factor));
        has_changed = 0;
      }
      h = (h < desired) ? most(desired, h * factor) : (h * (rejected ? least(1.0, factor) : factor));
      rejected = 0;
      if (has_timers && (t < (stop - do_rounding(stop)))) {
        has_acted = 1;
        if (do_act(run, segment, t, run->x) || changes) {
          h = least(h, first);
          step_before = 0.0;
          calm = t;
          has_changed = 1;
        }
      }
    } else {
      h *= (is_finite(error) ? most(SHRINK, least(0.8, SAFETY / do_fourth_root(error))) : SHRINK);
      rejected = 1;
      if (((t + h) <= t) || (h < 1e-300) || control->replays) {
        *r0 = STALLED;
        *r1 = t;
        *r2 = h;
        return;
      }
    }
    status = do_verdict(run, t, window, has_acted);
    if (status != DONE) {
      *r0 = status;
      *r1 = t;
      *r2 = h;
      return;
    }
    if ((counts.at[ATTEMPTS] % STALL_WINDOW) == 0) {
      window = t;
      has_acted = 0;
    }
  }
  *r0 = DONE;
  *r1 = t;
  *r2 = h;
  return;
}

/* Process a segment of a circuit without states, and return the time at which it ends. Output rows and timers are
   processed in the order of time. Stop conditions are also evaluated between rows. */
static double do_without_states(const RunState *run, Segment segment) {
  double t = 0.0;
  double stop = 0.0;
  integers counts;
  vector grid;
  double end = 0.0;
  double instant = 0.0;
  int64_t row = 0;
  int64_t event = 0;
  double theta = 0.0;
  Step made1;
  Step made2;
  t = segment.start;
  stop = segment.stop;
  counts = run->counts;
  grid = run->rows.grid;
  while (t < stop) {
    end = stop;
    if (run->memory.fired.size > 0) {
      do_act(run, segment, t, run->x);
      instant = do_next_instant(&run->memory);
      end = (instant < (stop - do_rounding(stop))) ? instant : stop;
    }
    if (run->stops.weights.rows > 0) {
      row = counts.at[COLUMN];
      while ((row < (grid.size - 1)) && (grid.at[row] <= (t + do_rounding(t)))) {
        row += 1;
      }
      end = (grid.at[row] < (end - do_rounding(end))) ? grid.at[row] : end;
      made1.t = t;
      made1.h = end - t;
      made1.end = end;
      made1.new_x = run->x;
      do_stop_inside(run, segment, made1, &event, &theta);
      counts.at[CONDITION] = event;
      end = (event >= 0) ? (t + theta * (end - t)) : end;
    }
    made2.t = t;
    made2.h = end - t;
    made2.end = end;
    made2.new_x = run->x;
    do_write_rows(run, segment, made2, end);
    t = end;
    if (counts.at[CONDITION] >= 0) {
      break;
    }
  }
  return t;
}

/* Integrate over all segments, and return the status. fields is the address of a Job. */
int64_t integrate(const int64_t *fields) {
  const Job *job;
  RunState run;
  int64_t n = 0;
  int64_t n_u = 0;
  int64_t n_k = 0;
  integers counts;
  vector grid;
  vector starts;
  flags jumps;
  integers courses;
  cube coefficients;
  vector limits;
  matrix scales;
  int64_t s = 0;
  int64_t status = 0;
  double t = 0.0;
  double h = 0.0;
  Segment segment;
  int64_t k = 0;
  job = (const Job *)(const void *)fields;
  run = do_run_of(job);
  n = job->n_states;
  n_u = job->n_inputs;
  n_k = job->n_segments;
  counts = run.counts;
  grid = run.rows.grid;
  starts = vector_at(job->starts, n_k);
  jumps = flags_at(job->jumps, n_k);
  courses = integers_at(job->courses, n_k);
  coefficients = cube_at(job->coefficients, job->n_courses, n_u, 7);
  limits = vector_at(job->limits, 4);
  scales = matrix_at(job->scales, 3, job->n_controlled);
  if (limits.at[3] > 0.0) {
    do_set_tolerances(&run.control, scales, limits.at[3], run.x);
    run.work.tt.at[1] = 0.0;
  }
  for (s = 0; s < n; s++) {
    run.books.at[s] = run.x.at[s];
    run.books.at[n + s] = run.x.at[s];
    run.books.at[2 * n + s] = 0.0;
  }
  counts.at[CONDITION] = -1;
  status = DONE;
  t = starts.at[0];
  h = run.work.tt.at[1];
  segment.start = t;
  segment.stop = t;
  segment.inputs = set_of(coefficients, courses.at[0]);
  for (k = 0; k < n_k; k++) {
    t = starts.at[k];
    segment.start = t;
    segment.stop = ((k + 1) < n_k) ? starts.at[k + 1] : grid.at[grid.size - 1];
    segment.inputs = set_of(coefficients, courses.at[k]);
    if (job->n_timers > 0) {
      do_act(&run, segment, t, run.x);
    }
    if (job->n_conditions > 0) {
      counts.at[CONDITION] = do_stop_condition(&run, segment, t, run.x);
      if (counts.at[CONDITION] >= 0) {
        status = STOPPED;
        break;
      }
    }
    h = jumps.at[k] ? -h : h;
    if (n > 0) {
      do_over(&run, segment, h, &status, &t, &h);
    } else {
      t = do_without_states(&run, segment);
      status = (counts.at[CONDITION] >= 0) ? STOPPED : DONE;
    }
    if (status != DONE) {
      break;
    }
  }
  if ((status == DONE) || (status == STOPPED)) {
    counts.at[COLUMN] = least_integer(counts.at[COLUMN], grid.size - 1);
    do_write_row(&run, segment, t, run.x);
  }
  run.watch.at[0] = t;
  run.work.tt.at[1] = h;
  return status;
}
