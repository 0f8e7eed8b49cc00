"""The paper's staircase in C, beside the kernel and in one run with it: whole runs, and steps for real time.

The adaptive run in C writes the rows that the kernel writes. Times are the least of several rounds, taken in turns. For
steps of fixed length each stretch of a hundred steps, and each single step, counts with its least time over all
rounds: what a scheduler or an interrupt adds does not come twice at the same place. Single steps are timed with two
looks at the clock around them, which is part of what is printed. Errors are those of the tank's pressure at rows every
0.1 s, against a run with a relative tolerance of 1e-12.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import poppet
from poppet import Circuit, loads
from poppet.deploy.c.project import c_project
from poppet.engine.call import Call
from staircase import CIRCUIT

OPTIONS = ("-std=c99", "-O2", "-march=native", "-ffp-contract=fast")
HARNESS = r"""
#define _POSIX_C_SOURCE 199309L
#include "paper.h"
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

/* One adaptive run with rows every 0.1 s: its time. */
static double adaptive(int rows, double *error_of) {
  static paper_adaptive m;
  double *times = malloc(sizeof(double) * rows), *table = malloc(sizeof(double) * rows * PAPER_OUTPUTS), begin, took;
  int k;
  for (k = 0; k < rows; k++) times[k] = k / 10.0;
  paper_adaptive_begin(&m);
  begin = now();
  if (paper_adaptive_run(&m, times, rows, table)) exit(1);
  took = now() - begin;
  for (k = 0; k < rows; k++) error_of[k] = table[PLACE * rows + k];
  free(times);
  free(table);
  return took;
}

int main(int count, char **arguments) {
  double h = atof(arguments[1]), end = atof(arguments[2]);
  int rounds = atoi(arguments[3]), round, rows = (int)(end * 10.0 + 1.5);
  long steps = (long)(end / h + 0.5), every = (long)(0.1 / h + 0.5), k;
  static paper_fixed m;
  float *least = malloc(sizeof(float) * steps), *stretch = malloc(sizeof(float) * (steps / 100 + 1));
  double *pressure = malloc(sizeof(double) * rows), y[PAPER_OUTPUTS], best = 1e300, sum = 0.0, worst = 0.0;
  (void)count;
  for (k = 0; k < steps; k++) least[k] = 1e30f;
  for (k = 0; k < steps / 100 + 1; k++) stretch[k] = 1e30f;
  for (round = 0; round < rounds; round++) {
    double begin;
    for (k = 0; k < 5; k++) {
      double took = adaptive(rows, pressure);
      if (took < best) best = took;
    }
    begin = now();
    paper_fixed_begin(&m);
    for (k = 0; k < steps; k++) {
      if (paper_fixed_step(&m, (k + 1) * h)) return 1;
      if (k % 100 == 99) {
        double stop = now();
        if (stop - begin < stretch[k / 100]) stretch[k / 100] = (float)(stop - begin);
        begin = now();
      }
    }
    paper_fixed_begin(&m);
    for (k = 0; k < steps; k++) {
      double before = now(), single;
      paper_fixed_step(&m, (k + 1) * h);
      single = now() - before;
      if (single < least[k]) least[k] = (float)single;
    }
  }
  for (k = 0; k < steps / 100; k++) sum += stretch[k];
  for (k = 0; k < steps; k++) worst = least[k] > worst ? least[k] : worst;
  printf("%.17g %.17g %.17g %ld\n", best, sum / (double)(steps / 100 * 100), worst, steps);
  paper_fixed_begin(&m);
  for (k = 0; k <= steps; k++) {
    if (k) paper_fixed_step(&m, k * h);
    if (k % every == 0) {
      paper_fixed_outputs(&m, y);
      printf("%.17g\n", y[PLACE]);
    }
  }
  for (k = 0; k < rows; k++) printf("%.17g\n", pressure[k]);
  return 0;
}
"""


def build(circuit: Circuit, folder: Path) -> Path:
    """The harness with the exported circuit, compiled."""
    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if compiler is None:
        sys.exit("there is no C compiler on this machine")
    place = [name for name, _ in circuit.model.outputs].index("tank.pressure")
    files = {name: text for name, text in c_project(circuit, "paper").items() if "host" not in name}
    files["harness.c"] = f"#define PLACE {place}\n{HARNESS}"
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    sources = [str(folder / name) for name in files if name.endswith(".c")]
    subprocess.run([compiler, *OPTIONS, "-o", str(folder / "harness"), *sources, "-lm"], check=True)
    return folder / "harness"


def main(size: float = 1.0) -> None:
    """Print times and errors; `size` scales the number of rounds, and below 1 the length of the run."""
    circuit = loads(CIRCUIT)
    duration = 120.0 if size >= 1.0 else 5.0
    circuit = circuit.with_values({"run.duration": duration})
    tight = circuit.simulate(relative_tolerance=1e-12)["tank.pressure"]
    rounds = max(1, round(9 * size))
    call, kernel, in_c = Call(circuit.problem(circuit.run)), [], []

    def error(pressure: np.ndarray) -> float:
        return float(np.max(np.abs(pressure / tight - 1.0)))

    lines = []
    with tempfile.TemporaryDirectory() as folder:
        harness = build(circuit, Path(folder))
        for step in ("1e-3", "1e-4"):
            for _ in range(5 * rounds):
                begin = time.perf_counter()
                call.repeat()
                kernel.append(time.perf_counter() - begin)
            command = [str(harness), step, str(duration), str(rounds)]
            head, *rest = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split("\n")
            best, average, worst, steps = map(float, head.split())
            fixed, adaptive = np.array([float(word) for word in rest if word]).reshape(2, -1)
            in_c.append(1e-9 * best)
            lines.append(
                f"{1e-3 / float(step):4.0f} kHz {average:10.0f} {worst:10.0f} {steps:10.0f} {error(fixed):10.2g}"
            )
        print(f"poppet {poppet.__version__}; paper staircase, {duration:g} s, {tight.size} rows; {' '.join(OPTIONS)}")
        print(f"kernel {1e3 * min(kernel):.3f} ms, adaptive in C {1e3 * min(in_c):.3f} ms: ", end="")
        print(f"{min(in_c) / min(kernel):.2f} times; error in pressure {error(adaptive):.2g}")
    print(f"{'fixed':>8s} {'average ns':>10s} {'worst ns':>10s} {'of steps':>10s} {'error':>10s}")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
