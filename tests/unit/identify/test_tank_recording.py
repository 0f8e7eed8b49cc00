"""Tests of the interpretation of recordings of tank tests: what the file states, and what is asked."""

from __future__ import annotations

import tomllib

import numpy as np
import pytest

from poppet.core.errors import InputError
from poppet.identify.recorded_columns import SERIAL, UserStatement
from poppet.identify.tank.tank_recording import interpret_tank
from poppet.identify.tank.test import read_tank_file
from tank_discharge import AMBIENT, REST, discharge, excel_export, logger_file, noisy_gauge

CLOSINGS = {"nothing": {}, "time": {"closes": "8 s"}, "open": {"closes": "no"}}
KNOWN = {"volume": "20 l", "ambient": "987 hPa", "opens": "free"}


def stated(**texts):
    return {key: UserStatement(text, "option") for key, text in texts.items()}


def keys(interpretation):
    return {question.key for question in interpretation.questions}


def item(interpretation, subject):
    (found,) = [item for item in interpretation.items if item.subject == subject]
    return found


def written(path, time, pressure, heading="t [s],p_tank [bar g]"):
    rows = [f"{t:.6g},{p:.6g}" for t, p in zip(time, pressure, strict=True)]
    path.write_text("\n".join([heading, *rows]) + "\n")
    return path


def test_a_spreadsheet_export_states_all_but_the_reference(tmp_path):
    found = interpret_tank(excel_export(tmp_path / "export.csv"), {})
    assert keys(found) == {"reference", "opens", "volume", "ambient"}
    assert item(found, "column separator").value == "semicolons"
    assert item(found, "decimal sign").value == ","
    assert item(found, "first time stamp").value == "23:59:50,200"
    assert item(found, "time").value.startswith("Uhrzeit [s], 0 to 39.9")  # over midnight
    assert item(found, "direction").value == "discharge: the pressure falls"
    assert found.rest_duration == pytest.approx(REST, abs=0.05)
    assert item(found, "not used").value == "Temperatur Raum"


@pytest.mark.parametrize(
    ("heading", "unit", "reference"),
    [
        ("Druck Kessel", "[bar_rel]", "bar g"),
        ("Druck Kessel", "bar ü", "bar g"),
        ("Überdruck Kessel", "bar", "bar g"),
        ("p abs", "[bar]", "bar a"),
        ("Druck Kessel", "[bara]", "bar a"),
    ],
)
def test_headings_can_state_the_reference(tmp_path, heading, unit, reference):
    found = interpret_tank(excel_export(tmp_path / "export.csv", heading, unit), {})
    assert keys(found) == {"opens", "volume", "ambient"}
    assert found.recording["tank.pressure"]["unit"] == reference
    assert item(found, "tank pressure").origins == ("file",)


def test_headings_that_state_both_references_are_asked_for(tmp_path):
    found = interpret_tank(excel_export(tmp_path / "export.csv", "p rel oder abs"), {})
    assert "reference" in keys(found)


def test_units_that_no_heading_states_are_questions_with_the_evidence(tmp_path):
    found = interpret_tank(logger_file(tmp_path / "log.csv"), {})
    assert keys(found) == {"time_unit", "pressure_unit", "reference", "opens", "volume", "ambient"}
    (question,) = [question for question in found.questions if question.key == "time_unit"]
    assert question.note.facts["durations"]["ms"] == pytest.approx(39.9)
    assert found.axes == ("", "")  # the picture shows the values of the file
    answered = interpret_tank(tmp_path / "log.csv", stated(**KNOWN, time_unit="ms", pressure="p1 [mbar g]"))
    assert keys(answered) == set()
    assert answered.run.pressure.time[-1] == pytest.approx(39.9)
    assert answered.run.pressure.values[0] == pytest.approx(7.0e5, rel=0.01)
    assert item(answered, "time").origins == ("file", "option")


def test_a_heading_with_unit_and_reference_in_its_name(tmp_path):
    time, pressure = discharge()
    found = interpret_tank(written(tmp_path / "a.csv", time, pressure / 1e5, "t_s,p_bar_abs"), {})
    assert found.recording["tank.pressure"]["unit"] == "bar a"
    assert keys(found) == {"opens", "volume", "ambient"}


def test_all_invalid_statements_are_reported_together(tmp_path):
    path = written(tmp_path / "a.csv", *noisy_gauge())
    with pytest.raises(InputError) as caught:
        interpret_tank(path, stated(volume="20", ambient="1000", opens="late", pressure="q [bar]"))
    assert [problem.address for problem in caught.value.problems] == ["pressure", "volume", "ambient"]


def test_a_column_of_text_is_an_item(tmp_path):
    path = tmp_path / "a.csv"
    rows = [f"1.{k:03d}.000;{6.0 - 0.05 * k:.3f}" for k in range(100)]  # points between thousands
    path.write_text("\n".join(["t [ms];p [bar g]", *rows]) + "\n")
    found = interpret_tank(path, {})
    assert item(found, "text, no numbers").value.startswith("t: 1.0")
    assert "time" in keys(found)


@pytest.mark.parametrize(("name", "unit"), [("t_ms", "ms"), ("Zeit / ms", "ms"), ("time in min", "min")])
def test_a_heading_with_the_unit_in_its_name(tmp_path, name, unit):
    time, gauge = noisy_gauge()
    found = interpret_tank(written(tmp_path / "a.csv", time, gauge, f"{name},p_tank_bar"), {})
    assert "time_unit" not in keys(found)
    assert found.recording["time"]["unit"] == unit
    assert "pressure_unit" not in keys(found)


def test_days_of_a_spreadsheet_are_asked_for(tmp_path):
    time, gauge = noisy_gauge()
    rows = [f"{45987.25 + t / 86400.0:.9f},{p:.4f}" for t, p in zip(time, gauge, strict=True)]
    path = tmp_path / "a.csv"
    path.write_text("\n".join(["Zeit,p_tank [bar g]", *rows]) + "\n")
    assert "time_unit" in keys(interpret_tank(path, {}))
    answered = interpret_tank(path, stated(**KNOWN, time_unit=SERIAL))
    assert answered.run.pressure.time[-1] == pytest.approx(39.9, abs=1e-3)
    assert answered.axes[0] == "s"


def test_an_absolute_pressure_read_as_gauge_and_the_reverse_are_doubts(tmp_path):
    time, gauge = noisy_gauge()
    path = written(tmp_path / "a.csv", time, gauge, "t [s],p [bar]")
    codes = {
        reference: {note.code for note in interpret_tank(path, stated(**KNOWN, reference=reference)).doubts}
        for reference in ("gauge", "absolute")
    }
    assert codes == {"gauge": set(), "absolute": {"suspicion.read_as_absolute"}}
    time, pressure = discharge(duration=90.0)
    path = written(tmp_path / "b.csv", time, pressure / 1e5, "t [s],p [bar]")
    assert {note.code for note in interpret_tank(path, stated(**KNOWN, reference="gauge")).doubts} == {
        "suspicion.read_as_gauge"
    }


def test_milliseconds_read_as_seconds_are_a_doubt(tmp_path):
    time, gauge = noisy_gauge()
    path = written(tmp_path / "a.csv", 1e3 * time, gauge, "t,p [bar g]")
    doubts = interpret_tank(path, stated(**KNOWN, time_unit="s")).doubts
    assert "finding.unusual.time" in {note.code for note in doubts}
    assert interpret_tank(path, stated(**KNOWN, time_unit="ms")).doubts == ()


@pytest.mark.parametrize(("opens", "is_doubtful"), [("2.3 s", False), ("2.25 s", False), ("1 s", True), ("5 s", True)])
def test_an_opening_beside_the_change_of_the_pressure_is_a_doubt(tmp_path, opens, is_doubtful):
    path = written(tmp_path / "a.csv", *noisy_gauge())
    doubts = interpret_tank(path, stated(**KNOWN | {"opens": opens})).doubts
    assert [note.code for note in doubts] == ["question.unsynchronised"] * is_doubtful


def test_a_recording_without_rest_opens_at_its_first_sample(tmp_path):
    time, gauge = noisy_gauge()
    is_after = time >= REST
    found = interpret_tank(written(tmp_path / "a.csv", time[is_after], gauge[is_after]), {})
    assert keys(found) == {"volume", "ambient"}
    assert found.rest_duration == 0.0
    assert item(found, "valve opens").origins == ("file",)


def test_a_clock_in_whole_seconds_hides_no_rest(tmp_path):
    time, gauge = noisy_gauge()
    rows = [f"10:00:{int(t):02d};{p:.4f}".replace(".", ",") for t, p in zip(time + 0.3, gauge, strict=True)]
    path = tmp_path / "a.csv"
    path.write_text("\n".join(["Zeit;p [bar_rel]", *rows]) + "\n")
    found = interpret_tank(path, stated(volume="20 l", ambient="987 hPa"))
    assert keys(found) == {"opens"}
    assert found.rest_duration == pytest.approx(REST, abs=1.0)


def test_noise_that_hides_the_opening_is_asked_for(tmp_path):
    time, gauge = noisy_gauge()
    noise = np.random.default_rng(5).normal(0.0, 0.1, gauge.size)
    assert "opens" in keys(interpret_tank(written(tmp_path / "a.csv", time, gauge + noise), {}))


@pytest.mark.parametrize(("wall", "is_isothermal"), [(6.0, False), (1e4, True)])
def test_a_discharge_whose_valve_closes_early_is_asked_for(tmp_path, wall, is_isothermal):
    time, pressure = discharge(closes=8.0, wall=wall)
    path = written(tmp_path / "a.csv", time, (pressure - AMBIENT) / 1e5)
    asked = {name: keys(interpret_tank(path, stated(**KNOWN, **answers))) for name, answers in CLOSINGS.items()}
    assert asked == {"nothing": {"closes"}, "time": set(), "open": set()}
    assert "closes" in keys(interpret_tank(path, {})) or is_isothermal  # a constant level needs the ambient pressure
    found = interpret_tank(path, stated(**KNOWN, closes="8 s"))
    assert found.recording["closes"] == "8 s"


def test_a_discharge_to_ambient_pressure_is_not_closed(tmp_path):
    time, pressure = discharge(duration=120.0)
    gauge = (pressure - AMBIENT) / 1e5 + np.random.default_rng(2).normal(0.0, 0.003, time.size)
    assert keys(interpret_tank(written(tmp_path / "a.csv", time, gauge), stated(**KNOWN))) == set()


def test_a_charge_asks_for_supply_and_closing(tmp_path):
    time = np.arange(0.0, 20.0, 0.1)
    gauge = np.minimum(6.0, 0.8 * time)
    found = interpret_tank(written(tmp_path / "a.csv", time, gauge), stated(volume="20 l", ambient="1 bar"))
    assert item(found, "direction").value == "charge: the pressure rises"
    assert keys(found) == {"supply", "closes"}
    answers = stated(volume="20 l", ambient="1 bar", supply="6.2 bar g", closes="no")
    assert keys(interpret_tank(tmp_path / "a.csv", answers)) == set()


def test_a_column_of_the_supply(tmp_path):
    time = np.arange(0.0, 20.0, 0.1)
    rows = [f"{t:.1f},{min(6.0, 0.8 * t):.3f},6.2" for t in time]
    path = tmp_path / "a.csv"
    path.write_text("\n".join(["t [s],p_tank [bar g],p_supply [bar g]", *rows]) + "\n")
    answers = stated(volume="20 l", ambient="1 bar", supply="p_supply", closes="no", pressure="p_tank")
    found = interpret_tank(path, answers)
    assert keys(found) == set()
    assert found.recording["inputs"] == {"supply.pressure": {"column": "p_supply", "unit": "bar g"}}
    assert "not used" not in {item.subject for item in found.items}


def test_ambient_conditions_can_be_columns(tmp_path):
    path = excel_export(tmp_path / "export.csv")
    answers = stated(**KNOWN | {"ambient_temperature": "Temperatur Raum"}, reference="gauge")
    found = interpret_tank(path, answers)
    assert found.fields["ambient_temperature"].text == "21 degC"
    assert "not used" not in {item.subject for item in found.items}
    with pytest.raises(InputError) as caught:
        interpret_tank(path, answers | stated(ambient="Temperatur Raum"))
    assert [problem.address for problem in caught.value.problems] == ["ambient"]


def test_two_pressures_are_a_question(tmp_path):
    path = tmp_path / "a.csv"
    rows = [f"{0.1 * k:.1f},{6.0 - 0.05 * k:.3f},{6.0 - 0.04 * k:.3f}" for k in range(100)]
    path.write_text("\n".join(["t [s],p1 [bar g],p2 [bar g]", *rows]) + "\n")
    found = interpret_tank(path, {})
    assert "pressure" in keys(found)
    (question,) = [question for question in found.questions if question.key == "pressure"]
    assert question.choices == ("p1", "p2")


def test_a_filling_before_the_discharge_needs_a_window(tmp_path):
    gauge = noisy_gauge()[1]
    fill = np.linspace(0.0, gauge[0], 100)
    all_time = 0.1 * np.arange(fill.size + gauge.size)
    path = written(tmp_path / "a.csv", all_time, np.concatenate([fill, gauge]))
    assert "window" in keys(interpret_tank(path, {}))
    found = interpret_tank(path, stated(**KNOWN, window="10.1 s, 49 s") | stated(opens="12.3 s"))
    assert keys(found) == set()
    assert found.doubts == ()
    assert found.recording["skip"] == "10.1 s"
    assert found.recording["opens"] == "2.2 s"  # the file of the test counts from the first used sample


@pytest.mark.parametrize(
    ("answers", "code"),
    [
        ({"volume": "20"}, "question.no_unit"),
        ({"volume": "20 bar"}, "quantity.other_quantity"),
        ({"volume": "-2 l"}, "question.not_above_zero"),
        ({"ambient": "1 bar g"}, "question.not_above_zero"),
        ({"reference": "relative"}, "fields.not_an_option"),
        ({"direction": "emptying"}, "fields.not_an_option"),
        ({"window": "5 s"}, "question.bad_window"),
        ({"window": "9 s, 5 s"}, "question.bad_window"),
        ({"pressure": "p_tank [degC]"}, "quantity.other_quantity"),
        ({"pressure": "q_tank [bar]"}, "table.misspelt"),
        ({"pressure": "p_tank [furlong]"}, "question.column_unit"),
        ({"pressure": "p_tank (furlong)"}, "question.column_unit"),
        ({"reference": "absolute"}, "question.reference_twice"),
    ],
)
def test_invalid_statements(tmp_path, answers, code):
    path = written(tmp_path / "a.csv", *noisy_gauge())
    with pytest.raises(InputError) as caught:
        interpret_tank(path, stated(**KNOWN | answers))
    assert code in {problem.code for problem in caught.value.problems}


@pytest.mark.parametrize(
    ("heading", "other", "time"),
    [
        ("Zeit", "Durchfluss in l / min", "Zeit"),  # a flow rate is no time
        ("t", "dt [ms]", "t"),  # constant
        ("t [s]", "Zyklen [h]", "t"),
        ("Zeit", "Betriebszeit [h]", None),
    ],
)
def test_the_column_of_the_time_increases_and_is_asked_for_if_two_do(tmp_path, heading, other, time):
    seconds, gauge = noisy_gauge()
    others = {"dt [ms]": np.full(seconds.size, 100.0)}.get(other, 50.0 + 0.01 * seconds)
    rows = [f"{t:.6g};{p:.6g};{x:.6g}" for t, p, x in zip(seconds, gauge, others, strict=True)]
    (tmp_path / "a.csv").write_text("\n".join([f"{heading};p [bar g];{other}", *rows]) + "\n")
    found = interpret_tank(tmp_path / "a.csv", {})
    columns = {item.value.split(" [")[0] for item in found.items if item.subject == "time"}
    assert (columns, "time" in keys(found)) == (({time}, False) if time else (set(), True))


@pytest.mark.parametrize(
    ("first", "second", "pressure"),
    [
        ("p_tank", "p_supply [bar g]", None),  # the only unit is that of another pressure
        ("p_tank", "Barometer [hPa]", "p_tank"),
        ("ch1", "Netzdruck [bar g]", None),
        ("ch1", "dp [bar g]", None),
        ("ch1", "Druck [bar g]", "Druck"),
        ("tank [bar g]", "supply [bar g]", "tank"),
    ],
)
def test_the_tank_pressure_is_not_that_of_the_supply(tmp_path, first, second, pressure):
    time, gauge = noisy_gauge()
    rows = [f"{t:.6g};{p:.6g};{6.5 - 0.001 * t:.6g}" for t, p in zip(time, gauge, strict=True)]
    (tmp_path / "a.csv").write_text("\n".join([f"t [s];{first};{second}", *rows]) + "\n")
    found = interpret_tank(tmp_path / "a.csv", {})
    columns = {item.value.split(" [")[0] for item in found.items if item.subject == "tank pressure"}
    assert (columns, "pressure" in keys(found)) == (({pressure}, False) if pressure else (set(), True))


@pytest.mark.parametrize(
    ("heading", "answers", "code"),
    [
        ("p abs [bar g]", {}, "question.two_references"),
        ("p abs [bar]", {"reference": "gauge"}, "question.reference_twice"),
        ("p abs [bar]", {"pressure": "²"}, "table.unknown"),
        ("p [bar g]", {"pressure": "empty [bar g]"}, "measured.empty_column"),
        ("p [bar g]", {"time": "empty"}, "measured.empty_column"),
        ("p [bar g]", {"pressure": "still"}, "question.constant"),
        ("p [bar g]", {"direction": "charge", "supply": "still"}, "question.supply_unit"),
        ("p [bar g]", {"opens": "still"}, "question.no_switching"),
        ("p [bar g]", {"direction": "charge", "supply": "2"}, "question.no_unit"),
        ("p [bar g]", {"direction": "charge", "supply": "7 bar"}, "question.no_answer"),
    ],
)
def test_contradictions_and_columns_without_values(tmp_path, heading, answers, code):
    time, gauge = noisy_gauge()
    rows = [f"{t:.6g};{p:.6g};6.5;" for t, p in zip(time, gauge, strict=True)]
    (tmp_path / "a.csv").write_text("\n".join([f"t [s];{heading};still;empty", *rows]) + "\n")
    with pytest.raises(InputError) as caught:
        interpret_tank(tmp_path / "a.csv", stated(**KNOWN | answers))
    assert code in {problem.code for problem in caught.value.problems}


@pytest.mark.parametrize("opens", ["valve", "valve [V]"])
def test_a_valve_signal_gives_the_opening(tmp_path, opens):
    """The signal of 24 V has noise; the valve opens at `REST`."""
    time, gauge = noisy_gauge()
    signal = 24.0 * (time > REST - 1e-6) + np.random.default_rng(4).normal(0.0, 0.2, time.size)
    rows = [f"{t + 5.0:.6g},{p:.6g},{v:.4f}" for t, p, v in zip(time, gauge, signal, strict=True)]
    (tmp_path / "a.csv").write_text("\n".join([f"t [s],p_tank [bar g],{opens}", *rows]) + "\n")
    found = interpret_tank(tmp_path / "a.csv", stated(**KNOWN | {"opens": "valve"}))
    assert keys(found) == set()
    assert found.moments["opens"] == pytest.approx(REST)
    assert found.recording["opens"] == f"{REST:g} s"
    assert item(found, "valve opens") == ("valve opens", f"{REST:g} s: first change of valve", ("option", "file"))
    assert "not used" not in {item.subject for item in found.items}
    assert found.doubts == ()
    windowed = interpret_tank(tmp_path / "a.csv", stated(**KNOWN | {"opens": "valve"}, window="1 s, 30 s"))
    assert windowed.recording["opens"] == f"{REST - 1.0:g} s"


def test_a_column_of_the_supply_can_state_its_unit_in_the_answer(tmp_path):
    rows = [f"{0.1 * k:.1f};{min(6.0, 0.08 * k):.3f};6.2" for k in range(200)]
    (tmp_path / "a.csv").write_text("\n".join(["t [s];p_tank [bar g];netz", *rows]) + "\n")
    answers = stated(volume="20 l", ambient="1 bar", supply="netz [bar g]", closes="no")
    found = interpret_tank(tmp_path / "a.csv", answers)
    assert found.recording["inputs"] == {"supply.pressure": {"column": "netz", "unit": "bar g"}}


def test_points_between_thousands_are_no_decimal_points(tmp_path):
    time, gauge = noisy_gauge()
    rows = [f"{t:.2f};{1e3 * p:,.0f}" for t, p in zip(time, gauge, strict=True)]
    text = "\n".join(["t [s];p [mbar g]", *rows]) + "\n"
    (tmp_path / "a.csv").write_text(text.translate(str.maketrans(".,", ",.")))
    with pytest.raises(InputError) as caught:
        interpret_tank(tmp_path / "a.csv", stated(**KNOWN))
    assert [problem.code for problem in caught.value.problems] == ["question.no_numbers"]


def test_the_file_of_the_test_states_every_source(tmp_path):
    path = excel_export(tmp_path / "Messung 12.csv")
    answers = stated(**KNOWN) | {"reference": UserStatement("gauge", "answer")}
    text = interpret_tank(path, answers).test_file(tmp_path)
    content = tomllib.loads(text)
    assert content["volume"] == "20 l"
    assert content["valve_delay"] == "free"
    assert content["recordings"]["messung_12"]["tank.pressure"]["unit"] == "bar g"
    lines = {line.split(" = ")[0]: line.rpartition("# ")[2] for line in text.splitlines() if " = " in line}
    assert lines["direction"] == "file"
    assert lines["volume"] == "option"
    assert lines['"tank.pressure"'] == "file, answer"
    assert "# wall_conductance: free (assumed)" in text
    (tmp_path / "test.toml").write_text(text)
    assert read_tank_file(tmp_path / "test.toml").volume == "20 l"


def test_the_picture_shows_the_curve_in_both_references(tmp_path):
    pytest.importorskip("matplotlib")
    from poppet.report.identification.interpretation_figure import draw_interpretation

    path = excel_export(tmp_path / "export.csv")
    figure = draw_interpretation(interpret_tank(path, stated(**KNOWN, reference="gauge")))
    left, right = figure.axes
    assert left.get_ylabel() == "tank pressure  [bar g]"
    (curve, ambient) = left.lines
    assert curve.get_ydata()[0] == pytest.approx(6.013, abs=0.02)
    assert ambient.get_ydata()[0] == pytest.approx(0.0)
    assert np.array(right.get_ylim()) - AMBIENT / 1e5 == pytest.approx(left.get_ylim(), abs=1e-9)
    texts = [text.get_text() for text in figure.texts]
    assert "Druck Kessel [bar g], 0.1218 to 6.023" in texts
    assert "assumed" in texts
    undecided = draw_interpretation(interpret_tank(path, {}))
    assert undecided.axes[0].get_ylabel() == "tank pressure  [unit unknown]"
