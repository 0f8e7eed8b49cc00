/* FMU for tests (FMI 2.0): y' = rate*u, integrated exactly for inputs that are straight lines; z = gain*u.
   `fault` after the time `fault_time`: 1 segmentation fault, 2 exit, 3 endless loop, 4 status error, 5 not finite,
   6 end of the simulation, 7 output to both streams, 8 start of another program and status error. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct { double rate, gain, fault_time, u, slope, y; int fault; double reached; int has_ended; } Model;
typedef void *Component;

Component fmi2Instantiate(const char *name, int type, const char *guid, const char *resources, const void *callbacks,
                          int visible, int logging) {
    Model *m = strcmp(name, "rejected") ? calloc(1, sizeof(Model)) : 0;
    if (!m) return 0;
    (void)name; (void)type; (void)guid; (void)resources; (void)callbacks; (void)visible; (void)logging;
    m->rate = 1.0;
    m->fault_time = 0.5;
    return m;
}
void fmi2FreeInstance(Component c) { free(c); }
int fmi2SetupExperiment(Component c, int a, double b, double d, int e, double f) {
    (void)c; (void)a; (void)b; (void)d; (void)e; (void)f;
    return 0;
}
int fmi2EnterInitializationMode(Component c) { (void)c; return 0; }
int fmi2ExitInitializationMode(Component c) { (void)c; return 0; }
int fmi2Terminate(Component c) { (void)c; return 0; }

static double *real(Model *m, unsigned reference) {
    double *places[] = {&m->u, &m->y, 0, &m->rate, &m->gain, &m->fault_time};
    return reference < 6 ? places[reference] : 0;
}
int fmi2SetReal(Component c, const unsigned *references, size_t n, const double *values) {
    for (size_t k = 0; k < n; k++) {
        if (!real(c, references[k])) return 3;
        *real(c, references[k]) = values[k];
    }
    ((Model *)c)->slope = 0.0;
    return 0;
}
int fmi2GetReal(Component c, const unsigned *references, size_t n, double *values) {
    Model *m = c;
    for (size_t k = 0; k < n; k++) values[k] = references[k] == 2 ? m->gain * m->u : *real(m, references[k]);
    return 0;
}
int fmi2SetInteger(Component c, const unsigned *references, size_t n, const int *values) {
    for (size_t k = 0; k < n; k++) ((Model *)c)->fault = values[k];
    (void)references;
    return 0;
}
int fmi2GetInteger(Component c, const unsigned *references, size_t n, int *values) {
    for (size_t k = 0; k < n; k++) values[k] = ((Model *)c)->fault;
    (void)references;
    return 0;
}
int fmi2SetRealInputDerivatives(Component c, const unsigned *references, size_t n, const int *orders,
                                const double *values) {
    (void)references; (void)orders;
    if (n) ((Model *)c)->slope = values[0];
    return 0;
}
int fmi2DoStep(Component c, double t, double h, int unused) {
    Model *m = c;
    (void)unused;
    if (t + h > m->fault_time) switch (m->fault) {
        case 1: fprintf(stderr, "about to crash\n"); fflush(stderr); *(volatile int *)0 = 1; break;
        case 2: exit(7);
        case 3: for (;;) {} 
        case 4: return 3;
        case 5: m->y = NAN; return 0;
        case 6: m->reached = m->fault_time > t ? m->fault_time : t; m->has_ended = 1; return 2;
        case 7: printf("noise {}\n"); fflush(stdout); break;
        case 8: return system("sleep 3600 & echo $! >&2") ? 3 : 4;
        default: break;
    }
    m->y += m->rate * (m->u * h + 0.5 * m->slope * h * h);
    m->u += m->slope * h;
    return 0;
}
int fmi2GetBooleanStatus(Component c, int kind, int *value) { (void)kind; *value = ((Model *)c)->has_ended; return 0; }
int fmi2GetRealStatus(Component c, int kind, double *value) { (void)kind; *value = ((Model *)c)->reached; return 0; }
int fmi2GetFMUstate(Component c, void **state) {
    if (!*state) *state = malloc(sizeof(Model));
    memcpy(*state, c, sizeof(Model));
    return 0;
}
int fmi2SetFMUstate(Component c, void *state) { memcpy(c, state, sizeof(Model)); return 0; }
int fmi2FreeFMUstate(Component c, void **state) { (void)c; free(*state); *state = 0; return 0; }

/* Variables of these types do not exist; libcosim calls the functions for none. */
#define NONE(name) int name(Component c, void *r, size_t n, void *v) { (void)c; (void)r; (void)v; return n ? 3 : 0; }
NONE(fmi2GetBoolean)
NONE(fmi2GetString)
NONE(fmi2SetBoolean)
NONE(fmi2SetString)

/* Functions that importers look up, but that these tests do not call. */
#define UNUSED(name) int name(void) { return 3; }
const char *fmi2GetTypesPlatform(void) { return "default"; }
const char *fmi2GetVersion(void) { return "2.0"; }
UNUSED(fmi2SetDebugLogging)
UNUSED(fmi2Reset)
UNUSED(fmi2SerializedFMUstateSize)
UNUSED(fmi2SerializeFMUstate)
UNUSED(fmi2DeSerializeFMUstate)
UNUSED(fmi2GetDirectionalDerivative)
UNUSED(fmi2GetRealOutputDerivatives)
UNUSED(fmi2CancelStep)
UNUSED(fmi2GetStatus)
UNUSED(fmi2GetIntegerStatus)
UNUSED(fmi2GetStringStatus)
