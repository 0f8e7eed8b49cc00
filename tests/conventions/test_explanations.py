"""Explanations of message codes: every code has cause, example and remedy, and they add to the message."""

from __future__ import annotations

import re
import runpy
from functools import cache

import pytest

from poppet.cli.commands import all_commands
from poppet.cli.main import command_parser, split_command
from poppet.core.explanations import EXPLAINED, REMEDIES, explanation, verdict_explanations
from poppet.core.message_format import every_code
from poppet.deploy.parity import parity_table
from poppet.identify.result import VERDICTS
from source_files import ROOT

REPOSITORY = ROOT.parents[1]
DIALECT = runpy.run_path(str(REPOSITORY / "tools" / "measure_language.py"))["DIALECT"]
TEXTS_OF_REPORTS = ("figure.", "identification.", "near.", "paper.", "size.page.", "watch.page.")
"""First components of codes of headings, captions and definitions, which no message shows."""
PARTS_OF_MESSAGES = {"linear.rate_of", "linear.value_of", "rest.drifts", "rest.ends", "rest.swings"}
"""Codes of phrases, which occur within other messages only."""
MESSAGES_OF_REPORTS = {"paper.folder", "paper.folder_is_file"}
MIN_CAUSE, MIN_EXAMPLE, MIN_REMEDY = 9, 4, 5
"""Smallest numbers of words."""
NO_ACTION = "No action is necessary"
MAX_WORDS = {"cause": 60, "example": 35, "remedy": 60}
MAX_SENTENCE = 30


def is_message(code: str) -> bool:
    return code in MESSAGES_OF_REPORTS or not (code.startswith(TEXTS_OF_REPORTS) or code in PARTS_OF_MESSAGES)


MESSAGES = [code for code in every_code() if is_message(code)]
EXPLANATIONS = {code: dict.fromkeys(EXPLAINED, "") | explanation(code) for code in [*MESSAGES, *verdict_explanations()]}


def words(text: str) -> list[str]:
    return re.findall(r"[a-z]{4,}", text.casefold())


def test_every_message_has_cause_example_and_remedy():
    missing = {code: [part for part in EXPLAINED if not parts[part]] for code, parts in EXPLANATIONS.items()}
    assert {code: parts for code, parts in missing.items() if parts} == {}


def test_files_explain_only_codes_of_messages():
    texts = [file.read_text(encoding="utf-8") for file in REMEDIES.glob("*.toml")]
    assert sum(text.count("\ncause = ") for text in texts) == len(MESSAGES)


def test_every_verdict_is_explained():
    words_of_parity = {"within", "beyond", "not run", "not compared", *parity_table.VERDICTS.values()}
    assert verdict_explanations().keys() == {*VERDICTS, *words_of_parity}
    assert not verdict_explanations().keys() & every_code().keys()


def test_explanations_add_to_the_message():
    """Cause and remedy are sentences with words that the message does not contain."""
    thin = []
    for code, parts in EXPLANATIONS.items():
        message, cause, remedy = (set(words(parts[key])) for key in ("message", "cause", "remedy"))
        is_snippet = len(parts["example"].split()) >= MIN_EXAMPLE or "`" in parts["example"]
        is_short = len(parts["cause"].split()) < MIN_CAUSE or len(parts["remedy"].split()) < MIN_REMEDY
        is_repetition = len(cause - message) < 3 or not remedy - message or cause == remedy
        thin += [code] if is_repetition or not is_snippet or (is_short and NO_ACTION not in parts["remedy"]) else []
    assert thin == []


def test_no_two_codes_have_the_same_cause():
    causes: dict[str, list[str]] = {}
    for code, parts in EXPLANATIONS.items():
        causes.setdefault(parts["cause"], []).append(code)
    assert [codes for codes in causes.values() if len(codes) > 1] == []


@pytest.mark.parametrize("part", EXPLAINED)
def test_texts_are_short_sentences(part):
    wrong = []
    for code, parts in EXPLANATIONS.items():
        text = parts[part]
        sentences = re.split(r"(?<=[.?])\s+(?=[A-Z`])", text)
        is_long = len(text.split()) > MAX_WORDS[part] or max(len(s.split()) for s in sentences) > MAX_SENTENCE
        wrong += [code] if is_long or not text.endswith((".", '."', ".`")) else []
    assert wrong == []


def test_texts_are_in_plain_language():
    hits = {code: DIALECT.findall(parts["cause"] + " " + parts["remedy"]) for code, parts in EXPLANATIONS.items()}
    assert {code: found for code, found in hits.items() if found} == {}


@cache
def vocabulary() -> tuple[frozenset[str], frozenset[str]]:
    """Return the names and the options of the source code and the documents."""
    files = [*ROOT.rglob("*.py"), *(REPOSITORY / "docs").glob("*.md"), *(REPOSITORY / "examples").rglob("*.toml")]
    text = "\n".join(file.read_text(encoding="utf-8") for file in files)
    return frozenset(re.findall(r"[A-Za-z_]\w*", text)), frozenset(re.findall(r"--[a-z][a-z-]+", text))


def test_explanations_name_things_that_exist():
    """Fields, options, commands and pages of causes and remedies occur in the source code or the documents."""
    names, options = vocabulary()
    unknown = []
    for code, parts in EXPLANATIONS.items():
        text = f"{parts['cause']} {parts['remedy']}"
        unknown += [f"{code}: {page}" for page in re.findall(r"\]\((.+?)\)", text) if not (REPOSITORY / page).is_file()]
        unknown += [f"{code}: {option}" for option in re.findall(r"--[a-z][a-z-]+", text) if option not in options]
        for quoted in re.findall(r"`([^`]+)`", text):
            plain = re.sub(r'"[^"]*"', "", quoted)
            unknown += [
                f"{code}: {n}" for n in re.findall(r"[A-Za-z_]\w*", plain) if n not in names and not n.isupper()
            ]
    assert unknown == []


def test_explanations_name_commands_with_their_options():
    names = {name.partition(" ")[0] for name in all_commands()}
    unknown = []
    for code, parts in EXPLANATIONS.items():
        for quoted in re.findall(r"`poppet (\w[^`]*)`", " ".join(parts[part] for part in EXPLAINED)):
            name, arguments = split_command(quoted.split())
            if name in all_commands():
                # The example of this code is an option of another method.
                options = set(re.findall(r"--[a-z-]+", quoted)) if code != "cli.option.misplaced" else set()
                unknown += [f"{code}: {quoted}"] if options - command_parser(name)._option_string_actions.keys() else []
            else:
                unknown += [] if name in names and (not arguments or arguments[0] == "...") else [f"{code}: {quoted}"]
    assert unknown == []
