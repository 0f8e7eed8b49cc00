"""Measure the language of a Python source tree. Standard library only.

Usage: python tools/measure_language.py SRC [SRC ...] [--list] [--json]

Each SRC is a folder that is searched for ``*.py`` files. ``--list`` also prints every hit as ``file:line: text``.
"""

from __future__ import annotations

import ast
import io
import json
import re
import sys
import tokenize
from collections import Counter, defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any

# Local names that carry no information about the value they hold. Conventional one-letter names, `value`, `result`,
# `index`, `key`, `name` and `row` are not in the list: they are accepted in peer libraries.
VAGUE = frozenset(
    [
        "found",
        "each",
        "own",
        "given",
        "known",
        "told",
        "said",
        "held",
        "seen",
        "kept",
        "wanted",
        "shown",
        "taken",
        "moved",
        "named",
        "chosen",
        "made",
        "drawn",
        "used",
        "asked",
        "meant",
        "one",
        "ones",
        "what",
        "whose",
        "which",
        "where",
        "there",
        "here",
        "who",
        "these",
        "those",
        "them",
        "others",
        "other",
        "more",
        "most",
        "every",
        "all_",
        "both",
        "alone",
        "thing",
        "things",
        "stuff",
        "whole",
        "place",
        "places",
        "way",
        "ways",
        "room",
        "beside",
        "between",
        "apart",
        "beyond",
        "above",
        "below",
        "before",
        "after",
        "along",
        "across",
        "until",
        "at",
        "of",
        "to_",
        "inside",
        "outside",
        "around",
        "own_",
        "look",
        "looks",
        "lead",
        "led",
        "late",
        "lost",
        "doubt",
        "words",
        "word",
        "mistakes",
        "mistake",
        "several",
        "near",
        "far",
        "much",
        "many",
        "few",
        "bad",
        "good",
        "plain",
        "bare",
        "part_",
        "rest",
        "again",
        "once",
        "tells",
        "says",
        "stands",
        "lies",
        "gives",
        "takes",
        "goes",
        "comes",
    ]
)

# Adjectives, participles, adverbs and prepositions that are used alone as class names. Participles in -ed and -ing are
# found by rule; this list adds the others and the exceptions.
NOT_NOUNS = frozenset(
    [
        "beside",
        "between",
        "held",
        "led",
        "told",
        "known",
        "found",
        "kept",
        "seen",
        "shown",
        "drawn",
        "given",
        "made",
        "taken",
        "lawful",
        "ready",
        "near",
        "recent",
        "free",
        "enough",
        "prior",
        "late",
        "loud",
        "plain",
        "bare",
        "whole",
        "several",
        "worst",
        "best",
        "other",
        "inside",
        "outside",
        "smooth",
        "linear",
        "raw",
    ]
)
NOUNS_IN_ED_ING = frozenset(
    [
        "spring",
        "bearing",
        "fitting",
        "string",
        "timing",
        "setting",
        "meeting",
        "ring",
        "drawing",
        "sizing",
        "tuning",
        "scaling",
        "heading",
        "coupling",
        "damping",
        "embedding",
        "recording",
        "filling",
        "reading",
        "seed",
        "speed",
        "feed",
        "sound",
        "bound",
        "round",
        "ground",
    ]
)

# The first words that a summary line must not begin with: they start an indirect question or a relative clause.
QUESTION_WORDS = ("What", "Which", "How", "Where", "Who", "Whom", "Whose", "Whether", "When", "Why", "That")
# First words that are neither an imperative or third-person verb nor the start of a plain noun phrase.
WEAK_STARTS = (
    *QUESTION_WORDS,
    "As",
    "If",
    "Of",
    "In",
    "On",
    "At",
    "By",
    "For",
    "From",
    "With",
    "Without",
    "So",
    "Such",
    "There",
    "Here",
    "To",
    "And",
    "Or",
    "But",
    "Not",
    "Nothing",
    "It",
    "They",
    "We",
    "Is",
    "Are",
    "Has",
    "Have",
)
# Inverted or archaic constructions, counted in docstrings and comments.
DIALECT = re.compile(
    r"\b(mend(?:s|ed)?|cure[sd]?|mistakes?|told|tells|said|hands? (?:on|over|back)|way in|ways in|what stands|"
    r"stands? (?:there|behind|beside|below|in|at)|whoever|whichever|hardly|beside|nobody|somebody|as it stands|"
    r"to and fro|by the clock|anew|reckon(?:s|ed)?|sought|seeks?|become of|became of|left out|asked for|"
    r"the house|floors?|rooms?|round a corner|at hand|a hair of|gives away)\b",
    re.IGNORECASE,
)


SECTION = re.compile(
    r"\n\s*(?:Parameters|Returns|Raises|Examples?|Attributes|Other Parameters|See Also|References|Yields)\n\s*-{3,}"
)


def files_in(folder: Path) -> list[Path]:
    """Return the Python files below ``folder``, without test folders."""
    return sorted(p for p in folder.rglob("*.py") if not {"tests", "test"} & set(p.relative_to(folder).parts[:-1]))


def words_in_class_name(name: str) -> list[str]:
    """Split ``CamelCase`` into lower-case words."""
    return [w.lower() for w in re.findall(r"[A-Z]+(?![a-z])|[A-Z][a-z0-9]*|[a-z0-9]+", name)]


def is_not_a_noun(name: str) -> bool:
    """Return True if the last word of a class name is an adjective, a participle or a preposition."""
    words = words_in_class_name(name.lstrip("_"))
    if not words:
        return False
    last = words[-1]
    if last in NOUNS_IN_ED_ING:
        return False
    return last in NOT_NOUNS or bool(re.fullmatch(r"[a-z]{3,}(ed|ing)", last))


def stored_names(tree: ast.AST) -> Iterator[tuple[str, int]]:
    """Yield ``(name, line)`` for each local assignment target, loop variable and parameter inside functions."""
    for function in ast.walk(tree):
        if isinstance(function, ast.Lambda | ast.FunctionDef | ast.AsyncFunctionDef):
            a = function.args
            for arg in [*a.posonlyargs, *a.args, *a.kwonlyargs, *filter(None, (a.vararg, a.kwarg))]:
                if arg.arg not in ("self", "cls"):
                    yield arg.arg, arg.lineno
    seen: set[int] = set()
    for function in ast.walk(tree):
        if isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef):
            for node in ast.walk(function):
                if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store) and id(node) not in seen:
                    seen.add(id(node))
                    yield node.id, node.lineno


def comments_in(text: str) -> Iterator[tuple[int, str]]:
    """Yield ``(line, comment)`` without directives such as ``noqa``."""
    try:
        for token in tokenize.generate_tokens(io.StringIO(text).readline):
            if token.type == tokenize.COMMENT and not re.match(r"#\s*(noqa|type:|ruff|mypy|pragma|!)", token.string):
                yield token.start[0], token.string.lstrip("# ").strip()
    except (tokenize.TokenError, IndentationError):
        return


def measure(folder: Path) -> tuple[dict[str, Any], dict[str, list[str]]]:
    """Measure one source tree; return the indicators and the hits behind them."""
    hits: dict[str, list[str]] = defaultdict(list)
    classes: dict[str, list[str]] = defaultdict(list)
    basenames: Counter[str] = Counter()
    vague: Counter[str] = Counter()
    assignments = summaries = sentences = sentence_words = words_total = n_classes = lines = 0
    for path in files_in(folder):
        text = path.read_text(encoding="utf-8", errors="replace")
        try:
            tree = ast.parse(text)
        except SyntaxError:
            continue
        lines += text.count("\n")
        where = path.relative_to(folder).as_posix()
        if path.name not in ("__init__.py", "__main__.py"):
            basenames[path.name] += 1
        for name, line in stored_names(tree):
            assignments += 1
            if name.strip("_") in VAGUE:
                vague[name] += 1
                hits["vague"].append(f"{where}:{line}: {name}")
        for node in ast.walk(tree):
            if isinstance(node, ast.ClassDef):
                n_classes += 1
                classes[node.name.lstrip("_")].append(f"{where}:{node.lineno}")
                if is_not_a_noun(node.name):
                    hits["class_not_noun"].append(f"{where}:{node.lineno}: {node.name}")
            if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
                doc = ast.get_docstring(node)
                if not doc:
                    continue
                line = getattr(node, "lineno", 1)
                summary = " ".join(doc.split("\n\n", 1)[0].split())
                summaries += 1
                start = re.match(r"[`\"'*(]*([A-Za-z][\w.-]*)?", summary)
                first = (start and start[1]) or ""
                if first in QUESTION_WORDS:
                    hits["summary_question"].append(f"{where}:{line}: {summary}")
                if first in WEAK_STARTS or not first[:1].isupper():
                    hits["summary_weak"].append(f"{where}:{line}: {summary}")
                if not summary.rstrip().endswith((".", ":", "!")):
                    hits["summary_no_stop"].append(f"{where}:{line}: {summary}")
                prose = SECTION.split(doc)[0]
                prose = re.sub(r"\.\. math::.*?(?=\n\S|\Z)", "", prose, flags=re.S)
                for sentence in re.split(r"(?<=[.!?])\s+(?=[A-Z`])|\n\s*\n", prose):
                    n = len(re.findall(r"[A-Za-z][\w'-]*", sentence))
                    if n >= 2:
                        sentences += 1
                        sentence_words += n
                words_total += len(re.findall(r"[A-Za-z][\w'-]*", doc))
                for match in DIALECT.finditer(doc):
                    hits["dialect"].append(f"{where}:{line}: {match.group(0)}")
        for line, comment in comments_in(text):
            words_total += len(re.findall(r"[A-Za-z][\w'-]*", comment))
            for match in DIALECT.finditer(comment):
                hits["dialect"].append(f"{where}:{line}: {match.group(0)}")
    twice = {name: places for name, places in classes.items() if len(places) > 1}
    hits["class_twice"] = [f"{name}: {', '.join(places)}" for name, places in sorted(twice.items())]
    crowded = {name: n for name, n in basenames.items() if n > 2}
    hits["basenames"] = [f"{name} x{n}" for name, n in sorted(crowded.items(), key=lambda item: -item[1])]
    return {
        "lines": lines,
        "assignments and parameters": assignments,
        "vague names per 1000": round(1000 * sum(vague.values()) / max(assignments, 1), 1),
        "most frequent vague names": dict(vague.most_common(12)),
        "classes": n_classes,
        "classes that are not nouns": len(hits["class_not_noun"]),
        "class names defined more than once": len(twice),
        "module basenames used more than twice": len(crowded),
        "modules under such a basename": sum(crowded.values()),
        "docstrings": summaries,
        "summaries that start with a question word": len(hits["summary_question"]),
        "... in percent": round(100 * len(hits["summary_question"]) / max(summaries, 1), 1),
        "summaries without a verb or noun phrase first": len(hits["summary_weak"]),
        "... in percent ": round(100 * len(hits["summary_weak"]) / max(summaries, 1), 1),
        "summaries without a full stop": len(hits["summary_no_stop"]),
        "mean words in a docstring sentence": round(sentence_words / max(sentences, 1), 1),
        "dialect words per 1000 words of docstrings and comments": round(
            1000 * len(hits["dialect"]) / max(words_total, 1), 1
        ),
    }, hits


def main() -> None:
    """Print the indicators of each source tree given on the command line."""
    arguments = [a for a in sys.argv[1:] if not a.startswith("--")]
    if not arguments:
        sys.exit(__doc__)
    for folder in arguments:
        values, hits = measure(Path(folder))
        if "--json" in sys.argv:
            print(json.dumps({folder: values}, indent=1))
            continue
        print(f"== {folder}")
        for name, value in values.items():
            print(f"{name.strip():58} {value}")
        if "--list" in sys.argv:
            for kind, entries in hits.items():
                print(f"-- {kind}")
                print(*entries, sep="\n")


if __name__ == "__main__":
    main()
