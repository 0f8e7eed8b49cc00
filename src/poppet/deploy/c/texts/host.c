/* @ABOUT@

   An example of a host, and a check: both integrators against rows that poppet has computed. Exit code 0 where all is
   well. `model_host STEP` takes another length of the fixed step [s] than 1 ms. */
#include "@NAME@.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { ROWS = @ROWS@ };
static const double times[ROWS] = {@TIMES@};
/* Of each output its size, and its values at these times. */
static const double sizes[] = {@SIZES@};
static const double known[] = {
@KNOWN@
};
static const uint8_t is_smooth[] = {@SMOOTH@}; /* states: they do not jump */

/* The greatest difference of an output from what is known, by its size. */
static double difference(const double *table, int output) {
  double worst = 0.0;
  int row;
  for (row = 0; row < ROWS; row++) {
    double d = fabs(table[output * ROWS + row] - known[output * ROWS + row]) / sizes[output];
    if (!(d <= worst)) worst = d;
  }
  return worst;
}

static int adaptive_is_well(void) {
  static model_adaptive m;
  static double table[MODEL_OUTPUTS * ROWS];
  double worst = 0.0;
  int64_t status;
  int k;
  model_adaptive_begin(&m);
  status = model_adaptive_run(&m, times, ROWS, table);
  for (k = 0; k < MODEL_OUTPUTS; k++) {
    double d = is_smooth[k] ? difference(table, k) : 0.0;
    if (!(d <= worst)) worst = d;
  }
  printf("adaptive: status %d, %d steps, greatest difference of a state %.2e\n", (int)status, (int)m.counts[0], worst);
  return (status == 0 || status == 1) && worst <= @ALLOWED@;
}

static int fixed_is_well(double h) {
  static model_fixed m;
  static double table[MODEL_OUTPUTS * ROWS];
  double y[MODEL_OUTPUTS], worst = 0.0;
  double count = 0.0;
  int row, k, worst_output = 0;
  model_fixed_begin(&m);
  for (row = 0; row < ROWS; row++) {
    while (m.t < times[row]) {
      double until = ++count * h;
      int status = model_fixed_step(&m, until < times[row] * (1.0 - 1e-12) ? until : times[row]);
      if (until > times[row]) count -= 1.0;
      if (status) {
        printf("fixed step: status %d at %g s\n", status, m.t);
        return 0;
      }
    }
    model_fixed_outputs(&m, y);
    for (k = 0; k < MODEL_OUTPUTS; k++) table[k * ROWS + row] = y[k];
  }
  for (k = 0; k < MODEL_OUTPUTS; k++) {
    double d = is_smooth[k] ? difference(table, k) : 0.0;
    if (!(d <= worst)) {
      worst = d;
      worst_output = k;
    }
  }
  printf("fixed step of %g s: greatest difference of a state %.2e, of %s\n", h, worst, model_output_list[worst_output].name);
  return worst <= 0.05;
}

int main(int count, char **arguments) {
  int is_well = adaptive_is_well();
  is_well &= fixed_is_well(count > 1 ? atof(arguments[1]) : 1e-3);
  puts(is_well ? "well" : "NOT WELL");
  return is_well ? 0 : 1;
}
