/* @ABOUT@

   Condition monitoring of a running plant: an extended Kalman filter for states and free numbers, a bank of possible
   onsets of the faults, and the rule of alarms. Call model_init once, then model_update with each sample, and read the
   results. All values are SI, and pressures and temperatures are absolute. The code allocates no memory, does not
   recurse, and has no state outside the struct, which can be copied. Not for -ffast-math: the code tests for NaN. */
#ifndef MODEL_H
#define MODEL_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
  MODEL_CHANNELS = @CHANNELS@, /* sensors */
  MODEL_INPUTS = @INPUTS@, /* inputs of the circuit that the samples drive */
  MODEL_FAULTS = @FAULTS@,
  MODEL_FREE = @FREE@, /* free numbers: faults, then nuisances, then offsets of sensors */
  MODEL_STATES = @STATES@,
  MODEL_ESTIMATES = MODEL_STATES + MODEL_FREE,
  MODEL_ONSETS = @ONSETS@,
  MODEL_STEPS = MODEL_ONSETS * MODEL_FAULTS,
  MODEL_REVIEWS = @REVIEWS@
};

/* Indices of the readings, the inputs and the free numbers. */
enum {
@READING_NAMES@
};
enum {
@INPUT_NAMES@
};
enum {
@FREE_NAMES@
};

/* Results of model_update. */
enum {
  MODEL_OK,
  MODEL_RESTARTED, /* after a gap, or because the sample is not possible: the states start from this sample */
  MODEL_LATE, /* the time is earlier than the last one, or not finite: the sample is ignored */
  MODEL_FAILED /* the states cannot start from the readings: the sample is ignored */
};

/* Conclusions. */
typedef enum {
  MODEL_NO_INFORMATION, /* the samples contain no information about the faults */
  MODEL_HEALTHY,
  MODEL_NONE_FITS, /* neither the healthy plant nor any fault explains the readings */
  MODEL_FAULT, /* one fault */
  MODEL_NOT_ISOLABLE, /* one of several faults that cannot be told apart */
  MODEL_SEVERAL /* two faults at once */
} model_verdict;

/* A column of the recordings: a value v has the SI value scale * v + shift. */
typedef struct {
  const char *address, *column, *unit;
  double scale, shift;
} model_column;

/* A free number: name of the fault or nuisance, SI unit, and value of the healthy plant. */
typedef struct {
  const char *name, *unit;
  double healthy;
} model_number;

extern const model_column model_channel_list[];
extern const model_column model_input_list[];
extern const model_number model_free_list[];
extern const model_column model_time;

/* State of the rule of alarms. */
typedef struct {
  double time, next_review, next_judgement, step_since, fault_since, present_at, begun;
  double misfit, averaged, squares, readings;
  double reviews[3 * MODEL_REVIEWS]; /* time, sum of squares and number of readings */
  int n_reviews, next_of_reviews;
  double adopted[MODEL_FAULTS], roots[MODEL_FAULTS], sizes[MODEL_FAULTS], uncertainties[MODEL_FAULTS];
  double probabilities[MODEL_FAULTS];
  double information;
  int is_changed, is_informed, is_confirmed;
  /* Statistics of the last judgement. */
  double z[MODEL_FAULTS], best_sizes[MODEL_FAULTS], rests[MODEL_FAULTS], joint;
  int onsets[MODEL_FAULTS], joint_onset;
  double precision[MODEL_FAULTS * MODEL_FAULTS], gains[MODEL_FAULTS];
  /* Step that the filter adopts. */
  int n_members, members[2], onset;
  double steps[2];
} model_monitor;

/* Read `verdict`, `alarm`, `restarts`, `ignored` and the arrays of the filter; do not write them. */
typedef struct {
  double time; /* of the last sample [s] */
  model_verdict verdict;
  uint8_t alarm[MODEL_FAULTS]; /* 1 for each possible fault of the present alarm */
  unsigned long restarts, ignored;
  double mean[MODEL_ESTIMATES]; /* states, then free numbers */
  double covariance[MODEL_ESTIMATES * MODEL_ESTIMATES];
  double expected[MODEL_CHANNELS]; /* readings that the filter expected */
  double deviations[MODEL_CHANNELS]; /* standard deviations of reading minus expected reading */
  double used[MODEL_CHANNELS]; /* 1 for a used reading, 0 for a missing one, -1 for a rejected one */
  /* The rest is internal. */
  double clock[2], u[2 * @ROOM_U@], p[@ROOM_P@], walk[MODEL_ESTIMATES], readings[MODEL_CHANNELS];
  double innovations[MODEL_CHANNELS], rejected[MODEL_CHANNELS], outside[MODEL_CHANNELS], nis;
  double transition[MODEL_STATES * MODEL_ESTIMATES];
  double signatures[MODEL_ESTIMATES * MODEL_STEPS], numerators[MODEL_STEPS], gram[MODEL_STEPS * MODEL_FAULTS];
  double onsets[MODEL_ONSETS];
  double mean_before[MODEL_ESTIMATES], covariance_before[MODEL_ESTIMATES * MODEL_ESTIMATES];
  double row[@ROOM_INPUTS@], usual_step, next_onset, settles_at, next_check;
  double grown[MODEL_FAULTS], adopted_at[MODEL_FAULTS];
  double start_theta[MODEL_FREE], start_covariance[MODEL_FREE * MODEL_FREE];
  int age, is_started, is_settled;
  model_monitor monitor;
  double limits[4], x[MODEL_STATES], scratch[@SCRATCH@], memory[@MEMORY@], work[@WORK@];
  int64_t counts[5];
} model_watch;

void model_init(model_watch *w);

/* Use a sample: readings[MODEL_CHANNELS] and inputs[MODEL_INPUTS]. NaN is a missing value; a missing input keeps its last
   value. The inputs may be NULL if none has changed. */
int model_update(model_watch *w, double time, const double *readings, const double *inputs);

/* Number of the possible faults of the present alarm, 0 without an alarm; `w->alarm` has their flags. */
int model_alarm(const model_watch *w);

/* Estimate of a free number, and its standard deviation. */
double model_value(const model_watch *w, int number);
double model_sigma(const model_watch *w, int number);

/* Largest evidence for a fault in its direction, in standard deviations. */
double model_z(const model_watch *w, int fault);

/* Joint squared normalised innovation of the used readings of the last sample, and their number. */
double model_nis(const model_watch *w);
int model_count(const model_watch *w);

#ifdef __cplusplus
}
#endif

#endif
