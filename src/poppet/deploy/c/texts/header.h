/* @ABOUT@

   All values are SI and absolute. Nothing here allocates memory, calls itself or keeps anything outside of the struct
   that it is handed; tables are constants. C99 and later, C90 with stdint.h, C++. */
#ifndef MODEL_H
#define MODEL_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
  MODEL_NUMBERS = @N_NUMBERS@,
  MODEL_INPUTS = @N_INPUTS@,
  MODEL_ROOM_OF_INPUTS = @ROOM@,
  MODEL_STATES = @N_STATES@, /* with error control */
  MODEL_INTEGRATED = @N_X@,  /* with the integrals of flows and heat after them */
  MODEL_MEMORY = @N_MEMORY@, /* sampled or switched states, in p after the parameters */
  MODEL_TIMERS = @N_TIMERS@, /* first elements of the memory: next sample instants [s] */
  MODEL_OUTPUTS = @N_OUTPUTS@,
  MODEL_SEGMENTS = @N_SEGMENTS@, /* of the signals of the model */
  MODEL_COURSES = @N_COURSES@,
  MODEL_SUBSTEPS = @SUBSTEPS@ /* initial number of steps per call of model_fixed_step */
};

/* Indices of the parameters in p. */
enum {
@P@
};

/* Indices of the inputs in u. */
enum {
@U@
};

/* Indices of the states in x. */
enum {
@X@
};

/* Indices of the outputs in y. */
enum {
@Y@
};

typedef struct {
  const char *name, *unit;
  double value, low, high;
  int may_change; /* at run time; constants of the model depend on the others */
} model_number;

typedef struct {
  const char *name, *unit;
  double low, high;
  int number;    /* index of the parameter with its value if it has no signal, or -1 */
  int is_driven; /* by a signal of the model */
} model_input;

typedef struct {
  const char *name, *unit;
} model_quantity;

extern const model_number model_number_list[];
extern const model_input model_input_list[];
extern const model_quantity model_state_list[], model_memory_list[], model_output_list[];
extern const double model_starts[], model_coefficients[];
extern const int64_t model_courses[];
extern const uint8_t model_jumps[];

/* Change a parameter in p. Returns 0; 1 if it must not change; 2 if the value is not finite or outside its limits. */
int model_set(double *p, int place, double value);

/* Value of an input within its limits; a value that is not finite is returned unchanged. *limited becomes 1 if the value
   is outside the limits by more than 1e-6 of their range (of the limit, if there is only one), otherwise 0. */
double model_limit(int place, double value, uint8_t *limited);

/* Results of model_fixed_step and model_adaptive_run. MODEL_LIMITED is a bit that is added to the others and is no
   failure: an input was outside its limits, and the limit was used instead; the flags `limited` of the struct name it. */
enum {
  MODEL_OK = 0,
  MODEL_OUTSIDE = 1,  /* fixed step: the state would leave the domain of the model */
  MODEL_TOO_MANY = 2, /* fixed step: more than 256 parts per substep */
  MODEL_INVALID = 5,  /* an input, a time or (adaptive run) a parameter is not finite, or the time runs backwards */
  MODEL_FAILED = 7,   /* mask: (result & MODEL_FAILED) is 0 if a fixed step has reached its time */
  MODEL_LIMITED = 16
};

/* Real time: model_fixed.c. */
typedef struct {
  double t;                                    /* time [s] */
  double x[@ROOM_X_FIXED@];                    /* states */
  double p[MODEL_NUMBERS + MODEL_MEMORY + 1];  /* parameters, then the memory */
  double u[MODEL_ROOM_OF_INPUTS];              /* inputs at t; set by the caller if by_host */
  double slopes[MODEL_ROOM_OF_INPUTS];         /* slopes of the inputs [1/s]; set by the caller if by_host */
  double accepted[MODEL_ROOM_OF_INPUTS];       /* last finite values of the inputs that the caller sets */
  uint8_t by_host[MODEL_ROOM_OF_INPUTS];       /* 1 for an input that the caller sets */
  uint8_t limited[MODEL_ROOM_OF_INPUTS];       /* 1 for an input that was limited in the last call of model_fixed_step */
  int64_t segment;
  int has_jumped;
  int substeps; /* minimum number of equal steps per call of model_fixed_step; set by the caller */
} model_fixed;

void model_fixed_begin(model_fixed *m);   /* parameters of the circuit file, and the state at t = 0 */
void model_fixed_restart(model_fixed *m); /* t = 0 with the present parameters */
/* Integrate to a time. Returns MODEL_OK, MODEL_OUTSIDE, MODEL_TOO_MANY or MODEL_INVALID, and the bit MODEL_LIMITED. In
   each case, m contains the last valid state and its time, and values of u within their limits. */
int model_fixed_step(model_fixed *m, double until);
void model_fixed_outputs(const model_fixed *m, double *y);

/* A whole run with error control: model_adaptive.c and model_integrator.c. */
typedef struct {
  double p[MODEL_NUMBERS + MODEL_MEMORY + 1];
  double x[MODEL_INTEGRATED + 1];
  double tolerance, longest_step, most_attempts;
  double coefficients[MODEL_COURSES * MODEL_ROOM_OF_INPUTS * 7]; /* of the inputs */
  double limits[4], watch[2], books[3 * MODEL_INTEGRATED + 1], scratch[@SCRATCH@];
  int64_t counts[5]; /* accepted steps, attempts, rows written, stop condition that was met or -1 */
  uint8_t limited[MODEL_ROOM_OF_INPUTS]; /* 1 for an input that was limited */
} model_adaptive;

void model_adaptive_begin(model_adaptive *m); /* parameters, signals and tolerance of the circuit file */
/* From t = 0 to the last of the times; table has MODEL_OUTPUTS rows, output k at times[i] is table[k * n_times + i].
   Returns 0 done, 1 stopped by a condition, 2 stalled, 3 too many attempts, 4 not finite, MODEL_INVALID, and the bit
   MODEL_LIMITED. */
int64_t model_adaptive_run(model_adaptive *m, const double *times, int64_t n_times, double *table);

/* The functions themselves, of pointers to t, x, u, p: x' = f, y. */
@PROTOTYPES@

#ifdef __cplusplus
}
#endif

#endif
