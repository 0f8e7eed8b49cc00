/* Runs an exported model for the table of parity: STEP (0: with error control), substeps, file of times,
   file of the table. */
#include "model.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static model_adaptive adaptive;
static model_fixed fixed;

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int run(double step, int substeps, const double *times, int64_t n, double *table) {
  double y[MODEL_OUTPUTS + 1], count = 0.0;
  int64_t row;
  int k, status;
  if (step == 0.0) {
    model_adaptive_begin(&adaptive);
    status = (int)model_adaptive_run(&adaptive, times, n, table);
    return status > 1 ? status : 0;
  }
  model_fixed_begin(&fixed);
  fixed.substeps = substeps;
  for (row = 0; row < n; row++) {
    while (fixed.t < times[row]) {
      double until = (count + 1.0) * step;
      if (until < times[row] * (1.0 - 1e-12)) count += 1.0;
      else {
        if (until <= times[row] * (1.0 + 1e-12)) count += 1.0;
        until = times[row];
      }
      status = model_fixed_step(&fixed, until);
      if (status) return status;
    }
    model_fixed_outputs(&fixed, y);
    for (k = 0; k < MODEL_OUTPUTS; k++) table[k * n + row] = y[k];
  }
  return 0;
}

int main(int argc, char **argv) {
  double step = argc == 5 ? atof(argv[1]) : 0.0, best = 1e9, spent = 0.0;
  double *times, *table;
  FILE *file;
  long size;
  int status = 0, round;
  if (argc != 5 || !(file = fopen(argv[3], "rb"))) return 9;
  fseek(file, 0, SEEK_END);
  size = ftell(file);
  rewind(file);
  times = malloc((size_t)size + 8);
  table = malloc(((size_t)size + 8) * (MODEL_OUTPUTS + 1));
  if (!times || !table || fread(times, 1, (size_t)size, file) != (size_t)size) return 9;
  fclose(file);
  /* Minimum time of several runs. */
  for (round = 0; round < 20 && spent < 0.5; round++) {
    double began = now(), took;
    status = run(step, atoi(argv[2]), times, size / 8, table);
    if (status) break;
    took = now() - began;
    spent += took;
    if (took < best) best = took;
  }
  printf("%.9g\nstatus %d\n", best, status);
  if (status) return 10 + status;
  file = fopen(argv[4], "wb");
  if (!file || fwrite(table, sizeof(double), (size_t)(size / 8) * MODEL_OUTPUTS, file) != (size_t)(size / 8) * MODEL_OUTPUTS)
    return 9;
  return fclose(file);
}
