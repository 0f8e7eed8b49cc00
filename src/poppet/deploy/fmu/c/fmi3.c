/* FMI 3.0, model exchange and co-simulation, on the common core. */
#include "core.c"

#include "fmi3Functions.h"

typedef struct {
  Core core;
  fmi3LogMessageCallback log;
  fmi3InstanceEnvironment environment;
  int logs, may_return_early;
} Instance;

static fmi3Status tell(const Instance *i, fmi3Status status, const char *text) {
  if (i->log && (i->logs || status != fmi3OK))
    i->log(i->environment, status, LOG_CATEGORIES[status], text);
  return status;
}

static void warn(void *instance, const char *text) { tell((const Instance *)instance, fmi3Warning, text); }

static fmi3Status illegal(Instance *i, const char *function) {
  char text[128];
  if (!i) return fmi3Error;
  strcpy(text, function);
  strcat(text, " is not allowed in the present state.");
  return tell(i, fmi3Error, text);
}

#define OF(c, states, name)                             \
  Instance *i = (Instance *)(c);                        \
  if (!i || !(i->core.state & (states))) return illegal(i, name)

static fmi3Status refused(Instance *i, int refusal, unsigned reference) {
  char text[MESSAGE];
  if (refusal == REF_OK) return fmi3OK;
  return tell(i, refusal == REF_NO_RESULT ? fmi3Discard : fmi3Error, core_refusal(text, refusal, reference));
}

const char *fmi3GetVersion(void) { return fmi3Version; }

fmi3Status fmi3SetDebugLogging(fmi3Instance c, fmi3Boolean loggingOn, size_t n, const fmi3String categories[]) {
  int is_known;
  OF(c, ALIVE, "fmi3SetDebugLogging");
  i->logs = core_logs(loggingOn, n, categories, &is_known);
  return is_known ? fmi3OK : tell(i, fmi3Warning, "There is no such category.");
}

static fmi3Instance instantiated(fmi3String name, fmi3String token, fmi3Boolean loggingOn, int is_exchange,
                                 fmi3InstanceEnvironment environment, fmi3LogMessageCallback log) {
  Instance *i = (Instance *)calloc(1, sizeof(Instance));
  if (!i) return NULL;
  i->log = log, i->environment = environment, i->logs = loggingOn;
  if (!name || !token || strcmp(token, MODEL_GUID) != 0) {
    tell(i, fmi3Error, "No name, or the instantiation token is not that of this model.");
    free(i);
    return NULL;
  }
  if (core_create(&i->core, calloc, free) != CORE_OK) {
    tell(i, fmi3Error, "Out of memory.");
    free(i);
    return NULL;
  }
  i->core.warn = warn;
  i->core.is_exchange = is_exchange;
  return i;
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                          fmi3Boolean loggingOn, fmi3InstanceEnvironment environment,
                                          fmi3LogMessageCallback log) {
  (void)resources, (void)visible;
  return instantiated(name, token, loggingOn, 1, environment, log);
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                         fmi3Boolean loggingOn, fmi3Boolean eventModeUsed,
                                         fmi3Boolean earlyReturnAllowed, const fmi3ValueReference required[],
                                         size_t nRequired, fmi3InstanceEnvironment environment,
                                         fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback update) {
  Instance *i;
  (void)resources, (void)visible, (void)required, (void)nRequired, (void)update;
  if (eventModeUsed) {
    if (log) log(environment, fmi3Error, "logStatusError", "This FMU has no event mode in co-simulation.");
    return NULL;
  }
  i = (Instance *)instantiated(name, token, loggingOn, 0, environment, log);
  if (i) i->may_return_early = earlyReturnAllowed;
  return i;
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                               fmi3Boolean visible, fmi3Boolean loggingOn,
                                               fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                               fmi3ClockUpdateCallback update, fmi3LockPreemptionCallback lock,
                                               fmi3UnlockPreemptionCallback unlock) {
  (void)name, (void)token, (void)resources, (void)visible, (void)loggingOn, (void)update, (void)lock, (void)unlock;
  if (log) log(environment, fmi3Error, "logStatusError", "This FMU has no scheduled execution.");
  return NULL;
}

void fmi3FreeInstance(fmi3Instance c) {
  Instance *i = (Instance *)c;
  if (!i) return;
  core_release(&i->core);
  free(i);
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance c, fmi3Boolean toleranceDefined, fmi3Float64 tolerance,
                                       fmi3Float64 startTime, fmi3Boolean stopTimeDefined, fmi3Float64 stopTime) {
  const char *why;
  OF(c, INSTANTIATED, "fmi3EnterInitializationMode");
  why = core_set_up(&i->core, startTime, toleranceDefined, tolerance, stopTimeDefined, stopTime);
  if (why) return tell(i, fmi3Error, why);
  i->core.state = INITIALISING;
  return fmi3OK;
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance c) {
  OF(c, INITIALISING, "fmi3ExitInitializationMode");
  core_initialise(&i->core);
  i->core.d[AT_OWN + OWN_RUNNING] = 1.0;
  i->core.state = i->core.is_exchange ? EVENT : STEPPING;
  return fmi3OK;
}

fmi3Status fmi3Terminate(fmi3Instance c) {
  OF(c, STEPPING | EVENT | CONTINUOUS | BROKEN, "fmi3Terminate");
  i->core.state = ENDED;
  return fmi3OK;
}

fmi3Status fmi3Reset(fmi3Instance c) {
  OF(c, ALIVE, "fmi3Reset");
  core_reset(&i->core);
  return fmi3OK;
}

#define SAME(n, values) \
  if ((n) != (values)) return tell(i, fmi3Error, "These are not as many values as variables.")

fmi3Status fmi3GetFloat64(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3Float64 value[], size_t values) {
  unsigned at = 0;
  OF(c, READABLE, "fmi3GetFloat64");
  SAME(n, values);
  return refused(i, core_get_all(&i->core, vr, n, value, &at), at);
}

fmi3Status fmi3SetFloat64(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const fmi3Float64 value[],
                          size_t values) {
  unsigned at = 0;
  int refusal;
  OF(c, INSTANTIATED | INITIALISING | STEPPING | EVENT | CONTINUOUS, "fmi3SetFloat64");
  SAME(n, values);
  refusal = core_set_all(&i->core, vr, n, value, &at);
  return refusal == REF_OK && i->core.has_warned ? fmi3Warning : refused(i, refusal, at);
}

fmi3Status fmi3GetBoolean(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3Boolean value[], size_t values) {
  size_t k;
  OF(c, READABLE, "fmi3GetBoolean");
  SAME(n, values);
  for (k = 0; k < n; k++) {
    if (vr[k] != REF_FOLLOWS) return refused(i, REF_NO_NUMBER, vr[k]);
    value[k] = i->core.d[AT_OWN + OWN_FOLLOWS] != 0.0;
  }
  return fmi3OK;
}

fmi3Status fmi3SetBoolean(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const fmi3Boolean value[],
                          size_t values) {
  size_t k;
  OF(c, INSTANTIATED | INITIALISING | STEPPING | EVENT, "fmi3SetBoolean");
  SAME(n, values);
  for (k = 0; k < n; k++) {
    int refusal = vr[k] != REF_FOLLOWS ? REF_NO_NUMBER : core_set(&i->core, REF_FOLLOWS, value[k]);
    if (refusal != REF_OK) return refused(i, refusal, vr[k]);
  }
  return fmi3OK;
}

#define NONE_OF_TYPE(kind)                                                                                          \
  fmi3Status fmi3Get##kind(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3##kind value[],             \
                           size_t values) {                                                                         \
    OF(c, ALIVE, "fmi3Get" #kind);                                                                                  \
    (void)value, (void)values;                                                                                      \
    return n ? refused(i, REF_NO_NUMBER, vr ? vr[0] : 0) : fmi3OK;                                                  \
  }                                                                                                                 \
  fmi3Status fmi3Set##kind(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const fmi3##kind value[],       \
                           size_t values) {                                                                         \
    OF(c, ALIVE, "fmi3Set" #kind);                                                                                  \
    (void)value, (void)values;                                                                                      \
    return n ? refused(i, REF_NO_NUMBER, vr ? vr[0] : 0) : fmi3OK;                                                  \
  }
NONE_OF_TYPE(Float32)
NONE_OF_TYPE(Int8)
NONE_OF_TYPE(UInt8)
NONE_OF_TYPE(Int16)
NONE_OF_TYPE(UInt16)
NONE_OF_TYPE(Int32)
NONE_OF_TYPE(UInt32)
NONE_OF_TYPE(Int64)
NONE_OF_TYPE(UInt64)
NONE_OF_TYPE(String)

/* Not supported: binary values, clocks, configuration, adjoint derivatives. */
static fmi3Status none(fmi3Instance c, const char *function) {
  OF(c, ALIVE, function);
  return tell(i, fmi3Error, "This model has none of these.");
}

fmi3Status fmi3GetBinary(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,
                         size_t valueSizes[], fmi3Binary values[], size_t nValues) {
  (void)valueReferences, (void)nValueReferences, (void)valueSizes, (void)values, (void)nValues;
  return none(instance, "fmi3GetBinary");
}

fmi3Status fmi3SetBinary(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,
                         const size_t valueSizes[], const fmi3Binary values[], size_t nValues) {
  (void)valueReferences, (void)nValueReferences, (void)valueSizes, (void)values, (void)nValues;
  return none(instance, "fmi3SetBinary");
}

fmi3Status fmi3GetClock(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,
                        fmi3Clock values[]) {
  (void)valueReferences, (void)nValueReferences, (void)values;
  return none(instance, "fmi3GetClock");
}

fmi3Status fmi3SetClock(fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,
                        const fmi3Clock values[]) {
  (void)valueReferences, (void)nValueReferences, (void)values;
  return none(instance, "fmi3SetClock");
}

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance instance, fmi3ValueReference valueReference,
                                               size_t* nDependencies) {
  (void)valueReference, (void)nDependencies;
  return none(instance, "fmi3GetNumberOfVariableDependencies");
}

fmi3Status fmi3GetVariableDependencies(fmi3Instance instance, fmi3ValueReference dependent,
                                       size_t elementIndicesOfDependent[], fmi3ValueReference independents[],
                                       size_t elementIndicesOfIndependents[], fmi3DependencyKind dependencyKinds[],
                                       size_t nDependencies) {
  (void)dependent, (void)elementIndicesOfDependent, (void)independents, (void)elementIndicesOfIndependents, (void)dependencyKinds, (void)nDependencies;
  return none(instance, "fmi3GetVariableDependencies");
}

fmi3Status fmi3GetAdjointDerivative(fmi3Instance instance, const fmi3ValueReference unknowns[], size_t nUnknowns,
                                    const fmi3ValueReference knowns[], size_t nKnowns, const fmi3Float64 seed[],
                                    size_t nSeed, fmi3Float64 sensitivity[], size_t nSensitivity) {
  (void)unknowns, (void)nUnknowns, (void)knowns, (void)nKnowns, (void)seed, (void)nSeed, (void)sensitivity, (void)nSensitivity;
  return none(instance, "fmi3GetAdjointDerivative");
}

fmi3Status fmi3EnterConfigurationMode(fmi3Instance instance) {
  return none(instance, "fmi3EnterConfigurationMode");
}

fmi3Status fmi3ExitConfigurationMode(fmi3Instance instance) {
  return none(instance, "fmi3ExitConfigurationMode");
}

fmi3Status fmi3GetIntervalDecimal(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                  size_t nValueReferences, fmi3Float64 intervals[],
                                  fmi3IntervalQualifier qualifiers[]) {
  (void)valueReferences, (void)nValueReferences, (void)intervals, (void)qualifiers;
  return none(instance, "fmi3GetIntervalDecimal");
}

fmi3Status fmi3GetIntervalFraction(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                   size_t nValueReferences, fmi3UInt64 counters[], fmi3UInt64 resolutions[],
                                   fmi3IntervalQualifier qualifiers[]) {
  (void)valueReferences, (void)nValueReferences, (void)counters, (void)resolutions, (void)qualifiers;
  return none(instance, "fmi3GetIntervalFraction");
}

fmi3Status fmi3GetShiftDecimal(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                               size_t nValueReferences, fmi3Float64 shifts[]) {
  (void)valueReferences, (void)nValueReferences, (void)shifts;
  return none(instance, "fmi3GetShiftDecimal");
}

fmi3Status fmi3GetShiftFraction(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                size_t nValueReferences, fmi3UInt64 counters[], fmi3UInt64 resolutions[]) {
  (void)valueReferences, (void)nValueReferences, (void)counters, (void)resolutions;
  return none(instance, "fmi3GetShiftFraction");
}

fmi3Status fmi3SetIntervalDecimal(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                  size_t nValueReferences, const fmi3Float64 intervals[]) {
  (void)valueReferences, (void)nValueReferences, (void)intervals;
  return none(instance, "fmi3SetIntervalDecimal");
}

fmi3Status fmi3SetIntervalFraction(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                   size_t nValueReferences, const fmi3UInt64 counters[],
                                   const fmi3UInt64 resolutions[]) {
  (void)valueReferences, (void)nValueReferences, (void)counters, (void)resolutions;
  return none(instance, "fmi3SetIntervalFraction");
}

fmi3Status fmi3SetShiftDecimal(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                               size_t nValueReferences, const fmi3Float64 shifts[]) {
  (void)valueReferences, (void)nValueReferences, (void)shifts;
  return none(instance, "fmi3SetShiftDecimal");
}

fmi3Status fmi3SetShiftFraction(fmi3Instance instance, const fmi3ValueReference valueReferences[],
                                size_t nValueReferences, const fmi3UInt64 counters[],
                                const fmi3UInt64 resolutions[]) {
  (void)valueReferences, (void)nValueReferences, (void)counters, (void)resolutions;
  return none(instance, "fmi3SetShiftFraction");
}

fmi3Status fmi3EnterStepMode(fmi3Instance instance) {
  return none(instance, "fmi3EnterStepMode");
}

fmi3Status fmi3ActivateModelPartition(fmi3Instance instance, fmi3ValueReference clockReference,
                                      fmi3Float64 activationTime) {
  (void)clockReference, (void)activationTime;
  return none(instance, "fmi3ActivateModelPartition");
}

fmi3Status fmi3GetFMUState(fmi3Instance c, fmi3FMUState *kept) {
  OF(c, ALIVE, "fmi3GetFMUState");
  if (!kept) return tell(i, fmi3Error, "fmi3GetFMUState has no place for the state.");
  if (!*kept) *kept = calloc(1, KEPT);
  if (!*kept) return tell(i, fmi3Error, "Out of memory.");
  core_keep(&i->core, *kept);
  return fmi3OK;
}

fmi3Status fmi3SetFMUState(fmi3Instance c, fmi3FMUState kept) {
  OF(c, ALIVE, "fmi3SetFMUState");
  if (core_restore(&i->core, kept) != CORE_OK)
    return tell(i, fmi3Error, "This is no state of this model, or one of an instance of the other kind.");
  return fmi3OK;
}

fmi3Status fmi3FreeFMUState(fmi3Instance c, fmi3FMUState *kept) {
  OF(c, ALIVE, "fmi3FreeFMUState");
  if (kept && *kept) {
    free(*kept);
    *kept = NULL;
  }
  return fmi3OK;
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance c, fmi3FMUState kept, size_t *size) {
  OF(c, ALIVE, "fmi3SerializedFMUStateSize");
  if (!kept || !size) return tell(i, fmi3Error, "There is no state to serialise.");
  *size = KEPT;
  return fmi3OK;
}

fmi3Status fmi3SerializeFMUState(fmi3Instance c, fmi3FMUState kept, fmi3Byte bytes[], size_t size) {
  OF(c, ALIVE, "fmi3SerializeFMUState");
  if (!kept || !bytes || size < KEPT) return tell(i, fmi3Error, "There is no state, or no room to serialise it.");
  memcpy(bytes, kept, KEPT);
  return fmi3OK;
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance c, const fmi3Byte bytes[], size_t size, fmi3FMUState *kept) {
  OF(c, ALIVE, "fmi3DeserializeFMUState");
  if (!kept || !core_is_kept(bytes, size))
    return tell(i, fmi3Error, "These bytes are no state of this model.");
  if (!*kept) *kept = calloc(1, KEPT);
  if (!*kept) return tell(i, fmi3Error, "Out of memory.");
  memcpy(*kept, bytes, KEPT);
  return fmi3OK;
}

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance c, const fmi3ValueReference unknown[], size_t nUnknown,
                                        const fmi3ValueReference known[], size_t nKnown, const fmi3Float64 seed[],
                                        size_t nSeed, fmi3Float64 found[], size_t nFound) {
  int refusal;
  OF(c, INITIALISING | STEPPING | EVENT | CONTINUOUS | ENDED | BROKEN, "fmi3GetDirectionalDerivative");
  SAME(nKnown, nSeed);
  SAME(nUnknown, nFound);
  refusal = core_directional(&i->core, unknown, nUnknown, known, nKnown, seed, found);
  return refusal == REF_OK ? fmi3OK : tell(i, fmi3Error, "There is no derivative between these variables.");
}

/* Model exchange -------------------------------------------------------------------------------------------------- */

#define OF_EXCHANGE(c, states, name) \
  OF(c, states, name);               \
  if (!i->core.is_exchange) return illegal(i, name)

fmi3Status fmi3EnterEventMode(fmi3Instance c) {
  OF_EXCHANGE(c, CONTINUOUS | EVENT, "fmi3EnterEventMode");
  i->core.state = EVENT;
  return fmi3OK;
}

fmi3Status fmi3UpdateDiscreteStates(fmi3Instance c, fmi3Boolean *discreteStatesNeedUpdate,
                                    fmi3Boolean *terminateSimulation, fmi3Boolean *nominalsOfContinuousStatesChanged,
                                    fmi3Boolean *valuesOfContinuousStatesChanged, fmi3Boolean *nextEventTimeDefined,
                                    fmi3Float64 *nextEventTime) {
  double next;
  OF_EXCHANGE(c, EVENT, "fmi3UpdateDiscreteStates");
  core_event(&i->core);
  next = core_next_event(&i->core);
  *discreteStatesNeedUpdate = *terminateSimulation = fmi3False;
  *nominalsOfContinuousStatesChanged = *valuesOfContinuousStatesChanged = fmi3False;
  *nextEventTimeDefined = next < HUGE_VAL ? fmi3True : fmi3False;
  *nextEventTime = next < HUGE_VAL ? next : 0.0;
  return fmi3OK;
}

fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance c) {
  OF(c, INITIALISING | EVENT, "fmi3EvaluateDiscreteStates");
  return fmi3OK;
}

fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance c) {
  OF_EXCHANGE(c, EVENT, "fmi3EnterContinuousTimeMode");
  i->core.state = CONTINUOUS;
  return fmi3OK;
}

fmi3Status fmi3CompletedIntegratorStep(fmi3Instance c, fmi3Boolean noSetFMUStatePriorToCurrentPoint,
                                       fmi3Boolean *enterEventMode, fmi3Boolean *terminateSimulation) {
  OF_EXCHANGE(c, CONTINUOUS, "fmi3CompletedIntegratorStep");
  (void)noSetFMUStatePriorToCurrentPoint;
  *enterEventMode = fmi3False;
  *terminateSimulation = core_ends(&i->core) >= 0 ? fmi3True : fmi3False;
  if (*terminateSimulation) tell(i, fmi3OK, CONDITION_TEXTS[i->core.ending]);
  return fmi3OK;
}

fmi3Status fmi3SetTime(fmi3Instance c, fmi3Float64 time) {
  OF_EXCHANGE(c, EVENT | CONTINUOUS, "fmi3SetTime");
  if (!IS_NUMBER(time)) return tell(i, fmi3Error, "The time is not finite.");
  i->core.d[AT_OWN + OWN_TIME] = time - i->core.d[AT_OWN + OWN_BEGIN];
  return fmi3OK;
}

fmi3Status fmi3SetContinuousStates(fmi3Instance c, const fmi3Float64 x[], size_t n) {
  size_t k;
  OF_EXCHANGE(c, EVENT | CONTINUOUS, "fmi3SetContinuousStates");
  if (n != N_STATES || (n && !x)) return tell(i, fmi3Error, "This is not the number of states.");
  for (k = 0; k < n; k++)
    if (!IS_NUMBER(x[k])) return tell(i, fmi3Error, "A state is not finite.");
  memcpy(i->core.d + AT_X, x, n * sizeof(double));
  return fmi3OK;
}

fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance c, fmi3Float64 found[], size_t n) {
  OF_EXCHANGE(c, INITIALISING | EVENT | CONTINUOUS | ENDED | BROKEN, "fmi3GetContinuousStateDerivatives");
  if (n != N_STATES || (n && !found)) return tell(i, fmi3Error, "This is not the number of states.");
  return core_derivatives(&i->core, found) ? fmi3OK : tell(i, fmi3Discard, "The derivatives are not finite in this state.");
}

fmi3Status fmi3GetEventIndicators(fmi3Instance c, fmi3Float64 found[], size_t n) {
  OF_EXCHANGE(c, INITIALISING | EVENT | CONTINUOUS | ENDED | BROKEN, "fmi3GetEventIndicators");
  if (n != N_INDICATORS || (n && !found)) return tell(i, fmi3Error, "This is not the number of event indicators.");
  core_initialise(&i->core);
  core_indicators(&i->core, found);
  return fmi3OK;
}

fmi3Status fmi3GetContinuousStates(fmi3Instance c, fmi3Float64 x[], size_t n) {
  OF_EXCHANGE(c, INITIALISING | EVENT | CONTINUOUS | ENDED | BROKEN, "fmi3GetContinuousStates");
  if (n != N_STATES || (n && !x)) return tell(i, fmi3Error, "This is not the number of states.");
  core_initialise(&i->core);
  memcpy(x, i->core.d + AT_X, n * sizeof(double));
  return fmi3OK;
}

fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance c, fmi3Float64 x[], size_t n) {
  OF_EXCHANGE(c, INSTANTIATED | INITIALISING | EVENT | CONTINUOUS | ENDED | BROKEN,
              "fmi3GetNominalsOfContinuousStates");
  if (n != N_STATES || (n && !x)) return tell(i, fmi3Error, "This is not the number of states.");
  memcpy(x, STATE_NOMINALS, n * sizeof(double));
  return fmi3OK;
}

fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance c, size_t *n) {
  OF(c, ALIVE, "fmi3GetNumberOfEventIndicators");
  *n = N_INDICATORS;
  return fmi3OK;
}

fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance c, size_t *n) {
  OF(c, ALIVE, "fmi3GetNumberOfContinuousStates");
  *n = N_STATES;
  return fmi3OK;
}

/* Co-simulation --------------------------------------------------------------------------------------------------- */

fmi3Status fmi3GetOutputDerivatives(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const fmi3Int32 orders[],
                                    fmi3Float64 value[], size_t values) {
  (void)vr, (void)n, (void)orders, (void)value, (void)values;
  return none(c, "fmi3GetOutputDerivatives");
}

fmi3Status fmi3DoStep(fmi3Instance c, fmi3Float64 point, fmi3Float64 step, fmi3Boolean noSetFMUStatePriorToCurrentPoint,
                      fmi3Boolean *eventHandlingNeeded, fmi3Boolean *terminateSimulation, fmi3Boolean *earlyReturn,
                      fmi3Float64 *lastSuccessfulTime) {
  const char *why;
  int came;
  OF(c, STEPPING, "fmi3DoStep");
  if (i->core.is_exchange) return illegal(i, "fmi3DoStep");
  (void)noSetFMUStatePriorToCurrentPoint;
  *eventHandlingNeeded = *terminateSimulation = *earlyReturn = fmi3False;
  *lastSuccessfulTime = i->core.d[AT_OWN + OWN_BEGIN] + i->core.d[AT_OWN + OWN_TIME];
  why = core_no_step(&i->core, point, step);
  if (why) return tell(i, fmi3Error, why);
  came = core_step(&i->core, point + step);
  *lastSuccessfulTime = i->core.d[AT_OWN + OWN_BEGIN] + i->core.d[AT_OWN + OWN_TIME];
  switch (came) {
    case CORE_OK: return i->core.has_warned ? fmi3Warning : fmi3OK;
    case CORE_ENDED:
      tell(i, fmi3OK, CONDITION_TEXTS[i->core.ending]);
      *terminateSimulation = fmi3True;
      *earlyReturn = i->may_return_early ? fmi3True : fmi3False;
      i->core.state = BROKEN;
      return fmi3OK;
    case CORE_DISCARDED: return tell(i, fmi3Discard, "The integrator did not come to the end of the step.");
    default: return tell(i, fmi3Error, "Out of memory.");
  }
}
