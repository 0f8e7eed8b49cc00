/* @ABOUT@

   Constants: names, units, values at the start, limits; courses of the signals. */
#include "@NAME@.h"

#include <math.h>

const model_number model_number_list[] = {
@NUMBERS@
};

const model_input model_input_list[] = {
@INPUTS@
};

const model_quantity model_state_list[] = {
@STATES@
};

const model_quantity model_memory_list[] = {
@MEMORY@
};

const model_quantity model_output_list[] = {
@OUTPUTS@
};

/* Start of each segment of the signals, and the index of its coefficients. */
const double model_starts[] = {@STARTS@};
const uint8_t model_jumps[] = {@JUMPS@}; /* 1 if an input jumps at the start */
const int64_t model_courses[] = {@COURSES@};
/* For each set and input: value, slope, amplitude, frequency, chirp rate, phase, and origin of its time. */
const double model_coefficients[] = {
@COEFFICIENTS@
};

double model_limit(int place, double value, uint8_t *limited) {
  const double low = model_input_list[place].low, high = model_input_list[place].high;
  const double nearest = value < low ? low : value > high ? high : value;
  const int has_range = low > -HUGE_VAL && high < HUGE_VAL;
  double allowance = 1e-6 * (has_range ? high - low : fabs(nearest));
  if (!has_range && allowance < 1e-12) allowance = 1e-12;
  *limited = 0;
  if (value - value != 0.0) return value;
  if (fabs(value - nearest) > allowance) *limited = 1;
  return nearest;
}

int model_set(double *p, int place, double value) {
  if (place < 0 || place >= MODEL_NUMBERS || !model_number_list[place].may_change) return 1;
  if (!(value >= model_number_list[place].low && value <= model_number_list[place].high) || value - value != 0.0)
    return 2;
  p[place] = value;
  return 0;
}
