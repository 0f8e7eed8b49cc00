/* @ABOUT@

   The filter around the estimator (model_estimator.c), and the rule of alarms. Estimates have the same bits as those of
   poppet without fused operations. */
#include "@NAME@.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

@PROTOTYPES@
int64_t model_estimate(const int64_t *fields);

#define IS_NUMBER(v) ((v) - (v) == 0.0)
#define N MODEL_ESTIMATES
#define F MODEL_FAULTS
#define STEP @STEP@ /* of a difference, in standard deviations */
#define WINDOW @WINDOW@ /* [s] */
#define ALARM_DELAY @ALARM_DELAY@ /* [s] */
#define SPACING (ALARM_DELAY / @PER_DELAY@) /* time between two onsets [s] */
#define GAP @GAP@
#define FORGET @FORGET@
#define FARTHEST @FARTHEST@
#define CHECK @CHECK@
#define FIRST @FIRST@ /* samples */
#define MOST_ATTEMPTS @MOST_ATTEMPTS@
#define TOLERANCE @TOLERANCE@
#define LINEAR @LINEAR@
enum { PREDICT = 1, CORRECT = 2, U = @ROOM_U@, BASE_P = @BASE_P@, N_INITIAL = @N_INITIAL@, N_PLACES = @N_PLACES@ };

const model_column model_time = @TIME@;

const model_column model_channel_list[] = {
@CHANNEL_LIST@
};

const model_column model_input_list[] = {
@INPUT_LIST@
};

const model_number model_free_list[] = {
@FREE_LIST@
};

/* Model of the plant. */
static const double scales[] = {@SCALES@};
static const uint8_t positive[] = {@POSITIVE@};
static const uint8_t acting[] = {@ACTING@};
static const double start_p[] = {
@START_P@
};
static const double start_u[] = {@START_U@};
static const int driven[] = {@DRIVEN@}; /* indices in u */
static const double input_low[] = {@INPUT_LOW@};
static const double input_high[] = {@INPUT_HIGH@};
static const uint8_t holds[] = {@HOLDS@}; /* 0 for an input that changes linearly */
enum { N_SLOPES = @N_SLOPES@ };
static const int slopes[] = {@SLOPES@}; /* index in u of a derivative, and that of its driven input */
static const double nominal[] = {@NOMINAL@};

/* Free numbers. */
static const int64_t places[] = {@PLACES@};
static const int64_t touched_inputs[] = {@TOUCHED_INPUTS@};
static const double base[] = {@BASE@};
static const double directions[] = {
@DIRECTIONS@
};
static const double reference[] = {@REFERENCE@};
static const double low[] = {@LOW@};
static const double high[] = {@HIGH@};
static const double cap[] = {@CAP@};
static const double walk[] = {@WALK@};
static const double prior[] = {@PRIOR@};
static const double start_variances[] = {@VARIANCES@};

/* Sensors. */
static const double effects[] = {
@EFFECTS@
};
static const double noise[] = {@NOISE@};
static const double gates[] = {@GATES@};
static const double sensor_noise[] = {@SENSOR_NOISE@};

/* Initial values of the plant: parameters, their sensors or -1, and their standard deviations. */
static const double initial_p[] = {
@INITIAL_P@
};
static const int initial_places[] = {@INITIAL_PLACES@};
static const int initial_channels[] = {@INITIAL_CHANNELS@};
static const double initial_sizes[] = {@INITIAL_SIZES@};

/* Estimator --------------------------------------------------------------------------------------------------------- */

static int64_t address(const void *of) { return (int64_t)(intptr_t)of; }

/* Predict, correct, or both; returns 1 if this succeeds. */
static int run(model_watch *w, int action) {
  int64_t job[@JOB_SIZE@], fields[@FIELDS_SIZE@];
@JOB@
@FIELDS@
  return model_estimate(fields) == 0;
}

/* Initial estimate -------------------------------------------------------------------------------------------------- */

static void initial_state(model_watch *w, const double *p, double *x) {
  model_start(p, x, w->work + @AT_MEMORY@);
}

/* Set mean and covariance from the readings and the free numbers; readings that are used are removed. */
static void set_estimate(model_watch *w, const double *theta, const double *covariance) {
  double *p = w->work + @AT_P@, *touched = w->work + @AT_TOUCHED@, *x = w->work + @AT_X@, *moved = w->work + @AT_MOVED@;
  double *by_theta = w->work + @AT_BY_THETA@, *product = w->work + @AT_PRODUCT@, *errors = w->work + @AT_ERRORS@;
  double step, size, sum;
  int is_used[MODEL_CHANNELS], c, i, j, k, r;
  memcpy(p, initial_p, BASE_P * sizeof(double));
  for (k = 0; k < N_PLACES; k++) {
    sum = 0.0;
    for (j = 0; j < MODEL_FREE; j++) sum += directions[k * MODEL_FREE + j] * (theta[j] - reference[j]);
    p[places[k]] += sum;
  }
  for (c = 0; c < MODEL_CHANNELS; c++) is_used[c] = 0;
  for (i = 0; i < N_INITIAL; i++) {
    c = initial_channels[i];
    if (c < 0 || !IS_NUMBER(w->readings[c])) continue;
    is_used[c] = 1;
    sum = 0.0;
    for (j = 0; j < MODEL_FREE; j++) sum += effects[c * MODEL_FREE + j] * (theta[j] - reference[j]);
    p[initial_places[i]] = w->readings[c] - sum;
  }
  initial_state(w, p, x);
  /* Derivatives by the free numbers. An initial value that is measured does not follow a free number. */
  memset(by_theta, 0, N * MODEL_FREE * sizeof(double));
  for (j = 0; j < MODEL_FREE; j++) {
    by_theta[(MODEL_STATES + j) * MODEL_FREE + j] = 1.0;
    step = STEP * prior[j];
    memcpy(touched, p, BASE_P * sizeof(double));
    for (k = 0; k < N_PLACES; k++) touched[places[k]] += directions[k * MODEL_FREE + j] * step;
    for (i = 0; i < N_INITIAL; i++) {
      if (initial_channels[i] >= 0 && is_used[initial_channels[i]]) touched[initial_places[i]] = p[initial_places[i]];
    }
    initial_state(w, touched, moved);
    for (r = 0; r < MODEL_STATES; r++) by_theta[r * MODEL_FREE + j] = (moved[r] - x[r]) / step;
  }
  /* Derivatives by the initial values, times their standard deviations. */
  for (i = 0; i < N_INITIAL; i++) {
    c = initial_channels[i] >= 0 && is_used[initial_channels[i]] ? initial_channels[i] : -1;
    size = c < 0 ? initial_sizes[i] : sensor_noise[c];
    step = STEP * size;
    memcpy(touched, p, BASE_P * sizeof(double));
    touched[initial_places[i]] += step;
    initial_state(w, touched, moved);
    for (r = 0; r < MODEL_STATES; r++) {
      const double slope = (moved[r] - x[r]) / step;
      errors[i * MODEL_STATES + r] = slope * size;
      for (j = 0; c >= 0 && j < MODEL_FREE; j++) by_theta[r * MODEL_FREE + j] -= slope * effects[c * MODEL_FREE + j];
    }
  }
  for (r = 0; r < N; r++) {
    for (j = 0; j < MODEL_FREE; j++) {
      sum = 0.0;
      for (k = 0; k < MODEL_FREE; k++) sum += by_theta[r * MODEL_FREE + k] * covariance[k * MODEL_FREE + j];
      product[r * MODEL_FREE + j] = sum;
    }
  }
  for (r = 0; r < N; r++) {
    for (k = 0; k < N; k++) {
      sum = 0.0;
      for (j = 0; j < MODEL_FREE; j++) sum += product[r * MODEL_FREE + j] * by_theta[k * MODEL_FREE + j];
      w->covariance[r * N + k] = sum;
    }
  }
  for (r = 0; r < MODEL_STATES; r++) {
    for (k = 0; k < MODEL_STATES; k++) {
      sum = 0.0;
      for (i = 0; i < N_INITIAL; i++) sum += errors[i * MODEL_STATES + r] * errors[i * MODEL_STATES + k];
      w->covariance[r * N + k] += sum;
    }
  }
  for (r = 0; r < MODEL_STATES; r++) {
    const double least = STEP * nominal[r];
    if (!(w->covariance[r * N + r] > least * least)) w->covariance[r * N + r] += nominal[r] * nominal[r];
    w->mean[r] = x[r];
  }
  for (j = 0; j < MODEL_FREE; j++) w->mean[MODEL_STATES + j] = theta[j];
  for (c = 0; c < MODEL_CHANNELS; c++) {
    if (is_used[c]) w->readings[c] = NAN;
  }
}

/* Onsets ------------------------------------------------------------------------------------------------------------ */

static void begin_onset(model_watch *w, int slot) {
  int i, r, first = slot * F;
  for (i = 0; i < F; i++) {
    for (r = 0; r < N; r++) w->signatures[r * MODEL_STEPS + first + i] = r == MODEL_STATES + i ? 1.0 : 0.0;
    w->numerators[first + i] = 0.0;
  }
  memset(w->gram + first * F, 0, F * F * sizeof(double));
  w->onsets[slot] = w->time;
  w->next_onset = w->onsets[slot] + SPACING;
}

/* Remove all onsets, and begin a new one if something is known about the faults. */
static void clear_bank(model_watch *w) {
  int o;
  memset(w->signatures, 0, sizeof w->signatures);
  memset(w->numerators, 0, sizeof w->numerators);
  memset(w->gram, 0, sizeof w->gram);
  for (o = 0; o < MODEL_ONSETS; o++) w->onsets[o] = NAN;
  w->next_onset = HUGE_VAL;
  if (w->is_settled) begin_onset(w, 0);
}

/* Index of the onset that a new one replaces: an unused one; the oldest one if it is older than the window; otherwise
   the one whose neighbours are closest, relative to their age. */
static int slot_to_renew(const model_watch *w) {
  int order[MODEL_ONSETS], o, k, best = 1;
  double least = HUGE_VAL;
  for (o = 0; o < MODEL_ONSETS; o++) {
    if (!IS_NUMBER(w->onsets[o])) return o;
    for (k = o; k > 0 && w->onsets[order[k - 1]] > w->onsets[o]; k--) order[k] = order[k - 1];
    order[k] = o;
  }
  if (w->time - w->onsets[order[0]] > WINDOW) return order[0];
  for (k = 1; k + 1 < MODEL_ONSETS; k++) {
    double age = w->time - w->onsets[order[k + 1]], ratio;
    if (!(age > 1e-9 * WINDOW)) age = 1e-9 * WINDOW;
    ratio = (w->time - w->onsets[order[k - 1]]) / age;
    if (ratio < least) {
      least = ratio;
      best = k;
    }
  }
  return order[best];
}

/* Add confirmed steps of faults to the estimates, and begin the bank again. */
static void adopt(model_watch *w) {
  const model_monitor *a = &w->monitor;
  const double *gram = w->gram + a->onset * F * F;
  double inverse[4], moved[N];
  int r, k, i, j, n = a->n_members;
  if (n == 1) {
    if (!(gram[a->members[0] * F + a->members[0]] > 0.0)) return;
    inverse[0] = 1.0 / gram[a->members[0] * F + a->members[0]];
  } else {
    const int m0 = a->members[0], m1 = a->members[1];
    const double a00 = gram[m0 * F + m0], a01 = gram[m0 * F + m1], a11 = gram[m1 * F + m1];
    const double determinant = a00 * a11 - a01 * a01;
    if (!(determinant > 1e-15 * a00 * a11)) return;
    inverse[0] = a11 / determinant;
    inverse[1] = inverse[2] = -a01 / determinant;
    inverse[3] = a00 / determinant;
  }
  for (r = 0; r < N; r++) {
    const double *of_r = w->signatures + r * MODEL_STEPS + a->onset * F;
    double sum = 0.0, error;
    for (i = 0; i < n; i++) sum += of_r[a->members[i]] * a->steps[i];
    w->mean[r] += sum;
    error = LINEAR * sum;
    for (k = 0; k < N; k++) {
      const double *of_k = w->signatures + k * MODEL_STEPS + a->onset * F;
      sum = 0.0;
      for (j = 0; j < n; j++) {
        double inner = 0.0;
        for (i = 0; i < n; i++) inner += of_r[a->members[i]] * inverse[i * n + j];
        sum += inner * of_k[a->members[j]];
      }
      w->covariance[r * N + k] += sum;
    }
    w->covariance[r * N + r] += error * error;
  }
  /* A fault that is adopted again with a larger size grows: it walks. */
  for (i = 0; i < n; i++) {
    const int fault = a->members[i], row = MODEL_STATES + fault;
    const double size = a->steps[i];
    if (size * w->grown[fault] > 0.0) {
      const double elapsed = w->time - w->adopted_at[fault];
      const double rate = size * size / (elapsed > ALARM_DELAY ? elapsed : ALARM_DELAY);
      const double variance = size * size / 3.0;
      if (rate > w->walk[row]) w->walk[row] = rate;
      for (r = 0; r < N; r++) moved[r] = w->covariance[r * N + row] / w->covariance[row * N + row];
      for (r = 0; r < N; r++) {
        for (k = 0; k < N; k++) w->covariance[r * N + k] += variance * (moved[r] * moved[k]);
      }
    } else {
      w->walk[row] = walk[fault];
    }
    w->adopted_at[fault] = w->time;
    w->grown[fault] += size;
  }
  clear_bank(w);
}

/* Let all faults walk slowly again, after the end of an alarm. */
static void end_growth(model_watch *w) {
  memset(w->grown, 0, sizeof w->grown);
  memcpy(w->walk + MODEL_STATES, walk, MODEL_FREE * sizeof(double));
}

/* Samples ----------------------------------------------------------------------------------------------------------- */

/* Inputs of the circuit at both ends of an interval; linear inputs change from `before` to the present row. */
static void set_inputs(model_watch *w, const double *before, double dt) {
  int j, k;
  memcpy(w->u, start_u, U * sizeof(double));
  memcpy(w->u + U, start_u, U * sizeof(double));
  for (j = 0; j < MODEL_INPUTS; j++) {
    w->u[driven[j]] = before[j];
    w->u[U + driven[j]] = holds[j] ? before[j] : before[j] + 1.0 * (w->row[j] - before[j]);
  }
  for (k = 0; k < N_SLOPES && dt > 0.0; k++) {
    const double slope = (w->u[U + slopes[2 * k + 1]] - w->u[slopes[2 * k + 1]]) / dt;
    w->u[slopes[2 * k]] = w->u[U + slopes[2 * k]] = slope;
  }
}

static void fill_row(model_watch *w, const double *inputs) {
  int j;
  for (j = 0; inputs && j < MODEL_INPUTS; j++) {
    const double v = inputs[j];
    if (IS_NUMBER(v)) w->row[j] = v < input_low[j] ? input_low[j] : v > input_high[j] ? input_high[j] : v;
  }
}

/* Impossible readings can cause overflows. */
static int is_valid(const model_watch *w) {
  int k;
  for (k = 0; k < N; k++) {
    if (!IS_NUMBER(w->mean[k]) || w->covariance[k * N + k] < 0.0) return 0;
  }
  for (k = 0; k < N * N; k++) {
    if (!IS_NUMBER(w->covariance[k])) return 0;
  }
  return 1;
}

/* Returns 1 if impossible readings have moved a free number far away from its healthy value. */
static int is_far(const model_watch *w) {
  int i;
  for (i = 0; i < MODEL_FREE; i++) {
    const double change = w->mean[MODEL_STATES + i] - model_free_list[i].healthy;
    if (!(fabs(change) <= FARTHEST * sqrt(cap[MODEL_STATES + i]))) return 1;
  }
  return 0;
}

static void set_prior(double *theta, double *covariance) {
  int i;
  memset(covariance, 0, MODEL_FREE * MODEL_FREE * sizeof(double));
  for (i = 0; i < MODEL_FREE; i++) {
    theta[i] = model_free_list[i].healthy;
    covariance[i * MODEL_FREE + i] = start_variances[i];
  }
}

/* Estimates before the first sample. */
static void reset(model_watch *w) {
  int j;
  w->is_started = w->is_settled = 0;
  memset(w->mean, 0, sizeof w->mean);
  memset(w->covariance, 0, sizeof w->covariance);
  for (j = 0; j < MODEL_FREE; j++) {
    w->mean[MODEL_STATES + j] = model_free_list[j].healthy;
    w->covariance[(MODEL_STATES + j) * (N + 1)] = start_variances[j];
  }
}

/* Start the states from the readings; returns 0 if they are not possible, and keeps the estimates if these are valid. */
static int start(model_watch *w, double time, const double *theta, const double *covariance) {
  double *kept_mean = w->work + @AT_KEPT@, *kept = kept_mean + N;
  const int was_valid = is_valid(w);
  int r;
  memcpy(kept_mean, w->mean, sizeof w->mean);
  memcpy(kept, w->covariance, sizeof w->covariance);
  w->clock[0] = w->time = time;
  set_estimate(w, theta, covariance);
  if (!is_valid(w)) {
    if (!was_valid) {
      reset(w);
      return 0;
    }
    memcpy(w->mean, kept_mean, sizeof w->mean);
    memcpy(w->covariance, kept, sizeof w->covariance);
    return 0;
  }
  memmove(w->start_theta, theta, sizeof w->start_theta);
  memmove(w->start_covariance, covariance, sizeof w->start_covariance);
  for (r = 0; r < MODEL_STATES; r++) {
    const double deviation = @STATE_NOISE@ * (fabs(w->mean[r]) > nominal[r] ? fabs(w->mean[r]) : nominal[r]);
    w->walk[r] = deviation * deviation;
  }
  w->limits[0] = HUGE_VAL;
  w->limits[1] = MOST_ATTEMPTS;
  w->limits[2] = 0.0;
  w->limits[3] = TOLERANCE;
  set_inputs(w, w->row, 0.0);
  (void)run(w, CORRECT);
  w->usual_step = 0.0;
  w->age = 0;
  if (!w->is_settled) w->settles_at = time + WINDOW;
  w->next_check = time + CHECK * WINDOW;
  clear_bank(w);
  return 1;
}

/* Start the states again, and keep the estimates of the free numbers. */
static int restart(model_watch *w, double time, double gap) {
  double *theta = w->work + @AT_THETA@, *covariance = w->work + @AT_COVARIANCE@, *excess = w->work + @AT_EXCESS@;
  const int has_moved_far = is_far(w);
  int i, j;
  /* The estimates before this sample, which may have changed them already. */
  memcpy(w->mean, w->mean_before, sizeof w->mean);
  memcpy(w->covariance, w->covariance_before, sizeof w->covariance);
  for (i = 0; i < MODEL_FREE; i++) {
    theta[i] = w->mean[MODEL_STATES + i];
    for (j = 0; j < MODEL_FREE; j++) {
      covariance[i * MODEL_FREE + j] = w->covariance[(MODEL_STATES + i) * N + MODEL_STATES + j];
    }
    covariance[i * MODEL_FREE + i] += walk[i] * gap;
    excess[i] = sqrt(covariance[i * MODEL_FREE + i]) / sqrt(cap[MODEL_STATES + i]);
    if (!(excess[i] > 1.0)) excess[i] = 1.0;
  }
  for (i = 0; i < MODEL_FREE; i++) {
    for (j = 0; j < MODEL_FREE; j++) covariance[i * MODEL_FREE + j] /= excess[i] * excess[j];
  }
  if (has_moved_far) set_prior(theta, covariance);
  w->restarts++;
  return start(w, time, theta, covariance);
}

/* Move the estimates to a sample and use its readings; returns 0 if this fails. */
static int apply(model_watch *w, const double *before, double step) {
  if (step > 0.0) {
    w->clock[1] = step;
    set_inputs(w, before, step);
    if (!run(w, PREDICT)) return 0;
  }
  set_inputs(w, w->row, 0.0);
  return run(w, CORRECT);
}

static int has_rejected(const model_watch *w) {
  int c;
  for (c = 0; c < MODEL_CHANNELS; c++) {
    if (fabs(w->rejected[c]) > 1.0) return 1;
  }
  return 0;
}

/* Rule of alarms ---------------------------------------------------------------------------------------------------- */

#define RISE @RISE@
#define FALL @FALL@
#define RISE_SIZE @RISE_SIZE@
#define FALL_SIZE @FALL_SIZE@
#define REVIEW @REVIEW@
#define KEPT @KEPT@
#define LARGEST @LARGEST@
#define EXPLAINED @EXPLAINED@
#define EXPLAINED_LINEARLY @EXPLAINED_LINEARLY@
#define GROWN @GROWN@
#define MISFIT @MISFIT@
#define LEFT @LEFT@
#define LIKELY @LIKELY@
#define TEMPER @TEMPER@
#define HEALTHY_NIS @HEALTHY_NIS@
#define SCATTER @SCATTER@
#define WIDE @WIDE@
#define FAULT_PRIOR @FAULT_PRIOR@
#define SPREAD @SPREAD@
#define SET @SET@
#define CEILING @CEILING@
#define LIMIT_ONE @LIMIT_ONE@ /* of the rest of one fault */
#define LIMIT_CAUTION @LIMIT_CAUTION@ /* the same, also of a single possible fault */
#define LIMIT_TWO @LIMIT_TWO@ /* of the rest of two faults */
#define LIMIT_UNKNOWN @LIMIT_UNKNOWN@

static const double alarms[] = {@ALARMS@};
static const double least_change[] = {@LEAST_CHANGE@}; /* limits of the parameters, in alarm sizes */
static const double most_change[] = {@MOST_CHANGE@};
static const int ways[] = {@WAYS@}; /* directions of the faults: 1, -1, or 0 for both */

static int is_alarm_kind(model_verdict kind) { return kind >= MODEL_FAULT; }

static double directed(int fault, double value) { return ways[fault] == 0 ? fabs(value) : ways[fault] * value; }

static int is_evident(int fault, double root, double size, double z, double least) {
  return directed(fault, root) > z && directed(fault, size) >= least;
}

/* Evidence for a step of a fault at an onset, and its size in alarm sizes. */
static double root_of(const model_watch *w, int onset, int fault) {
  const double information = w->gram[(onset * F + fault) * F + fault] * TEMPER;
  return w->numerators[onset * F + fault] / sqrt(information > 1e-300 ? information : 1e-300);
}

static double size_of(const model_watch *w, int onset, int fault) {
  const double information = w->gram[(onset * F + fault) * F + fault] * TEMPER;
  return w->numerators[onset * F + fault] * TEMPER / ((information > 1e-300 ? information : 1e-300) * alarms[fault]);
}

/* Solve a x = b for several right sides by elimination with pivots; the solution replaces b. */
static void solve(double *a, double *b, int columns) {
  int i, j, k, pivot;
  for (k = 0; k < F; k++) {
    pivot = k;
    for (i = k + 1; i < F; i++) {
      if (fabs(a[i * F + k]) > fabs(a[pivot * F + k])) pivot = i;
    }
    for (j = 0; j < F && pivot != k; j++) {
      const double other = a[k * F + j];
      a[k * F + j] = a[pivot * F + j];
      a[pivot * F + j] = other;
    }
    for (j = 0; j < columns && pivot != k; j++) {
      const double other = b[k * columns + j];
      b[k * columns + j] = b[pivot * columns + j];
      b[pivot * columns + j] = other;
    }
    for (i = k + 1; i < F; i++) {
      const double factor = a[i * F + k] / a[k * F + k];
      for (j = k; j < F; j++) a[i * F + j] -= factor * a[k * F + j];
      for (j = 0; j < columns; j++) b[i * columns + j] -= factor * b[k * columns + j];
    }
  }
  for (k = F - 1; k >= 0; k--) {
    for (j = 0; j < columns; j++) {
      double sum = b[k * columns + j];
      for (i = k + 1; i < F; i++) sum -= a[k * F + i] * b[i * columns + j];
      b[k * columns + j] = sum / a[k * F + k];
    }
  }
}

/* Information of the estimates of the filter on the faults, and its product with their changes. */
static void estimated(const model_watch *w, double *information, double *evidence) {
  double a[F * F], change[F];
  int i, j;
  for (i = 0; i < F; i++) {
    for (j = 0; j < F; j++) {
      a[i * F + j] = w->covariance[(MODEL_STATES + i) * N + MODEL_STATES + j];
      if (!w->is_settled) a[i * F + j] = i == j ? cap[MODEL_STATES + i] : 0.0;
      information[i * F + j] = i == j ? 1.0 : 0.0;
    }
    change[i] = w->is_settled ? w->mean[MODEL_STATES + i] - model_free_list[i].healthy : 0.0;
  }
  solve(a, information, F);
  for (i = 0; i < F; i++) {
    evidence[i] = 0.0;
    for (j = 0; j < F; j++) evidence[i] += information[i * F + j] * change[j];
  }
}

/* Evaluate the estimates of the filter, which change slowly, and the information of the bank. */
static void review(model_watch *w) {
  model_monitor *a = &w->monitor;
  double information[F * F], gains[F];
  double *kept = a->reviews + 3 * a->next_of_reviews;
  int i, o;
  a->next_review = a->time + REVIEW * WINDOW;
  kept[0] = a->time;
  kept[1] = a->squares;
  kept[2] = a->readings;
  a->next_of_reviews = (a->next_of_reviews + 1) % MODEL_REVIEWS;
  if (a->n_reviews < MODEL_REVIEWS) a->n_reviews++;
  estimated(w, information, gains);
  a->is_changed = 0;
  a->is_informed = 0;
  for (i = 0; i < F; i++) {
    const double diagonal = information[i * F + i];
    a->roots[i] = gains[i] / sqrt(diagonal * TEMPER);
    a->sizes[i] = gains[i] / (diagonal * alarms[i]);
    a->uncertainties[i] = sqrt(TEMPER / diagonal) / alarms[i];
    if (is_evident(i, a->roots[i], a->sizes[i], RISE, RISE_SIZE)) a->is_changed = 1;
    for (o = 0; o < MODEL_ONSETS; o++) {
      if (w->gram[(o * F + i) * F + i] * (alarms[i] * alarms[i]) > TEMPER) a->is_informed = 1;
    }
  }
}

/* Add the squared innovations of a sample, relative to healthy cycles, to their moving average. */
static void average_misfit(model_monitor *a, double ratio, double elapsed) {
  const double memory = 0.25 * WINDOW;
  double weight = 1.0;
  if (!(elapsed > 0.0)) elapsed = 0.0;
  /* A plain mean at first, until its duration reaches the memory. */
  if (elapsed < memory) a->averaged = a->averaged + elapsed < memory ? a->averaged + elapsed : memory;
  else a->averaged = 0.0;
  if (a->averaged > 0.0 && elapsed / a->averaged < 1.0) weight = elapsed / a->averaged;
  a->misfit += (ratio - a->misfit) * weight;
}

/* Statistics of single faults; each has the onset with the largest evidence. An onset after the last one of the bank is
   the estimates. */
static void compute_statistics(model_watch *w, int n_onsets) {
  model_monitor *s = &w->monitor;
  double information[F * F], evidence[F], system[F * F], right[F * (F + 1)], precision[F * F], gains[F], product[F];
  int o, i, j;
  s->joint = -HUGE_VAL;
  for (o = 0; o < n_onsets; o++) {
    double joint = 0.0;
    if (o == MODEL_ONSETS) {
      estimated(w, information, evidence);
    } else {
      memcpy(information, w->gram + o * F * F, sizeof information);
      memcpy(evidence, w->numerators + o * F, sizeof evidence);
    }
    for (i = 0; i < F; i++) {
      for (j = 0; j < F; j++) {
        const double scaled = information[i * F + j] * (alarms[i] * alarms[j] / TEMPER);
        right[i * (F + 1) + j] = scaled;
        system[i * F + j] = (i == j ? 1.0 : 0.0) + SCATTER * SCATTER * scaled;
      }
      right[i * (F + 1) + F] = evidence[i] * (alarms[i] / TEMPER);
    }
    solve(system, right, F + 1);
    for (i = 0; i < F; i++) {
      for (j = 0; j < F; j++) precision[i * F + j] = right[i * (F + 1) + j] + (i == j ? 1.0 / (WIDE * WIDE) : 0.0);
      gains[i] = product[i] = right[i * (F + 1) + F];
    }
    memcpy(system, precision, sizeof system);
    solve(system, product, 1);
    for (i = 0; i < F; i++) {
      const double diagonal = precision[i * F + i], z = directed(i, gains[i] / sqrt(diagonal));
      joint += gains[i] * product[i];
      if (o == 0 || z > s->z[i]) {
        s->z[i] = z;
        s->onsets[i] = o;
        s->best_sizes[i] = gains[i] / diagonal;
      }
    }
    if (joint > s->joint) {
      s->joint = joint;
      s->joint_onset = o;
      memcpy(s->precision, precision, sizeof precision);
      memcpy(s->gains, gains, sizeof gains);
    }
  }
  for (i = 0; i < F; i++) s->rests[i] = s->joint - (s->z[i] > 0.0 ? s->z[i] * s->z[i] : 0.0);
}

/* Probability of each single fault. `caution` divides the evidence: the effect of a fault is not linear in its size. */
static void compute_probabilities(model_monitor *a, double caution) {
  double logarithms[F], largest, total, least_occam = 0.0;
  const double healthy = log1p(-FAULT_PRIOR) - 0.5 * (a->joint / caution);
  double unknown = -HUGE_VAL;
  int i;
  largest = healthy;
  for (i = 0; i < F; i++) {
    const double ratio = SPREAD / (a->z[i] > SPREAD ? a->z[i] : SPREAD), occam = log(ratio < 1.0 ? ratio : 1.0);
    if (occam < least_occam) least_occam = occam;
    logarithms[i] = a->z[i] >= 0.0 ? log(FAULT_PRIOR / F) + occam - 0.5 * (a->rests[i] / caution) : -HUGE_VAL;
    if (logarithms[i] > largest) largest = logarithms[i];
  }
  if (F > 1) unknown = log(FAULT_PRIOR / F) + least_occam - 0.5 * LIMIT_UNKNOWN;
  if (unknown > largest) largest = unknown;
  total = exp(healthy - largest) + exp(unknown - largest);
  for (i = 0; i < F; i++) total += exp(logarithms[i] - largest);
  for (i = 0; i < F; i++) a->probabilities[i] = CEILING * exp(logarithms[i] - largest) / total;
}

static void set_verdict(model_watch *w, model_verdict kind) {
  w->verdict = kind;
  memset(w->alarm, 0, sizeof w->alarm);
}

/* Let the filter adopt total changes of some faults, in alarm sizes; returns 0 if the bank has no information on them. */
static int set_adoption(model_watch *w, int onset, int n, const int *members, const double *sizes) {
  model_monitor *a = &w->monitor;
  int k;
  if (onset >= MODEL_ONSETS) return 1; /* the estimates contain the change */
  for (k = 0; k < n; k++) {
    const double information = w->gram[(onset * F + members[k]) * F + members[k]];
    if (!(information * (alarms[members[k]] * alarms[members[k]]) > TEMPER && fabs(sizes[k]) < LARGEST)) return 0;
  }
  for (k = 0; k < n; k++) {
    const float rounded = (float)sizes[k];
    a->members[k] = members[k];
    a->steps[k] = ((double)rounded - a->adopted[members[k]]) * alarms[members[k]];
    a->adopted[members[k]] = (double)rounded;
  }
  a->n_members = n;
  a->onset = onset;
  a->next_review = -HUGE_VAL;
  a->step_since = HUGE_VAL;
  return 1;
}

static int is_possible(int fault, double size) {
  return size >= least_change[fault] - FALL_SIZE && size <= most_change[fault] + FALL_SIZE;
}

/* Two faults at once; returns 0 if none explain the evidence. `factor` is the misfit. */
static int judge_pairs(model_watch *w, double factor) {
  model_monitor *a = &w->monitor;
  double least = HUGE_VAL, sizes[2] = {0.0, 0.0};
  int pair[2] = {0, 0}, i, j;
  for (i = 0; i < F; i++) {
    for (j = i + 1; j < F; j++) {
      const double a00 = a->precision[i * F + i], a01 = a->precision[i * F + j], a11 = a->precision[j * F + j];
      const double determinant = a00 * a11 - a01 * a01;
      double first = (a11 * a->gains[i] - a01 * a->gains[j]) / determinant;
      double second = (a00 * a->gains[j] - a01 * a->gains[i]) / determinant;
      const double rest = a->joint - (a->gains[i] * first + a->gains[j] * second) / factor;
      if (!(first * ways[i] >= 0.0 && second * ways[j] >= 0.0 && rest < least)) continue;
      if (a->joint_onset < MODEL_ONSETS) {
        first += a->adopted[i];
        second += a->adopted[j];
      }
      if (!is_possible(i, first) || !is_possible(j, second)) continue;
      least = rest;
      pair[0] = i;
      pair[1] = j;
      sizes[0] = first;
      sizes[1] = second;
    }
  }
  if (!(least <= LIMIT_TWO + (1.0 - EXPLAINED_LINEARLY) * a->joint)) return 0;
  set_verdict(w, MODEL_SEVERAL);
  w->alarm[pair[0]] = w->alarm[pair[1]] = 1;
  a->is_confirmed = set_adoption(w, a->joint_onset, 2, pair, sizes);
  return 1;
}

/* Smallest set of faults that contains the fault with a probability of 95 %; returns their number. */
static int probable_set(const model_monitor *a, uint8_t *members, int *first, double *probability) {
  double total = 0.0;
  int count = 0, i;
  memset(members, 0, F);
  *first = 0;
  *probability = 0.0;
  for (i = 0; i < F; i++) total += a->probabilities[i];
  while (total > 0.0 && count < F && (count == 0 || *probability < SET * total * (1.0 - 1e-12))) {
    int best = -1;
    for (i = 0; i < F; i++) {
      if (!members[i] && (best < 0 || a->probabilities[i] > a->probabilities[best])) best = i;
    }
    if (!count++) *first = best;
    members[best] = 1;
    *probability += a->probabilities[best];
  }
  return count;
}

/* Possible times at which the fault has begun: of the best fault, and of all faults together; returns their number. */
static int find_onsets(model_watch *w, double *times) {
  model_monitor *a = &w->monitor;
  int i, k, best = 0, onsets[2];
  compute_statistics(w, MODEL_ONSETS);
  if (a->joint <= RISE * RISE) {
    times[0] = a->time - WINDOW;
    return 1;
  }
  for (i = 1; i < F; i++) {
    if (a->z[i] > a->z[best]) best = i;
  }
  onsets[0] = a->onsets[best];
  onsets[1] = a->joint_onset;
  for (k = 0; k < 2; k++) times[k] = IS_NUMBER(w->onsets[onsets[k]]) ? w->onsets[onsets[k]] : a->time;
  return onsets[0] == onsets[1] ? 1 : 2;
}

/* Sum of squared innovations since a time, relative to healthy cycles, and number of readings. */
static void sums_since(const model_monitor *a, double since, double *squares, double *readings) {
  const double *kept = a->reviews + 3 * (a->n_reviews < MODEL_REVIEWS ? 0 : a->next_of_reviews);
  int k;
  for (k = 0; k < a->n_reviews; k++) {
    const double *other = a->reviews + 3 * k;
    if (other[0] <= since && (kept[0] > since || other[0] > kept[0])) kept = other;
  }
  *squares = a->squares - kept[1];
  *readings = a->readings - kept[2];
}

/* Compare all hypotheses, set the verdict, and let the filter adopt the step of an alarm. */
static void judge(model_watch *w, int is_alarm) {
  model_monitor *a = &w->monitor;
  double times[2], z[F], rests[F], joint, least, rest = HUGE_VAL, largest = 0.0, factor = 1.0, age = 0.0, probability;
  uint8_t members[F];
  int n_times = 1, is_fit = 0, i, k, first, count;
  times[0] = a->begun;
  if (!is_alarm) n_times = find_onsets(w, times);
  compute_statistics(w, MODEL_ONSETS + 1);
  memcpy(z, a->z, sizeof z);
  memcpy(rests, a->rests, sizeof rests);
  joint = a->joint;
  for (i = 0; i < F; i++) {
    if (a->onsets[i] < MODEL_ONSETS) a->best_sizes[i] += a->adopted[i];
  }
  for (k = 0; k < n_times; k++) {
    double squares, readings, most = 0.0;
    a->begun = times[k];
    age = a->time - a->begun < WINDOW ? a->time - a->begun : WINDOW;
    sums_since(a, a->time - age, &squares, &readings);
    least = HUGE_VAL;
    for (i = 0; i < F; i++) {
      if (z[i] > most) most = z[i];
      if (z[i] > 0.0 && rests[i] < least) least = rests[i];
    }
    /* The filter has the innovations of a healthy plant; the best fault explains a part of them. */
    squares -= TEMPER * (most * most) / HEALTHY_NIS;
    if (!(squares > 0.0)) squares = 0.0;
    factor = squares / (readings > 1.0 ? readings : 1.0);
    if (!(factor > 1.0)) factor = 1.0;
    is_fit = factor <= MISFIT || squares - readings <= LEFT * (joint - least);
    a->joint = joint / factor;
    largest = -HUGE_VAL;
    rest = HUGE_VAL;
    for (i = 0; i < F; i++) {
      a->z[i] = is_possible(i, a->best_sizes[i]) ? z[i] / sqrt(factor) : -1.0;
      a->rests[i] = rests[i] / factor;
      if (a->z[i] > largest) largest = a->z[i];
      if (a->z[i] > 0.0 && a->rests[i] < rest) rest = a->rests[i];
    }
    if (is_fit && largest > RISE && rest <= LIMIT_ONE + (1.0 - EXPLAINED_LINEARLY) * a->joint) break;
  }
  a->present_at = a->time;
  compute_probabilities(a, 1.0 + (1.0 - EXPLAINED_LINEARLY) * a->joint / LIMIT_CAUTION);
  count = probable_set(a, members, &first, &probability);
  if (is_fit && largest <= RISE) {
    if (!is_alarm) set_verdict(w, MODEL_HEALTHY);
  } else if (is_fit && rest <= LIMIT_ONE + (1.0 - EXPLAINED_LINEARLY) * a->joint) {
    if (probability < LIKELY) {
      /* A single fault explains the readings, but a healthy plant is still possible. */
      age *= 0.25;
      a->next_judgement = a->time + (age > ALARM_DELAY ? age : ALARM_DELAY);
      return;
    }
    set_verdict(w, count > 1 ? MODEL_NOT_ISOLABLE : MODEL_FAULT);
    memcpy(w->alarm, members, sizeof members);
    if (count == 1 || age > KEPT * WINDOW) {
      a->is_confirmed = set_adoption(w, a->onsets[first], 1, &first, &a->best_sizes[first]);
    }
  } else if (!(is_fit && judge_pairs(w, factor)) && !is_alarm) {
    memset(a->probabilities, 0, sizeof a->probabilities);
    set_verdict(w, MODEL_NONE_FITS);
  }
  /* Without a name, the onset can be wrong: a later comparison has a better one. */
  if (!is_alarm_kind(w->verdict)) age *= 0.25;
  a->next_judgement = a->time + (age > ALARM_DELAY ? age : ALARM_DELAY);
}

/* Let the filter adopt a further step during a confirmed alarm, and add its fault to the names. */
static void add_fault(model_watch *w) {
  model_monitor *a = &w->monitor;
  double least = HUGE_VAL, size, explained;
  int i, k = 0;
  compute_statistics(w, MODEL_ONSETS);
  for (i = 0; i < F; i++) {
    if (a->z[i] > RISE && a->rests[i] < least) {
      least = a->rests[i];
      k = i;
    }
  }
  size = a->adopted[k] + a->best_sizes[k];
  /* A fault that grows steadily is not a step, and is followed in several steps. */
  explained = a->adopted[k] * a->best_sizes[k] > 0.0 ? GROWN : EXPLAINED;
  if (!(a->rests[k] <= LIMIT_ONE + (1.0 - explained) * a->joint)) return;
  if (set_adoption(w, a->onsets[k], 1, &k, &size) && !w->alarm[k]) {
    w->alarm[k] = 1;
    w->verdict = MODEL_SEVERAL;
  }
}

/* Let the filter adopt a step that is no new fault: against its direction, or a change during an alarm. */
static void adopt_return(model_watch *w, int is_alarm) {
  model_monitor *a = &w->monitor;
  double largest = -1.0, root, size;
  int o, i, onset = 0, fault = 0;
  for (o = 0; o < MODEL_ONSETS; o++) {
    for (i = 0; i < F; i++) {
      if (fabs(root_of(w, o, i)) > largest) {
        largest = fabs(root_of(w, o, i));
        onset = o;
        fault = i;
      }
    }
  }
  root = root_of(w, onset, fault);
  size = size_of(w, onset, fault);
  if (largest > RISE && fabs(size) >= FALL_SIZE && (is_alarm || root * ways[fault] < 0.0) &&
      !is_evident(fault, root, size + a->adopted[fault], RISE, RISE_SIZE)) {
    size += a->adopted[fault];
    (void)set_adoption(w, onset, 1, &fault, &size);
  }
}

/* Returns 1 if the faults of the present alarm have been absent for the alarm delay. A fault that the filter has adopted
   is absent only if its estimate is well known and small. */
static int has_ended(model_watch *w, int has_steps) {
  model_monitor *a = &w->monitor;
  int o, i;
  for (i = 0; i < F; i++) {
    int is_present;
    if (a->is_confirmed) {
      is_present = directed(i, a->sizes[i]) >= FALL_SIZE || a->uncertainties[i] >= FALL_SIZE;
    } else {
      is_present = is_evident(i, a->roots[i], a->sizes[i], FALL, FALL_SIZE);
      for (o = 0; has_steps && o < MODEL_ONSETS; o++) {
        is_present |= is_evident(i, root_of(w, o, i), size_of(w, o, i) + a->adopted[i], FALL, FALL_SIZE);
      }
    }
    if (is_present && w->alarm[i]) a->present_at = a->time;
  }
  return a->time - a->present_at > ALARM_DELAY;
}

static void monitor(model_watch *w) {
  model_monitor *a = &w->monitor;
  const double time = w->time;
  const int count = model_count(w), was_alarm = is_alarm_kind(w->verdict);
  const double limit = was_alarm ? FALL : RISE;
  const double elapsed = time - a->time;
  double latest;
  int has_steps = 0, is_step = 0, is_fault, is_alarm, o, i;
  a->n_members = 0;
  if (!count) {
    /* Without readings, old evidence does not become older. */
    const double known = a->information;
    a->information = 0.0;
    for (i = 0; i < MODEL_STEPS * F; i++) a->information += w->gram[i];
    if (!(a->information > known)) return;
  }
  a->time = time;
  if (elapsed > ALARM_DELAY && elapsed < HUGE_VAL) {
    a->step_since = a->fault_since = HUGE_VAL;
    a->present_at += elapsed;
  }
  if (count) average_misfit(a, w->nis / (count * HEALTHY_NIS), elapsed);
  a->squares += w->nis / HEALTHY_NIS;
  a->readings += count;
  if (time >= a->next_review) review(w);
  is_fault = a->is_changed;
  for (o = 0; o < MODEL_ONSETS; o++) {
    for (i = 0; i < F; i++) {
      const double evidence = w->numerators[o * F + i], information = w->gram[(o * F + i) * F + i] * TEMPER;
      if (evidence * evidence > limit * limit * information) has_steps = 1;
    }
  }
  for (o = 0; has_steps && o < MODEL_ONSETS; o++) {
    for (i = 0; i < F; i++) {
      const double root = root_of(w, o, i), size = size_of(w, o, i);
      if (fabs(root) > RISE && fabs(size) >= FALL_SIZE) is_step = 1;
      if (is_evident(i, root, size + a->adopted[i], RISE, RISE_SIZE)) is_fault = 1;
    }
  }
  if (!is_step) {
    a->step_since = HUGE_VAL;
  } else if (a->step_since == HUGE_VAL) {
    a->step_since = time;
    a->next_judgement = -HUGE_VAL;
  }
  if (!is_fault) a->fault_since = HUGE_VAL;
  else if (a->fault_since > time) a->fault_since = time;
  is_alarm = was_alarm && !has_ended(w, has_steps);
  a->is_confirmed = a->is_confirmed && is_alarm;
  latest = a->step_since > a->fault_since ? a->step_since : a->fault_since;
  if (a->is_confirmed) {
    if (has_steps && time - latest >= ALARM_DELAY) add_fault(w);
  } else if (is_alarm || time - a->fault_since >= ALARM_DELAY) {
    if (time >= a->next_judgement && (time - latest >= ALARM_DELAY || !is_step)) judge(w, is_alarm);
  } else {
    for (i = 0; i < F; i++) a->probabilities[i] = FAULT_PRIOR / F;
    if (a->misfit > MISFIT && a->averaged > ALARM_DELAY) set_verdict(w, MODEL_NONE_FITS);
    else set_verdict(w, a->is_informed ? MODEL_HEALTHY : MODEL_NO_INFORMATION);
  }
  /* Without confirmation, the fault of the alarm is not known yet. */
  if (!a->n_members && has_steps && !(is_alarm && !a->is_confirmed) && time - a->step_since >= ALARM_DELAY) {
    adopt_return(w, is_alarm);
  }
  if (a->n_members) {
    adopt(w);
    if (!is_valid(w)) (void)restart(w, time, 0.0);
  }
  if (!is_alarm_kind(w->verdict)) end_growth(w);
}

/* Interface --------------------------------------------------------------------------------------------------------- */

void model_init(model_watch *w) {
  model_monitor *a = &w->monitor;
  int j;
  memset(w, 0, sizeof *w);
  memcpy(w->p, start_p, sizeof start_p);
  memcpy(w->walk + MODEL_STATES, walk, MODEL_FREE * sizeof(double));
  for (j = 0; j < MODEL_INPUTS; j++) w->row[j] = start_u[driven[j]];
  reset(w);
  a->time = a->next_review = a->next_judgement = a->present_at = a->begun = -HUGE_VAL;
  a->step_since = a->fault_since = HUGE_VAL;
  a->misfit = 1.0;
  for (j = 0; j < F; j++) a->uncertainties[j] = HUGE_VAL;
  w->verdict = MODEL_NO_INFORMATION;
}

int model_update(model_watch *w, double time, const double *readings, const double *inputs) {
  double before[@ROOM_INPUTS@], step, longest = WINDOW;
  int status = MODEL_OK, is_moved;
  if (!IS_NUMBER(time) || (w->is_started && time < w->time)) {
    w->ignored++;
    return MODEL_LATE;
  }
  memcpy(before, w->row, sizeof before);
  memcpy(w->mean_before, w->mean, sizeof w->mean);
  memcpy(w->covariance_before, w->covariance, sizeof w->covariance);
  fill_row(w, inputs);
  memcpy(w->readings, readings, sizeof w->readings);
  if (!w->is_started) {
    double *theta = w->work + @AT_THETA@, *covariance = w->work + @AT_COVARIANCE@;
    set_prior(theta, covariance);
    if (!start(w, time, theta, covariance)) {
      reset(w);
      w->ignored++;
      return MODEL_FAILED;
    }
    w->is_started = 1;
  } else {
    step = time - w->time;
    if (MODEL_INPUTS && w->usual_step > 0.0 && GAP * w->usual_step < longest) longest = GAP * w->usual_step;
    is_moved = step <= longest && apply(w, before, step) && is_valid(w);
    if (is_moved && time >= w->next_check) {
      w->next_check = time + CHECK * WINDOW;
      is_moved = !is_far(w);
    }
    if (!is_moved) {
      memcpy(w->readings, readings, sizeof w->readings);
      if (!restart(w, time, step)) {
        w->ignored++;
        return MODEL_FAILED;
      }
      status = MODEL_RESTARTED;
    } else {
      w->time = time;
      w->age++;
      if (w->age < FIRST && has_rejected(w)) {
        /* The reading of the start was an outlier, not these ones. */
        memcpy(w->readings, readings, sizeof w->readings);
        if (!start(w, time, w->start_theta, w->start_covariance)) {
          w->ignored++;
          return MODEL_FAILED;
        }
        monitor(w);
        return MODEL_RESTARTED;
      }
      w->usual_step += (step - w->usual_step) * (w->usual_step > 0.0 ? FORGET : 1.0);
      if (!w->is_settled && time >= w->settles_at) {
        w->is_settled = 1;
        clear_bank(w);
      }
      if (time >= w->next_onset) begin_onset(w, slot_to_renew(w));
    }
  }
  monitor(w);
  return status;
}

int model_alarm(const model_watch *w) {
  int i, count = 0;
  for (i = 0; i < F; i++) count += w->alarm[i];
  return count;
}

double model_value(const model_watch *w, int number) { return w->mean[MODEL_STATES + number]; }

double model_sigma(const model_watch *w, int number) {
  const int row = MODEL_STATES + number;
  double variance = w->covariance[row * N + row], most = 0.0;
  int i, o;
  /* Changes by steps that are evident, but not adopted. */
  for (i = 0; i < F && (is_alarm_kind(w->verdict) || w->monitor.step_since < HUGE_VAL); i++) {
    int onset = 0;
    double change;
    for (o = 1; o < MODEL_ONSETS; o++) {
      if (fabs(root_of(w, o, i)) > fabs(root_of(w, onset, i))) onset = o;
    }
    if (!(fabs(root_of(w, onset, i)) > FALL)) continue;
    change = w->signatures[row * MODEL_STEPS + onset * F + i] * (size_of(w, onset, i) * alarms[i]);
    if (change * change > most) most = change * change;
  }
  return sqrt(variance + most);
}

double model_z(const model_watch *w, int fault) {
  double largest = directed(fault, w->monitor.roots[fault]);
  int o;
  for (o = 0; o < MODEL_ONSETS; o++) {
    const double z = directed(fault, root_of(w, o, fault));
    if (z > largest) largest = z;
  }
  return largest;
}

double model_nis(const model_watch *w) { return w->nis; }

int model_count(const model_watch *w) {
  int c, count = 0;
  for (c = 0; c < MODEL_CHANNELS; c++) count += w->used[c] > 0.0;
  return count;
}
