/* @ABOUT@

   Functions of the model, and a run by the adaptive integrator of poppet, whose source is model_integrator.c. */
#include "@NAME@.h"

#include <math.h>

@FUNCTIONS@

static const double scales[] = {@SCALES@}; /* per state: factor on the tolerance, floor, nominal size */
static const uint8_t positive[] = {@POSITIVE@};
static const uint8_t acting[] = {@ACTING@};
static const int64_t places[] = {@PLACES@}; /* stop conditions: indices of outputs, or -1, and weights */
static const double weights[] = {@WEIGHTS@};

int64_t model_integrate(const int64_t *fields);

static int64_t address(const void *of) { return (int64_t)(intptr_t)of; }

void model_adaptive_begin(model_adaptive *m) {
  int64_t k;
  for (k = 0; k < MODEL_NUMBERS; k++) m->p[k] = model_number_list[k].value;
  for (k = 0; k < (int64_t)(sizeof m->coefficients / sizeof m->coefficients[0]); k++) {
    m->coefficients[k] = model_coefficients[k];
  }
  m->tolerance = @TOLERANCE@;
  m->longest_step = @LONGEST@;
  m->most_attempts = 20000000;
}

int64_t model_adaptive_run(model_adaptive *m, const double *times, int64_t n_times, double *table) {
  int64_t job[@N_FIELDS@], course, k;
  int place, status = MODEL_OK;
  for (k = 0; k < n_times; k++) {
    if (times[k] - times[k] != 0.0 || times[k] < (k ? times[k - 1] : 0.0)) return MODEL_INVALID;
  }
  for (k = 0; k < MODEL_NUMBERS; k++) {
    if (m->p[k] - m->p[k] != 0.0) return MODEL_INVALID;
  }
  /* An input without a signal has the value of its parameter. */
  for (place = 0; place < MODEL_INPUTS; place++) {
    double value;
    m->limited[place] = 0;
    if (model_input_list[place].number < 0 || model_input_list[place].is_driven) continue;
    value = model_limit(place, m->p[model_input_list[place].number], m->limited + place);
    if (m->limited[place]) status = MODEL_LIMITED;
    for (course = 0; course < MODEL_COURSES; course++) {
      m->coefficients[(course * MODEL_ROOM_OF_INPUTS + place) * 7] = value;
    }
  }
  model_start(m->p, m->x, m->p + MODEL_NUMBERS);
  m->limits[0] = m->longest_step;
  m->limits[1] = m->most_attempts;
  m->limits[2] = 0.0;
  m->limits[3] = m->tolerance;
  m->watch[0] = 0.0;
  m->watch[1] = 0.0;
  for (k = 0; k < 5; k++) m->counts[k] = 0;
@JOB@
  return model_integrate(job) | status;
}
