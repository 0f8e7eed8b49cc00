/* @ABOUT@ */
#include "@NAME@.h"

#include <math.h>

#define N_TIMERS @N_TIMERS@

@HELPERS@/* Use valid inputs and parameters. The others keep their last valid values. */
static void accept(const model_in_t *in, const model_param_t *param, const model_state_t *z, model_state_t *next) {
@ACCEPT@
}

/* Set the memory before the first sample. */
static void start(const model_state_t *z, model_state_t *next) {
@START@
}

/* Advance the timers, and find those that have expired. */
static void advance(@REAL@ dt, const model_state_t *z, model_state_t *next, bool fired[N_TIMERS]) {
@ADVANCE@
}

/* Execute one sample of each controller whose timer has expired. */
static void update(const model_state_t *z, const bool fired[N_TIMERS], model_state_t *next) {
@UPDATE@
}

/* Write the outputs, and return the status. */
static model_status_t outputs(const model_state_t *z, model_out_t *out) {
  bool input_held;
  bool safe;
  bool saturated;
  bool late;
  bool parameter_held;
  model_status_t status = MODEL_OK;
@OUTPUTS@
  if (input_held) {
    status |= MODEL_INPUT_HELD;
  }
  if (safe) {
    status |= MODEL_SAFE;
  }
  if (saturated) {
    status |= MODEL_SATURATED;
  }
  if (late) {
    status |= MODEL_LATE;
  }
  if (parameter_held) {
    status |= MODEL_PARAMETER_HELD;
  }
  return status;
}

void model_init(model_t *r) {
@INITIAL@
  r->state.in = r->in;
  r->state.param = r->param;
  r->state.has_input_fault = false;
  r->state.has_parameter_fault = false;
  r->state.is_late = false;
  model_reset(r);
}

void model_reset(model_t *r) {
  model_state_t next = r->state;
  start(&r->state, &next);
  next.is_started = false;
  r->state = next;
  (void)outputs(&r->state, &r->out);
}

model_status_t model_step(model_t *r) {
  return model_step_dt(r, MODEL_CYCLE);
}

model_status_t model_step_dt(model_t *r, @REAL@ dt) {
  bool fired[N_TIMERS];
  bool has_fired = false;
  int k;
  model_state_t next = r->state;

  accept(&r->in, &r->param, &r->state, &next);
  r->state = next;
  if (!r->state.is_started) {
    start(&r->state, &next);
    r->state = next;
  }
  advance(dt, &r->state, &next, fired);
  r->state = next;
  for (k = 0; k < N_TIMERS; k++) {
    has_fired = has_fired || fired[k];
  }
  if (has_fired) {
    update(&r->state, fired, &next);
    r->state = next;
  }
  return outputs(&r->state, &r->out);
}
