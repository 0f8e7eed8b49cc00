/* @ABOUT@

   Call model_call once in every cycle, of @CYCLE@ s, with the time. All values are SI and absolute. Nothing is allocated,
   nothing calls itself, and nothing is kept outside of the struct. */
#ifndef MODEL_H
#define MODEL_H

#ifdef __cplusplus
extern "C" {
#endif

enum {
  MODEL_INPUTS = @N_INPUTS@,
  MODEL_NUMBERS = @N_NUMBERS@,
  MODEL_MEMORY = @N_MEMORY@,
  MODEL_TIMERS = @N_TIMERS@, /* the first elements of the memory: when it acts next [s] */
  MODEL_OUTPUTS = @N_OUTPUTS@
};
#define MODEL_CYCLE @CYCLE@ /* [s] */

/* Places of the inputs in u. */
enum {
@U@
};

/* Places of the numbers in p. */
enum {
@P@
};

/* Places of the outputs in y. */
enum {
@Y@
};

typedef struct {
  @REAL@ u[MODEL_INPUTS + 1];  /* set them before each call */
  double p[MODEL_NUMBERS + 1]; /* may be changed between calls */
  @REAL@ y[MODEL_OUTPUTS + 1]; /* of the last call */
  double z[MODEL_MEMORY + 1];
} model_state;

void model_begin(model_state *m); /* numbers and inputs as in the circuit file; the next call is the first */
void model_restart(model_state *m); /* memory as at the start, with the numbers as they are */
void model_call(model_state *m, double t); /* the time [s], from 0 on: of the calls before, times the cycle */

#ifdef __cplusplus
}
#endif

#endif
