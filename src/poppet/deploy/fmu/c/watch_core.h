/* Instance of a watch: its state is one block of doubles, which is copied to store and to restore it. */
#ifndef POPPET_CORE_H
#define POPPET_CORE_H

#include <stddef.h>
#include <stdint.h>

#include "ports.h"

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
#define MESSAGE 512
/* Modes of an instance. */
enum { INSTANTIATED = 1, INITIALISING = 2, STEPPING = 4, EVENT = 8, CONTINUOUS = 16, ENDED = 32, BROKEN = 64 };
#define ALIVE (INSTANTIATED | INITIALISING | STEPPING | EVENT | CONTINUOUS | ENDED | BROKEN)
#define READABLE (INITIALISING | STEPPING | EVENT | CONTINUOUS | ENDED | BROKEN)

/* A watch has no continuous states. */
#define N_STATES 0
#define N_INDICATORS 0
#define N_PORTS (N_READINGS + N_DRIVEN)

/* First value reference of each kind. */
#define REF_TIME 0u
#define REF_FOLLOWS 1u
#define REF_U 2u
#define REF_X (REF_U + N_PORTS)
#define REF_END (REF_X + N_OUTPUTS)

/* Offsets in the block. */
enum { OWN_TIME, OWN_BEGIN, OWN_FOLLOWS, OWN_RUNNING, N_OWN };
#define AT_OWN 0
#define AT_X N_OWN
#define AT_U N_OWN              /* readings, then inputs */
#define AT_S (AT_U + N_PORTS)   /* slopes, which are not used */
#define AT_W (AT_S + N_PORTS)   /* the watch */
#define BLOCK (AT_W + sizeof(WATCH(watch)) / sizeof(double) + 1)

typedef struct {
  double *d;
  int is_exchange;
  int state;
  double stop; /* time of the importer */
  int ending;
  int has_warned;
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
