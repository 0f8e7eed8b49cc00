/* @ABOUT@

   An example of a host, and a check: outputs of @CALLS@ calls against those that poppet has computed. Exit code 0 where
   all is well. */
#include "@NAME@.h"

#include <math.h>
#include <stdio.h>

enum { CALLS = @CALLS@ };
static const double given[] = {
@GIVEN@
};
static const double known[] = {
@KNOWN@
};
static const double sizes[] = {@SIZES@};
static const char *const names[] = {@NAMES@};

int main(void) {
  static model_state m;
  double worst = 0.0;
  int call, k, which = 0;
  model_begin(&m);
  for (call = 0; call < CALLS; call++) {
    for (k = 0; k < MODEL_INPUTS; k++) m.u[k] = (@REAL@)given[call * MODEL_INPUTS + k];
    model_call(&m, call * MODEL_CYCLE);
    for (k = 0; k < MODEL_OUTPUTS; k++) {
      double d = fabs((double)m.y[k] - known[call * MODEL_OUTPUTS + k]) / sizes[k];
      if (!(d <= worst)) {
        worst = d;
        which = k;
      }
    }
  }
  printf("%d calls, greatest difference %.2e, of %s: %s\n", CALLS, worst, names[which], worst <= @ALLOWED@ ? "well" : "NOT WELL");
  return worst <= @ALLOWED@ ? 0 : 1;
}
