"""Sampled step sequences, which command valves from conditions on outputs of the circuit."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector
from poppet.core.provenance import Number
from poppet.core.symbolic import clip, floor, maximum, where
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.conditions import KIND_OF_UNIT, Flag, Internal, Literal, Operand, Reading, never_true
from poppet.parts.electronics import MIN_SAMPLE_TIME
from poppet.parts.fields import NumberLike, number, reference
from poppet.parts.part import (
    Case,
    Controller,
    ControlOutputs,
    DiscreteState,
    Input,
    PartConnection,
    Quantities,
    Scope,
    Surroundings,
    Timer,
    advance_clock,
)
from poppet.parts.safe_state import FAULT_INPUT, FAULT_MEMORY, NEVER_VALID, fault_state
from poppet.parts.steps import Form, SequenceProgram, SequenceStep, read_names, stated_conditions

_ROUNDING = 1e-6
"""Tolerance of the time of a timeout, relative; it permits single precision."""


@dataclass(frozen=True, init=False)
class Sequence(Controller):
    """Sampled step sequence, such as the program of a PLC.

    Exactly one step is active. During a step, the outputs in its list `on` are 1, those in its table `set` have the
    stated values, and all others are 0. At each sample instant, the first of these rules that applies decides:

    1. `emergency` is 1: the sequence changes to the emergency step and remains in it.
    2. `halt` is 1: step, outputs and times are unchanged.
    3. `reset` is 1: the sequence starts again in its first step, with counters of zero.
    4. A condition in `next` is true: the sequence changes to this step. The first true condition decides.
    5. The time in the step has reached `timeout`: the sequence changes to the step `to`.

    There is at most one transition per sample. All sequences and switches read the values before the instant, also
    those of each other, and their outputs change at the instant.

    Notes
    -----
    Outputs are the names in `outputs`, the number `step` of the step in the order of declaration (1, 2, ...), the time
    `elapsed` in the step [s], and `cycles`, which counts the transitions to the first step.
    Inputs are `halt`, `reset`, `emergency` (if there is an emergency step), `input_fault`, the names in `inputs`, and
    one input for each output that a condition reads. The circuit connects the latter.

    Numbers in conditions, in timeouts and in `set` are parameters, so that a fit, an ensemble or a slider can change
    them. Their addresses are those of the fields, for example `plc.steps.extend A.next.extend B` and
    `plc.steps.extend A.timeout.after`. If a condition contains several numbers, the addresses end with `.1`, `.2` and
    so on. Integers after `==` and `!=` are constants, because they select a step.

    After `fault_time` with an input fault, the sequence changes to the emergency step. Without such a step, all outputs
    are 0, and the sequence continues with the first valid sample. In a steady state, the sequence holds its step.
    Comparisons of the time in a step have a relative tolerance of 1e-6.
    """

    kind: ClassVar[str] = "sequence"
    symbol: ClassVar[symbols.Symbol | str] = symbols.SEQUENCE
    summary: ClassVar[str] = "sampled step sequence with conditions, timeouts and counters"
    is_switching: ClassVar[bool] = True
    resume: ClassVar[dict[str, str]] = {
        "step": "initial_step", "elapsed": "initial_elapsed", "cycles": "initial_cycles"
    }  # fmt: skip

    outputs: Any = reference(doc="names of the outputs", form="list of str")
    steps: Any = reference(
        doc="steps; mapping from name to a table with `on`, `set`, `next`, `timeout`", form="mapping"
    )
    start_: Any = reference(doc="first step", form="str")
    inputs_: Any = reference(doc="names of the inputs, each 0 or 1", form="list of str")
    emergency: Any = reference(doc="emergency step; adds the input `emergency`", form="str")
    sample_time: NumberLike = number("s", "5 ms", doc="sample time", low=MIN_SAMPLE_TIME)
    fault_time: NumberLike = number("s", "0.1 s", doc="time from an invalid input to the safe state", low=0.0)
    initial_step: NumberLike = number(
        "1", optional=True, doc="number of the step at the start of a run; default that of `start`", low=1.0
    )
    initial_elapsed: NumberLike = number("s", 0.0, doc="time in the step at the start of a run", low=0.0)
    initial_cycles: NumberLike = number("1", 0.0, doc="completed cycles at the start of a run", low=0.0)

    def __init__(
        self,
        outputs: Any = None,
        steps: Any = None,
        start: Any = None,
        inputs: Any = None,
        emergency: Any = None,
        *,
        sample_time: NumberLike = None,
        fault_time: NumberLike = None,
        initial_step: NumberLike = None,
        initial_elapsed: NumberLike = None,
        initial_cycles: NumberLike = None,
        start_: Any = None,
        inputs_: Any = None,
    ) -> None:
        # The attributes end with an underscore, because `start` and `inputs` are methods of all parts.
        fields = {
            "outputs": outputs, "steps": steps, "start_": start if start_ is None else start_,
            "inputs_": inputs if inputs_ is None else inputs_, "emergency": emergency, "sample_time": sample_time,
            "fault_time": fault_time, "initial_step": initial_step, "initial_elapsed": initial_elapsed,
            "initial_cycles": initial_cycles,
        }  # fmt: skip
        for name, value in fields.items():
            object.__setattr__(self, name, value)
        self.__post_init__()

    def check(self) -> None:
        with ErrorCollector() as errors:
            inputs = read_names(errors, self.inputs_, "inputs")
            outputs = read_names(errors, self.outputs, "outputs", inputs)
            form = Form(outputs, inputs, self.start_ or "", self.emergency or "")
            with errors.collecting():
                steps = SequenceProgram.read(self.steps, form)
                number = self.initial_step
                if number is not None and not 1 <= float(number) <= len(steps.steps):  # type: ignore[arg-type]
                    errors.add("sequence.no_initial_step", "initial_step", value=float(number), most=len(steps.steps))  # type: ignore[arg-type]
        for name, result in {"inputs_": inputs, "outputs": outputs, "steps": steps}.items():
            object.__setattr__(self, name, result)

    @property
    def program(self) -> SequenceProgram:
        """Steps with their parsed conditions."""
        steps: SequenceProgram = self.steps
        return steps

    def notes(self) -> tuple[Note, ...]:
        dead_ends = [
            step.name for step in self.program.steps
            if not step.transitions and step.timeout is None and step.name != self.emergency
        ]  # fmt: skip
        never = [
            Note("sequence.never_true", f"steps.{step.name}.next.{transition.target}", input=name)
            for step in self.program.steps
            for transition in step.transitions
            for relation in transition.condition.relations()
            if (name := never_true(relation))
        ]
        return *(Note("sequence.no_exit", f"steps.{name}", name=name) for name in dead_ends), *never

    def commands(self) -> tuple[str, ...]:
        return tuple(self.outputs)

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        steps, program, time = series(f"{name}.step"), self.program, series("time")
        first_step = program.number(program.form.start) if self.initial_step is None else self.initial_step
        if (steps == float(first_step)).all():  # type: ignore[arg-type]
            active = program.steps[int(steps[0]) - 1]
            has_exit = active.transitions and active.timeout is None and active.name != self.emergency
            return (Note("sequence.waiting", "step", name=active.name),) if has_exit else ()
        elapsed, found = series(f"{name}.elapsed"), []
        emergency = series(f"{name}.emergency") if self.emergency else 0.0 * steps
        numbers = program.numbers()
        for k in (steps[1:] != steps[:-1]).nonzero()[0]:
            before, after = (program.steps[int(number) - 1] for number in (steps[k], steps[k + 1]))
            timeout = before.timeout
            if timeout is None or timeout.target != after.name or emergency[k + 1] > 0.5:
                continue
            duration = float(numbers[timeout.place].value)
            is_over = elapsed[k] + time[k + 1] - time[k] >= duration * (1.0 - _ROUNDING)
            if is_over and after.name not in [transition.target for transition in before.transitions]:
                found.append((float(time[k + 1]), before.name, after.name, duration))
        if not found:
            return ()
        first, step, target, duration = found[0]
        facts = {"time": first, "name": step, "target": target, "after": duration}
        return (Note("sequence.timed_out", "step", **facts, count=len(found) if len(found) > 1 else None),)

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        return [f"sequence of {len(self.program.steps)} steps", f"sampled every {numbers.text(self.sample_time)}"]

    def list_internal_outputs(self) -> tuple[str, ...]:
        return "elapsed", "halt", "reset", "emergency", "input_fault", *self.program.readings()

    def numbers(self) -> dict[str, Number]:
        return super().numbers() | {f"steps.{name}": value for name, value in self.program.numbers().items()}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        values.setdefault("initial_step", float(self.program.number(self.program.form.start)))
        for name, value in self.program.numbers().items():
            values[f"steps.{name}"] = value.absolute(ambient.pressure)
        return values

    def structure(self) -> Hashable:
        return super().structure(), self.program.structure()

    def integer_outputs(self) -> tuple[str, ...]:
        return (*super().integer_outputs(), "step", "cycles")

    def lost_at_resume(self) -> tuple[str, ...]:
        return tuple(f'count("{name}")' for name in self.program.counted())

    def connections(self) -> dict[str, PartConnection]:
        integers = self.program.compared_as_integers()
        return {
            name: PartConnection(reading.address, f"steps.{place}", reading.address in integers)
            for name, (reading, place) in self.program.readings().items()
        }

    @classmethod
    def stated_connections(cls, table: Mapping[str, Any]) -> dict[str, tuple[PartConnection, str]]:
        readings = (
            (PartConnection(operand.address, place), operand.unit)
            for place, condition in stated_conditions(table)
            for operand in condition.operands()
            if isinstance(operand, Reading)
        )
        return {f"reading_{k}": reading for k, reading in enumerate(readings)}

    def inputs(self) -> tuple[Input, ...]:
        def flag(name: str, **properties: Any) -> Input:
            return Input(name, "1", 0.0, low=0.0, high=1.0, is_flag=True, **properties)

        emergency = (flag("emergency", at_rest=0.0),) if self.program.form.emergency else ()
        readings = (
            Input(name, reading.unit, 0.0, kind=KIND_OF_UNIT.get(reading.unit, "plain"))
            for name, (reading, _) in self.program.readings().items()
        )
        declared = (flag(name, is_command=True) for name in self.program.form.inputs)
        return (
            flag("halt", at_rest=1.0), flag("reset"), *emergency, *declared, *readings,
            replace(FAULT_INPUT, at_rest=0.0),
        )  # fmt: skip

    def memory(self) -> tuple[DiscreteState, ...]:
        counters = (f"count_{self.program.number(name)}" for name in self.program.counted())
        names = (*self.program.form.outputs, "step", "elapsed_samples", "is_held", "cycles", *counters, "sample_count")
        fault = (state for state in FAULT_MEMORY if state.name != "is_saturated")
        return *(DiscreteState(name, "1") for name in names), *fault

    def timers(self) -> tuple[Timer, ...]:
        return (Timer("sample", rank=-1, is_simultaneous=True),)

    def flags(self) -> tuple[str, ...]:
        steps = self.program.steps
        has_values = {name for step in steps for name, value in step.values.items() if isinstance(value, str)}
        return tuple(name for name in self.program.form.outputs if name not in has_values)

    def output_ranges(self) -> dict[str, tuple[str | float, str | float]]:
        steps = self.program.steps
        ranges: dict[str, tuple[str | float, str | float]] = {
            name: (-1.0 if any(isinstance(step.values.get(name), str) for step in steps) else 0.0, 1.0)
            for name in self.program.form.outputs
        }
        flags: dict[str, tuple[str | float, str | float]] = {f"step:{step.name}": (0.0, 1.0) for step in steps}
        return ranges | flags | {"step": (1.0, float(len(steps))), "elapsed": (0.0, float("inf"))}

    def start(self, scope: Scope) -> dict[str, Any]:
        steps = self.program
        # A parameter can change at run time: the number of a step is always one of those that exist.
        step = clip(floor(scope["initial_step"] + 0.5), 1.0, float(len(steps.steps)))
        counts = {f"count_{steps.number(name)}": where(step == steps.number(name), 1.0, 0.0)
                  for name in steps.counted()}  # fmt: skip
        return {
            **self._output_values(scope, step), **counts, "step": step,
            # The first sample is at t = 0 and adds one.
            "elapsed_samples": scope["initial_elapsed"] / scope["sample_time"] - 1.0,
            "cycles": scope["initial_cycles"], "sample": 0.0, "sample_count": 0.0, "faulty_samples": NEVER_VALID,
            "is_safe": 0.0, "is_held": 0.0,
        }  # fmt: skip

    def control(self, scope: Scope) -> ControlOutputs:
        memory = scope.memory
        outputs: Quantities = {name: (memory[name], "1") for name in self.program.form.outputs}
        # Between instants the time continues, unless the sequence is halted.
        period = scope["sample_time"]
        since_sample = clip(period - (memory["sample"] - scope.time), 0.0, period)
        since_sample = where(memory["is_held"] > 0.5, 0.0, since_sample)
        elapsed = maximum(memory["elapsed_samples"] * period + since_sample, 0.0)
        outputs |= {"step": (memory["step"], "1"), "elapsed": (elapsed, "s"), "cycles": (memory["cycles"], "1")}
        # For conditions of other sequences: 1 during the step.
        hidden: Quantities = {
            f"step:{step.name}": (where(memory["step"] == k, 1.0, 0.0), "1")
            for k, step in enumerate(self.program.steps, 1)
        }
        return ControlOutputs(outputs, hidden=hidden)

    def update(self, timer: str, scope: Scope) -> dict[str, Any]:
        memory, steps, form = scope.memory, self.program, self.program.form
        is_safe, fault = fault_state(scope, scope["sample_time"])
        step, samples = memory["step"], memory["elapsed_samples"] + 1.0
        elapsed = samples * scope["sample_time"]
        scope.label("time_in_step", elapsed, "time in the step [s]")
        target = self._target(scope, step, elapsed)
        first = float(steps.number(form.start))
        halts, resets = scope.inputs["halt"] > 0.5, scope.inputs["reset"] > 0.5
        # Number of the entered step; 0 without a transition.
        entered = where(halts, 0.0, where(resets, first, target))
        is_held, restarts = where(halts, 1.0, 0.0), where(halts, 0.0, where(resets, 1.0, 0.0))
        if form.emergency:
            last = float(steps.number(form.emergency))
            is_urgent = where(scope.inputs["emergency"] > 0.5, 1.0, is_safe) > 0.5
            entered = where(is_urgent, where(step == last, 0.0, last), entered)
            is_held, restarts = where(is_urgent, 0.0, is_held), where(is_urgent, 0.0, restarts)
        else:
            entered, restarts = where(is_safe > 0.5, 0.0, entered), where(is_safe > 0.5, 0.0, restarts)
            is_held = where(is_safe > 0.5, 1.0, is_held)
        scope.label("entered_step", entered, "number of the step that begins, 0 if the step continues")
        is_entered = entered > 0.5
        new_step = where(is_entered, entered, step)
        scope.label("new_step", new_step, "number of the step after this sample")
        values = self._output_values(scope, new_step)
        if not form.emergency:
            # A halt also holds outputs that a safe state before it has set to 0.
            held = {name: where(halts, memory[name], value) for name, value in values.items()}
            values = {name: where(is_safe > 0.5, 0.0, value) for name, value in held.items()}
        result = {"step": new_step, "is_held": is_held, **values, **fault}
        continued = where(is_held > 0.5, memory["elapsed_samples"], samples)
        result["elapsed_samples"] = where(is_entered, 0.0, continued)
        scope.label("is_restarted", restarts > 0.5, "true if the counters start again")
        begins = where(entered == first, 1.0, 0.0)
        result["cycles"] = where(restarts > 0.5, 0.0, memory["cycles"] + begins)
        for name in steps.counted():
            k = float(steps.number(name))
            count = memory[f"count_{k:.0f}"] + where(entered == k, 1.0, 0.0)
            result[f"count_{k:.0f}"] = where(restarts > 0.5, float(name == form.start), count)
        return result | advance_clock(scope, timer, scope["sample_time"])

    def _target(self, scope: Scope, step: Any, elapsed: Any) -> Any:
        """Return the number of the step to which a transition leads, or 0.

        `step` is the number of the present step, and `elapsed` the time in it [s].
        """
        names = {reading.address: name for name, (reading, _) in self.program.readings().items()}

        def value(operand: Operand) -> Any:
            match operand:
                case Literal():
                    return scope[f"steps.{operand.place}"] if operand.place else float(operand.number.value)
                case Reading():
                    return scope.inputs[names[operand.address]]
                case Flag():
                    return scope.inputs[operand.name]
                case Internal(name="elapsed"):
                    return elapsed
                case Internal(name="cycles"):
                    return scope.memory["cycles"]
            return scope.memory[f"count_{self.program.number(operand.step)}"]

        def target_of(item: SequenceStep) -> Any:
            target: Any = 0.0
            if item.timeout is not None:
                after = scope[f"steps.{item.timeout.place}"]
                target = where(
                    elapsed >= after * (1.0 - _ROUNDING), float(self.program.number(item.timeout.target)), target
                )
            for transition in reversed(item.transitions):
                is_true = transition.condition.evaluate(value) > 0.5
                target = where(is_true, float(self.program.number(transition.target)), target)
            return target

        steps = self.program.steps
        cases = [Case(item.name, {"next_step": target_of(item)}) for item in steps]
        titles = {number: item.name for number, item in enumerate(steps, 1)}
        return scope.select(step, cases, titles=titles)["next_step"]

    def _output_values(self, scope: Scope, step: Any) -> dict[str, Any]:
        """Return the values of all outputs during the step with a given number."""

        def value(item: SequenceStep, name: str) -> Any:
            stated = item.values.get(name, 0.0)
            return scope[f"steps.{stated}"] if isinstance(stated, str) else stated

        outputs = self.program.form.outputs
        cases = [
            Case(item.name, {f"new_{name}": value(item, name) for name in outputs}) for item in self.program.steps
        ]  # fmt: skip
        values = scope.select(step, cases, flags=[f"new_{name}" for name in self.flags()])
        return {name: values[f"new_{name}"] for name in outputs}
