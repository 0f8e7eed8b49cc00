/* @ABOUT@

   An example of a host program, and a check: it compares outputs and status of @CALLS@ calls with those that poppet has
   computed. Some inputs are not finite. The exit code is 0 if all agree. */
#include "@NAME@.h"

#include <math.h>
#include <stdio.h>

enum { CALLS = @CALLS@, N_IN = @N_IN@, N_OUT = @N_OUT@ };
static const double given[] = {
@GIVEN@
};
static const double known[] = {
@KNOWN@
};
static const unsigned status_known[] = {@STATUS@};
static const double sizes[] = {@SIZES@};
static const char *const names[] = {@NAMES@};

int main(void) {
  static model_t r;
  double worst = 0.0;
  int call, k, which = 0, wrong = 0;
  model_init(&r);
  for (call = 0; call < CALLS; call++) {
    const double *row = &given[call * N_IN];
    double out[N_OUT];
    unsigned status;
@READ@
    status = (unsigned)model_step(&r);
@WRITE@
    wrong += status != status_known[call];
    for (k = 0; k < N_OUT; k++) {
      double d = fabs(out[k] - known[call * N_OUT + k]) / sizes[k];
      if (!(d <= worst)) {
        worst = d;
        which = k;
      }
    }
  }
  printf("%d calls, maximum difference %.2e, of %s, %d statuses differ: %s\n", CALLS, worst, names[which], wrong,
         worst <= @ALLOWED@ && wrong == 0 ? "passed" : "FAILED");
  return worst <= @ALLOWED@ && wrong == 0 ? 0 : 1;
}
