/* @ABOUT@

   An example of a host program, and a check. Without an argument, it compares the estimates and alarms of @ROWS@ samples
   with those that poppet has computed, and the exit code is 0 if all agree. With a recording (CSV with the columns of the
   twin file), it prints one line for each sample. */
#include "@NAME@.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS = @ROWS@, C = MODEL_CHANNELS, U = MODEL_INPUTS, F = MODEL_FAULTS, WIDTH = @WIDTH@ };
/* Time, readings, inputs; then estimates of the faults, their standard deviations, NIS and alarm (one bit per fault). */
static const double table[] = {
@TABLE@
};

static int check(void) {
  static model_watch w;
  double worst = 0.0;
  long same = 0, alarms = 0, wrong = 0;
  int row, i;
  model_init(&w);
  for (row = 0; row < ROWS; row++) {
    const double *given = table + row * WIDTH, *known = given + 1 + C + U;
    double bits = 0.0;
    int is_same = 1;
    (void)model_update(&w, given[0], given + 1, given + 1 + C);
    for (i = 0; i < F; i++) {
      const double apart = fabs(model_value(&w, i) - known[i]) / known[F + i];
      if (!(apart <= worst)) worst = apart;
      is_same &= model_value(&w, i) == known[i] && model_sigma(&w, i) == known[F + i];
      bits += w.alarm[i] ? ldexp(1.0, i) : 0.0;
    }
    is_same &= model_nis(&w) == known[2 * F];
    same += is_same;
    alarms += bits != 0.0;
    wrong += bits != known[2 * F + 1];
  }
  printf("%d samples: %ld with the same bits, largest difference %.1e standard deviations, %ld with an alarm, "
         "%ld alarms differ: %s\n", ROWS, same, worst, alarms, wrong, worst <= 1e-3 && !wrong ? "passed" : "FAILED");
  return worst <= 1e-3 && !wrong ? 0 : 1;
}

/* Divide a line at its commas; returns the number of cells. */
static int divide(char *line, char **cells, int most) {
  int count = 0;
  char *end;
  line[strcspn(line, "\r\n")] = 0;
  for (;;) {
    end = strchr(line, ',');
    if (count < most) cells[count++] = line;
    if (!end) return count;
    *end = 0;
    line = end + 1;
  }
}

/* Value of a cell in SI; NaN if there is none. */
static double cell(const model_column *column, char **cells, int count, int place) {
  char *end;
  double value;
  if (place < 0 || place >= count) return NAN;
  value = strtod(cells[place], &end);
  return end == cells[place] ? NAN : column->scale * value + column->shift;
}

static int find(const model_column *column, char **cells, int count) {
  int k;
  for (k = 0; k < count; k++) {
    if (!strcmp(cells[k], column->column)) return k;
  }
  fprintf(stderr, "no column %s\n", column->column);
  exit(2);
}

static int replay(const char *path) {
  static model_watch w;
  static char line[65536];
  char *cells[1024];
  int places[1 + C + U], count, k;
  FILE *file = fopen(path, "r");
  if (!file || !fgets(line, sizeof line, file)) {
    fprintf(stderr, "%s cannot be read\n", path);
    return 2;
  }
  count = divide(line, cells, 1024);
  places[0] = find(&model_time, cells, count);
  for (k = 0; k < C; k++) places[1 + k] = find(&model_channel_list[k], cells, count);
  for (k = 0; k < U; k++) places[1 + C + k] = find(&model_input_list[k], cells, count);
  model_init(&w);
  printf("time [s]");
  for (k = 0; k < F; k++) printf(",%s [%s],%s.sigma", model_free_list[k].name, model_free_list[k].unit, model_free_list[k].name);
  puts(",nis,alarm");
  while (fgets(line, sizeof line, file)) {
    double readings[C], inputs[U + 1], time;
    const char *separator = "";
    count = divide(line, cells, 1024);
    time = cell(&model_time, cells, count, places[0]);
    for (k = 0; k < C; k++) readings[k] = cell(&model_channel_list[k], cells, count, places[1 + k]);
    for (k = 0; k < U; k++) inputs[k] = cell(&model_input_list[k], cells, count, places[1 + C + k]);
    if (model_update(&w, time, readings, inputs) >= MODEL_LATE) continue;
    printf("%.9g", w.time);
    for (k = 0; k < F; k++) printf(",%.17g,%.17g", model_value(&w, k), model_sigma(&w, k));
    printf(",%.17g,", model_nis(&w));
    for (k = 0; k < F; k++) {
      if (!w.alarm[k]) continue;
      printf("%s%s", separator, model_free_list[k].name);
      separator = w.verdict == MODEL_SEVERAL ? " and " : " or ";
    }
    puts("");
  }
  fclose(file);
  return 0;
}

int main(int count, char **arguments) { return count > 1 ? replay(arguments[1]) : check(); }
