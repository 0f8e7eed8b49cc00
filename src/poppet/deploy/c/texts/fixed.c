/* @ABOUT@

   The model for real time: steps of a length that the caller decides, by a Rosenbrock method of two stages.

   The method is ROS2 of Verwer, Spee, Blom and Hundsdorfer (SIAM J. Sci. Comput. 20, 1999, 1456-1480): order 2, L-stable
   with gamma = 1 + 1/sqrt(2), with the exact Jacobian and the drift of inputs that move, one factorisation in a step.
   With the other value, 1 - 1/sqrt(2), errors are smaller, but its first stage goes 3.4 times as far as to the rest of
   what is fast: small volumes would be emptied on the way.
   The integrals of flows that the adaptive run keeps are left out. Nothing is allocated, nothing kept but in *m. */
#include "@NAME@.h"

#include <math.h>

@FUNCTIONS@

@PIECES@
#define GAMMA 1.70710678118654752440 /* 1 + 1/sqrt(2) */
#define AFTER_JUMP 4
#define HALVINGS 6 /* of a step that leaves the domain of the model */
#define MOST_PARTS 256 /* of a substep that is divided by sample instants and breakpoints */

#define APART 0.1 /* of a state: a larger difference of both stages halves the step */

static const uint8_t positive[] = {@POSITIVE@};
static const double nominal[] = {@NOMINAL@};

/* Value of an input that the caller sets: within its limits, and the last one that was finite. */
static double host_input(const model_fixed *m, int k, double t) {
  uint8_t ignored;
  double value = model_limit(k, m->u[k] + (t - m->t) * m->slopes[k], &ignored);
  return value - value == 0.0 ? value : m->accepted[k];
}

/* Inputs at a time of the present segment, and their slopes; returns 0 if they are constant. */
static int inputs_now(const model_fixed *m, double t, double *u, double *slopes) {
  double own[MODEL_ROOM_OF_INPUTS], moving[MODEL_ROOM_OF_INPUTS];
  Segment segment;
  vector all;
  int k, moves = 0;
  segment.start = 0.0;
  segment.stop = 0.0;
  segment.inputs.at = (double *)(intptr_t)(model_coefficients + model_courses[m->segment] * MODEL_ROOM_OF_INPUTS * 7);
  segment.inputs.rows = MODEL_INPUTS;
  segment.inputs.columns = 7;
  all.size = MODEL_INPUTS;
  all.at = own;
  do_inputs_at(t, segment, all);
  all.at = moving;
  if (slopes) do_input_slopes_at(t, segment, all);
  for (k = 0; k < MODEL_INPUTS; k++) {
    if (m->by_host[k]) {
      u[k] = host_input(m, k, t);
      moves |= m->slopes[k] != 0.0;
      continue;
    }
    u[k] = model_input_list[k].is_driven || model_input_list[k].number < 0 ? own[k] : m->p[model_input_list[k].number];
    if (slopes) {
      slopes[k] = moving[k];
      moves |= moving[k] != 0.0;
    }
  }
  return moves;
}

/* Present segment of the signals, inputs, and sampled parts whose instant has come. */
static void settle(model_fixed *m) {
  double due = m->t + do_rounding(m->t);
  while (m->segment + 1 < MODEL_SEGMENTS && model_starts[m->segment + 1] <= due) {
    m->segment++;
    m->has_jumped |= model_jumps[m->segment];
  }
@UPDATE@
}

/* One step of the method; returns 0 if the new state is valid. */
static int step(model_fixed *m, double h, int moves, int is_choosy) {
@STEP@
}

void model_fixed_begin(model_fixed *m) {
  int64_t k;
  for (k = 0; k < MODEL_NUMBERS; k++) m->p[k] = model_number_list[k].value;
  for (k = 0; k < MODEL_ROOM_OF_INPUTS; k++) {
    m->by_host[k] = 0;
    m->limited[k] = 0;
    m->u[k] = 0.0;
    m->accepted[k] = 0.0;
    m->slopes[k] = 0.0;
  }
  m->substeps = MODEL_SUBSTEPS;
  model_fixed_restart(m);
  inputs_now(m, m->t, m->u, 0);
  for (k = 0; k < MODEL_INPUTS; k++) m->accepted[k] = m->u[k];
}

void model_fixed_restart(model_fixed *m) {
  m->t = 0.0;
  m->segment = 0;
  m->has_jumped = 1;
  start(m->p, m->x, m->p + MODEL_NUMBERS);
  settle(m);
}

/* Check the inputs of a step: limit values, and slopes so that they end at the limit; returns a status. */
static int check_inputs(model_fixed *m, double until) {
  int k, status = MODEL_OK;
  for (k = 0; k < MODEL_INPUTS; k++) {
    uint8_t at_end = 0;
    double end, limit;
    m->limited[k] = 0;
    if (!m->by_host[k]) continue; /* model_set checks parameters */
    if (m->u[k] - m->u[k] != 0.0 || m->slopes[k] - m->slopes[k] != 0.0) {
      status = MODEL_INVALID;
      if (m->u[k] - m->u[k] != 0.0) m->u[k] = m->accepted[k];
    } else {
      m->u[k] = m->accepted[k] = model_limit(k, m->u[k], m->limited + k);
      end = m->u[k] + (until - m->t) * m->slopes[k];
      limit = model_limit(k, end, &at_end);
      if (limit != end && until > m->t) m->slopes[k] = (limit - m->u[k]) / (until - m->t);
      if (at_end) m->limited[k] = 1;
    }
    if (m->limited[k] && status == MODEL_OK) status = MODEL_LIMITED;
  }
  return status;
}

static int integrate_to(model_fixed *m, double until) {
  const long substeps = m->substeps > 1 ? m->substeps : 1;
  const double longest = (until - m->t) / (double)substeps;
  long parts = 0;
  int halved = 0, k;
  /* A jump of an input causes fast transients: the first step after it is divided. */
  int left = m->has_jumped ? AFTER_JUMP : 1;
  double share = 1.0;
  m->has_jumped = 0;
  while (m->t < until) {
    double end = until, even, h;
    int moves = inputs_now(m, m->t, m->u, m->slopes);
    if (++parts > MOST_PARTS * substeps) return MODEL_TOO_MANY;
    if (m->segment + 1 < MODEL_SEGMENTS && model_starts[m->segment + 1] < end - do_rounding(end)) {
      end = model_starts[m->segment + 1];
    }
@INSTANT@
    /* Equal substeps up to that time. */
    even = floor((end - m->t) / longest + (1.0 - 1e-9));
    h = (end - m->t) * share / (even > 1.0 ? left * even : left);
    if (step(m, h, moves, halved < HALVINGS)) {
      if (++halved > HALVINGS) return MODEL_OUTSIDE;
      share *= 0.5;
      continue;
    }
    end = share < 1.0 || left > 1 || even > 1.0 ? m->t + h : end;
    for (k = 0; k < MODEL_INPUTS; k++) {
      if (m->by_host[k]) m->u[k] = m->accepted[k] = host_input(m, k, end);
    }
    m->t = end;
    left -= left > 1;
    /* The next part is at most twice the last successful one. */
    share = share < 0.5 ? 2.0 * share : 1.0;
    halved -= halved > 0;
    settle(m);
  }
  return MODEL_OK;
}

int model_fixed_step(model_fixed *m, double until) {
  double slopes[MODEL_ROOM_OF_INPUTS];
  int k, status, checked;
  if (until - until != 0.0 || until < m->t - do_rounding(m->t)) return MODEL_INVALID;
  for (k = 0; k < MODEL_ROOM_OF_INPUTS; k++) slopes[k] = m->slopes[k];
  checked = check_inputs(m, until);
  if (checked == MODEL_INVALID) return checked;
  status = integrate_to(m, until);
  for (k = 0; k < MODEL_ROOM_OF_INPUTS; k++) m->slopes[k] = m->by_host[k] ? slopes[k] : m->slopes[k];
  return status | checked;
}

void model_fixed_outputs(const model_fixed *m, double *y) {
  double u[MODEL_ROOM_OF_INPUTS];
  inputs_now(m, m->t, u, 0);
  outputs(&m->t, m->x, u, m->p, y);
}
