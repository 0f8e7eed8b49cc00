"""Tests of texts in CSV files: quoting, formulas, and reading back."""

from __future__ import annotations

import csv
import io

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from poppet.core.csv_cells import csv_text, safe_text, unmarked_text
from poppet.report.tables import ReportTable
from poppet.timeseries.recording import Recording
from poppet.timeseries.tables.reading import read_table

FORMULAS = ["=1+1", "+1+1", "-1+1", "@SUM(A1)", "\t=1", "\r=1", '=HYPERLINK("http://x")', "'=1", "''@a"]
ODD = ["a,b", 'say "m"', "two\nlines", 'two\nlines, and "quotes"', '5" tube', *FORMULAS]


@pytest.mark.parametrize("text", FORMULAS)
def test_formulas_begin_with_an_apostrophe(text):
    assert safe_text(text) == f"'{text}"
    assert unmarked_text(safe_text(text)) == text


@pytest.mark.parametrize("text", ["-0.5", "+3", "-1e-9", "-inf", "nan", "-", "--", "", "a=b", "tank [Pa]", "'quoted'"])
def test_numbers_and_other_texts_are_unchanged(text):
    assert safe_text(text) == unmarked_text(text) == text


@given(st.text(max_size=8))
def test_every_text_is_read_back(text):
    (row,) = csv.reader(io.StringIO(csv_text([[text, "x"]]), newline=""))
    assert unmarked_text(row[0]) == text
    assert row[0][:1] not in ("=", "@", "\t", "\r")


def test_numbers_stay_numbers():
    assert csv_text([["-1", -1.5, 2]]) == "-1,-1.5,2\n"
    assert ReportTable(("=name", "x"), [("@a", -1.5)]).csv() == "'=name,x\n'@a,-1.5\n"


@pytest.mark.parametrize("name", [text for text in ODD if not text[0].isspace()])
def test_recordings_read_back_their_own_names(tmp_path, name):
    recording = Recording.from_series([0.0, 1.0, 2.0], {name: [-1.0, 2.0, 3.0], "other": [4.0, 5.0, 6.0]})
    path = recording.save(tmp_path / "out.csv")
    (first, *_) = csv.reader(io.StringIO(path.read_text(encoding="utf-8"), newline=""))
    assert first == ["time [s]", safe_text(name), "other"]
    read = Recording.read(path)
    assert read.names == (name, "other")
    assert np.array_equal(read[name], [-1.0, 2.0, 3.0])
    assert read_table(path).names == ("time", name, "other")


def test_inch_signs_of_other_programs_do_not_join_lines(tmp_path):
    path = tmp_path / "inch.csv"
    path.write_text('t;p 5"\n0;1\n1;2\n2;3\n', encoding="utf-8")
    assert read_table(path).columns[1].tolist() == [1.0, 2.0, 3.0]
