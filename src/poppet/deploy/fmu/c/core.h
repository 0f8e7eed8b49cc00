/* One instance of a model behind FMI: its state in one block of doubles, which is copied to keep and to go back. */
#ifndef POPPET_CORE_H
#define POPPET_CORE_H

#include <stddef.h>
#include <stdint.h>

#include "model.h"

/* What a call of the core comes to. */
enum { CORE_OK, CORE_DISCARDED, CORE_ENDED, CORE_WRONG };
/* Why a value reference is refused. */
enum { REF_OK, REF_UNKNOWN, REF_NO_NUMBER, REF_CONSTANT, REF_TOO_LATE, REF_AT_EVENTS, REF_OUTSIDE, REF_NO_RESULT };
/* What an instance is doing. */
enum { INSTANTIATED = 1, INITIALISING = 2, STEPPING = 4, EVENT = 8, CONTINUOUS = 16, ENDED = 32, BROKEN = 64 };
#define ALIVE (INSTANTIATED | INITIALISING | STEPPING | EVENT | CONTINUOUS | ENDED | BROKEN)
#define READABLE (INITIALISING | STEPPING | EVENT | CONTINUOUS | ENDED | BROKEN)

/* Places of value references. */
#define REF_TIME 0u
#define REF_FOLLOWS 1u
#define REF_P 2u
#define REF_U (REF_P + N_NUMBERS)
#define REF_X (REF_U + N_INPUTS)
#define REF_D (REF_X + N_STATES)
#define REF_Y (REF_D + N_STATES)
#define REF_END (REF_Y + N_OUTPUTS)

/* Places in the block. */
#define ROOM(n) ((n) > 0 ? (n) : 1)
#define AT_X 0
#define AT_P (AT_X + ROOM(N_ALL))
#define AT_U (AT_P + ROOM(N_NUMBERS + N_MEMORY)) /* of the host */
#define AT_S (AT_U + ROOM(N_INPUTS))             /* and their slopes over the next step */
#define AT_L (AT_S + ROOM(N_INPUTS))             /* inputs where the last step ended */
#define AT_W (AT_L + ROOM(N_INPUTS))             /* of the integrator */
#define AT_OWN (AT_W + N_SCRATCH)
enum { OWN_TIME, OWN_BEGIN, OWN_END, OWN_FOLLOWS, OWN_SEGMENT, OWN_TOLERANCE, OWN_STARTED, OWN_RUNNING, OWN_MOVED, N_OWN };
#define BLOCK (AT_OWN + N_OWN)

typedef struct {
  double *d;      /* the block */
  double *before; /* the block before a step */
  double *work;   /* whatever a call needs for itself */
  double *rows;   /* coefficients of the segments of a step */
  double *starts;
  int64_t *courses;
  unsigned char *jumps;
  size_t room; /* segments that there is room for */
  int is_exchange;
  int state;
  double stop; /* time of the host */
  int has_rates, has_outputs;
  int ending; /* stop condition that was met, or -1 */
  int64_t status;
  int64_t accepted, attempts; /* of all steps since the start */
  void *(*allocate)(size_t, size_t);
  void (*release)(void *);
} Core;

/* A kept state: the block, and before it what it is a state of. */
typedef struct {
  char guid[64];
  int is_exchange, state, ending;
  double stop;
} Head;

#define KEPT (sizeof(Head) + BLOCK * sizeof(double))

#endif
