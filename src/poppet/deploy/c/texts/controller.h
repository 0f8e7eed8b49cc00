/* @ABOUT@

   Call model_step once in every cycle of @CYCLE@ s, or model_step_dt with the measured time between two calls.
   All values are SI and absolute. The code allocates no memory, does not recurse, and has no state outside the struct. */
#ifndef MODEL_H
#define MODEL_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define MODEL_CYCLE @CYCLE_LITERAL@ /* nominal time between two calls [s] */

/* Status of a call: 0, or a combination of bits. */
typedef uint32_t model_status_t;
#define MODEL_OK 0u
#define MODEL_INPUT_HELD 1u /* an input is not finite: its last valid value is used */
#define MODEL_SAFE 2u /* an input has not been valid for the fault time: the command is the safe command */
#define MODEL_SATURATED 4u /* a command is cut by a limit */
#define MODEL_LATE 8u /* a sample was late or is dropped, or the time ran backwards */
#define MODEL_PARAMETER_HELD 16u /* a parameter is not valid: the last valid parameters are used */

/* Inputs: write them before each call. */
typedef struct {
@IN@
} model_in_t;

/* Outputs of the last call. */
typedef struct {
@OUT@
} model_out_t;

/* Parameters: they can change between two calls. */
typedef struct {
@PARAM@
} model_param_t;

/* State between two calls: do not write it. */
typedef struct {
@MEMORY@
  model_in_t in; /* last valid inputs */
  model_param_t param; /* last valid parameters */
  bool is_started;
  bool has_input_fault;
  bool has_parameter_fault;
  bool is_late;
} model_state_t;

typedef struct {
  model_in_t in;
  model_out_t out;
  model_param_t param;
  model_state_t state;
} model_t;

void model_init(model_t *r); /* inputs and parameters as in the circuit file; the next call is the first */
void model_reset(model_t *r); /* the next call is the first; inputs and parameters remain */
model_status_t model_step(model_t *r); /* one cycle of MODEL_CYCLE */
model_status_t model_step_dt(model_t *r, @REAL@ dt); /* dt: time since the previous call [s] */

#ifdef __cplusplus
}
#endif

#endif
