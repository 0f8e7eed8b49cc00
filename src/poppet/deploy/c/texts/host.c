/* @ABOUT@

   An example of a host, and a check: both integrators against rows that poppet has computed. Exit code 0 where all is
   well. `model_host STEP SUBSTEPS` takes another length of the fixed step [s] than 1 ms, made in so many substeps. */
#include "@NAME@.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { ROWS = @ROWS@, COMPARED = @COMPARED@ };
static const double times[ROWS] = {@TIMES@};
/* Outputs that are states, which do not jump: size and expected values at these times. */
static const int places[] = {@PLACES_OF_STATES@};
static const double sizes[] = {@SIZES@};
static const double known[] = {
@KNOWN@
};
/* By how much of its size each may differ there: by the tolerance, and by ten times what a start that is moved by 1e-14,
   or a tolerance as coarse as the fixed step, becomes in it. A number beyond 1 says that this run shows nothing there. */
static const double allowed_adaptive[] = {
@ALLOWED_ADAPTIVE@
};
static const double allowed_fixed[] = {
@ALLOWED_FIXED@
};

/* Returns 1 if all states are within their limits; prints the state with the largest ratio to its limit. */
static int is_near(const double *table, const double *allowed) {
  double worst = -1.0, most = 0.0, limit = 0.0, at = 0.0;
  int k, row, place = -1;
  for (k = 0; k < COMPARED; k++) {
    for (row = 0; row < ROWS; row++) {
      double d = fabs(table[places[k] * ROWS + row] - known[k * ROWS + row]) / sizes[k];
      if (d / allowed[k * ROWS + row] <= worst) continue;
      most = d;
      limit = allowed[k * ROWS + row];
      worst = d / limit;
      at = times[row];
      place = places[k];
      if (!(worst <= 1e300)) k = COMPARED, row = ROWS; /* not a number */
    }
  }
  if (place >= 0) {
    printf("difference %.2e of %s at %g s, %.2e allowed\n", most, model_output_list[place].name, at, limit);
  }
  return worst <= 1.0;
}

static int adaptive_is_well(void) {
  static model_adaptive m;
  static double table[MODEL_OUTPUTS * ROWS];
  int64_t status;
  model_adaptive_begin(&m);
  status = model_adaptive_run(&m, times, ROWS, table);
  printf("adaptive: status %d, %d steps; ", (int)status, (int)m.counts[0]);
  return is_near(table, allowed_adaptive) && (status == 0 || status == 1);
}

static int fixed_is_well(double h, int substeps) {
  static model_fixed m;
  static double table[MODEL_OUTPUTS * ROWS];
  double y[MODEL_OUTPUTS];
  double count = 0.0;
  int row, k;
  model_fixed_begin(&m);
  if (substeps) m.substeps = substeps;
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
  printf("fixed step of %g s in %d: ", h, m.substeps);
  return is_near(table, allowed_fixed);
}

int main(int count, char **arguments) {
  int is_well = adaptive_is_well();
  is_well &= fixed_is_well(count > 1 ? atof(arguments[1]) : 1e-3, count > 2 ? atoi(arguments[2]) : 0);
  puts(is_well ? "well" : "NOT WELL");
  return is_well ? 0 : 1;
}
