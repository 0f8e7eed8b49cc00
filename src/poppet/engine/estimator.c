/* made from estimator.py, estimator_job.py, integrator.py, stepping.py, job.py, rosenbrock.py, sha256 4d815c098f0cd7e00e5c2eb2130f207e32faf6d31ba52df3652d415c51368b93 */
/* The estimator, an extended Kalman filter, translated from Python (tools/integrator_c.py); change it there.

   `estimate` takes one row of 64 bit numbers, addresses of functions and arrays and their lengths, and gives back how
   the update ended: 0 done, 2 stalled, 3 too many attempts, 4 not finite. It allocates nothing.
   Not for -ffast-math: it asks what is finite. */

#include <math.h>
#include <stdint.h>

typedef void of_jacobian(const double *t, const double *x, const double *u, const double *slopes, const double *p, double *f, double *J, double *drift);
typedef void of_step(const double *th, const double *x, const double *us, const double *p, const double *f, const double *J, const double *drift, double *w, double *k, double *x1);
typedef void of_dense(const double *k, double *d);
typedef void of_update(const double *t, const double *x, const double *u, const double *p, const double *fired, double *z);
typedef void of_linear(const double *t, const double *x, const double *u, const double *p, double *A, double *B);
typedef void of_observe(const double *t, const double *x, const double *u, const double *p, double *y, double *Hx, double *Ht);

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

static double least(double a, double b) { return b < a ? b : a; }

static double most(double a, double b) { return b > a ? b : a; }

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
  int64_t action;
  int64_t linear;
  int64_t observe;
  int64_t run;
  int64_t n_free;
  int64_t n_places;
  int64_t n_touched_inputs;
  int64_t n_channels;
  int64_t n_onsets;
  int64_t n_faults;
  int64_t clock;
  int64_t mean;
  int64_t covariance;
  int64_t u;
  int64_t places;
  int64_t touched_inputs;
  int64_t base;
  int64_t directions;
  int64_t reference;
  int64_t low;
  int64_t high;
  int64_t effects;
  int64_t readings;
  int64_t noise;
  int64_t gates;
  int64_t walk;
  int64_t cap;
  int64_t expected;
  int64_t innovations;
  int64_t deviations;
  int64_t used;
  int64_t rejected;
  int64_t outside;
  int64_t scores;
  int64_t transition;
  int64_t signatures;
  int64_t numerators;
  int64_t gram;
  int64_t memory;
} EstimatorJob;

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

typedef struct {
  matrix by_state;
  matrix by_free;
  vector by_touched;
  matrix start_system;
  matrix linear_system;
  matrix product;
  matrix other;
  vector y;
  vector forecast;
  vector y_by_state;
  vector y_by_touched;
  matrix slopes;
  matrix gains;
  matrix steps;
  vector effects;
  vector variances;
  vector sequence;
  vector moved;
  vector correction;
  vector shift;
  vector gain;
  vector image;
  matrix course;
  vector kept;
  vector before;
} Scratch;

typedef struct {
  int64_t linear;
  int64_t observe;
  vector clock;
  vector mean;
  matrix covariance;
  matrix u;
  integers places;
  integers touched_inputs;
  vector base;
  matrix directions;
  vector reference;
  vector low;
  vector high;
  matrix effects;
  vector readings;
  vector noise;
  vector gates;
  vector walk;
  vector cap;
  vector expected;
  vector innovations;
  vector deviations;
  vector used;
  vector rejected;
  vector outside;
  vector scores;
  matrix transition;
  matrix signatures;
  matrix numerators;
  matrix gram;
  Scratch scratch;
} Estimator;

#define ACCEPTED 0
#define ATTEMPTS 1
#define CORRECT 2
#define CURVED 0.1
#define DONE 0
#define GROWTH 6.0
static const double INPUT_TIMES[4] = {0.386, 0.21, 0.63, 1.0};
#define INTERNAL 0.25
#define LASTING 2.0
#define LEAST_FRACTION 0.1
#define MOST_PARTS 3
#define MOVED 1.0
#define NOT_FINITE 4
#define PREDICT 1
#define ROUNDING 1e-12
#define SAFETY 0.9
#define SHRINK 0.15
#define SLOW 0.5
#define STALLED 2
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

/* Return the scratch memory of an EstimatorJob as arrays. */
static Scratch do_scratch_of(const EstimatorJob *estimator_job, const Job *job) {
  int64_t n = 0;
  int64_t m = 0;
  int64_t n_c = 0;
  int64_t n_u = 0;
  int64_t q = 0;
  int64_t total = 0;
  int64_t steps = 0;
  int64_t of_free = 0;
  int64_t of_touched = 0;
  int64_t of_system = 0;
  int64_t of_product = 0;
  int64_t of_other = 0;
  int64_t of_slopes = 0;
  int64_t of_gains = 0;
  int64_t of_steps = 0;
  int64_t of_course = 0;
  int64_t of_rest = 0;
  int64_t of_readings = 0;
  vector rest;
  vector vectors;
  Scratch made;
  n = job->n_states;
  m = estimator_job->n_free;
  n_c = estimator_job->n_channels;
  n_u = job->n_inputs;
  q = estimator_job->n_places + estimator_job->n_touched_inputs;
  total = n + m;
  steps = estimator_job->n_onsets * estimator_job->n_faults;
  of_free = estimator_job->memory + 8 * 3 * n * n;
  of_touched = of_free + 8 * 3 * n * m;
  of_system = of_touched + 8 * n * q;
  of_product = of_system + 8 * 3 * n * (2 * n + total);
  of_other = of_product + 8 * n * total;
  of_slopes = of_other + 8 * total * total;
  of_gains = of_slopes + 8 * n_c * total;
  of_steps = of_gains + 8 * n_c * total;
  of_course = of_steps + 8 * n * steps;
  of_rest = of_course + 8 * 7 * n_u;
  of_readings = n_c * (4 + n + q) + steps;
  rest = vector_at(of_rest, of_readings + 5 * total + job->n_memory + n_u);
  vectors = part_of(rest, of_readings, rest.size);
  made.by_state = matrix_at(estimator_job->memory, 3, n * n);
  made.by_free = matrix_at(of_free, 3, n * m);
  made.by_touched = vector_at(of_touched, n * q);
  made.start_system = matrix_at(of_system, n, 2 * n + total);
  made.linear_system = matrix_at(of_system + 8 * n * (2 * n + total), 2 * n, 2 * n + total);
  made.product = matrix_at(of_product, n, total);
  made.other = matrix_at(of_other, total, total);
  made.y = part_of(rest, 0, n_c);
  made.forecast = part_of(rest, n_c, 2 * n_c);
  made.y_by_state = part_of(rest, 4 * n_c, (4 + n) * n_c);
  made.y_by_touched = part_of(rest, (4 + n) * n_c, (4 + n + q) * n_c);
  made.slopes = matrix_at(of_slopes, n_c, total);
  made.gains = matrix_at(of_gains, n_c, total);
  made.steps = matrix_at(of_steps, n, steps);
  made.effects = part_of(rest, (4 + n + q) * n_c, of_readings);
  made.variances = part_of(rest, 2 * n_c, 3 * n_c);
  made.sequence = part_of(rest, 3 * n_c, 4 * n_c);
  made.moved = part_of(vectors, 0, total);
  made.correction = part_of(vectors, total, 2 * total);
  made.shift = part_of(vectors, 2 * total, 3 * total);
  made.gain = part_of(vectors, 3 * total, 4 * total);
  made.image = part_of(vectors, 4 * total, 5 * total);
  made.course = matrix_at(of_course, n_u, 7);
  made.kept = part_of(vectors, 5 * total, 5 * total + job->n_memory);
  made.before = part_of(vectors, 5 * total + job->n_memory, vectors.size);
  return made;
}

/* Return the arrays of an EstimatorJob. */
static Estimator do_estimator_of(const EstimatorJob *estimator_job, const Job *job) {
  int64_t n = 0;
  int64_t m = 0;
  int64_t n_c = 0;
  int64_t n_places = 0;
  int64_t q = 0;
  int64_t total = 0;
  int64_t n_onsets = 0;
  int64_t n_faults = 0;
  Estimator made;
  n = job->n_states;
  m = estimator_job->n_free;
  n_c = estimator_job->n_channels;
  n_places = estimator_job->n_places;
  q = n_places + estimator_job->n_touched_inputs;
  total = n + m;
  n_onsets = estimator_job->n_onsets;
  n_faults = estimator_job->n_faults;
  made.linear = estimator_job->linear;
  made.observe = estimator_job->observe;
  made.clock = vector_at(estimator_job->clock, 2);
  made.mean = vector_at(estimator_job->mean, total);
  made.covariance = matrix_at(estimator_job->covariance, total, total);
  made.u = matrix_at(estimator_job->u, 2, job->n_inputs);
  made.places = integers_at(estimator_job->places, n_places);
  made.touched_inputs = integers_at(estimator_job->touched_inputs, estimator_job->n_touched_inputs);
  made.base = vector_at(estimator_job->base, q);
  made.directions = matrix_at(estimator_job->directions, q, m);
  made.reference = vector_at(estimator_job->reference, m);
  made.low = vector_at(estimator_job->low, m);
  made.high = vector_at(estimator_job->high, m);
  made.effects = matrix_at(estimator_job->effects, n_c, m);
  made.readings = vector_at(estimator_job->readings, n_c);
  made.noise = vector_at(estimator_job->noise, n_c);
  made.gates = vector_at(estimator_job->gates, n_c);
  made.walk = vector_at(estimator_job->walk, total);
  made.cap = vector_at(estimator_job->cap, total);
  made.expected = vector_at(estimator_job->expected, n_c);
  made.innovations = vector_at(estimator_job->innovations, n_c);
  made.deviations = vector_at(estimator_job->deviations, n_c);
  made.used = vector_at(estimator_job->used, n_c);
  made.rejected = vector_at(estimator_job->rejected, n_c);
  made.outside = vector_at(estimator_job->outside, n_c);
  made.scores = vector_at(estimator_job->scores, 1);
  made.transition = matrix_at(estimator_job->transition, n, total);
  made.signatures = matrix_at(estimator_job->signatures, total, n_onsets * n_faults);
  made.numerators = matrix_at(estimator_job->numerators, n_onsets, n_faults);
  made.gram = matrix_at(estimator_job->gram, n_onsets, n_faults * n_faults);
  made.scratch = do_scratch_of(estimator_job, job);
  return made;
}

/* Write parameters and inputs for the free numbers of an estimate mean. */
static void do_set_numbers(const Estimator *est, const RunState *run, vector mean) {
  int64_t n = 0;
  int64_t n_places = 0;
  int64_t i = 0;
  double value = 0.0;
  int64_t j = 0;
  int64_t k = 0;
  n = run->x.size;
  n_places = est->places.size;
  for (i = 0; i < est->base.size; i++) {
    value = est->base.at[i];
    for (j = 0; j < est->reference.size; j++) {
      value += (est->directions.at[i * est->directions.columns + j] * (mean.at[n + j] - est->reference.at[j]));
    }
    if (i < n_places) {
      run->memory.p.at[est->places.at[i]] = value;
    } else {
      k = est->touched_inputs.at[i - n_places];
      est->u.at[1 * est->u.columns + k] = value;
      est->u.at[0 * est->u.columns + k] = est->u.at[1 * est->u.columns + k];
    }
  }
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

/* Write the inputs, linear over the interval from t to t + dt, as coefficients of a segment. The result is True if an
   input has jumped since the last interval. */
static int do_set_course(const Estimator *est, double t, double dt) {
  const Scratch *s;
  int jumps = 0;
  int64_t j = 0;
  int64_t k = 0;
  s = &est->scratch;
  jumps = 0;
  for (j = 0; j < est->touched_inputs.size; j++) {
    s->before.at[est->touched_inputs.at[j]] = est->u.at[0 * est->u.columns + est->touched_inputs.at[j]];
  }
  for (k = 0; k < s->before.size; k++) {
    jumps = jumps || (est->u.at[0 * est->u.columns + k] != s->before.at[k]);
    s->course.at[k * s->course.columns + 0] = est->u.at[0 * est->u.columns + k];
    s->course.at[k * s->course.columns + 6] = t;
    s->course.at[k * s->course.columns + 1] = (est->u.at[1 * est->u.columns + k] - est->u.at[0 * est->u.columns + k]) / dt;
    s->before.at[k] = est->u.at[1 * est->u.columns + k];
  }
  return jumps;
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

/* Compute the inputs at all solver stages of a step from t to t + h. */
static void do_stage_inputs(const RunState *run, Segment segment, double t, double h) {
  int64_t n = 0;
  int64_t i = 0;
  n = run->work.u.size;
  for (i = 0; i < 4; i++) {
    do_inputs_at(t + INPUT_TIMES[i & 3] * h, segment, part_of(run->work.us, i * n, (i + 1) * n));
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

/* Compute the derivatives of the rates by states and free numbers at the state x and the time t of a segment. They are
   stored as those of a node of the step: 0 for the start, 1 for the middle, 2 for the end. */
static void do_linearise(const Estimator *est, const RunState *run, Segment segment, double t, vector x, int64_t node) {
  const Work *w;
  const Scratch *s;
  int64_t n = 0;
  int64_t j = 0;
  int64_t r = 0;
  int64_t i = 0;
  double direction = 0.0;
  w = &run->work;
  s = &est->scratch;
  n = run->x.size;
  w->tt.at[0] = t;
  do_inputs_at(t, segment, w->u);
  ((of_linear *)(intptr_t)est->linear)(w->tt.at, x.at, w->u.at, run->memory.p.at, row_of(s->by_state, node).at, s->by_touched.at);
  for (j = 0; j < est->reference.size; j++) {
    for (r = 0; r < n; r++) {
      s->by_free.at[node * s->by_free.columns + (j * n + r)] = 0.0;
    }
    for (i = 0; i < est->base.size; i++) {
      direction = est->directions.at[i * est->directions.columns + j];
      if (direction != 0.0) {
        for (r = 0; r < n; r++) {
          s->by_free.at[node * s->by_free.columns + (j * n + r)] += (s->by_touched.at[i * n + r] * direction);
        }
      }
    }
  }
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

/* Return the number of equal parts of a step of length h for the transition. The errors of the states determine the
   step, not those of their derivatives: a fast mode at rest permits a long step. The number therefore depends on
   the norm of the Jacobian in the middle, with the sizes of the states. */
static int64_t do_parts(const Estimator *est, const RunState *run, double h) {
  int64_t n = 0;
  matrix sizes;
  double largest = 0.0;
  int64_t r = 0;
  double total = 0.0;
  int64_t c = 0;
  n = run->x.size;
  sizes = run->control.tolerances;
  largest = 0.0;
  for (r = 0; r < n; r++) {
    total = 0.0;
    for (c = 0; c < n; c++) {
      total += (fabs(est->scratch.by_state.at[1 * est->scratch.by_state.columns + (c * n + r)]) * sizes.at[2 * sizes.columns + c]);
    }
    largest = most(largest, h * total / sizes.at[2 * sizes.columns + r]);
  }
  return (largest < SLOW) ? 1 : MOST_PARTS;
}

/* Return the element k of derivatives at start, middle and end of a step, at a position from 0 to 1. The result is the
   value of the parabola. */
static double do_interpolated(matrix derivatives, int64_t k, double position) {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;
  if ((position == 0.0) || (position == 1.0)) {
    return (position == 0.0) ? derivatives.at[0 * derivatives.columns + k] : derivatives.at[2 * derivatives.columns + k];
  }
  a = (1.0 - 2.0 * position) * (1.0 - position);
  b = 4.0 * position * (1.0 - position);
  c = position * (2.0 * position - 1.0);
  return a * derivatives.at[0 * derivatives.columns + k] + b * derivatives.at[1 * derivatives.columns + k] + c * derivatives.at[2 * derivatives.columns + k];
}

/* Solve a linear system by elimination with row pivoting, for its last n unknowns. The right-hand sides are the
   columns after the square matrix, and the solutions replace them. */
static void do_solve(matrix system, int64_t n) {
  int64_t size = 0;
  int64_t width = 0;
  int64_t k = 0;
  int64_t pivot = 0;
  double largest = 0.0;
  int64_t r = 0;
  int64_t c = 0;
  double value = 0.0;
  double inverse = 0.0;
  double factor = 0.0;
  int64_t i = 0;
  int64_t q = 0;
  size = system.rows;
  width = system.columns;
  for (k = 0; k < size; k++) {
    pivot = k;
    largest = fabs(system.at[k * system.columns + k]);
    for (r = k + 1; r < size; r++) {
      if (fabs(system.at[r * system.columns + k]) > largest) {
        pivot = r;
        largest = fabs(system.at[r * system.columns + k]);
      }
    }
    if (pivot != k) {
      for (c = k; c < width; c++) {
        value = system.at[k * system.columns + c];
        system.at[k * system.columns + c] = system.at[pivot * system.columns + c];
        system.at[pivot * system.columns + c] = value;
      }
    }
    inverse = 1.0 / system.at[k * system.columns + k];
    for (r = k + 1; r < size; r++) {
      factor = system.at[r * system.columns + k] * inverse;
      if (factor != 0.0) {
        for (c = k + 1; c < width; c++) {
          system.at[r * system.columns + c] -= (factor * system.at[k * system.columns + c]);
        }
      }
    }
  }
  for (i = 0; i < n; i++) {
    r = size - 1 - i;
    for (q = r + 1; q < size; q++) {
      factor = system.at[r * system.columns + q];
      if (factor != 0.0) {
        for (c = size; c < width; c++) {
          system.at[r * system.columns + c] -= (factor * system.at[q * system.columns + c]);
        }
      }
    }
    inverse = 1.0 / system.at[r * system.columns + r];
    for (c = size; c < width; c++) {
      system.at[r * system.columns + c] *= inverse;
    }
  }
}

/* Compute the matrix at the start of a part of a step, for given matrices at its middle and end. (3 - h A_0) Psi_0 = 6
   Psi + [0, h B_0] - 4 Psi_1 + Psi_2. The right-hand sides of the solution are the identity, the factor on Psi_2 -
   4 Psi_1, and the constant rest. h is the length of the part, and position is its start in the step. */
static void do_solve_start(const Estimator *est, const RunState *run, double h, double position) {
  const Scratch *s;
  matrix system;
  int64_t n = 0;
  matrix sizes;
  int64_t r = 0;
  double scale = 0.0;
  int64_t c = 0;
  s = &est->scratch;
  system = est->scratch.start_system;
  n = run->x.size;
  sizes = run->control.tolerances;
  for (r = 0; r < n; r++) {
    scale = 1.0 / sizes.at[2 * sizes.columns + r];
    for (c = 0; c < n; c++) {
      system.at[r * system.columns + c] = -scale * h * do_interpolated(s->by_state, c * n + r, position);
      system.at[r * system.columns + (n + c)] = 0.0;
    }
    system.at[r * system.columns + r] += (3.0 * scale);
    system.at[r * system.columns + (n + r)] = scale;
    for (c = 0; c < est->mean.size; c++) {
      system.at[r * system.columns + (2 * n + c)] = 6.0 * scale * est->transition.at[r * est->transition.columns + c];
    }
    for (c = 0; c < est->reference.size; c++) {
      system.at[r * system.columns + (3 * n + c)] += (scale * h * do_interpolated(s->by_free, c * n + r, position));
    }
  }
  do_solve(system, n);
}

/* Multiply the transition by that of a part of a step of length h. The part begins at the position first of the step,
   from 0 to 1, and its length is fraction of the step. The unknowns are the matrices Psi at the three nodes of
   Lobatto IIIC: Psi_i = Psi + h sum_j a_ij (A_j Psi_j + [0, B_j]), where Psi is the present transition and the last
   Psi_j the next one. Multiplied by the inverse of the coefficients a, each equation contains the derivatives at
   one node only:: (3 - h A_0) Psi_0 + 4 Psi_1 - Psi_2 = 6 Psi + [0, h B_0] - Psi_0 - h A_1 Psi_1 + Psi_2 = [0, h
   B_1] Psi_0 - 4 Psi_1 + (3 - h A_2) * Psi_2 = [0, h B_2] The solution of the first equation is inserted into the
   others. Each equation is divided by the size of its state. */
static void do_advance_part(const Estimator *est, const RunState *run, double h, double first, double fraction) {
  const Scratch *s;
  int64_t n = 0;
  matrix sizes;
  double length = 0.0;
  matrix start;
  matrix system;
  double middle = 0.0;
  double end = 0.0;
  int64_t r = 0;
  double scale = 0.0;
  int64_t c = 0;
  double factor = 0.0;
  double rest = 0.0;
  s = &est->scratch;
  n = run->x.size;
  sizes = run->control.tolerances;
  length = h * fraction;
  start = s->start_system;
  system = s->linear_system;
  middle = first + 0.5 * fraction;
  end = first + fraction;
  do_solve_start(est, run, length, first);
  for (r = 0; r < n; r++) {
    scale = 1.0 / sizes.at[2 * sizes.columns + r];
    for (c = 0; c < n; c++) {
      factor = start.at[r * start.columns + (n + c)];
      system.at[r * system.columns + c] = scale * (4.0 * factor - length * do_interpolated(s->by_state, c * n + r, middle));
      system.at[r * system.columns + (n + c)] = -scale * factor;
      system.at[(n + r) * system.columns + c] = -4.0 * scale * factor;
      system.at[(n + r) * system.columns + (n + c)] = scale * (factor - length * do_interpolated(s->by_state, c * n + r, end));
    }
    system.at[r * system.columns + (n + r)] += scale;
    system.at[(n + r) * system.columns + r] -= (4.0 * scale);
    system.at[(n + r) * system.columns + (n + r)] += (3.0 * scale);
    for (c = 0; c < est->mean.size; c++) {
      rest = scale * start.at[r * start.columns + (2 * n + c)];
      system.at[r * system.columns + (2 * n + c)] = rest;
      system.at[(n + r) * system.columns + (2 * n + c)] = -rest;
    }
    for (c = 0; c < est->reference.size; c++) {
      system.at[r * system.columns + (3 * n + c)] += (scale * length * do_interpolated(s->by_free, c * n + r, middle));
      system.at[(n + r) * system.columns + (3 * n + c)] += (scale * length * do_interpolated(s->by_free, c * n + r, end));
    }
  }
  do_solve(system, n);
  for (r = 0; r < n; r++) {
    for (c = 0; c < est->mean.size; c++) {
      est->transition.at[r * est->transition.columns + c] = system.at[(n + r) * system.columns + (2 * n + c)];
    }
  }
}

/* Multiply the transition by that of an accepted step of length h. */
static void do_advance_transition(const Estimator *est, const RunState *run, double h) {
  int64_t parts = 0;
  int64_t k = 0;
  parts = do_parts(est, run, h);
  for (k = 0; k < parts; k++) {
    do_advance_part(est, run, h, 1.0 * k / parts, 1.0 / parts);
  }
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

/* Integrate states and transition over a segment, and return status and next step length. If h is positive, it is the
   length of the first step. Otherwise the rates determine this length; if h is negative, -h is the maximum. Steps
   end at sample instants. */
static void do_integrate(const Estimator *est, const RunState *run, Segment segment, double h, int64_t *r0, double *r1) {
  const Work *w;
  const Scratch *s;
  integers counts;
  int64_t n = 0;
  double t = 0.0;
  double stop = 0.0;
  int has_timers = 0;
  int moves = 0;
  double error_before = 0.0;
  double step_before = 0.0;
  int rejected = 0;
  int fresh = 0;
  int linear = 0;
  double desired = 0.0;
  double goal = 0.0;
  double end = 0.0;
  double error = 0.0;
  Step step;
  int64_t r = 0;
  int64_t k = 0;
  double factor = 0.0;
  w = &run->work;
  s = &est->scratch;
  counts = run->counts;
  n = run->x.size;
  t = segment.start;
  stop = segment.stop;
  has_timers = run->memory.fired.size > 0;
  moves = do_varies(segment);
  error_before = 0.01;
  step_before = 0.0;
  rejected = 0;
  fresh = 1;
  linear = 0;
  do_stage_inputs(run, segment, t, 0.0);
  if (has_timers) {
    do_act(run, segment, t, run->x);
  }
  while (t < stop) {
    if (fresh) {
      h = do_begin(run, segment, t, h);
      fresh = 0;
    }
    do_reach(run, segment, t, h, t, 1, &desired, &goal);
    h = do_length(desired, goal - t);
    if (moves) {
      do_stage_inputs(run, segment, t, h);
    }
    end = (h >= ((goal - t) * (1.0 - 1e-12))) ? goal : (t + h);
    w->tt.at[0] = t;
    w->tt.at[1] = h;
    ((of_step *)(intptr_t)run->functions.step)(w->tt.at, run->x.at, w->us.at, run->memory.p.at, w->rates.at, w->jacobian.at, w->drift.at, w->scratch.at, w->stages.at, w->new_x.at);
    error = do_error(run);
    counts.at[ATTEMPTS] += 1;
    if (error <= 1.0) {
      counts.at[ACCEPTED] += 1;
      ((of_dense *)(intptr_t)run->functions.dense)(w->stages.at, w->dense.at);
      step.t = t;
      step.h = h;
      step.end = end;
      step.new_x = w->new_x;
      if (!linear) {
        do_linearise(est, run, segment, t, run->x, 0);
      }
      do_interpolate(run, step, 0.5, w->inside);
      do_linearise(est, run, segment, t + 0.5 * h, w->inside, 1);
      do_linearise(est, run, segment, end, w->new_x, 2);
      do_advance_transition(est, run, h);
      for (r = 0; r < n; r++) {
        run->x.at[r] = w->new_x.at[r];
      }
      for (k = 0; k < (n * n); k++) {
        s->by_state.at[0 * s->by_state.columns + k] = s->by_state.at[2 * s->by_state.columns + k];
      }
      for (k = 0; k < (n * est->reference.size); k++) {
        s->by_free.at[0 * s->by_free.columns + k] = s->by_free.at[2 * s->by_free.columns + k];
      }
      t = end;
      fresh = 1;
      linear = 1;
      error = most(error, 1e-10);
      factor = do_growth(error, h, error_before, step_before);
      step_before = h;
      error_before = most(0.01, error);
      h = (h < desired) ? most(desired, h * factor) : (h * (rejected ? least(1.0, factor) : factor));
      rejected = 0;
      if (has_timers && (t < (stop - do_rounding(stop))) && do_act(run, segment, t, run->x)) {
        h = -h;
        step_before = 0.0;
        linear = 0;
      }
    } else {
      h *= (is_finite(error) ? most(SHRINK, least(0.8, SAFETY / do_fourth_root(error))) : SHRINK);
      rejected = 1;
      if (((t + h) <= t) || (h < 1e-300)) {
        *r0 = STALLED;
        *r1 = 0.0;
        return;
      }
    }
    if (counts.at[ATTEMPTS] >= run->control.most) {
      *r0 = TOO_MANY;
      *r1 = 0.0;
      return;
    }
  }
  *r0 = DONE;
  *r1 = fabs(h);
  return;
}

/* Run the timers of a model without states up to the end of a segment. */
static void do_act_in(const RunState *run, Segment segment) {
  double t = 0.0;
  double limit = 0.0;
  t = segment.start;
  limit = segment.stop - do_rounding(segment.stop);
  while (t < limit) {
    do_act(run, segment, t, run->x);
    t = do_next_instant(&run->memory);
  }
}

/* Compute the covariance at the end of an interval, F P F' + walk dt, and return True if it is finite. A variance
   above its cap is reduced to the cap, with all correlations unchanged. So the variance of a free number about
   which the readings contain no information returns to its cap, and a combination that they determine remains
   determined. The result is stored in other. */
static int do_spread(const Estimator *est, int64_t n, double dt) {
  const Scratch *s;
  int64_t total = 0;
  int finite = 0;
  int64_t r = 0;
  int64_t c = 0;
  int64_t q = 0;
  double factor = 0.0;
  double value = 0.0;
  double variance = 0.0;
  s = &est->scratch;
  total = est->mean.size;
  finite = 1;
  for (r = 0; r < n; r++) {
    for (c = 0; c < total; c++) {
      s->product.at[r * s->product.columns + c] = 0.0;
    }
    for (q = 0; q < total; q++) {
      factor = est->transition.at[r * est->transition.columns + q];
      if (factor != 0.0) {
        for (c = 0; c < total; c++) {
          s->product.at[r * s->product.columns + c] += (factor * est->covariance.at[q * est->covariance.columns + c]);
        }
      }
    }
  }
  for (r = 0; r < n; r++) {
    for (c = r; c < n; c++) {
      value = 0.0;
      for (q = 0; q < total; q++) {
        value += (s->product.at[r * s->product.columns + q] * est->transition.at[c * est->transition.columns + q]);
      }
      s->other.at[c * s->other.columns + r] = value;
      s->other.at[r * s->other.columns + c] = s->other.at[c * s->other.columns + r];
    }
    for (c = n; c < total; c++) {
      s->other.at[c * s->other.columns + r] = s->product.at[r * s->product.columns + c];
      s->other.at[r * s->other.columns + c] = s->other.at[c * s->other.columns + r];
    }
  }
  for (r = n; r < total; r++) {
    for (c = n; c < total; c++) {
      s->other.at[r * s->other.columns + c] = est->covariance.at[r * est->covariance.columns + c];
    }
  }
  for (r = 0; r < total; r++) {
    variance = s->other.at[r * s->other.columns + r] * (1.0 + ROUNDING) + est->walk.at[r] * dt;
    s->other.at[r * s->other.columns + r] = variance;
    if (variance > est->cap.at[r]) {
      factor = sqrt(est->cap.at[r] / variance);
      for (c = 0; c < total; c++) {
        s->other.at[r * s->other.columns + c] *= factor;
        s->other.at[c * s->other.columns + r] *= factor;
      }
    }
  }
  for (r = 0; r < total; r++) {
    for (c = 0; c < total; c++) {
      finite = finite && is_finite(s->other.at[r * s->other.columns + c]);
    }
  }
  return finite;
}

/* Advance the signatures of the steps of faults by the interval, with the transition. */
static void do_move_signatures(const Estimator *est, int64_t n) {
  matrix steps;
  int64_t total = 0;
  int64_t r = 0;
  int64_t k = 0;
  int64_t q = 0;
  double factor = 0.0;
  steps = est->scratch.steps;
  total = est->mean.size;
  for (r = 0; r < n; r++) {
    for (k = 0; k < steps.columns; k++) {
      steps.at[r * steps.columns + k] = 0.0;
    }
    for (q = 0; q < total; q++) {
      factor = est->transition.at[r * est->transition.columns + q];
      if (factor != 0.0) {
        for (k = 0; k < steps.columns; k++) {
          steps.at[r * steps.columns + k] += (factor * est->signatures.at[q * est->signatures.columns + k]);
        }
      }
    }
  }
  for (r = 0; r < n; r++) {
    for (k = 0; k < steps.columns; k++) {
      est->signatures.at[r * est->signatures.columns + k] = steps.at[r * steps.columns + k];
    }
  }
}

/* Advance the estimate by the interval, and return the status. A failed prediction does not change time, mean,
   covariance and discrete states. */
static int64_t do_predict(const Estimator *est, const RunState *run, vector limits, matrix scales) {
  const Scratch *s;
  int64_t n = 0;
  int64_t total = 0;
  double t = 0.0;
  double dt = 0.0;
  vector z;
  double stop = 0.0;
  int64_t status = 0;
  double h = 0.0;
  int64_t k = 0;
  int64_t c = 0;
  Segment segment;
  int64_t r = 0;
  s = &est->scratch;
  n = run->x.size;
  total = est->mean.size;
  t = est->clock.at[0];
  dt = est->clock.at[1];
  z = run->memory.z;
  if (!((dt >= 0.0) && is_finite(t + dt))) {
    return NOT_FINITE;
  }
  stop = t + dt;
  status = DONE;
  h = run->work.tt.at[1];
  for (k = 0; k < n; k++) {
    run->x.at[k] = est->mean.at[k];
    for (c = 0; c < total; c++) {
      est->transition.at[k * est->transition.columns + c] = (c == k) ? 1.0 : 0.0;
    }
  }
  for (k = 0; k < z.size; k++) {
    s->kept.at[k] = z.at[k];
  }
  do_set_numbers(est, run, est->mean);
  if (limits.at[3] > 0.0) {
    do_set_tolerances(&run->control, scales, limits.at[3], run->x);
    limits.at[3] = 0.0;
    h = 0.0;
  }
  run->counts.at[ATTEMPTS] = 0;
  run->counts.at[ACCEPTED] = run->counts.at[ATTEMPTS];
  if (stop > t) {
    h = do_set_course(est, t, stop - t) ? -h : h;
    segment.start = t;
    segment.stop = stop;
    segment.inputs = s->course;
    if (n > 0) {
      do_integrate(est, run, segment, h, &status, &h);
    } else {
      do_act_in(run, segment);
    }
  }
  run->work.tt.at[1] = h;
  if ((status == DONE) && !do_spread(est, n, dt)) {
    status = NOT_FINITE;
  }
  if (status == DONE) {
    for (k = 0; k < n; k++) {
      est->mean.at[k] = run->x.at[k];
    }
    for (r = 0; r < total; r++) {
      for (c = 0; c < total; c++) {
        est->covariance.at[r * est->covariance.columns + c] = s->other.at[r * s->other.columns + c];
      }
    }
    do_move_signatures(est, n);
    est->clock.at[0] = stop;
  } else {
    run->work.tt.at[1] = 0.0;
    for (k = 0; k < z.size; k++) {
      z.at[k] = s->kept.at[k];
    }
  }
  return status;
}

/* Compute the readings y for an estimate mean, and their derivatives by states and free numbers. The result is True if
   they are finite. */
static int do_observe(const Estimator *est, const RunState *run, vector mean) {
  const Work *w;
  const Scratch *s;
  int64_t n = 0;
  int64_t n_c = 0;
  int finite = 0;
  int64_t c = 0;
  int64_t k = 0;
  int64_t j = 0;
  double slope = 0.0;
  int64_t i = 0;
  w = &run->work;
  s = &est->scratch;
  n = run->x.size;
  n_c = est->readings.size;
  finite = 1;
  do_set_numbers(est, run, mean);
  w->tt.at[0] = est->clock.at[0];
  ((of_observe *)(intptr_t)est->observe)(w->tt.at, mean.at, row_of(est->u, 1).at, run->memory.p.at, s->y.at, s->y_by_state.at, s->y_by_touched.at);
  for (c = 0; c < n_c; c++) {
    for (k = 0; k < n; k++) {
      s->slopes.at[c * s->slopes.columns + k] = s->y_by_state.at[k * n_c + c];
    }
    for (j = 0; j < est->reference.size; j++) {
      slope = est->effects.at[c * est->effects.columns + j];
      s->y.at[c] += (slope * (mean.at[n + j] - est->reference.at[j]));
      for (i = 0; i < est->base.size; i++) {
        slope += (s->y_by_touched.at[i * n_c + c] * est->directions.at[i * est->directions.columns + j]);
      }
      s->slopes.at[c * s->slopes.columns + (n + j)] = slope;
    }
    finite = finite && is_finite(s->y.at[c]);
    for (k = 0; k < mean.size; k++) {
      finite = finite && is_finite(s->slopes.at[c * s->slopes.columns + k]);
    }
  }
  return finite;
}

/* Return the variance of an innovation, and write the product of covariance and slopes into image. */
static double do_variance(const Estimator *est, vector slopes, double noise) {
  vector image;
  double variance = 0.0;
  int64_t r = 0;
  double value = 0.0;
  int64_t c = 0;
  image = est->scratch.image;
  variance = noise;
  for (r = 0; r < image.size; r++) {
    value = 0.0;
    for (c = 0; c < image.size; c++) {
      value += (est->covariance.at[r * est->covariance.columns + c] * slopes.at[c]);
    }
    image.at[r] = value;
    variance += (slopes.at[r] * value);
  }
  return variance;
}

/* Compute innovations of all channels with their standard deviations, and decide which readings are used. The decision
   on a reading does not depend on the other readings. A reading outside its gate is rejected, unless it follows
   several rejected readings on the same side, and agrees with the last of them. */
static void do_select(const Estimator *est) {
  int64_t c = 0;
  double variance = 0.0;
  double innovation = 0.0;
  double side = 0.0;
  double jump = 0.0;
  for (c = 0; c < est->readings.size; c++) {
    variance = do_variance(est, row_of(est->scratch.slopes, c), est->noise.at[c]);
    innovation = est->readings.at[c] - est->scratch.y.at[c];
    est->expected.at[c] = est->scratch.y.at[c];
    est->innovations.at[c] = innovation;
    est->deviations.at[c] = sqrt(variance);
    est->used.at[c] = 1.0;
    if (!(is_finite(innovation) && is_finite(variance))) {
      est->used.at[c] = 0.0;
    } else if ((innovation * innovation) > (est->gates.at[c] * variance)) {
      side = (innovation > 0.0) ? 1.0 : -1.0;
      if ((side * est->rejected.at[c]) < 0.0) {
        est->rejected.at[c] = 0.0;
      }
      jump = innovation - est->outside.at[c];
      if ((side * est->rejected.at[c]) < LASTING) {
        est->rejected.at[c] += side;
        est->used.at[c] = -1.0;
      } else if ((jump * jump) > (2.0 * est->gates.at[c] * est->noise.at[c])) {
        est->used.at[c] = -1.0;
      }
      est->outside.at[c] = innovation;
    } else {
      est->rejected.at[c] = 0.0;
    }
  }
}

/* Correct estimate and covariance with the reading of the channel c, and return its squared normalised innovation. The
   covariance has the form of Bucy and Joseph, (I - k h) P (I - k h)' + k r k', which remains positive with rounding
   errors. */
static double do_use_reading(const Estimator *est, int64_t c) {
  const Scratch *s;
  int64_t total = 0;
  vector slopes;
  matrix p;
  double variance = 0.0;
  double innovation = 0.0;
  int64_t k = 0;
  int64_t r = 0;
  double gain = 0.0;
  double value = 0.0;
  s = &est->scratch;
  total = est->mean.size;
  slopes = row_of(est->scratch.slopes, c);
  p = est->covariance;
  variance = do_variance(est, slopes, est->noise.at[c]);
  innovation = est->readings.at[c] - s->y.at[c];
  for (k = 0; k < total; k++) {
    innovation -= (slopes.at[k] * (s->correction.at[k] - s->shift.at[k]));
    s->gains.at[c * s->gains.columns + k] = s->image.at[k] / variance;
    s->gain.at[k] = s->gains.at[c * s->gains.columns + k];
  }
  s->variances.at[c] = variance;
  s->sequence.at[c] = innovation;
  for (r = 0; r < total; r++) {
    gain = s->gain.at[r];
    s->correction.at[r] += (gain * innovation);
    for (k = 0; k < total; k++) {
      p.at[r * p.columns + k] -= (gain * s->image.at[k]);
    }
  }
  for (r = 0; r < total; r++) {
    value = 0.0;
    for (k = 0; k < total; k++) {
      value += (p.at[r * p.columns + k] * slopes.at[k]);
    }
    s->image.at[r] = value;
  }
  for (r = 0; r < total; r++) {
    for (k = r; k < total; k++) {
      p.at[r * p.columns + k] += (s->gain.at[k] * (est->noise.at[c] * s->gain.at[r] - s->image.at[r]));
      p.at[k * p.columns + r] = p.at[r * p.columns + k];
    }
  }
  return innovation * innovation / variance;
}

/* Correct the estimate with all accepted readings, and return the sum of their squared normalised innovations. */
static double do_use_all(const Estimator *est) {
  double nis = 0.0;
  int64_t k = 0;
  int64_t c = 0;
  nis = 0.0;
  for (k = 0; k < est->mean.size; k++) {
    est->scratch.correction.at[k] = 0.0;
  }
  for (c = 0; c < est->readings.size; c++) {
    if (est->used.at[c] > 0.0) {
      nis += do_use_reading(est, c);
    }
  }
  return nis;
}

/* Return the lower limit of the estimate k. */
static double do_low(const Estimator *est, const RunState *run, int64_t k) {
  int64_t n = 0;
  n = run->x.size;
  if (k >= n) {
    return est->low.at[k - n];
  }
  return run->control.positive.at[k] ? (LEAST_FRACTION * est->mean.at[k]) : -HUGE_VAL;
}

/* Move a corrected estimate into its limits, along the covariance. The result is the most probable estimate with the
   violated limit, as for a reading without noise. Other estimates therefore move with their correlation. The
   covariance is unchanged. The method repeats the projection, because the limits of others can be violated by it. */
static void do_move_inside(const Estimator *est, const RunState *run, vector mean) {
  int64_t n = 0;
  matrix p;
  int64_t sweep = 0;
  int64_t k = 0;
  double low = 0.0;
  double high = 0.0;
  double limit = 0.0;
  double factor = 0.0;
  int64_t j = 0;
  n = run->x.size;
  p = est->covariance;
  for (sweep = 0; sweep < 3; sweep++) {
    for (k = 0; k < mean.size; k++) {
      low = do_low(est, run, k);
      high = (k >= n) ? est->high.at[k - n] : HUGE_VAL;
      limit = least(most(mean.at[k], low), high);
      if (limit != mean.at[k]) {
        factor = ((p.at[k * p.columns + k] > 0.0) && (sweep < 2)) ? ((limit - mean.at[k]) / p.at[k * p.columns + k]) : 0.0;
        for (j = 0; j < mean.size; j++) {
          mean.at[j] += (factor * p.at[j * p.columns + k]);
        }
        mean.at[k] = limit;
      }
    }
  }
}

/* Write the corrected estimate into moved, and return True if it is finite. */
static int do_move(const Estimator *est, const RunState *run) {
  const Scratch *s;
  int finite = 0;
  int64_t k = 0;
  int64_t j = 0;
  s = &est->scratch;
  finite = 1;
  for (k = 0; k < est->mean.size; k++) {
    s->moved.at[k] = est->mean.at[k] + s->correction.at[k];
  }
  do_move_inside(est, run, s->moved);
  for (k = 0; k < est->mean.size; k++) {
    finite = finite && is_finite(s->moved.at[k]);
    for (j = 0; j < est->mean.size; j++) {
      finite = finite && is_finite(est->covariance.at[k * est->covariance.columns + j]);
    }
  }
  return finite;
}

/* Return True if the readings are nonlinear over the correction. If True, readings and derivatives are those of the
   corrected estimate, and shift is its distance. */
static int do_is_curved(const Estimator *est, const RunState *run) {
  const Scratch *s;
  int is_far = 0;
  int is_curved = 0;
  int64_t c = 0;
  int64_t k = 0;
  double difference = 0.0;
  s = &est->scratch;
  is_far = 0;
  is_curved = 0;
  for (c = 0; c < est->readings.size; c++) {
    s->forecast.at[c] = 0.0;
    for (k = 0; k < est->mean.size; k++) {
      s->forecast.at[c] += (s->slopes.at[c * s->slopes.columns + k] * (s->moved.at[k] - est->mean.at[k]));
    }
    is_far = is_far || ((est->used.at[c] > 0.0) && ((s->forecast.at[c] * s->forecast.at[c]) > (MOVED * MOVED * est->noise.at[c])));
  }
  if (!is_far || !do_observe(est, run, s->moved)) {
    return 0;
  }
  for (c = 0; c < est->readings.size; c++) {
    difference = s->y.at[c] - (est->expected.at[c] + s->forecast.at[c]);
    is_curved = is_curved || ((est->used.at[c] > 0.0) && ((difference * difference) > (CURVED * CURVED * est->noise.at[c])));
  }
  for (k = 0; k < est->mean.size; k++) {
    s->shift.at[k] = s->moved.at[k] - est->mean.at[k];
  }
  return is_curved;
}

/* Add the used readings to the evidence for steps of the faults, and correct the signatures. The likelihood ratio of
   steps at unknown times (Willsky & Jones 1976, IEEE Trans. Autom. Control 21, 108-112) needs the effect h of each
   step on the innovations of the filter, which assumes no step. */
static void do_weigh_onsets(const Estimator *est) {
  const Scratch *s;
  int64_t total = 0;
  int64_t n_faults = 0;
  vector effects;
  int64_t c = 0;
  int64_t k = 0;
  int64_t r = 0;
  double slope = 0.0;
  double gain = 0.0;
  double weight = 0.0;
  double inverse = 0.0;
  int64_t o = 0;
  int64_t i = 0;
  double effect = 0.0;
  int64_t j = 0;
  s = &est->scratch;
  total = est->mean.size;
  n_faults = est->numerators.columns;
  effects = est->scratch.effects;
  for (c = 0; c < est->readings.size; c++) {
    if (est->used.at[c] > 0.0) {
      for (k = 0; k < effects.size; k++) {
        effects.at[k] = 0.0;
      }
      for (r = 0; r < total; r++) {
        slope = s->slopes.at[c * s->slopes.columns + r];
        if (slope != 0.0) {
          for (k = 0; k < effects.size; k++) {
            effects.at[k] += (slope * est->signatures.at[r * est->signatures.columns + k]);
          }
        }
      }
      for (r = 0; r < total; r++) {
        gain = s->gains.at[c * s->gains.columns + r];
        for (k = 0; k < effects.size; k++) {
          est->signatures.at[r * est->signatures.columns + k] -= (gain * effects.at[k]);
        }
      }
      weight = s->sequence.at[c] / s->variances.at[c];
      inverse = 1.0 / s->variances.at[c];
      for (o = 0; o < est->numerators.rows; o++) {
        for (i = 0; i < n_faults; i++) {
          effect = effects.at[o * n_faults + i];
          est->numerators.at[o * est->numerators.columns + i] += (effect * weight);
          for (j = 0; j < n_faults; j++) {
            est->gram.at[o * est->gram.columns + (i * n_faults + j)] += (effect * effects.at[o * n_faults + j] * inverse);
          }
        }
      }
    }
  }
}

/* Correct the estimate with the readings, and return the status. The readings are processed in sequence, because their
   noise is independent (Bierman, Factorization Methods for Discrete Sequential Estimation, 1977). The sum of the
   squared normalised innovations of the sequence is the joint one, v' S^-1 v: the sequence is a factorisation of S.
   If the readings are nonlinear over the correction, it is repeated once with the derivatives at the corrected
   estimate (iterated Kalman filter). A failed correction does not change mean and covariance. */
static int64_t do_correct(const Estimator *est, const RunState *run) {
  const Scratch *s;
  int64_t total = 0;
  int64_t r = 0;
  int64_t k = 0;
  int finite = 0;
  s = &est->scratch;
  total = est->mean.size;
  if (!do_observe(est, run, est->mean)) {
    return NOT_FINITE;
  }
  do_select(est);
  for (r = 0; r < total; r++) {
    s->shift.at[r] = 0.0;
    for (k = 0; k < total; k++) {
      s->other.at[r * s->other.columns + k] = est->covariance.at[r * est->covariance.columns + k];
    }
  }
  est->scores.at[0] = do_use_all(est);
  finite = do_move(est, run);
  if (finite && do_is_curved(est, run)) {
    for (r = 0; r < total; r++) {
      for (k = 0; k < total; k++) {
        est->covariance.at[r * est->covariance.columns + k] = s->other.at[r * s->other.columns + k];
      }
    }
    do_use_all(est);
    finite = do_move(est, run);
  }
  if (finite) {
    for (k = 0; k < total; k++) {
      est->mean.at[k] = s->moved.at[k];
    }
    do_weigh_onsets(est);
    return DONE;
  }
  for (r = 0; r < total; r++) {
    for (k = 0; k < total; k++) {
      est->covariance.at[r * est->covariance.columns + k] = s->other.at[r * s->other.columns + k];
    }
  }
  return NOT_FINITE;
}

/* Predict or correct an estimate, or both, and return the status. fields is the address of an EstimatorJob. */
int64_t estimate(const int64_t *fields) {
  const EstimatorJob *estimator_job;
  const Job *job;
  RunState run;
  Estimator est;
  vector limits;
  matrix scales;
  int64_t status = 0;
  estimator_job = (const EstimatorJob *)(const void *)fields;
  job = (const Job *)(intptr_t)estimator_job->run;
  run = do_run_of(job);
  est = do_estimator_of(estimator_job, job);
  limits = vector_at(job->limits, 4);
  scales = matrix_at(job->scales, 3, job->n_controlled);
  status = DONE;
  if (estimator_job->action & PREDICT) {
    status = do_predict(&est, &run, limits, scales);
  }
  if ((status == DONE) && (estimator_job->action & CORRECT)) {
    status = do_correct(&est, &run);
  }
  return status;
}
