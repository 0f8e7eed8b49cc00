/* FMI 2.0, model exchange and co-simulation, on the common core. */
#include "core.c"

#include "fmi2Functions.h"

typedef struct {
  Core core;
  const fmi2CallbackFunctions *functions;
  char name[128];
  int logs;
} Instance;

static fmi2Status tell(const Instance *i, fmi2Status status, const char *text) {
  if (i->functions->logger && (i->logs || status != fmi2OK))
    i->functions->logger(i->functions->componentEnvironment, i->name, status, LOG_CATEGORIES[status], "%s", text);
  return status;
}

static void warn(void *instance, const char *text) { tell((const Instance *)instance, fmi2Warning, text); }

static fmi2Status illegal(Instance *i, const char *function) {
  char text[128];
  if (!i) return fmi2Error;
  strcpy(text, function);
  strcat(text, " is not allowed in the present state.");
  return tell(i, fmi2Error, text);
}

#define OF(c, states, name)                             \
  Instance *i = (Instance *)(c);                        \
  if (!i || !(i->core.state & (states))) return illegal(i, name)

static fmi2Status refused(Instance *i, int refusal, unsigned reference) {
  char text[MESSAGE];
  if (refusal == REF_OK) return fmi2OK;
  return tell(i, refusal == REF_NO_RESULT ? fmi2Discard : fmi2Error, core_refusal(text, refusal, reference));
}

const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char *fmi2GetVersion(void) { return fmi2Version; }

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean loggingOn, size_t n, const fmi2String categories[]) {
  int is_known;
  OF(c, ALIVE, "fmi2SetDebugLogging");
  i->logs = core_logs(loggingOn, n, categories, &is_known);
  return is_known ? fmi2OK : tell(i, fmi2Warning, "There is no such category.");
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
  i->core.warn = warn;
  i->core.is_exchange = type == fmi2ModelExchange;
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
  const char *why;
  OF(c, INSTANTIATED, "fmi2SetupExperiment");
  why = core_set_up(&i->core, startTime, toleranceDefined, tolerance, stopTimeDefined, stopTime);
  if (why) return tell(i, fmi2Error, why);
  return fmi2OK;
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
  OF(c, INSTANTIATED, "fmi2EnterInitializationMode");
  i->core.state = INITIALISING;
  return fmi2OK;
}

fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
  OF(c, INITIALISING, "fmi2ExitInitializationMode");
  core_initialise(&i->core);
  i->core.d[AT_OWN + OWN_RUNNING] = 1.0;
  i->core.state = i->core.is_exchange ? EVENT : STEPPING;
  return fmi2OK;
}

fmi2Status fmi2Terminate(fmi2Component c) {
  OF(c, STEPPING | EVENT | CONTINUOUS | BROKEN, "fmi2Terminate");
  i->core.state = ENDED;
  return fmi2OK;
}

fmi2Status fmi2Reset(fmi2Component c) {
  OF(c, ALIVE, "fmi2Reset");
  core_reset(&i->core);
  return fmi2OK;
}

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Real value[]) {
  unsigned at = 0;
  OF(c, READABLE, "fmi2GetReal");
  if (n && (!vr || !value)) return tell(i, fmi2Error, "fmi2GetReal has no place for its values.");
  return refused(i, core_get_all(&i->core, vr, n, value, &at), at);
}

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Real value[]) {
  unsigned at = 0;
  int refusal;
  OF(c, INSTANTIATED | INITIALISING | STEPPING | EVENT | CONTINUOUS, "fmi2SetReal");
  if (n && (!vr || !value)) return tell(i, fmi2Error, "fmi2SetReal has no values.");
  refusal = core_set_all(&i->core, vr, n, value, &at);
  return refusal == REF_OK && i->core.has_warned ? fmi2Warning : refused(i, refusal, at);
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

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *kept) {
  OF(c, ALIVE, "fmi2GetFMUstate");
  if (!kept) return tell(i, fmi2Error, "fmi2GetFMUstate has no place for the state.");
  if (!*kept) *kept = i->functions->allocateMemory(1, KEPT);
  if (!*kept) return tell(i, fmi2Error, "Out of memory.");
  core_keep(&i->core, *kept);
  return fmi2OK;
}

fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate kept) {
  OF(c, ALIVE, "fmi2SetFMUstate");
  if (core_restore(&i->core, kept) != CORE_OK)
    return tell(i, fmi2Error, "This is no state of this model, or one of an instance of the other kind.");
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
  if (!kept || !core_is_kept(bytes, size))
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
  i->core.state = EVENT;
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
  i->core.state = CONTINUOUS;
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
  return core_derivatives(&i->core, found) ? fmi2OK : tell(i, fmi2Discard, "The derivatives are not finite in this state.");
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

/* Slope of an input over the next step. */
static int set_slope(Core *c, unsigned reference, double slope) {
  if (reference < REF_U || reference >= REF_X) return REF_CONSTANT;
  if (!IS_NUMBER(slope)) return REF_NOT_FINITE;
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
  const char *why;
  OF_STEPS(c, STEPPING, "fmi2DoStep");
  (void)noSetFMUStatePriorToCurrentPoint;
  why = core_no_step(&i->core, point, step);
  if (why) return tell(i, fmi2Error, why);
  switch (core_step(&i->core, point + step)) {
    case CORE_OK: return i->core.has_warned ? fmi2Warning : fmi2OK;
    case CORE_ENDED:
      tell(i, fmi2Discard, CONDITION_TEXTS[i->core.ending]);
      i->core.state = BROKEN;
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
