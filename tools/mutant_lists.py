# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists of mutants: what tools/mutants and proofs/mutants read, and how mutants are put into a source."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RUNNING = "!std::is_constant_evaluated()"

LOOSE = re.compile(
    r"(if|for|while|else|return)\b|&&|\|\||[=<>]=|[/%<>=?,.|^]|:(?!:)|(const|auto)\b|.*(&&|\|\||[-+*/%<>=!?:,.&])$")


def is_whole(expression):
    """Whether its brackets match, no operator lacks an operand and it is not a statement: only then can it be put in
    brackets."""
    closing = []
    if "//" in expression or LOOSE.match(expression):
        return False
    for c in expression:
        if c in ";," and not closing:
            return False
        if c in "([{":
            closing.append(")]}"["([{".index(c)])
        elif c in ")]}" and (not closing or closing.pop() != c):
            return False
    return not closing


class Mutant:
    """A paragraph of a list; proofs/mutants.txt explains the marks."""

    def __init__(self, number, paragraph):
        try:
            head, old, new = paragraph.split("\n")
            self.name, places = head.rsplit(": ", 1)
            self.file, self.test = places.split(", ")
        except ValueError:
            raise SystemExit(f"not a mutant: {paragraph}") from None
        self.number, self.old, self.mark, self.new = number, old[2:], new[0], new[2:]
        if (old[0] != "-" or self.mark not in "+&!" or self.mark == "+"
            and not (is_whole(self.old) and is_whole(self.new))):
            raise SystemExit(f"not a mutant: {paragraph}")


def source_of(root, file):
    """The source that a mutant names: below src/annulus, or below src where it begins with apps/."""
    return root / ("src" if file.startswith("apps/") else "src/annulus") / file


def mutants(*lists):
    """The mutants of these lists, numbered from 1."""
    found = []
    for name in lists:
        text = (ROOT / name).read_text(encoding="utf-8")
        lines = "\n".join(line for line in text.splitlines() if not line.startswith("#"))
        found += [Mutant(len(found) + i + 1, p) for i, p in enumerate(re.split(r"\n{2,}", lines.strip("\n"))) if p]
    return found


def with_mutants(text, chosen):
    """The text of a file with all of these in it, or with the one that needs a separate build."""
    # Where one expression is inside another, the longer one comes first: it would no longer be found once the shorter
    # one has its versions.
    for old in sorted(dict.fromkeys(m.old for m in chosen), key=len, reverse=True):
        if old not in text:
            raise SystemExit(f"{chosen[0].file} has no longer: {old}")
        versions = old
        for m in (m for m in chosen if m.old == old):
            if m.mark == "!":
                versions = m.new
            elif m.mark == "&":
                versions += f" if ({RUNNING} && annulus_mutant == {m.number}) {{ {m.new} }}"
            else:
                versions = f"({RUNNING} && annulus_mutant == {m.number} ? ({m.new}) : ({versions}))"
        text = text.replace(old, versions)
    return text
