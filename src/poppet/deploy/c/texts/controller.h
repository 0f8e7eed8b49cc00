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
  MODEL_TIMERS = @N_TIMERS@, /* first elements of the memory: next sample instants [s] */
  MODEL_OUTPUTS = @N_OUTPUTS@
};
#define MODEL_CYCLE @CYCLE@ /* [s] */

/* Indices of the inputs in u. */
enum {
@U@
};

/* Indices of the parameters in p. */
enum {
@P@
};

/* Indices of the outputs in y. */
enum {
@Y@
};

typedef struct {
  @REAL@ u[MODEL_INPUTS + 1];  /* inputs: set them before each call */
  double p[MODEL_NUMBERS + 1]; /* parameters: can change between calls */
  @REAL@ y[MODEL_OUTPUTS + 1]; /* outputs of the last call */
  double z[MODEL_MEMORY + 1];
} model_state;

void model_begin(model_state *m); /* parameters and inputs of the circuit file; the next call is the first */
void model_restart(model_state *m); /* memory as at the start, with the present parameters */
void model_call(model_state *m, double t); /* t [s]: number of the previous calls times the cycle */

#ifdef __cplusplus
}
#endif

#endif
