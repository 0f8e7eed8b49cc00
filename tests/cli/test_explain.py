"""Tests of `poppet explain`."""

from __future__ import annotations

import re
import shlex

import pytest

from poppet.core.explanations import explanation
from poppet.core.message_format import every_code, plain

COMMANDS = {
    code: match[1]
    for code in every_code()
    if (match := re.match(r"`poppet ((?:convert|explain) .+?)`", explanation(code).get("example", "")))
}
"""Complete commands of examples that need no file, by the code that they cause."""


def test_an_error_has_cause_example_and_remedy(poppet):
    done = poppet("explain", "fields.out_of_range")
    assert done.code == 0
    first, *lines = done.out.splitlines()
    assert first == "fields.out_of_range"
    assert [line.split()[0] for line in lines] == ["message:", "cause:", "example:", "remedy:"]
    assert "duration = 0 s is out of range" in lines[0]
    assert "[run]" in lines[2]


def test_several_codes_are_explained(poppet):
    done = poppet("explain", "finding.area", "finding.capped")
    assert [line for line in done.out.splitlines() if line and line[0] != " "] == ["finding.area", "finding.capped"]


def test_the_first_part_of_a_code_lists_all_its_codes(poppet):
    within = [code for code in every_code() if code.startswith("wiring.")]
    assert poppet("explain", "wiring").out.split()[-len(within) :] == within


def test_without_a_code_all_topics_are_listed(poppet):
    lines = poppet("explain").out.splitlines()
    assert {line.split()[0] for line in lines} == {code.partition(".")[0] for code in every_code()}
    assert all(len(line.split()) > 1 for line in lines)


@pytest.mark.parametrize("code", COMMANDS)
def test_the_command_of_an_example_causes_its_code(poppet, code):
    done = poppet(*shlex.split(COMMANDS[code]))
    assert (done.code, done.error.code) == (2, code)


def test_a_verdict_is_explained(poppet):
    done = poppet("explain", "not determined", "weak")
    assert [line for line in done.out.splitlines() if line and line[0] != " "] == ["not determined", "weak"]
    assert poppet("explain", "not determind").error.facts["suggestion"].names[0] == "not determined"


def test_a_former_code_shows_its_new_code(poppet):
    assert poppet("explain", "wiring.no_input").out.startswith("wiring.no_input is now names.unknown.\nnames.unknown\n")


def test_an_unknown_code_is_refused_with_the_nearest(poppet):
    done = poppet("explain", "fields.out_of_rang")
    assert (done.code, done.error.code) == (2, "cli.code")
    assert "fields.out_of_range" in done.err


def test_a_misspelt_first_part_has_a_suggestion(poppet):
    done = poppet("explain", "filds")
    assert done.code == 2
    assert "Did you mean fields" in done.err
    assert "fields." not in done.err


def test_an_error_names_the_explain_command(poppet):
    done = poppet("convert", "6 bax", "--to", "psi")
    assert done.code == 2
    (line,) = [line for line in done.err.splitlines() if line.startswith("more: poppet explain ")]
    for code in line.split()[3:]:
        assert code in every_code()


def test_every_template_has_plain_text():
    for template in every_code().values():
        for text in [template] if isinstance(template, str) else template.values():
            assert "{{" in text or "{" not in plain(text)
            assert plain(text).count("[") == plain(text).count("]")
