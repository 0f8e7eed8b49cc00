#include "core.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define IS_NUMBER(v) ((v) - (v) == 0.0)
#define ROUNDING(t) (1e-12 * (t) + 1e-10)

static const char *const CONDITION_TEXTS[] = {""};
static const double STATE_NOMINALS[] = {1.0};
/* Categories of the log by status; errors and warnings are always reported. */
static const char *const LOG_CATEGORIES[] = {"logAll", "logStatusWarning", "logStatusDiscard", "logStatusError"};

static WATCH(watch) *watch_of(const Core *c) { return (WATCH(watch) *)(void *)(c->d + AT_W); }

static void core_release(Core *c) {
  if (c->d) c->release(c->d);
}

static void core_reset(Core *c) {
  memset(c->d, 0, BLOCK * sizeof(double));
  memcpy(c->d + AT_U, START_PORTS, sizeof START_PORTS);
  WATCH(init)(watch_of(c));
  c->state = INSTANTIATED;
  c->stop = HUGE_VAL;
  c->ending = -1;
}

static int core_create(Core *c, void *(*allocate)(size_t, size_t), void (*release)(void *)) {
  memset(c, 0, sizeof *c);
  c->allocate = allocate;
  c->release = release;
  c->d = (double *)allocate(BLOCK, sizeof(double));
  if (!c->d) return CORE_WRONG;
  core_reset(c);
  return CORE_OK;
}

/* Set times of the experiment; returns the reason if they are invalid, or NULL. */
static const char *core_set_up(Core *c, double begin, int has_tolerance, double tolerance, int has_stop, double stop) {
  (void)has_tolerance, (void)tolerance;
  if (!IS_NUMBER(begin) || (has_stop && !(stop >= begin))) return "Start and stop time are not finite, or not in order.";
  c->d[AT_OWN + OWN_BEGIN] = begin;
  c->stop = has_stop ? stop : HUGE_VAL;
  return NULL;
}

/* Returns 1 if successes are reported too; `is_known` is 1 if all categories exist. */
static int core_logs(int is_on, size_t n, const char *const categories[], int *is_known) {
  int logs = is_on && !n, j;
  size_t k;
  *is_known = 1;
  for (k = 0; k < n; k++) {
    for (j = 0; j < 4 && strcmp(categories[k], LOG_CATEGORIES[j]) != 0;) j++;
    if (j == 4) *is_known = 0;
    if (j == 0 && is_on) logs = 1;
  }
  return logs;
}

static void core_initialise(Core *c) { (void)c; }

/* A watch has no model exchange. */
static void core_event(Core *c) { (void)c; }
static double core_next_event(const Core *c) { return (void)c, HUGE_VAL; }
static void core_indicators(Core *c, double *found) { (void)c, (void)found; }
static int core_ends(Core *c) { return c->ending; }
static int core_derivatives(Core *c, double *found) { return (void)c, (void)found, 1; }
static int core_directional(Core *c, const unsigned *unknown, size_t n_unknown, const unsigned *known, size_t n_known,
                            const double *seed, double *found) {
  (void)c, (void)unknown, (void)n_unknown, (void)known, (void)n_known, (void)seed, (void)found;
  return REF_UNKNOWN;
}

static double output_of(const Core *c, unsigned k) {
  const WATCH(watch) *w = watch_of(c);
  const int number = OUTPUT_NUMBERS[k];
  switch (OUTPUT_KINDS[k]) {
    case OUTPUT_VALUE: return WATCH(value)(w, number);
    case OUTPUT_SIGMA: return WATCH(sigma)(w, number);
    case OUTPUT_Z: return WATCH(z)(w, number);
    case OUTPUT_ALARM: return (double)w->alarm[number];
    case OUTPUT_VERDICT: return (double)w->verdict;
    default: return WATCH(nis)(w);
  }
}

static int core_get_all(Core *c, const unsigned *references, size_t n, double *values, unsigned *at) {
  size_t k;
  for (k = 0; k < n; k++) {
    const unsigned r = *at = references[k];
    if (r == REF_TIME) values[k] = c->d[AT_OWN + OWN_BEGIN] + c->d[AT_OWN + OWN_TIME];
    else if (r < REF_U) return REF_NO_NUMBER;
    else if (r < REF_X) values[k] = c->d[AT_U + r - REF_U];
    else if (r < REF_END) values[k] = output_of(c, r - REF_X);
    else return REF_UNKNOWN;
  }
  return REF_OK;
}

/* NaN is a missing reading. */
static int core_set(Core *c, unsigned reference, double value) {
  if (reference < REF_U || reference >= REF_X) return reference < REF_END ? REF_CONSTANT : REF_UNKNOWN;
  c->d[AT_U + reference - REF_U] = value;
  return REF_OK;
}

static int core_set_all(Core *c, const unsigned *references, size_t n, const double *values, unsigned *at) {
  int refusal = REF_OK;
  size_t k;
  c->has_warned = 0;
  for (k = 0; k < n && refusal == REF_OK; k++) refusal = core_set(c, *at = references[k], values[k]);
  return refusal;
}

/* Message for a rejected value reference. */
static const char *core_refusal(char *text, int refusal, unsigned reference) {
  static const char *const why[] = {"", "is no variable of this model", "is of another type", "cannot be set", "", "", "",
                                    "", "has no finite value"};
  unsigned unit = 1;
  size_t at;
  strcpy(text, "Value reference ");
  at = strlen(text);
  while (reference / unit >= 10) unit *= 10;
  for (; unit; unit /= 10) text[at++] = (char)('0' + reference / unit % 10);
  text[at] = '\0';
  strcat(text, " ");
  strcat(text, why[refusal]);
  return strcat(text, ".");
}

/* Reason for which no step is possible, or NULL. */
static const char *core_no_step(const Core *c, double point, double step) {
  const double now = c->d[AT_OWN + OWN_BEGIN] + c->d[AT_OWN + OWN_TIME];
  if (!IS_NUMBER(point) || !IS_NUMBER(step) || !(step > 0.0) || !(fabs(point - now) <= 1e-6 * step + ROUNDING(fabs(now))))
    return "A step begins where the last one has ended, and has a length.";
  if (point + step > c->stop + 1e-6 * step) return "The step goes past the stop time.";
  return NULL;
}

/* The readings are those at the start of the step. */
static int core_step(Core *c, double until) {
  double *own = c->d + AT_OWN;
  (void)WATCH(update)(watch_of(c), own[OWN_BEGIN] + own[OWN_TIME], c->d + AT_U, c->d + AT_U + N_READINGS);
  own[OWN_TIME] = until - own[OWN_BEGIN];
  return CORE_OK;
}

/* Stored states --------------------------------------------------------------------------------------------------- */

static void core_keep(const Core *c, void *kept) {
  Head *head = (Head *)kept;
  memset(head, 0, sizeof *head);
  strcpy(head->guid, MODEL_GUID);
  head->is_exchange = c->is_exchange, head->state = c->state, head->ending = c->ending, head->stop = c->stop;
  memcpy(head + 1, c->d, BLOCK * sizeof(double));
}

static int core_restore(Core *c, const void *kept) {
  const Head *head = (const Head *)kept;
  if (!head || strcmp(head->guid, MODEL_GUID) != 0 || head->is_exchange != c->is_exchange) return CORE_WRONG;
  c->state = head->state, c->ending = head->ending, c->stop = head->stop;
  memcpy(c->d, head + 1, BLOCK * sizeof(double));
  return CORE_OK;
}

static int core_is_kept(const void *bytes, size_t size) {
  return bytes && size == KEPT && strncmp((const char *)bytes, MODEL_GUID, sizeof MODEL_GUID) == 0;
}
