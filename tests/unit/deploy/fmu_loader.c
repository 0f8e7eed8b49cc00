/* A host in C that loads the library of an FMU, on Linux or Windows: LIBRARY TOKEN STEP COUNT FOLLOWS REFERENCE...
   Prints the values after each step; the second half of the run is gone through twice, from a kept state. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#if FMI == 2
#include "fmi2Functions.h"
#define PREFIX "fmi2"
#define OF(name) fmi2##name
static void told(void *e, fmi2String n, fmi2Status s, fmi2String c, fmi2String m, ...) {
  (void)e, (void)n, (void)c;
  fprintf(stderr, "%d %s\n", (int)s, m);
}
#else
#include "fmi3Functions.h"
#define PREFIX "fmi3"
#define OF(name) fmi3##name
static void told(void *e, fmi3Status s, fmi3String c, fmi3String m) {
  (void)e, (void)c;
  fprintf(stderr, "%d %s\n", (int)s, m);
}
#endif

static void *library;

static void *entry(const char *name) {
  char full[99];
  void *found;
  snprintf(full, sizeof full, PREFIX "%s", name);
#ifdef _WIN32
  found = (void *)GetProcAddress((HMODULE)library, full);
#else
  found = dlsym(library, full);
#endif
  if (!found) fprintf(stderr, "no %s\n", full), exit(3);
  return found;
}

#define CALL(name) ((JOIN(OF(name), TYPE) *)entry(#name))
#define DO(call) do { if ((call) > 1) fprintf(stderr, "line %d\n", __LINE__), exit(4); } while (0)

int main(int n, char **words) {
  double step = atof(words[3]), values[64];
  unsigned references[64], follows = (unsigned)atoi(words[5]);
  int count = atoi(words[4]), wanted = n - 6, k, j, is_again;
  void *it, *kept = 0;
#ifdef _WIN32
  library = LoadLibraryA(words[1]);
#else
  library = dlopen(words[1], RTLD_NOW | RTLD_LOCAL);
#endif
  if (!library) return 2;
  for (k = 0; k < wanted; k++) references[k] = (unsigned)atoi(words[6 + k]);
#if FMI == 2
  {
    static fmi2CallbackFunctions calls = {told, calloc, free, 0, 0};
    fmi2Boolean yes = 1;
    it = CALL(Instantiate)("it", fmi2CoSimulation, words[2], "", &calls, 0, 1);
    if (!it) return 2;
    DO(CALL(SetBoolean)(it, &follows, 1, &yes));
    DO(CALL(SetupExperiment)(it, 0, 0.0, 0.0, 0, 0.0));
    DO(CALL(EnterInitializationMode)(it));
  }
#else
  {
    fmi3Boolean yes = 1;
    it = CALL(InstantiateCoSimulation)("it", words[2], "", 0, 1, 0, 0, 0, 0, 0, told, 0);
    if (!it) return 2;
    DO(CALL(SetBoolean)(it, &follows, 1, &yes, 1));
    DO(CALL(EnterInitializationMode)(it, 0, 0.0, 0.0, 0, 0.0));
  }
#endif
  DO(CALL(ExitInitializationMode)(it));
  for (is_again = 0; is_again < 2; is_again++) {
    for (k = is_again ? count / 2 : 0; k < count; k++) {
#if FMI == 2
      if (k == count / 2 && !is_again) DO(CALL(GetFMUstate)(it, &kept));
      DO(CALL(DoStep)(it, k * step, step, 0));
      DO(CALL(GetReal)(it, references, (size_t)wanted, values));
#else
      fmi3Boolean needed, ends, early;
      double last;
      if (k == count / 2 && !is_again) DO(CALL(GetFMUState)(it, &kept));
      DO(CALL(DoStep)(it, k * step, step, 0, &needed, &ends, &early, &last));
      DO(CALL(GetFloat64)(it, references, (size_t)wanted, values, (size_t)wanted));
#endif
      for (j = 0; j < wanted; j++) printf("%.17g ", values[j]);
      printf("\n");
    }
#if FMI == 2
    DO(CALL(SetFMUstate)(it, kept));
#else
    DO(CALL(SetFMUState)(it, kept));
#endif
  }
#if FMI == 2
  DO(CALL(FreeFMUstate)(it, &kept));
#else
  DO(CALL(FreeFMUState)(it, &kept));
#endif
  CALL(FreeInstance)(it);
  return 0;
}
