"""Exported controllers in C with random faults, compiled with sanitizers.

The calls mix valid inputs, inputs that are not finite, wild finite values, parameters within and outside their limits,
times that jitter or run backwards, and restarts.
"""

from __future__ import annotations

import re
import subprocess
from functools import cache

import pytest

from circuits_of_exports import CONTROLLERS, EXAMPLES
from controller_targets import C_COMPILER, STRICT, members
from poppet import load
from poppet.deploy.c.controller import c_controller
from poppet.deploy.controller import controller_program
from poppet.engine.printers.c import DOUBLE, SINGLE

VALVES = ("fill_command", "vent_command", "fill_duty", "vent_duty")
SANITIZERS = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-fno-omit-frame-pointer")
HOST = """
#include "ctl.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

typedef %(real)s real;
static const double values[] = {%(values)s}, low[] = {%(low)s}, high[] = {%(high)s};
static uint64_t random_state = 88172645463325252u;

static uint64_t next_random(void) { /* xorshift64 by Marsaglia */
  random_state ^= random_state << 13;
  random_state ^= random_state >> 7;
  random_state ^= random_state << 17;
  return random_state;
}
static double uniform(double a, double b) { return a + (b - a) * (double)(next_random() >> 11) * 0x1p-53; }
static int one_of(int n) { return (int)(next_random() %% (uint64_t)n); }

static real wild(void) {
  double size = pow(10.0, uniform(-45.0, 45.0));
  switch (one_of(6)) {
  case 0: return (real)NAN;
  case 1: return (real)INFINITY;
  case 2: return (real)-INFINITY;
  case 3: return (real)0.0;
  case 4: return (real)(sizeof(real) == 8 ? size : fmin(size, 3e38));
  default: return (real)-(sizeof(real) == 8 ? size : fmin(size, 3e38));
  }
}
static real input(int k, double value) {
  static int broken, n_left;
  if (n_left > 0 && k == broken) { /* a sensor that is broken for some time */
    n_left--;
    return (real)NAN;
  }
  if (n_left == 0 && one_of(5000) == 0) {
    broken = k;
    n_left = one_of(400);
  }
  if (one_of(50) == 0) return wild();
  return (real)(value == 0.0 ? uniform(-0.05, 0.05) : value * uniform(0.5, 1.6));
}
static real parameter(int k) { /* in the range of the parameter, or anything */
  int kind = one_of(4);
  if (kind == 0) return wild();
  if (kind == 1 && low[k] > -1e14 && high[k] < 1e14) return (real)uniform(low[k], high[k]);
  if (kind == 2) return (real)low[k];
  return (real)(values[k] * pow(10.0, uniform(-3.0, 3.0)));
}
static real interval(void) {
  switch (one_of(400)) {
  case 0: return (real)-uniform(0.0, 10.0);
  case 1: return (real)uniform(0.0, 10.0);
  case 2: return wild();
  case 3: return (real)0.0;
  default: return (real)(%(cycle)s * uniform(0.5, 1.5));
  }
}

int main(int argc, char **argv) {
  static ctl_t r;
  long call, n = argc > 1 ? atol(argv[1]) : 1000, counts[6] = {0};
  ctl_init(&r);
  for (call = 0; call < n; call++) {
    unsigned status;
    int k;
    static real p[%(n_parameters)d];
    if (call %% 2000 == 0) ctl_init(&r);
    if (one_of(1000) == 0) ctl_reset(&r);
    if (call %% 40 == 0) for (k = 0; k < %(n_parameters)d; k++) p[k] = (real)values[k];
    if (one_of(60) == 0) { k = one_of(%(n_parameters)d); p[k] = parameter(k); }
%(read)s
    status = (unsigned)ctl_step_dt(&r, interval());
    for (k = 0; k < 5; k++) counts[k] += (status >> k) & 1u;
    {
      const double outputs[] = {%(outputs)s};
      const int is_valve[] = {%(is_valve)s};
      for (k = 0; k < %(n_outputs)d; k++) {
        if (!isfinite(outputs[k]) || (is_valve[k] && !(outputs[k] >= 0.0 && outputs[k] <= 1.0))) {
          printf("call %%ld: output %%d is %%g\\n", call, k, outputs[k]);
          return 1;
        }
        counts[5] += is_valve[k] && outputs[k] > 0.0;
      }
    }
  }
  for (int b = 0; b < 6; b++) printf("%%ld ", counts[b]);
  return 0;
}
"""


@cache
def compile_random_calls(name, precision, folder):
    """Compile the controller and its random calls with sanitizers; return the program."""
    if C_COMPILER is None:
        pytest.skip("no C compiler")
    circuit = load(EXAMPLES / f"{name}.toml")
    program = controller_program(circuit, CONTROLLERS[name])
    files = c_controller(circuit, CONTROLLERS[name], name="ctl", precision=precision)
    kind = SINGLE if precision == "single" else DOUBLE
    read = []
    for k, (member, item) in enumerate(zip(members(program, "in"), program.inputs, strict=True)):
        is_flag = item.address in program.flags
        value = f"one_of(20) ? {int(item.value > 0.5)} : one_of(2)" if is_flag else f"input({k}, {item.value!r})"
        read.append(f"    r.in.{member} = {value};")
    read += [f"    r.param.{member} = p[{k}];" for k, member in enumerate(members(program, "param"))]
    limits = [
        [min(max(limit, -1e15), 1e15) for limit in (parameter.low, parameter.high)] for parameter in program.parameters
    ]
    is_valve = [output.address.rpartition(".")[2] in VALVES for output in program.outputs]
    fields = {
        "real": kind.real, "cycle": repr(program.cycle), "n_parameters": len(program.parameters),
        "values": ", ".join(repr(parameter.value) for parameter in program.parameters),
        "low": ", ".join(repr(low) for low, _ in limits), "high": ", ".join(repr(high) for _, high in limits),
        "read": "\n".join(read), "n_outputs": len(program.outputs),
        "outputs": ", ".join(f"(double)r.out.{member}" for member in members(program, "out")),
        "is_valve": ", ".join(str(int(flag)) for flag in is_valve),
    }  # fmt: skip
    host = HOST % fields
    folder = folder / f"{name}_{precision}"
    folder.mkdir()
    for file, text in {**files, "random.c": host}.items():
        (folder / file).write_text(text)
    command = [C_COMPILER, *STRICT[:-2], "-g", "-O1", *SANITIZERS, "-o", "random", "random.c", "ctl.c", "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    return folder / "random"


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("random_calls")


def check_calls(name, precision, n, folder):
    """Make random calls: no sanitizer reports, outputs are finite, and commands of valves are within 0 to 1."""
    run = subprocess.run(
        [compile_random_calls(name, precision, folder), str(n)], capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stdout + run.stderr
    held, safe, saturated, late, parameter, valve = map(int, re.findall(r"\d+", run.stdout))
    # The calls reach every state.
    assert min(held, safe, late, parameter, n - held, n - parameter) > n // 1000
    return held, safe, saturated, late, parameter, valve


@pytest.mark.parametrize("precision", ["double", "single"])
@pytest.mark.parametrize("name", CONTROLLERS)
def test_random_calls(name, precision, folder):
    check_calls(name, precision, 20_000, folder)


@pytest.mark.slow
@pytest.mark.parametrize("precision", ["double", "single"])
@pytest.mark.parametrize("name", CONTROLLERS)
def test_a_million_random_calls(name, precision, folder):
    print(name, precision, check_calls(name, precision, 1_000_000, folder))
