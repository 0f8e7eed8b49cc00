/* FMI 2.0, model exchange and co-simulation, over the common core. */
#include "core.c"

#include "fmi2Functions.h"

enum { INSTANTIATED = 1, INITIALISING = 2, STEPPING = 4, EVENT = 8, CONTINUOUS = 16, ENDED = 32, BROKEN = 64 };
#define ALIVE (INSTANTIATED | INITIALISING | STEPPING | EVENT | CONTINUOUS | ENDED | BROKEN)
#define READABLE (INITIALISING | STEPPING | EVENT | CONTINUOUS | ENDED | BROKEN)

typedef struct {
  Core core;
  const fmi2CallbackFunctions *functions;
  char name[128];
  int state, logs;
  double stop;
} Instance;

static fmi2Status tell(const Instance *i, fmi2Status status, const char *text) {
  if (i->functions->logger && (i->logs || status >= fmi2Error))
    i->functions->logger(i->functions->componentEnvironment, i->name, status,
                         status >= fmi2Error ? "logStatusError" : "logAll", "%s", text);
  return status;
}

static fmi2Status illegal(Instance *i, const char *function) {
  char text[128];
  if (!i) return fmi2Error;
  strcpy(text, function);
  strcat(text, " is not allowed in the present state.");
  return tell(i, fmi2Error, text);
}

#define OF(c, states, name)                             \
  Instance *i = (Instance *)(c);                        \
  if (!i || !(i->state & (states))) return illegal(i, name)

static fmi2Status refused(Instance *i, int refusal, fmi2ValueReference reference) {
  char text[160];
  const char *why = core_refusal(refusal);
  int at = 0;
  fmi2ValueReference left = reference, unit = 1;
  if (refusal == REF_OK) return fmi2OK;
  strcpy(text, "Value reference ");
  at = (int)strlen(text);
  while (left / unit >= 10) unit *= 10;
  for (; unit; unit /= 10) text[at++] = (char)('0' + left / unit % 10);
  text[at++] = ' ';
  strcpy(text + at, why);
  strcat(text, ".");
  return tell(i, fmi2Error, text);
}

const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char *fmi2GetVersion(void) { return fmi2Version; }

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean loggingOn, size_t n, const fmi2String categories[]) {
  OF(c, ALIVE, "fmi2SetDebugLogging");
  (void)n, (void)categories;
  i->logs = loggingOn;
  return fmi2OK;
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions *functions, fmi2Boolean visible, fmi2Boolean loggingOn) {
  Instance *i;
  (void)resources, (void)visible;
  if (!functions || !functions->allocateMemory || !functions->freeMemory) return NULL;
  i = (Instance *)functions->allocateMemory(1, sizeof(Instance));
  if (!i) return NULL;
  memset(i, 0, sizeof *i);
  i->functions = functions;
  i->logs = loggingOn;
  if (name) strncpy(i->name, name, sizeof i->name - 1);
  if (!name || !*name || !guid || strcmp(guid, MODEL_GUID) != 0) {
    tell(i, fmi2Error, "No name, or the GUID is not that of this model.");
    functions->freeMemory(i);
    return NULL;
  }
  if (core_create(&i->core, functions->allocateMemory, functions->freeMemory) != CORE_OK) {
    tell(i, fmi2Error, "Out of memory.");
    functions->freeMemory(i);
    return NULL;
  }
  i->core.is_exchange = type == fmi2ModelExchange;
  i->state = INSTANTIATED;
  i->stop = HUGE_VAL;
  return i;
}

void fmi2FreeInstance(fmi2Component c) {
  Instance *i = (Instance *)c;
  if (!i) return;
  core_release(&i->core);
  i->functions->freeMemory(i);
}

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean toleranceDefined, fmi2Real tolerance, fmi2Real startTime,
                               fmi2Boolean stopTimeDefined, fmi2Real stopTime) {
  OF(c, INSTANTIATED, "fmi2SetupExperiment");
  if (!IS_NUMBER(startTime) || (stopTimeDefined && !(stopTime >= startTime)))
    return tell(i, fmi2Error, "Start and stop time are not finite, or not in order.");
  if (toleranceDefined && !(tolerance >= 1e-13 && tolerance <= 0.1))
    return tell(i, fmi2Error, "The tolerance is not between 1e-13 and 0.1.");
  core_set_up(&i->core, startTime, toleranceDefined ? tolerance : 0.0);
  i->stop = stopTimeDefined ? stopTime : HUGE_VAL;
  return fmi2OK;
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
  OF(c, INSTANTIATED, "fmi2EnterInitializationMode");
  i->state = INITIALISING;
  return fmi2OK;
}

fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
  OF(c, INITIALISING, "fmi2ExitInitializationMode");
  core_initialise(&i->core);
  i->core.d[AT_OWN + OWN_RUNNING] = 1.0;
  i->state = i->core.is_exchange ? EVENT : STEPPING;
  return fmi2OK;
}

fmi2Status fmi2Terminate(fmi2Component c) {
  OF(c, STEPPING | EVENT | CONTINUOUS | BROKEN, "fmi2Terminate");
  i->state = ENDED;
  return fmi2OK;
}

fmi2Status fmi2Reset(fmi2Component c) {
  OF(c, ALIVE, "fmi2Reset");
  core_reset(&i->core);
  i->state = INSTANTIATED;
  i->stop = HUGE_VAL;
  return fmi2OK;
}

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Real value[]) {
  size_t k;
  OF(c, READABLE, "fmi2GetReal");
  if (n && (!vr || !value)) return tell(i, fmi2Error, "fmi2GetReal has no place for its values.");
  for (k = 0; k < n; k++) {
    int refusal = core_get_next(&i->core, vr[k], value + k, k == 0);
    if (refusal != REF_OK) return refused(i, refusal, vr[k]);
  }
  return fmi2OK;
}

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Real value[]) {
  size_t k;
  OF(c, INSTANTIATED | INITIALISING | STEPPING | EVENT | CONTINUOUS, "fmi2SetReal");
  if (n && (!vr || !value)) return tell(i, fmi2Error, "fmi2SetReal has no values.");
  for (k = 0; k < n; k++) {
    int refusal = vr[k] == REF_FOLLOWS ? REF_NO_NUMBER : core_set(&i->core, vr[k], value[k]);
    if (i->state == CONTINUOUS && refusal == REF_OK && !core_is_input(vr[k])) refusal = REF_TOO_LATE;
    if (refusal != REF_OK) return refused(i, refusal, vr[k]);
  }
  return fmi2OK;
}

fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Boolean value[]) {
  size_t k;
  OF(c, READABLE, "fmi2GetBoolean");
  for (k = 0; k < n; k++) {
    if (vr[k] != REF_FOLLOWS) return refused(i, REF_NO_NUMBER, vr[k]);
    value[k] = i->core.d[AT_OWN + OWN_FOLLOWS] != 0.0;
  }
  return fmi2OK;
}

fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Boolean value[]) {
  size_t k;
  OF(c, INSTANTIATED | INITIALISING | STEPPING | EVENT, "fmi2SetBoolean");
  for (k = 0; k < n; k++) {
    int refusal = vr[k] != REF_FOLLOWS ? REF_NO_NUMBER : core_set(&i->core, REF_FOLLOWS, value[k]);
    if (refusal != REF_OK) return refused(i, refusal, vr[k]);
  }
  return fmi2OK;
}

#define NONE_OF_TYPE(name, kind)                                                                            \
  fmi2Status name(fmi2Component c, const fmi2ValueReference vr[], size_t n, kind value[]) {                 \
    OF(c, ALIVE, #name);                                                                                    \
    (void)value;                                                                                            \
    return n ? refused(i, REF_NO_NUMBER, vr ? vr[0] : 0) : fmi2OK;                                          \
  }
NONE_OF_TYPE(fmi2GetInteger, fmi2Integer)
NONE_OF_TYPE(fmi2GetString, fmi2String)
NONE_OF_TYPE(fmi2SetInteger, const fmi2Integer)
NONE_OF_TYPE(fmi2SetString, const fmi2String)

/* Kept states: the block, and before it what it is a state of. */

typedef struct {
  char guid[64];
  int state, ending;
  double stop;
} Head;

#define KEPT (sizeof(Head) + BLOCK * sizeof(double))

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *kept) {
  Head *head;
  OF(c, ALIVE, "fmi2GetFMUstate");
  if (!kept) return tell(i, fmi2Error, "fmi2GetFMUstate has no place for the state.");
  if (!*kept) *kept = i->functions->allocateMemory(1, KEPT);
  if (!*kept) return tell(i, fmi2Error, "Out of memory.");
  head = (Head *)*kept;
  memset(head, 0, sizeof *head);
  strcpy(head->guid, MODEL_GUID);
  head->state = i->state, head->ending = i->core.ending, head->stop = i->stop;
  memcpy(head + 1, i->core.d, BLOCK * sizeof(double));
  return fmi2OK;
}

fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate kept) {
  const Head *head = (const Head *)kept;
  OF(c, ALIVE, "fmi2SetFMUstate");
  if (!head || strcmp(head->guid, MODEL_GUID) != 0) return tell(i, fmi2Error, "This is no state of this model.");
  i->state = head->state, i->core.ending = head->ending, i->stop = head->stop;
  memcpy(i->core.d, head + 1, BLOCK * sizeof(double));
  return fmi2OK;
}

fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *kept) {
  OF(c, ALIVE, "fmi2FreeFMUstate");
  if (kept && *kept) {
    i->functions->freeMemory(*kept);
    *kept = NULL;
  }
  return fmi2OK;
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate kept, size_t *size) {
  OF(c, ALIVE, "fmi2SerializedFMUstateSize");
  if (!kept || !size) return tell(i, fmi2Error, "There is no state to serialise.");
  *size = KEPT;
  return fmi2OK;
}

fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate kept, fmi2Byte bytes[], size_t size) {
  OF(c, ALIVE, "fmi2SerializeFMUstate");
  if (!kept || !bytes || size < KEPT) return tell(i, fmi2Error, "There is no state, or no room to serialise it.");
  memcpy(bytes, kept, KEPT);
  return fmi2OK;
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *kept) {
  OF(c, ALIVE, "fmi2DeSerializeFMUstate");
  if (!bytes || !kept || size != KEPT || strncmp(bytes, MODEL_GUID, sizeof MODEL_GUID) != 0)
    return tell(i, fmi2Error, "These bytes are no state of this model.");
  if (!*kept) *kept = i->functions->allocateMemory(1, KEPT);
  if (!*kept) return tell(i, fmi2Error, "Out of memory.");
  memcpy(*kept, bytes, KEPT);
  return fmi2OK;
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference unknown[], size_t nUnknown,
                                        const fmi2ValueReference known[], size_t nKnown, const fmi2Real seed[],
                                        fmi2Real found[]) {
  int refusal;
  OF(c, INITIALISING | STEPPING | EVENT | CONTINUOUS | ENDED | BROKEN, "fmi2GetDirectionalDerivative");
  refusal = core_directional(&i->core, unknown, nUnknown, known, nKnown, seed, found);
  return refusal == REF_OK ? fmi2OK : tell(i, fmi2Error, "There is no derivative between these variables.");
}

/* Model exchange -------------------------------------------------------------------------------------------------- */

#define OF_EXCHANGE(c, states, name) \
  OF(c, states, name);               \
  if (!i->core.is_exchange) return illegal(i, name)

fmi2Status fmi2EnterEventMode(fmi2Component c) {
  OF_EXCHANGE(c, CONTINUOUS | EVENT, "fmi2EnterEventMode");
  i->state = EVENT;
  return fmi2OK;
}

fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *info) {
  double next;
  OF_EXCHANGE(c, EVENT, "fmi2NewDiscreteStates");
  core_event(&i->core);
  next = core_next_event(&i->core);
  info->newDiscreteStatesNeeded = fmi2False;
  info->terminateSimulation = fmi2False;
  info->nominalsOfContinuousStatesChanged = fmi2False;
  info->valuesOfContinuousStatesChanged = fmi2False;
  info->nextEventTimeDefined = next < HUGE_VAL ? fmi2True : fmi2False;
  info->nextEventTime = next < HUGE_VAL ? next : 0.0;
  return fmi2OK;
}

fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c) {
  OF_EXCHANGE(c, EVENT, "fmi2EnterContinuousTimeMode");
  i->state = CONTINUOUS;
  return fmi2OK;
}

fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean noSetFMUStatePriorToCurrentPoint,
                                       fmi2Boolean *enterEventMode, fmi2Boolean *terminateSimulation) {
  OF_EXCHANGE(c, CONTINUOUS, "fmi2CompletedIntegratorStep");
  (void)noSetFMUStatePriorToCurrentPoint;
  *enterEventMode = fmi2False;
  *terminateSimulation = core_ends(&i->core) >= 0 ? fmi2True : fmi2False;
  if (*terminateSimulation) tell(i, fmi2OK, CONDITION_TEXTS[i->core.ending]);
  return fmi2OK;
}

fmi2Status fmi2SetTime(fmi2Component c, fmi2Real time) {
  OF_EXCHANGE(c, EVENT | CONTINUOUS, "fmi2SetTime");
  if (!IS_NUMBER(time)) return tell(i, fmi2Error, "The time is not finite.");
  i->core.d[AT_OWN + OWN_TIME] = time - i->core.d[AT_OWN + OWN_BEGIN];
  return fmi2OK;
}

fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real x[], size_t n) {
  size_t k;
  OF_EXCHANGE(c, EVENT | CONTINUOUS, "fmi2SetContinuousStates");
  if (n != N_STATES || (n && !x)) return tell(i, fmi2Error, "This is not the number of states.");
  for (k = 0; k < n; k++)
    if (!IS_NUMBER(x[k])) return tell(i, fmi2Error, "A state is not finite.");
  memcpy(i->core.d + AT_X, x, n * sizeof(double));
  return fmi2OK;
}

fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real found[], size_t n) {
  OF_EXCHANGE(c, INITIALISING | EVENT | CONTINUOUS | ENDED | BROKEN, "fmi2GetDerivatives");
  if (n != N_STATES || (n && !found)) return tell(i, fmi2Error, "This is not the number of states.");
  core_initialise(&i->core);
  core_rates(&i->core, i->core.work + WORK_F);
  memcpy(found, i->core.work + WORK_F, n * sizeof(double));
  return fmi2OK;
}

fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real found[], size_t n) {
  OF_EXCHANGE(c, INITIALISING | EVENT | CONTINUOUS | ENDED | BROKEN, "fmi2GetEventIndicators");
  if (n != N_INDICATORS || (n && !found)) return tell(i, fmi2Error, "This is not the number of event indicators.");
  core_initialise(&i->core);
  core_indicators(&i->core, found);
  return fmi2OK;
}

fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real x[], size_t n) {
  OF_EXCHANGE(c, INITIALISING | EVENT | CONTINUOUS | ENDED | BROKEN, "fmi2GetContinuousStates");
  if (n != N_STATES || (n && !x)) return tell(i, fmi2Error, "This is not the number of states.");
  core_initialise(&i->core);
  memcpy(x, i->core.d + AT_X, n * sizeof(double));
  return fmi2OK;
}

fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real x[], size_t n) {
  OF_EXCHANGE(c, INSTANTIATED | INITIALISING | EVENT | CONTINUOUS | ENDED | BROKEN,
              "fmi2GetNominalsOfContinuousStates");
  if (n != N_STATES || (n && !x)) return tell(i, fmi2Error, "This is not the number of states.");
  memcpy(x, STATE_NOMINALS, n * sizeof(double));
  return fmi2OK;
}

/* Co-simulation --------------------------------------------------------------------------------------------------- */

#define OF_STEPS(c, states, name) \
  OF(c, states, name);            \
  if (i->core.is_exchange) return illegal(i, name)

/* How fast the host moves an input over the next step. */
static int set_slope(Core *c, unsigned reference, double slope) {
  if (reference < REF_U || reference >= REF_X) return REF_CONSTANT;
  if (!IS_NUMBER(slope)) return REF_OUTSIDE;
  c->d[AT_S + reference - REF_U] = slope;
  return REF_OK;
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                       const fmi2Integer order[], const fmi2Real value[]) {
  size_t k;
  OF_STEPS(c, INSTANTIATED | INITIALISING | STEPPING, "fmi2SetRealInputDerivatives");
  for (k = 0; k < n; k++) {
    int refusal = order[k] != 1 ? REF_CONSTANT : set_slope(&i->core, vr[k], value[k]);
    if (refusal != REF_OK) return refused(i, refusal, vr[k]);
  }
  return fmi2OK;
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                        const fmi2Integer order[], fmi2Real value[]) {
  OF_STEPS(c, STEPPING | ENDED | BROKEN, "fmi2GetRealOutputDerivatives");
  (void)vr, (void)order, (void)value;
  return n ? tell(i, fmi2Error, "There are no derivatives of outputs.") : fmi2OK;
}

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real point, fmi2Real step, fmi2Boolean noSetFMUStatePriorToCurrentPoint) {
  double now;
  OF_STEPS(c, STEPPING, "fmi2DoStep");
  (void)noSetFMUStatePriorToCurrentPoint;
  now = i->core.d[AT_OWN + OWN_BEGIN] + i->core.d[AT_OWN + OWN_TIME];
  if (!IS_NUMBER(point) || !IS_NUMBER(step) || !(step > 0.0) || !(fabs(point - now) <= 1e-6 * step + ROUNDING(fabs(now))))
    return tell(i, fmi2Error, "A step begins where the last one has ended, and has a length.");
  if (point + step > i->stop + 1e-6 * step) return tell(i, fmi2Error, "The step goes past the stop time.");
  switch (core_step(&i->core, point + step)) {
    case CORE_OK: return fmi2OK;
    case CORE_ENDED:
      tell(i, fmi2Discard, CONDITION_TEXTS[i->core.ending]);
      i->state = BROKEN;
      return fmi2Discard;
    case CORE_DISCARDED: return tell(i, fmi2Discard, "The integrator did not come to the end of the step.");
    default: return tell(i, fmi2Error, "Out of memory.");
  }
}

fmi2Status fmi2CancelStep(fmi2Component c) {
  OF(c, 0, "fmi2CancelStep");
  return fmi2Error;
}

fmi2Status fmi2GetStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Status *value) {
  OF_STEPS(c, STEPPING | BROKEN | ENDED, "fmi2GetStatus");
  (void)value;
  return kind == fmi2DoStepStatus ? tell(i, fmi2Discard, "No step is pending.") : fmi2Discard;
}

fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Real *value) {
  OF_STEPS(c, STEPPING | BROKEN | ENDED, "fmi2GetRealStatus");
  if (kind != fmi2LastSuccessfulTime || !value) return fmi2Discard;
  *value = i->core.d[AT_OWN + OWN_BEGIN] + i->core.d[AT_OWN + OWN_TIME];
  return fmi2OK;
}

fmi2Status fmi2GetIntegerStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Integer *value) {
  OF_STEPS(c, STEPPING | BROKEN | ENDED, "fmi2GetIntegerStatus");
  (void)kind, (void)value;
  return fmi2Discard;
}

fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Boolean *value) {
  OF_STEPS(c, STEPPING | BROKEN | ENDED, "fmi2GetBooleanStatus");
  if (kind != fmi2Terminated || !value) return fmi2Discard;
  *value = i->core.ending >= 0 ? fmi2True : fmi2False;
  return fmi2OK;
}

fmi2Status fmi2GetStringStatus(fmi2Component c, const fmi2StatusKind kind, fmi2String *value) {
  OF_STEPS(c, STEPPING | BROKEN | ENDED, "fmi2GetStringStatus");
  (void)kind, (void)value;
  return fmi2Discard;
}
