/* Instance of a model: its state is one block of doubles, which is copied to store and to restore it. */
#ifndef POPPET_CORE_H
#define POPPET_CORE_H

#include <stddef.h>
#include <stdint.h>

#include "model.h"

/* Results of a call of the core. */
enum { CORE_OK, CORE_DISCARDED, CORE_ENDED, CORE_WRONG };
/* Reasons for rejecting a value reference. */
enum {
  REF_OK,
  REF_UNKNOWN,
  REF_NO_NUMBER,
  REF_CONSTANT,
  REF_TOO_LATE,
  REF_AT_EVENTS,
  REF_OUTSIDE,
  REF_NOT_FINITE,
  REF_NO_RESULT
};
/* Maximum length of a message. */
#define MESSAGE 512
/* Modes of an instance. */
enum { INSTANTIATED = 1, INITIALISING = 2, STEPPING = 4, EVENT = 8, CONTINUOUS = 16, ENDED = 32, BROKEN = 64 };
#define ALIVE (INSTANTIATED | INITIALISING | STEPPING | EVENT | CONTINUOUS | ENDED | BROKEN)
#define READABLE (INITIALISING | STEPPING | EVENT | CONTINUOUS | ENDED | BROKEN)

/* First value reference of each kind. */
#define REF_TIME 0u
#define REF_FOLLOWS 1u
#define REF_P 2u
#define REF_U (REF_P + N_NUMBERS)
#define REF_X (REF_U + N_INPUTS)
#define REF_D (REF_X + N_STATES)
#define REF_Y (REF_D + N_STATES)
#define REF_END (REF_Y + N_OUTPUTS)

/* Offsets in the block. */
#define ROOM(n) ((n) > 0 ? (n) : 1)
#define AT_X 0
#define AT_P (AT_X + ROOM(N_ALL))
#define AT_U (AT_P + ROOM(N_NUMBERS + N_MEMORY)) /* inputs of the importer */
#define AT_S (AT_U + ROOM(N_INPUTS))             /* their slopes over the next step */
#define AT_L (AT_S + ROOM(N_INPUTS))             /* inputs at the end of the last step */
#define AT_W (AT_L + ROOM(N_INPUTS))             /* memory of the integrator */
#define AT_OWN (AT_W + N_SCRATCH)
enum { OWN_TIME, OWN_BEGIN, OWN_END, OWN_FOLLOWS, OWN_SEGMENT, OWN_TOLERANCE, OWN_STARTED, OWN_RUNNING, OWN_MOVED, N_OWN };
#define BLOCK (AT_OWN + N_OWN)

typedef struct {
  double *d;      /* the block */
  double *before; /* the block before a step */
  double *work;   /* scratch memory of a call */
  double *rows;   /* coefficients of the segments of a step */
  double *starts;
  int64_t *courses;
  unsigned char *jumps;
  size_t room; /* maximum number of segments */
  int is_exchange;
  int state;
  double stop; /* time of the importer */
  int has_rates, has_outputs;
  int ending; /* stop condition that was met, or -1 */
  int64_t status;
  int64_t accepted, attempts; /* steps since the start */
  unsigned char warned[ROOM(N_NUMBERS + N_INPUTS)]; /* 1 for an input whose saturation was reported */
  int has_warned;                                   /* since the call began */
  void (*warn)(void *instance, const char *text);
  void *(*allocate)(size_t, size_t);
  void (*release)(void *);
} Core;

/* Stored state: the identity of its model, then the block. */
typedef struct {
  char guid[64];
  int is_exchange, state, ending;
  double stop;
} Head;

#define KEPT (sizeof(Head) + BLOCK * sizeof(double))

#endif
