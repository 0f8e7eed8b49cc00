"""`poppet explain`: every code has an answer."""

from __future__ import annotations

from poppet.core.message_format import every_code, plain


def test_a_mistake_is_told_in_three_parts(poppet):
    done = poppet("explain", "fields.out_of_range")
    assert done.code == 0
    assert [line.split()[0] for line in done.out.splitlines()] == ["fields.out_of_range", "given:", "reason:", "hint:"]


def test_a_note_and_several_at_once(poppet):
    done = poppet("explain", "finding.area", "finding.capped")
    assert [line for line in done.out.splitlines() if line and line[0] != " "] == ["finding.area", "finding.capped"]


def test_what_codes_begin_with_lists_them(poppet):
    within = [code for code in every_code() if code.startswith("wiring.")]
    assert poppet("explain", "wiring").out.split()[3:] == within


def test_without_a_code_it_lists_all_beginnings(poppet):
    out = poppet("explain").out
    assert all(code in out for code in every_code() if "." in code)


def test_an_unknown_code_is_refused_with_the_nearest(poppet):
    done = poppet("explain", "fields.out_of_rang")
    assert (done.code, done.error.code) == (2, "cli.code")
    assert "fields.out_of_range" in done.err


def test_a_misspelt_beginning_is_answered_with_beginnings(poppet):
    done = poppet("explain", "filds")
    assert done.code == 2
    assert "Did you mean fields" in done.err
    assert "fields." not in done.err


def test_a_refusal_says_what_to_type(poppet):
    done = poppet("convert", "6 bax", "--to", "psi")
    assert done.code == 2
    (line,) = [line for line in done.err.splitlines() if line.startswith("more: poppet explain ")]
    for code in line.split()[3:]:
        assert code in every_code()


def test_every_template_can_be_read_plainly():
    for template in every_code().values():
        for text in [template] if isinstance(template, str) else template.values():
            assert "{{" in text or "{" not in plain(text)
            assert plain(text).count("[") == plain(text).count("]")
