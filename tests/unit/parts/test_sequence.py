"""Step sequences: semantics, compared with an interpreter that is written here, and checks of the fields."""

import pickle
from pathlib import Path

import numpy as np
import pytest

import poppet
from poppet import Chamber, Circuit, InputError, Orifice, Reservoir, Sequence
from poppet.deploy.controller import controller_program
from poppet.ensemble.ensemble_result import circuit_text
from poppet.signals import Steps

T = 0.005


def plant(**parts):
    vent = Orifice(from_="supply", to="ambient", sonic_conductance=1e-9, critical_ratio=0.3)
    return {**parts, "supply": Reservoir(pressure="5 bar"), "vent": vent}


def run(parts, signals=None, duration=0.2, connections=None, step=T):
    circuit = Circuit(plant(**parts), signals or {}, connections=connections or {})
    return rows(circuit, duration, step)


def rows(circuit, duration, step=T):
    """Return the rows at the sample instants; a run ends before the instant at its end."""
    return circuit.simulate(duration + 0.5 * T, output_step=step).between(-1.0, duration + 0.4 * T)


def steps_of(recording, name="plc"):
    return recording[f"{name}.step"].astype(int).tolist()


def pulse(*times):
    """Input that changes between 0 and 1 at these times."""
    return Steps([0.0, *times], [float(k % 2) for k in range(len(times) + 1)])


ON = Steps([0.0], [1.0])


def two_steps(**fields):
    steps = {"one": {"on": ["a"], "next": {"two": "go"}}, "two": {"on": ["b"], "next": {"one": "not go"}}}
    return Sequence(**{"outputs": ["a", "b"], "steps": steps, "start": "one", "inputs": ["go"], **fields})


# --- Semantics ---


def test_outputs_change_at_the_instant_of_the_transition():
    recording = run({"plc": two_steps()}, {"plc.go": pulse(0.0119, 0.0521)}, 0.08, step=1e-3)
    time, step = recording.time, recording["plc.step"]
    expected = np.where((time > 0.0149) & (time < 0.0549), 2.0, 1.0)
    assert step.tolist() == expected.tolist()
    assert recording["plc.a"].tolist() == (2.0 - step).tolist()
    assert recording["plc.b"].tolist() == (step - 1.0).tolist()


def test_at_most_one_transition_per_sample():
    steps = {str(k): {"next": {str(k % 4 + 1): "ready"}} for k in range(1, 5)}
    recording = run({"plc": Sequence(steps=steps, start="1", inputs=["ready"])}, {"plc.ready": ON}, 0.05)
    # The first sample is at t = 0.
    assert steps_of(recording)[:7] == [2, 3, 4, 1, 2, 3, 4]
    assert recording["plc.cycles"][:8].tolist() == [0, 0, 0, 1, 1, 1, 1, 2]


def test_first_true_condition_decides_and_timeout_is_last():
    steps = {
        "one": {"next": {"three": "go", "two": "elapsed >= 20 ms"}, "timeout": {"after": "10 ms", "to": "four"}},
        **{name: {"next": {"one": "go and not go"}} for name in ("two", "three", "four")},
    }
    plc = Sequence(steps=steps, start="one", inputs=["go"])
    assert steps_of(run({"plc": plc}, {"plc.go": ON}, 0.02)) == [3] * 5
    assert steps_of(run({"plc": plc}, duration=0.02)) == [1, 1, 4, 4, 4]


def test_elapsed_counts_from_the_entry():
    steps = {"one": {"next": {"two": "elapsed > 15 ms"}}, "two": {"next": {"one": "elapsed >= 15 ms"}}}
    recording = run({"plc": Sequence(steps=steps, start="one")}, duration=0.06)
    assert steps_of(recording) == [1, 1, 1, 1, 2, 2, 2, 1, 1, 1, 1, 2, 2]
    assert recording["plc.elapsed"] == pytest.approx(T * np.array([0, 1, 2, 3, 0, 1, 2, 0, 1, 2, 3, 0, 1]))


def test_sequences_read_the_values_before_the_instant():
    # Both exchange their flags: each sees the step of the other before the instant.
    def exchanging(other):
        return {
            "low": {"next": {"high": f'{other}.step == "high"'}},
            "high": {"next": {"low": f'{other}.step == "low"'}},
        }

    parts = {
        "first": Sequence(steps=exchanging("second"), start="low"),
        "second": Sequence(steps=exchanging("first"), start="high"),
    }
    for order in (parts, dict(reversed(parts.items()))):
        recording = run(order, duration=0.03)
        assert steps_of(recording, "first") == [2, 1, 2, 1, 2, 1, 2]
        assert steps_of(recording, "second") == [1, 2, 1, 2, 1, 2, 1]


def test_halt_freezes_and_reset_starts_again():
    steps = {
        "one": {"next": {"two": "elapsed >= 10 ms"}},
        "two": {"next": {"one": 'elapsed >= 10 ms and count("one") < 3'}},
    }
    plc = Sequence(steps=steps, start="one")
    recording = run({"plc": plc}, {"plc.halt": pulse(0.013, 0.027)}, 0.04)
    assert steps_of(recording) == [1, 1, 2, 2, 2, 2, 2, 1, 1]
    assert recording["plc.elapsed"] == pytest.approx(T * np.array([0, 1, 0, 0, 0, 0, 1, 0, 1]))
    # `one` is entered at most three times; a reset sets the counters to zero. A halt has priority.
    recording = run({"plc": plc}, {"plc.reset": pulse(0.071, 0.076), "plc.halt": pulse(0.099)}, 0.12)
    assert steps_of(recording) == [1, 1, 2, 2, 1, 1, 2, 2, 1, 1, 2, 2, 2, 2, 2, 1, 1, 2, 2, 1, 1, 1, 1, 1, 1]
    assert recording["plc.cycles"][[14, 15, 19]].tolist() == [2, 0, 1]
    both = {"plc.reset": pulse(0.071), "plc.halt": pulse(0.071)}
    assert steps_of(run({"plc": plc}, both, 0.1))[15:] == [2] * 6


def test_emergency_has_priority_and_holds_its_step():
    steps = {"one": {"on": ["a"], "next": {"two": "ready"}}, "two": {"on": ["a"], "next": {"one": "ready"}}}
    steps["safe"] = {"next": {"one": "elapsed >= 10 ms"}}
    plc = Sequence(outputs=["a"], steps=steps, start="one", inputs=["ready"], emergency="safe")
    signals = {"plc.ready": ON, "plc.emergency": pulse(0.012, 0.032), "plc.halt": pulse(0.012, 0.022)}
    recording = run({"plc": plc}, signals, 0.05)
    assert steps_of(recording) == [2, 1, 2, 3, 3, 3, 3, 1, 2, 1, 2]
    assert recording["plc.elapsed"][3:8] == pytest.approx(T * np.array([0, 1, 2, 3, 0]))
    assert recording["plc.a"].tolist() == [1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1]


def test_input_fault_sets_the_outputs_to_zero_after_its_time():
    signals = {"plc.go": pulse(0.006), "plc.input_fault": pulse(0.011, 0.041)}
    recording = run({"plc": two_steps(fault_time="10 ms")}, signals, 0.06)
    # The fault begins at the sample 0.015 s; until 0.025 s the sequence continues.
    assert steps_of(recording)[2:] == [2] * 11
    assert recording["plc.b"].tolist() == [0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1]
    assert recording["plc.elapsed"][4:10] == pytest.approx(T * np.array([2, 2, 2, 2, 2, 3]))
    steps = {**two_steps().program.table, "safe": {"on": ["a"], "next": {"two": "elapsed > 1 s"}}}
    recording = run({"plc": two_steps(steps=steps, emergency="safe", fault_time="10 ms")}, signals, 0.06)
    assert steps_of(recording) == [1, 1, 2, 2, 2, *[3] * 8]


def test_a_halt_holds_the_outputs_of_the_safe_state():
    # The fault ends at 0.042 s during a halt, which ends at 0.061 s.
    plc = two_steps(fault_time="10 ms")
    signals = {"plc.input_fault": pulse(0.012, 0.042), "plc.halt": pulse(0.032, 0.061)}
    recording = run({"plc": plc}, signals, 0.08)
    assert recording["plc.a"].tolist() == [1, 1, 1, 1, 1, *[0] * 8, 1, 1, 1, 1]
    assert steps_of(recording) == [1] * 17


def test_values_of_outputs():
    steps = {"one": {"set": {"v": -1, "w": 0.5}, "next": {"two": "elapsed >= 10 ms"}}, "two": {"on": ["v"]}}
    circuit = Circuit(plant(plc=Sequence(outputs=["v", "w"], steps=steps, start="one")))
    recording = rows(circuit, 0.02)
    assert recording["plc.v"].tolist() == [-1, -1, 1, 1, 1]
    assert recording["plc.w"].tolist() == [0.5, 0.5, 0, 0, 0]
    changed = rows(circuit.with_values({"plc.steps.one.set.w": 0.25}), 0.02)
    assert changed["plc.w"].tolist() == [0.25, 0.25, 0, 0, 0]
    assert changed["plc.v"].tolist() == recording["plc.v"].tolist()


def test_inputs_can_have_the_names_of_fields_and_steps():
    steps = {
        "idle": {"next": {"work": "start and not stop"}},
        "work": {"on": ["a"], "next": {"stop": "stop"}},
        "stop": {"next": {"idle": "not stop"}},
    }
    plc = Sequence(outputs=["a"], inputs=["start", "stop"], steps=steps, start="idle")
    circuit = Circuit(plant(plc=plc), {"plc.start": pulse(0.011), "plc.stop": pulse(0.021)})
    recording = rows(circuit, 0.03)
    assert steps_of(recording) == [1, 1, 1, 2, 2, 3, 3]
    assert recording["plc.start"].tolist() == [0, 0, 0, 1, 1, 1, 1]
    assert steps_of(rows(circuit.with_values({"plc.start": "work"}), 0.03)) == [2, 2, 2, 2, 2, 3, 3]


# --- Random sequences against an interpreter of their own ---


class Interpreter:
    """Sequence as the documentation describes it; conditions are functions of a dictionary of values."""

    def __init__(self, steps, start, emergency):
        self.steps, self.order, self.first, self.emergency = steps, list(steps), start, emergency
        self.restart()
        self.samples = -1

    def restart(self):
        self.step, self.samples, self.cycles = self.first, 0, 0
        self.counts = {name: int(name == self.first) for name in self.order}

    def enter(self, name):
        self.step, self.samples = name, 0
        self.counts[name] += 1
        self.cycles += name == self.first

    def sample(self, values):
        if values["emergency"]:
            if self.step != self.emergency:
                self.enter(self.emergency)
            else:
                self.samples += 1
            return
        if values["halt"]:
            return
        if values["reset"]:
            self.restart()
            return
        self.samples += 1
        known = {**values, "elapsed": self.samples * T, "cycles": self.cycles, "counts": dict(self.counts)}
        conditions, timeout = self.steps[self.step]
        for target, condition in conditions:
            if condition(known):
                self.enter(target)
                return
        if timeout is not None and self.samples >= timeout[0]:
            self.enter(timeout[1])


def random_condition(rng, names, depth=0):
    """Return a condition as text and as a function."""
    kind = rng.integers(9 if depth < 3 else 6)
    if kind == 0:
        limit = float(rng.integers(20, 80)) / 10.0
        return f"supply.pressure > {limit} bar", lambda v: v["pressure"] > limit * 1e5
    if kind == 1:
        limit = float(rng.integers(20, 80)) / 10.0
        return f"{limit} bar >= supply.pressure", lambda v: v["pressure"] <= limit * 1e5
    if kind == 2:
        name = str(rng.choice(["p", "q"]))
        return name, lambda v: v[name] > 0.5
    if kind == 3:
        n = int(rng.integers(1, 8))
        relation, test = [(">=", lambda a: a >= n), (">", lambda a: a > n)][rng.integers(2)]
        return f"elapsed {relation} {5 * n} ms", lambda v: test(round(v["elapsed"] / T))
    if kind == 4:
        name, n = str(rng.choice(names)), int(rng.integers(1, 5))
        return f'count("{name}") >= {n}', lambda v: v["counts"][name] >= n
    if kind == 5:
        n = int(rng.integers(3))
        return f"cycles != {n}", lambda v: v["cycles"] != n
    first, f = random_condition(rng, names, depth + 1)
    if kind == 6:
        return f"not ({first})", lambda v: not f(v)
    second, g = random_condition(rng, names, depth + 1)
    if kind == 7:
        return f"({first}) and ({second})", lambda v: f(v) and g(v)
    return f"({first}) or ({second})", lambda v: f(v) or g(v)


def random_signal(rng, duration, low, high, *, is_flag):
    times = np.sort(rng.uniform(0.001, duration, 12))
    values = rng.integers(2, size=13).astype(float) if is_flag else rng.uniform(low, high, 13)
    return Steps([0.0, *times], values)


@pytest.mark.parametrize("seed", range(20))
def test_random_sequences(seed):
    rng = np.random.default_rng(seed)
    duration, n = 1.0, int(rng.integers(3, 8))
    names = [f"step {k}" for k in range(n)]
    tables, functions = {}, {}
    for k, name in enumerate(names):
        # A chain reaches all steps.
        targets = list(dict.fromkeys([names[(k + 1) % n], *rng.choice(names, rng.integers(3))]))
        rng.shuffle(targets)
        conditions = {str(target): random_condition(rng, names) for target in targets}
        timeout = (int(rng.integers(2, 20)), str(rng.choice(names)))
        tables[name] = {
            "on": [output for output in "xyz" if rng.integers(2)],
            "next": {target: text for target, (text, _) in conditions.items()},
            "timeout": {"after": f"{5 * timeout[0]} ms", "to": timeout[1]},
        }
        functions[name] = [(target, function) for target, (_, function) in conditions.items()], timeout
    emergency = str(rng.choice(names))
    plc = Sequence(outputs=list("xyz"), steps=tables, start=names[0], inputs=["p", "q"], emergency=emergency)
    signals = {name: random_signal(rng, duration, 0.0, 1.0, is_flag=True) for name in ("p", "q")}
    rare = {name: pulse(*np.sort(rng.uniform(0.0, duration, 2))) for name in ("halt", "reset", "emergency")}
    rare["reset"] = pulse(0.4, 0.407)
    rare["emergency"] = pulse(0.7, 0.75)
    signals = {f"plc.{name}": signal for name, signal in (signals | rare).items()}
    signals["supply.pressure"] = random_signal(rng, duration, 2e5, 8e5, is_flag=False)
    recording = rows(Circuit(plant(plc=plc), signals), duration)
    tables_of = {address: signal.table(2.0) for address, signal in signals.items()}
    interpreter = Interpreter(functions, names[0], emergency)
    for k, time in enumerate(recording.time):
        values = {address.partition(".")[2]: table.evaluate(k * T) for address, table in tables_of.items()}
        interpreter.sample(values)
        row = {name: recording[f"plc.{name}"][k] for name in ("step", "cycles", "elapsed", *"xyz")}
        on = tables[interpreter.step]["on"]
        assert row == {
            "step": names.index(interpreter.step) + 1, "cycles": interpreter.cycles,
            "elapsed": pytest.approx(max(interpreter.samples, 0) * T), **{x: float(x in on) for x in "xyz"},
        }, f"t = {time}"  # fmt: skip
    assert len({*recording["plc.step"]}) > 2


# --- Connections of the circuit ---


def test_circuit_connects_the_outputs_that_conditions_read():
    steps = {"one": {"next": {"two": "supply.pressure > 6 bar"}}, "two": {"next": {"one": "supply.pressure < 4 bar"}}}
    circuit = Circuit(plant(plc=Sequence(steps=steps, start="one")))
    assert circuit.connections == {"plc.supply_pressure": "supply.pressure"}
    # Another condition of a copy replaces the connection.
    steps = {"one": {"next": {"two": "vent.mass_flow_rate > 1 g/s"}}, "two": {}}
    changed = circuit.with_values({"plc.steps": steps})
    assert changed.connections == {"plc.vent_mass_flow_rate": "vent.mass_flow_rate"}
    assert pickle.loads(pickle.dumps(changed)).connections == changed.connections
    with pytest.raises(InputError) as caught:
        Circuit(circuit.parts, connections={"plc.supply_pressure": "vent.mass_flow_rate"})
    assert caught.value.code == "wiring.connected_twice"
    with pytest.raises(InputError) as caught:
        Circuit(circuit.parts, {"plc.supply_pressure": Steps([0.0], [1e5])})
    assert caught.value.code == "wiring.driven_twice"


def test_thresholds_are_parameters():
    steps = {"one": {"next": {"two": "supply.pressure > 5 bar g and elapsed > 10 ms"}}, "two": {}}
    circuit = Circuit(plant(plc=Sequence(steps=steps, start="one")))
    assert {a: n.display() for a, n in circuit.numbers().items() if a.startswith("plc.steps")} == {
        "plc.steps.one.next.two.1": "5 bar g", "plc.steps.one.next.two.2": "10 ms",
    }  # fmt: skip
    assert circuit.parameters["plc.steps.one.next.two.1"] == pytest.approx(6e5)
    changed = circuit.with_values({"plc.steps.one.next.two.1": "3 bar", "plc.steps.one.next.two.2": 0.02})
    assert changed.structure == circuit.structure
    assert steps_of(rows(circuit, 0.04)) == [1] * 9
    assert steps_of(rows(changed, 0.04)) == [1] * 5 + [2] * 4
    text = changed.parts["plc"].program.table["one"]["next"]["two"]
    assert text == "supply.pressure > 3 bar and elapsed > 0.02 s"
    assert Circuit(plant(plc=Sequence(steps={**steps, "one": {"next": {"two": text}}}, start="one"))).parameters == (
        changed.parameters
    )
    gauge = circuit.with_values({"plc.steps.one.next.two.1": "5.5 bar g"})
    assert gauge.parameters["plc.steps.one.next.two.1"] == pytest.approx(6.5e5)
    with pytest.raises(InputError) as caught:
        circuit.with_values({"plc.steps.one.next.two.1": "3 mm"})
    assert caught.value.address == "plc.steps.one.next.two.1"


@pytest.mark.parametrize(
    ("address", "value"), [("plc.steps.one.set.a", -1.1), ("plc.steps.one.timeout.after", "-1 s"), ("plc.steps.x", 1)]
)
def test_invalid_changes_of_numbers(address, value):
    steps = {"one": {"set": {"a": 0.5}, "timeout": {"after": "1 s", "to": "one"}}}
    circuit = Circuit(plant(plc=Sequence(outputs=["a"], steps=steps, start="one")))
    with pytest.raises(InputError) as caught:
        circuit.with_values({address: value})
    assert caught.value.address == address


def test_sequence_holds_its_step_in_a_steady_state():
    steps = {"one": {"on": ["a"], "next": {"two": "elapsed > 1 s"}}, "two": {"next": {"one": "tank.pressure > 2 bar"}}}
    parts = plant(
        plc=Sequence(outputs=["a"], steps=steps, start="one"),
        tank=Chamber(volume="1 l", wall_conductance=1.0),
        fill=Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3),
    )
    circuit = Circuit(parts, connections={"fill.opening": "plc.a"})
    steady = circuit.steady_state()
    assert (steady.y["plc.step"], steady.y["plc.a"], steady.y["plc.elapsed"]) == (1.0, 1.0, 0.0)
    assert steady.y["tank.pressure"] == pytest.approx(5e5)
    model = circuit.linearise()
    assert model.states == ("tank.pressure", "tank.mass")
    assert np.all(np.abs(model.eigenvalues()) < 1.0)
    steady = circuit.with_values({"plc.initial_step": 2, "tank.initial_pressure": "3 bar"}).steady_state()
    assert (steady.y["plc.step"], steady.y["plc.a"]) == (2.0, 0.0)
    assert steady.y["tank.pressure"] == pytest.approx(3e5)


# --- Exported program ---


def test_exported_program_runs_the_same_steps():
    rng = np.random.default_rng(1)
    steps = {
        "one": {
            "on": ["a"],
            "next": {"two": "supply.pressure > 5 bar and go"},
            "timeout": {"after": "40 ms", "to": "two"},
        },
        "two": {"on": ["b"], "next": {"one": "supply.pressure < 4 bar", "three": "elapsed > 30 ms"}},
        "three": {"set": {"a": -0.5}, "next": {"one": 'not go or count("two") == 3'}},
    }
    plc = Sequence(outputs=["a", "b"], steps=steps, start="one", inputs=["go"])
    signals = {"plc.go": random_signal(rng, 0.6, 0, 1, is_flag=True)}
    signals["supply.pressure"] = random_signal(rng, 0.6, 3e5, 7e5, is_flag=False)
    circuit = Circuit(plant(plc=plc), signals)
    recording = rows(circuit, 0.6)
    program = controller_program(circuit, ["plc"])
    assert program.cycle == pytest.approx(T)
    names = [item.address for item in program.inputs]
    assert "plc.supply_pressure" in names
    columns = {item.address: np.zeros(recording.time.size) for item in program.inputs}
    columns["plc.supply_pressure"] = recording["supply.pressure"]
    columns["plc.go"] = recording["plc.go"]
    results = program.run(np.array([columns[name] for name in names]).T)
    for k, output in enumerate(program.outputs):
        assert results.outputs[:, k] == pytest.approx(recording[output.address], abs=1e-12), output.address
    assert len({*steps_of(recording)}) == 3


def test_dropped_samples_count_for_the_time_in_a_step():
    program = controller_program(Circuit(plant(plc=two_steps(steps={"one": {}}))), ["plc"])
    elapsed = [output.address for output in program.outputs].index("plc.elapsed")
    # The fourth call is 20 ms late: four samples are dropped.
    results = program.run(np.zeros((6, len(program.inputs))), intervals=[0.0, T, T, T + 0.02, T, T])
    assert results.outputs[:, elapsed] == pytest.approx([0.0, T, 2 * T, 3 * T + 0.02, 4 * T + 0.02, 5 * T + 0.02])


def test_circuit_file_with_changed_numbers():
    text = """
    [parts.tank]
    kind = "chamber"
    volume = "1 l"
    [parts.supply]
    kind = "reservoir"
    pressure = "5 bar"
    [parts.hole]
    kind = "orifice"
    from = "supply"
    to = "tank"
    sonic_conductance = 1e-9
    critical_ratio = 0.3
    [parts.plc]
    kind = "sequence"
    outputs = ["a"]
    start = "A+"
    steps."A+".set = { a = 0.5 }
    steps."A+".next = { "A-" = "tank.pressure > supply.pressure - 0.5 bar or supply.pressure < 1 bar g" }
    steps."A-".timeout = { after = "1 s", to = "A+" }
    [run]
    duration = "1 s"
    """
    changes = {"A+.set.a": 0.25, "A+.next.A-.1": 1e4, "A+.next.A-.2": "3 bar g", "A-.timeout.after": 2.0}
    circuit = poppet.loads(text).with_values({f"plc.steps.{name}": value for name, value in changes.items()})
    again = poppet.loads(circuit_text(circuit, Path()))
    assert again.parameters == circuit.parameters != poppet.loads(text).parameters
    assert again.structure == circuit.structure
    condition = again.parts["plc"].program.steps[0].transitions[0].condition.text
    assert condition == "tank.pressure > supply.pressure +10000.0 Pa or supply.pressure < 3 bar g"


def test_resumed_run_continues_the_step():
    steps = {str(k): {"next": {str(k % 3 + 1): "elapsed >= 30 ms"}} for k in range(1, 4)}
    circuit = Circuit(plant(plc=Sequence(steps=steps, start="1")))
    whole, first = circuit.simulate(0.4, output_step=T), circuit.simulate(0.2, output_step=T)
    second = circuit.resumed(first).simulate(0.2, output_step=T)
    # A run ends before the instant at its end.
    assert steps_of(first)[:-1] + steps_of(second) == steps_of(whole)
    for name in ("cycles", "elapsed"):
        assert second[f"plc.{name}"] == pytest.approx(whole[f"plc.{name}"][-second.time.size :])


def test_a_run_with_counters_cannot_be_resumed():
    steps = {"one": {"next": {"two": 'count("one") < 3'}}, "two": {"next": {"one": "elapsed > 10 ms"}}}
    circuit = Circuit(plant(plc=Sequence(steps=steps, start="one")))
    with pytest.raises(InputError) as caught:
        circuit.resumed(circuit.simulate(0.1, output_step=T))
    assert (caught.value.code, caught.value.address) == ("sequence.no_resume", "plc")
    assert 'count("one")' in str(caught.value)


def test_a_signal_cannot_replace_a_connection_that_a_part_declares():
    steps = {"one": {"next": {"one": "supply.pressure > 1 bar"}}}
    circuit = Circuit(plant(plc=Sequence(steps=steps, start="one")))
    with pytest.raises(InputError) as caught:
        circuit.with_signals({"plc.supply_pressure": ON})
    assert caught.value.code == "wiring.driven_twice"


# --- Invalid input ---

INVALID = """
[parts.supply]
kind = "reservoir"
pressure = "5 bar"

[parts.vent]
kind = "orifice"
from = "supply"
to = "ambient"
sonic_conductance = 1e-9
critical_ratio = 0.3

[parts.low]
kind = "switch"
measurement = "supply.pressure"
on_above = "3 bar"
off_below = "4 bar"

[parts.plc]
kind = "sequence"
outputs = ["a", "b", "a", "step"]
inputs = ["go", "b"]
start = "one"

[parts.plc.steps.one]
on = ["a", "c"]
next = { "tow" = "supply.pressure > 6 bar" }

[parts.plc.steps.two]
next = { "one" = "supply.presure > 6 bar", "three" = "gone" }
timeout = { after = "3 mm", to = "for" }

[parts.plc.steps.three]
[parts.plc.steps.island]
next = { "one" = "go" }
"""


def test_all_errors_are_reported_together():
    with pytest.raises(InputError) as caught:
        poppet.loads(INVALID)
    found = [(problem.code, problem.address) for problem in caught.value.problems]
    assert set(found) == {
        ("sequence.name_twice", "parts.plc.outputs"),
        ("sequence.reserved", "parts.plc.outputs"),
        ("sequence.unknown_output", "parts.plc.steps.one.on"),
        ("sequence.unknown_step", "parts.plc.steps.one.next.tow"),
        ("condition.unknown_name", "parts.plc.steps.two.next.three"),
        ("wiring.unknown_output", "parts.plc.steps.two.next.one"),
        ("quantity.other_quantity", "parts.plc.steps.two.timeout.after"),
        ("sequence.unknown_step", "parts.plc.steps.two.timeout.to"),
        ("sequence.unreachable", "parts.plc.steps.island"),
        ("switch.contradictory", "parts.low.on_above"),
    }
    # Both `a` and `b` occur twice.
    assert len(found) == len(set(found)) + 1
    assert all(problem.line for problem in caught.value.problems)
    assert "two" in str(caught.value)


def test_an_invalid_sequence_alone_is_one_error():
    text = INVALID.replace('on_above = "3 bar"', 'on_above = "4.5 bar"')
    plc = """
[parts.plc]
kind = "sequence"
start = "one"
steps.one.next = { two = "supply.pressure > 3 bar and low.state and line.pressure > 1 bar" }

[connections]
"vent.opening" = "plc.a"
"""
    with pytest.raises(InputError) as caught:
        poppet.loads(text.partition("[parts.plc]")[0] + plc)
    assert [(problem.code, problem.address) for problem in caught.value.problems] == [
        ("sequence.unknown_step", "parts.plc.steps.one.next.two"),
        ("wiring.unknown_output", "parts.plc.steps.one.next.two"),
    ]


@pytest.mark.parametrize(
    ("fields", "code", "address"),
    [
        ({"steps": {}}, "sequence.no_steps", "steps"),
        ({"steps": "one"}, "sequence.no_steps", "steps"),
        ({"steps": {str(k): {} for k in range(501)}}, "sequence.too_many", "steps"),
        ({"start": None}, "sequence.no_start", "start"),
        ({"start": "three"}, "sequence.unknown_step", "start"),
        ({"start": ["one"]}, "sequence.unknown_step", "start"),
        ({"emergency": {"one": 1}}, "sequence.unknown_step", "emergency"),
        ({"steps": {"one": {"timeout": {"after": 1, "to": ["one"]}}}}, "sequence.unknown_step", "steps.one.timeout.to"),
        ({"emergency": "three"}, "sequence.unknown_step", "emergency"),
        ({"outputs": "a"}, "sequence.no_list", "outputs"),
        ({"outputs": ["a", "b", "go"]}, "sequence.name_twice", "outputs"),
        ({"inputs": ["go", "halt"]}, "sequence.reserved", "inputs"),
        ({"outputs": ["a", "b", "count_1"]}, "sequence.reserved", "outputs"),
        ({"outputs": ["a", "b", "1a"]}, "sequence.no_name", "outputs"),
        ({"initial_step": 3}, "sequence.no_initial_step", "initial_step"),
        ({"steps": {"one": 5}}, "sequence.no_table", "steps.one"),
        ({"steps": {"one": {}, "o.e": {}}}, "sequence.no_step_name", "steps"),
        ({"steps": {"one": {"nxt": {}}}}, "fields.unknown", "steps.one.nxt"),
        ({"steps": {"one": {"next": "go"}}}, "sequence.no_mapping", "steps.one.next"),
        ({"steps": {"one": {"timeout": "3 s"}}}, "sequence.no_mapping", "steps.one.timeout"),
        ({"steps": {"one": {"timeout": {"after": "3 s"}}}}, "sequence.no_timeout", "steps.one.timeout"),
        ({"steps": {"one": {"on": "a"}}}, "sequence.no_list", "steps.one.on"),
        ({"steps": {"one": {"on": ["a"], "set": {"a": 1}}}}, "sequence.set_twice", "steps.one.set"),
        ({"steps": {"one": {"set": {"a": 2}}}}, "fields.out_of_range", "steps.one.set.a"),
        (
            {"steps": {"one": {"next": {"one": "x.y > 3 mm", "two": "x.y > 3 bar"}}, "two": {}}},
            "sequence.two_units", "steps.one.next.two",
        ),
        (
            {"steps": {"one": {"next": {"one": "x.y > 3", "two": "x.y > 3 bar"}}, "two": {}}},
            "sequence.two_units", "steps.one.next.one",
        ),
    ],
)  # fmt: skip
def test_invalid_fields(fields, code, address):
    with pytest.raises(InputError) as caught:
        two_steps(**fields)
    assert (code, address) in {(problem.code, problem.address) for problem in caught.value.problems}
    assert str(caught.value)


def test_step_without_exit_is_a_note():
    steps = {"one": {"next": {"two": "go"}}, "two": {}, "safe": {}}
    notes = two_steps(steps=steps, emergency="safe").notes()
    assert [(note.code, note.address) for note in notes] == [("sequence.no_exit", "steps.two")]


def test_comparison_that_is_never_true_is_a_note():
    def notes_of(condition):
        steps = {"one": {"next": {"one": condition}}}
        return [(n.code, n.address) for n in Sequence(steps=steps, start="one", inputs=["go"]).notes()]

    for condition in ("go > 1", "1 < go", "go == 2", "not go < 0 or go"):
        assert notes_of(condition) == [("sequence.never_true", "steps.one.next.one")]
    for condition in ("go", "go >= 1", "0 < go", "go != 1", "elapsed > 1 s"):
        assert notes_of(condition) == []


def test_output_that_drives_nothing_is_a_note():
    def notes_of(connections, **parts):
        circuit = Circuit(plant(plc=two_steps(), **parts), connections=connections)
        return [(note.code, note.address) for note in circuit.static_notes if note.code == "sequence.unused_output"]

    unused = [("sequence.unused_output", f"plc.{name}") for name in ("a", "b")]
    assert notes_of({}) == unused
    assert notes_of({"vent.opening": "plc.a"}) == unused[1:]
    reader = Sequence(steps={"one": {"next": {"one": "plc.b"}}}, start="one")
    assert notes_of({"vent.opening": "plc.a"}, reader=reader) == []
    # Alone, as for an export, all outputs belong to the host program.
    assert not any(note.code == "sequence.unused_output" for note in Circuit({"plc": two_steps()}).static_notes)


def test_timeouts_in_a_run_are_a_note():
    steps = {
        "one": {"next": {"two": "elapsed > 20 ms"}, "timeout": {"after": "1 s", "to": "fault"}},
        "two": {"next": {"one": "supply.pressure > 6 bar"}, "timeout": {"after": "50 ms", "to": "fault"}},
        "fault": {"next": {"one": "elapsed > 20 ms"}},
    }  # fmt: skip
    plc = Sequence(steps=steps, start="one", emergency="fault")
    circuit = Circuit(plant(plc=plc))

    def timeouts(circuit, duration):
        notes = circuit.simulate(duration, output_step=1e-3).remarks
        return [(note.address, note.facts) for note in notes if note.code == "sequence.timed_out"]

    facts = {"name": "two", "target": "fault", "after": pytest.approx(0.05), "count": None}
    # Step one lasts 25 ms, so step two ends at 75 ms.
    assert timeouts(circuit, 0.07) == []
    assert timeouts(circuit, 0.1) == [("plc.step", {"time": pytest.approx(0.075, abs=1e-3), **facts})]
    assert timeouts(circuit, 0.25)[0][1]["count"] == 2
    later = circuit.with_values({"plc.steps.two.timeout.after": "80 ms"})
    assert timeouts(later, 0.12)[0][1]["after"] == pytest.approx(0.08)
    # The same transition by a condition, or by the input emergency, is no timeout.
    stopped = Circuit(plant(plc=plc), {"plc.emergency": pulse(0.072, 0.2)})
    assert timeouts(stopped, 0.1) == []


def test_run_without_a_transition_is_a_note():
    def waiting(condition, **fields):
        steps = {"one": {"next": {"two": condition}, **fields}, "two": {"next": {"one": "elapsed > 1 s"}}}
        notes = Circuit(plant(plc=Sequence(steps=steps, start="one"))).simulate(0.1).remarks
        return [(note.address, note.facts) for note in notes if note.code == "sequence.waiting"]

    assert waiting("supply.pressure > 6 bar") == [("plc.step", {"name": "one"})]
    assert waiting("supply.pressure > 4 bar") == []
    assert waiting("supply.pressure > 6 bar", timeout={"after": "1 s", "to": "two"}) == []


def test_values_without_a_unit_are_named():
    for condition, text in {
        "supply.pressure > 5": "supply.pressure in Pa cannot be compared with a value without a unit.",
        "elapsed > 50": "50 has no unit, but the other value has the unit s.",
        'count("one") > 5 s': "5 s has the unit s, but the other value has no unit.",
    }.items():
        with pytest.raises(InputError) as caught:
            Circuit(plant(plc=Sequence(steps={"one": {"next": {"one": condition}}}, start="one")))
        assert text in str(caught.value)


def test_inputs_of_conditions_are_not_suggested():
    steps = {"one": {"next": {"one": "supply.pressur > 1 bar"}}}
    with pytest.raises(InputError) as caught:
        Circuit(plant(plc=Sequence(steps=steps, start="one")))
    assert caught.value.facts["suggestion"].names[0] == "supply.pressure"
    assert not any(name.startswith("plc.supply") for name in caught.value.facts["suggestion"].names)


def test_conditions_on_unknown_outputs_and_parts():
    def circuit_of(condition):
        steps = {"one": {"next": {"one": condition}}}
        return Circuit(plant(plc=Sequence(steps=steps, start="one")))

    for condition, code in {
        "suply.pressure > 1 bar": "wiring.unknown_output",
        "supply.presure > 1 bar": "wiring.unknown_output",
        'plc.step == "tow"': "wiring.unknown_step",
        "supply.pressure > 1 mm": "wiring.condition_unit",
        "vent.opening == 1": "wiring.no_integer",
        "not vent.opening != plc.step": "wiring.no_integer",
    }.items():
        with pytest.raises(InputError) as caught:
            circuit_of(condition)
        assert (caught.value.code, caught.value.address) == (code, "parts.plc.steps.one.next.one")
    for condition in ("vent.regime == 1", "plc.step != 1", "plc.cycles == 2", "plc.halt == 0", 'plc.step == "one"'):
        assert circuit_of(condition).parts["plc"].program.compared_as_integers()


def test_example_of_two_cylinders():
    circuit = poppet.load(Path(__file__).parents[3] / "examples" / "two_cylinders.toml")
    recording = circuit.simulate()
    steps = np.array(circuit.parts["plc"].program.names)[recording["plc.step"].astype(int) - 1]
    changes = np.flatnonzero(steps[1:] != steps[:-1]) + 1
    assert steps[changes].tolist() == ["A+", "B+", "B-", "A-", "wait"] * 6
    assert recording["plc.cycles"][-1] == 6
    # As on the page.
    starts = recording.time[changes][::5]
    assert np.diff(starts)[1:] == pytest.approx(1.415, abs=1e-9)
    # The outputs are those of the step.
    assert recording["plc.a"].tolist() == np.isin(steps, ["A+", "B+", "B-"]).astype(float).tolist()
    assert recording["plc.b"].tolist() == (steps == "B+").astype(float).tolist()
