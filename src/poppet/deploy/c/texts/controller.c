/* @ABOUT@ */
#include "@NAME@.h"

#include <math.h>

@FUNCTIONS@

void model_begin(model_state *m) {
  static const double numbers[] = {@START@};
  static const @REAL@ held[] = {@HELD@};
  int k;
  for (k = 0; k < MODEL_NUMBERS; k++) m->p[k] = numbers[k];
  for (k = 0; k < MODEL_INPUTS; k++) m->u[k] = held[k];
  for (k = 0; k < MODEL_OUTPUTS; k++) m->y[k] = 0;
  model_restart(m);
}

void model_restart(model_state *m) { start(m->p, m->z); }

void model_call(model_state *m, double t) {
  @REAL@ fired[MODEL_TIMERS];
  double after[MODEL_MEMORY];
  int k, any, rounds;
  /* Times within this tolerance are one instant. A part can set a timer to the same instant again. */
  const double due = t + 1e-14 * t + 1e-15;
  for (rounds = 0; rounds < 64; rounds++) {
    for (any = 0, k = 0; k < MODEL_TIMERS; k++) {
      fired[k] = m->z[k] <= due;
      any |= m->z[k] <= due;
    }
    if (!any) break;
    update(&t, m->u, m->p, m->z, fired, after);
    for (k = 0; k < MODEL_MEMORY; k++) m->z[k] = after[k];
  }
  outputs(m->u, m->p, m->z, m->y);
}
