#include "core.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Tolerance of sample instants and breakpoints at the end of a step, because importers add up their steps. */
#define CLOSE(span) (1e-9 * (span))
#define ROUNDING(t) (1e-12 * (t) + 1e-10)
#define MOST_INSTANTS 1000000
/* An input that leaves its range by up to this fraction of the range saturates without a warning. */
#define ALLOWANCE 1e-6
#define LEAST_ALLOWANCE 1e-12 /* without a range: in the unit of the input */
#define MOST_OF_A_NAME 300 /* characters of a name in a message */
#define IS_NUMBER(v) ((v) - (v) == 0.0)

enum { U_NUMBER, U_CONSTANT, U_PORT, U_DRIVEN };
enum { P_CONSTANT, P_FIXED, P_TUNABLE, P_INPUT };

/* Size of `work`. */
#define WORK_U 0
#define WORK_SLOPES (WORK_U + ROOM(N_INPUTS))
#define WORK_P (WORK_SLOPES + ROOM(N_INPUTS))
#define WORK_Y (WORK_P + ROOM(N_NUMBERS + N_MEMORY))
#define WORK_TABLE (WORK_Y + ROOM(N_OUTPUTS))
#define WORK_F (WORK_TABLE + ROOM(N_OUTPUTS))
#define WORK_BOOKS (WORK_F + ROOM(N_ALL))
#define WORK_FIRED (WORK_BOOKS + 3 * ROOM(N_ALL))
#define WORK_AFTER (WORK_FIRED + ROOM(N_TIMERS))
#define WORK_DX (WORK_AFTER + ROOM(N_MEMORY))
#define WORK_DU (WORK_DX + ROOM(N_ALL))
#define WORK_DP (WORK_DU + ROOM(N_INPUTS))
#define WORK_DF (WORK_DP + ROOM(N_NUMBERS + N_MEMORY))
#define WORK_DY (WORK_DF + ROOM(N_ALL))
#define WORK_SIZE (WORK_DY + ROOM(N_OUTPUTS))

static void core_release(Core *c) {
  void *owned[7];
  int k;
  owned[0] = c->d, owned[1] = c->before, owned[2] = c->work, owned[3] = c->rows, owned[4] = c->starts;
  owned[5] = c->courses, owned[6] = c->jumps;
  for (k = 0; k < 7; k++)
    if (owned[k]) c->release(owned[k]);
}

static void core_reset(Core *c) {
  memset(c->d, 0, BLOCK * sizeof(double));
  memset(c->work, 0, WORK_SIZE * sizeof(double));
  memcpy(c->d + AT_P, START_P, sizeof START_P);
  memcpy(c->d + AT_U, START_U, sizeof START_U);
  c->d[AT_OWN + OWN_TOLERANCE] = TOLERANCE;
  c->d[AT_OWN + OWN_FOLLOWS] = START_FOLLOWS;
  c->state = INSTANTIATED;
  c->stop = HUGE_VAL;
  c->ending = -1;
  c->accepted = c->attempts = 0;
  memset(c->warned, 0, sizeof c->warned);
}

static int core_create(Core *c, void *(*allocate)(size_t, size_t), void (*release)(void *)) {
  memset(c, 0, sizeof *c);
  c->allocate = allocate;
  c->release = release;
  c->d = (double *)allocate(BLOCK, sizeof(double));
  c->before = (double *)allocate(BLOCK, sizeof(double));
  c->work = (double *)allocate(WORK_SIZE, sizeof(double));
  if (!c->d || !c->before || !c->work) {
    core_release(c);
    return CORE_WRONG;
  }
  core_reset(c);
  return CORE_OK;
}

/* Set times and tolerance of the experiment; returns the reason if they are invalid, or NULL. */
static const char *core_set_up(Core *c, double begin, int has_tolerance, double tolerance, int has_stop, double stop) {
  if (!IS_NUMBER(begin) || (has_stop && !(stop >= begin))) return "Start and stop time are not finite, or not in order.";
  if (has_tolerance && !(tolerance >= 1e-13 && tolerance <= 0.1)) return "The tolerance is not between 1e-13 and 0.1.";
  c->d[AT_OWN + OWN_BEGIN] = begin;
  if (has_tolerance) c->d[AT_OWN + OWN_TOLERANCE] = tolerance;
  c->stop = has_stop ? stop : HUGE_VAL;
  return NULL;
}

/* Categories of the log by status; errors and warnings are always reported. */
static const char *const LOG_CATEGORIES[] = {"logAll", "logStatusWarning", "logStatusDiscard", "logStatusError"};

/* Returns 1 if successes are reported too; `is_known` is 1 if all categories exist. */
static int core_logs(int is_on, size_t n, const char *const categories[], int *is_known) {
  int logs = is_on && !n, j;
  size_t k;
  *is_known = 1;
  for (k = 0; k < n; k++) {
    for (j = 0; j < 4 && strcmp(categories[k], LOG_CATEGORIES[j]) != 0;) j++;
    if (j == 4) *is_known = 0;
    if (j == 0 && is_on) logs = 1;
  }
  return logs;
}

/* Inputs ---------------------------------------------------------------------------------------------------------- */

/* Value of an input within its limits; the first clear violation by each variable is reported. */
static double core_limited(Core *c, unsigned reference, double value, double low, double high) {
  double limited = value < low ? low : value > high ? high : value, allowance;
  unsigned char *warned = c->warned + (reference - REF_P);
  char text[MESSAGE];
  if (limited == value) return value;
  /* The limits of a parameter can be many powers of ten apart. */
  if (reference >= REF_U && low > -HUGE_VAL && high < HUGE_VAL) allowance = ALLOWANCE * (high - low);
  else {
    allowance = ALLOWANCE * fabs(limited);
    if (allowance < LEAST_ALLOWANCE) allowance = LEAST_ALLOWANCE;
  }
  if (fabs(value - limited) <= allowance || *warned) return limited;
  *warned = 1;
  c->has_warned = 1;
  strcpy(text, "The input ");
  strncat(text, VARIABLE_NAMES[reference - REF_P], MOST_OF_A_NAME);
  strcat(text, value < low ? " is below its minimum" : " is above its maximum");
  strcat(text, ", and the limit is used instead. This is reported only once.");
  if (c->warn) c->warn(c, text);
  return limited;
}

/* Segment of the signals at a time of the model; it begins up to `close` earlier. */
static int64_t segment_at(double t, double close) {
  int64_t low = 0, high = N_SEGMENTS;
  while (high - low > 1) {
    int64_t middle = low + (high - low) / 2;
    if (SEGMENT_STARTS[middle] <= t + close) low = middle;
    else high = middle;
  }
  return low;
}

/* Coefficients of an input after a time: value, slope, amplitude, frequency, chirp rate, phase, origin. */
static void coefficients(const Core *c, int k, int64_t segment, double t, double *row) {
  const double *d = c->d;
  int source = INPUT_SOURCE[k];
  memset(row, 0, 7 * sizeof(double));
  if (source == U_DRIVEN && d[AT_OWN + OWN_FOLLOWS] != 0.0) {
    memcpy(row, COURSES + ((size_t)SEGMENT_COURSES[segment] * ROOM(N_INPUTS) + k) * 7, 7 * sizeof(double));
  } else if (source == U_NUMBER) {
    row[0] = d[AT_P + INPUT_NUMBER[k]];
  } else if (source == U_CONSTANT) {
    row[0] = START_U[k];
  } else {
    row[0] = d[AT_U + k];
    row[1] = d[AT_S + k];
    row[6] = t;
  }
}

static double value_at(const double *row, double t) {
  double dt = t - row[6], value = row[0] + row[1] * dt;
  if (row[2] != 0.0) {
    double turns = (row[3] + 0.5 * row[4] * dt) * dt;
    value += row[2] * sin(2.0 * 3.14159265358979323846 * (turns - floor(turns)) + row[5]);
  }
  return value;
}

/* Inputs at the time of the instance. */
static double *inputs_now(Core *c) {
  double row[7], t = c->d[AT_OWN + OWN_TIME], *u = c->work + WORK_U;
  int64_t segment = (int64_t)c->d[AT_OWN + OWN_SEGMENT];
  int k;
  for (k = 0; k < N_INPUTS; k++) {
    coefficients(c, k, segment, t, row);
    u[k] = value_at(row, t);
  }
  return u;
}

/* Start and memory ------------------------------------------------------------------------------------------------ */

/* States can depend on inputs at the start time: the gas in a guided cylinder on its volume, a sensor on its quantity. */
static void core_initialise(Core *c) {
  double *d = c->d, *u;
  int k;
  if (d[AT_OWN + OWN_STARTED] != 0.0) return;
  d[AT_OWN + OWN_TIME] = 0.0;
  d[AT_OWN + OWN_SEGMENT] = 0.0;
  u = inputs_now(c);
  for (k = 0; k < N_GUIDED; k++) d[AT_P + GUIDED_NUMBER[k]] = u[GUIDED_INPUT[k]];
  model_start(d + AT_P, d + AT_X, d + AT_P + N_NUMBERS);
  memcpy(d + AT_L, u, N_INPUTS * sizeof(double));
  d[AT_OWN + OWN_STARTED] = 1.0;
}

static double next_instant(const double *z) {
  double first = HUGE_VAL;
  int k;
  for (k = 0; k < N_TIMERS; k++)
    if (z[k] < first) first = z[k];
  return first;
}

/* Update the memory until no timer has expired. */
static void act(Core *c, double t, double due, const double *u, double *p) {
#if N_MEMORY
  double *z = p + N_NUMBERS, *fired = c->work + WORK_FIRED, *after = c->work + WORK_AFTER;
  long count = 0;
  int k;
  while (N_TIMERS && next_instant(z) <= due && count++ < MOST_INSTANTS) {
    for (k = 0; k < N_TIMERS; k++) fired[k] = z[k] <= due ? 1.0 : 0.0;
    model_update(&t, c->d + AT_X, u, p, fired, after);
    memcpy(z, after, N_MEMORY * sizeof(double));
  }
#else
  (void)c, (void)t, (void)due, (void)u, (void)p;
#endif
}

/* Event of model exchange: the next segment of the signals, and expired timers. */
static void core_event(Core *c) {
  double *d = c->d, t = d[AT_OWN + OWN_TIME];
  d[AT_OWN + OWN_SEGMENT] = (double)segment_at(t, ROUNDING(t));
  act(c, t, t + ROUNDING(t), inputs_now(c), d + AT_P);
}

/* Time of the importer; infinite if there is none. */
static double core_next_event(const Core *c) {
  const double *own = c->d + AT_OWN;
  double next = next_instant(c->d + AT_P + N_NUMBERS);
  int64_t segment = (int64_t)own[OWN_SEGMENT] + 1;
  if (own[OWN_FOLLOWS] != 0.0 && segment < N_SEGMENTS && SEGMENT_STARTS[segment] < next) next = SEGMENT_STARTS[segment];
  return own[OWN_BEGIN] + next;
}

/* Values ---------------------------------------------------------------------------------------------------------- */

static void core_rates(Core *c, double *found) {
  double *d = c->d, *u = inputs_now(c);
  model_rates(d + AT_OWN + OWN_TIME, d + AT_X, u, d + AT_P, found);
}

static void core_indicators(Core *c, double *found) {
#if N_INDICATORS
  double *d = c->d;
  model_indicators(d + AT_OWN + OWN_TIME, d + AT_X, inputs_now(c), d + AT_P, found);
#else
  (void)c, (void)found;
#endif
}

/* Outputs; at a sample instant of co-simulation, those after it, because the importer can still change inputs. */
static void outputs_now(Core *c) {
  double *d = c->d, *p = d + AT_P, *u = inputs_now(c), t = d[AT_OWN + OWN_TIME];
  if (N_TIMERS && !c->is_exchange) {
    p = c->work + WORK_P;
    memcpy(p, d + AT_P, (N_NUMBERS + N_MEMORY) * sizeof(double));
    act(c, t, t + 1e-14 * t + 1e-15, u, p);
  }
  model_outputs(&t, d + AT_X, u, p, c->work + WORK_Y);
}

/* Model exchange: index of a stop condition that is met, or -1. */
static int core_ends(Core *c) {
  int k, j;
  c->ending = -1;
  if (!N_CONDITIONS || c->d[AT_OWN + OWN_TIME] <= 0.0) return -1;
  outputs_now(c);
  for (k = 0; k < N_CONDITIONS && c->ending < 0; k++) {
    double value = CONDITION_WEIGHTS[3 * k + 2];
    for (j = 0; j < 2; j++)
      if (CONDITION_PLACES[2 * k + j] >= 0)
        value += CONDITION_WEIGHTS[3 * k + j] * c->work[WORK_Y + CONDITION_PLACES[2 * k + j]];
    if (value > 0.0) c->ending = k;
  }
  return c->ending;
}

/* A value; rates and outputs are computed only for the first of several. */
static int core_get_next(Core *c, unsigned reference, double *value, int is_first) {
  double *d = c->d;
  if (is_first) c->has_rates = c->has_outputs = 0;
  if (reference == REF_TIME) *value = d[AT_OWN + OWN_BEGIN] + d[AT_OWN + OWN_TIME];
  else if (reference < REF_P) return REF_NO_NUMBER;
  else if (reference < REF_U) *value = d[AT_P + reference - REF_P];
  else if (reference < REF_X) {
    core_initialise(c);
    *value = inputs_now(c)[reference - REF_U];
  } else if (reference < REF_END) {
    core_initialise(c);
    if (reference < REF_D) *value = d[AT_X + reference - REF_X];
    else if (reference < REF_Y) {
      if (!c->has_rates) core_rates(c, c->work + WORK_F);
      c->has_rates = 1;
      *value = c->work[WORK_F + reference - REF_D];
    } else {
      if (!c->has_outputs) outputs_now(c);
      c->has_outputs = 1;
      *value = c->work[WORK_Y + reference - REF_Y];
    }
    if (!IS_NUMBER(*value)) return REF_NO_RESULT;
  } else return REF_UNKNOWN;
  return REF_OK;
}

static int core_set(Core *c, unsigned reference, double value) {
  double *own = c->d + AT_OWN;
  int runs = own[OWN_RUNNING] != 0.0;
  unsigned k;
  /* The initial value of some states is a parameter. */
  if (reference >= REF_X && reference < REF_D && STATE_NUMBER[reference - REF_X] >= 0)
    reference = REF_P + (unsigned)STATE_NUMBER[reference - REF_X];
  if (reference == REF_TIME || reference >= REF_X) return reference < REF_END ? REF_CONSTANT : REF_UNKNOWN;
  if (reference == REF_FOLLOWS) {
    if (runs) return REF_TOO_LATE;
    own[OWN_FOLLOWS] = value != 0.0 ? 1.0 : 0.0;
  } else if (reference < REF_U) {
    k = reference - REF_P;
    if (NUMBER_ROLE[k] == P_CONSTANT) return REF_CONSTANT;
    if (NUMBER_ROLE[k] == P_FIXED && runs) return REF_TOO_LATE;
    if (NUMBER_ROLE[k] == P_TUNABLE && c->state == CONTINUOUS) return REF_AT_EVENTS;
    if (!IS_NUMBER(value)) return REF_NOT_FINITE;
    if (NUMBER_ROLE[k] != P_INPUT && (value < NUMBER_LOW[k] || value > NUMBER_HIGH[k])) return REF_OUTSIDE;
    value = core_limited(c, reference, value, NUMBER_LOW[k], NUMBER_HIGH[k]);
    if (c->d[AT_P + k] != value) own[OWN_MOVED] = 1.0;
    c->d[AT_P + k] = value;
  } else {
    k = reference - REF_U;
    if (INPUT_SOURCE[k] != U_PORT && INPUT_SOURCE[k] != U_DRIVEN) return REF_CONSTANT;
    if (!IS_NUMBER(value)) return REF_NOT_FINITE;
    c->d[AT_U + k] = core_limited(c, reference, value, INPUT_LOW[k], INPUT_HIGH[k]);
    c->d[AT_S + k] = 0.0;
  }
  if (!runs) own[OWN_STARTED] = 0.0;
  return REF_OK;
}

/* Values of several references; `at` is the index of the last one. */
static int core_get_all(Core *c, const unsigned *references, size_t n, double *values, unsigned *at) {
  int refusal = REF_OK;
  size_t k;
  for (k = 0; k < n && refusal == REF_OK; k++) refusal = core_get_next(c, *at = references[k], values + k, k == 0);
  return refusal;
}

static int core_set_all(Core *c, const unsigned *references, size_t n, const double *values, unsigned *at) {
  int refusal = REF_OK;
  size_t k;
  c->has_warned = 0;
  for (k = 0; k < n && refusal == REF_OK; k++) {
    *at = references[k];
    refusal = *at == REF_FOLLOWS ? REF_NO_NUMBER : core_set(c, *at, values[k]);
  }
  return refusal;
}

/* Message for a rejected value reference. */
static const char *core_refusal(char *text, int refusal, unsigned reference) {
  static const char *const why[] = {"", "is no variable of this model", "is of another type", "cannot be set",
                                    "is fixed once the run has begun", "is set at events only in model exchange",
                                    "is outside its limits", "is not finite",
                                    "has no finite value here: a number or a state is none that the model has"};
  unsigned unit = 1;
  size_t at;
  strcpy(text, "Value reference ");
  at = strlen(text);
  while (reference / unit >= 10) unit *= 10;
  for (; unit; unit /= 10) text[at++] = (char)('0' + reference / unit % 10);
  text[at] = '\0';
  if (reference >= REF_P && reference < REF_X && *VARIABLE_NAMES[reference - REF_P]) {
    strcat(text, " (");
    strncat(text, VARIABLE_NAMES[reference - REF_P], MOST_OF_A_NAME);
    strcat(text, ")");
  }
  strcat(text, " ");
  strcat(text, why[refusal]);
  return strcat(text, ".");
}

/* Rates of all states; returns 1 if they are finite. */
static int core_derivatives(Core *c, double *found) {
  int k, is_finite = 1;
  core_initialise(c);
  core_rates(c, c->work + WORK_F);
  for (k = 0; k < N_STATES; k++) is_finite &= IS_NUMBER(c->work[WORK_F + k]);
  memcpy(found, c->work + WORK_F, N_STATES * sizeof(double));
  return is_finite;
}

/* Stored states --------------------------------------------------------------------------------------------------- */

static void core_keep(const Core *c, void *kept) {
  Head *head = (Head *)kept;
  memset(head, 0, sizeof *head);
  strcpy(head->guid, MODEL_GUID);
  head->is_exchange = c->is_exchange, head->state = c->state, head->ending = c->ending, head->stop = c->stop;
  memcpy(head + 1, c->d, BLOCK * sizeof(double));
}

static int core_restore(Core *c, const void *kept) {
  const Head *head = (const Head *)kept;
  if (!head || strcmp(head->guid, MODEL_GUID) != 0 || head->is_exchange != c->is_exchange) return CORE_WRONG;
  c->state = head->state, c->ending = head->ending, c->stop = head->stop;
  memcpy(c->d, head + 1, BLOCK * sizeof(double));
  return CORE_OK;
}

static int core_is_kept(const void *bytes, size_t size) {
  return bytes && size == KEPT && strncmp((const char *)bytes, MODEL_GUID, sizeof MODEL_GUID) == 0;
}

static int core_directional(Core *c, const unsigned *unknown, size_t n_unknown, const unsigned *known, size_t n_known,
                            const double *seed, double *found) {
  double *d = c->d, *dx = c->work + WORK_DX, *du = c->work + WORK_DU, *dp = c->work + WORK_DP;
  double *df = c->work + WORK_DF, *dy = c->work + WORK_DY;
  size_t i;
  int k;
  memset(dx, 0, (WORK_DF - WORK_DX) * sizeof(double));
  for (i = 0; i < n_known; i++) {
    unsigned r = known[i];
    if (r >= REF_P && r < REF_U) dp[r - REF_P] = seed[i];
    else if (r >= REF_U && r < REF_X) {
      k = (int)(r - REF_U);
      du[k] = INPUT_SOURCE[k] == U_DRIVEN && d[AT_OWN + OWN_FOLLOWS] != 0.0 ? 0.0 : seed[i];
    } else if (r >= REF_X && r < REF_D) dx[r - REF_X] = seed[i];
    else return REF_UNKNOWN;
  }
  for (k = 0; k < N_INPUTS; k++)
    if (INPUT_SOURCE[k] == U_NUMBER) du[k] = dp[INPUT_NUMBER[k]];
  core_initialise(c);
  model_directional(d + AT_OWN + OWN_TIME, d + AT_X, inputs_now(c), d + AT_P, dx, du, dp, df, dy);
  for (i = 0; i < n_unknown; i++) {
    unsigned r = unknown[i];
    if (r >= REF_D && r < REF_Y) found[i] = df[r - REF_D];
    else if (r >= REF_Y && r < REF_END) found[i] = dy[r - REF_Y];
    else return REF_UNKNOWN;
  }
  return REF_OK;
}

/* Steps of co-simulation ------------------------------------------------------------------------------------------ */

static int64_t place_of(const void *pointer) { return (int64_t)(intptr_t)pointer; }

static int reserve(Core *c, size_t n) {
  if (n <= c->room) return 1;
  n *= 2;
  if (c->rows) c->release(c->rows);
  if (c->starts) c->release(c->starts);
  if (c->courses) c->release(c->courses);
  if (c->jumps) c->release(c->jumps);
  c->rows = (double *)c->allocate(n * ROOM(N_INPUTS) * 7, sizeof(double));
  c->starts = (double *)c->allocate(n, sizeof(double));
  c->courses = (int64_t *)c->allocate(n, sizeof(int64_t));
  c->jumps = (unsigned char *)c->allocate(n, 1);
  c->room = c->rows && c->starts && c->courses && c->jumps ? n : 0;
  return c->room > 0;
}

/* Reduce the slope of an input that would leave its limits before the end of a step. */
static void limit_slope(Core *c, int k, double *row, double span) {
  double end = row[0] + row[1] * span, limited;
  if (row[1] == 0.0) return;
  limited = core_limited(c, REF_U + (unsigned)k, end, INPUT_LOW[k], INPUT_HIGH[k]);
  if (limited != end) row[1] = (limited - row[0]) / span;
}

/* Segments of a step with their coefficients; returns their number, 0 if out of memory. */
static size_t segments(Core *c, double until) {
  double *d = c->d, t = d[AT_OWN + OWN_TIME], span = until - t;
  int follows = d[AT_OWN + OWN_FOLLOWS] != 0.0, k;
  int64_t first = follows ? segment_at(t, CLOSE(span)) : 0, last = follows ? segment_at(until, -CLOSE(span)) : 0;
  size_t n = (size_t)(last - first) + 1, i;
  if (last < first) last = first, n = 1;
  if (!reserve(c, n)) return 0;
  for (i = 0; i < n; i++) {
    c->starts[i] = i ? SEGMENT_STARTS[first + (int64_t)i] : t;
    c->courses[i] = (int64_t)i;
    c->jumps[i] = (unsigned char)(i ? SEGMENT_JUMPS[first + (int64_t)i] : 0);
    for (k = 0; k < N_INPUTS; k++) {
      double *row = c->rows + (i * ROOM(N_INPUTS) + (size_t)k) * 7;
      coefficients(c, k, first + (int64_t)i, t, row);
      if (INPUT_SOURCE[k] == U_PORT || (INPUT_SOURCE[k] == U_DRIVEN && !follows)) limit_slope(c, k, row, span);
    }
    if (!N_INPUTS) memset(c->rows + i * 7, 0, 7 * sizeof(double));
  }
  /* Changes by the importer since the last step, and jumps of signals. */
  c->jumps[0] = (unsigned char)(d[AT_OWN + OWN_MOVED] != 0.0);
  if (follows && t > 0.0 && fabs(SEGMENT_STARTS[first] - t) <= CLOSE(span)) c->jumps[0] |= SEGMENT_JUMPS[first];
  for (k = 0; k < N_INPUTS; k++)
    if (INPUT_SOURCE[k] == U_PORT || (INPUT_SOURCE[k] == U_DRIVEN && !follows))
      if (d[AT_U + k] != d[AT_L + k]) c->jumps[0] = 1;
  d[AT_OWN + OWN_SEGMENT] = (double)last;
  return n;
}

static int64_t integrated(Core *c, size_t n, double until, double tolerance) {
  double *d = c->d, limits[4], watch[2], grid[1];
  int64_t job[JOB_SIZE], counts[5] = {0, 0, 0, 0, 0}, status;
  memset(job, 0, sizeof job);
  limits[0] = LONGEST_STEP, limits[1] = MOST_ATTEMPTS, limits[2] = 0.0, limits[3] = tolerance;
  watch[0] = watch[1] = 0.0, grid[0] = until;
  model_functions(job);
  job[JOB_n_states] = N_ALL, job[JOB_n_controlled] = N_STATES, job[JOB_n_inputs] = ROOM(N_INPUTS);
  job[JOB_n_outputs] = N_OUTPUTS, job[JOB_n_numbers] = N_NUMBERS, job[JOB_n_memory] = N_MEMORY;
  job[JOB_n_timers] = N_TIMERS, job[JOB_n_jacobian] = N_JACOBIAN, job[JOB_n_scratch] = N_STEP_SCRATCH;
  job[JOB_scales] = place_of(STATE_SCALES), job[JOB_positive] = place_of(STATE_POSITIVE);
  job[JOB_acting] = place_of(MEMORY_ACTING);
  job[JOB_n_segments] = (int64_t)n, job[JOB_n_courses] = (int64_t)n, job[JOB_n_rows] = 1;
  job[JOB_n_conditions] = N_CONDITIONS;
  job[JOB_x] = place_of(d + AT_X), job[JOB_p] = place_of(d + AT_P), job[JOB_starts] = place_of(c->starts);
  job[JOB_courses] = place_of(c->courses), job[JOB_coefficients] = place_of(c->rows);
  job[JOB_jumps] = place_of(c->jumps), job[JOB_grid] = place_of(grid), job[JOB_limits] = place_of(limits);
  job[JOB_places] = place_of(CONDITION_PLACES), job[JOB_weights] = place_of(CONDITION_WEIGHTS);
  job[JOB_table] = place_of(c->work + WORK_TABLE), job[JOB_books] = place_of(c->work + WORK_BOOKS);
  job[JOB_watch] = place_of(watch), job[JOB_counts] = place_of(counts), job[JOB_memory] = place_of(d + AT_W);
  status = model_integrate(job);
  c->ending = status == 1 ? (int)counts[3] : -1;
  d[AT_OWN + OWN_TIME] = watch[0];
  c->accepted += counts[0], c->attempts += counts[1];
  return status;
}

/* Go on to a time of the host. A step that fails leaves the instance where it was; one that a stop condition ends
   leaves it there. */
static int core_step(Core *c, double until) {
  double *d = c->d, *own = d + AT_OWN, row[7], goal = until - own[OWN_BEGIN], span = goal - own[OWN_TIME];
  double tolerance = own[OWN_RUNNING] == 1.0 ? own[OWN_TOLERANCE] : 0.0;
  int64_t next;
  size_t n;
  int k;
  c->has_warned = 0;
  /* The first step sets the tolerances of the states. */
  next = segment_at(goal, CLOSE(span));
  if (own[OWN_FOLLOWS] != 0.0 && fabs(SEGMENT_STARTS[next] - goal) <= CLOSE(span)) goal = SEGMENT_STARTS[next];
  memcpy(c->before, d, BLOCK * sizeof(double));
  n = segments(c, goal);
  if (!n) return CORE_WRONG;
  c->status = integrated(c, n, goal, tolerance);
  for (k = 0; k < 2 && c->status == 2; k++) {
    /* As in Python: a run often stalls if the step is too long for a contact that opens and closes. */
    memcpy(d, c->before, BLOCK * sizeof(double));
    n = segments(c, goal);
    c->status = integrated(c, n, goal, own[OWN_TOLERANCE] * (k ? 0.01 : 0.1));
  }
  if (c->status > 1) {
    memcpy(d, c->before, BLOCK * sizeof(double));
    return CORE_DISCARDED;
  }
  for (k = 0; k < N_INPUTS; k++) {
    coefficients(c, k, (int64_t)own[OWN_SEGMENT], own[OWN_TIME], row);
    if (INPUT_SOURCE[k] == U_PORT || (INPUT_SOURCE[k] == U_DRIVEN && own[OWN_FOLLOWS] == 0.0)) {
      /* Value of the input after the importer's slope. */
      double value = value_at(c->rows + ((n - 1) * ROOM(N_INPUTS) + (size_t)k) * 7, own[OWN_TIME]);
      d[AT_U + k] = core_limited(c, REF_U + (unsigned)k, value, INPUT_LOW[k], INPUT_HIGH[k]);
      d[AT_S + k] = 0.0;
    }
    d[AT_L + k] = d[AT_U + k];
  }
  own[OWN_RUNNING] = 2.0;
  own[OWN_MOVED] = 0.0;
  if (own[OWN_FOLLOWS] != 0.0) own[OWN_SEGMENT] = (double)segment_at(own[OWN_TIME], CLOSE(span));
  return c->status == 1 ? CORE_ENDED : CORE_OK;
}

/* Reason for which a step from a time of the importer is invalid, or NULL. */
static const char *core_no_step(const Core *c, double point, double step) {
  double now = c->d[AT_OWN + OWN_BEGIN] + c->d[AT_OWN + OWN_TIME];
  if (!IS_NUMBER(point) || !IS_NUMBER(step) || !(step > 0.0) || !(fabs(point - now) <= 1e-6 * step + ROUNDING(fabs(now))))
    return "A step begins where the last one has ended, and has a length.";
  if (point + step > c->stop + 1e-6 * step) return "The step goes past the stop time.";
  return NULL;
}
