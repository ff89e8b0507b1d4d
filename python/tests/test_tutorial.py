# SPDX-License-Identifier: GPL-3.0-or-later
"""README.md and docs/: their Python is run, block after block, as one program for each section; and it prints what it
says."""

import contextlib
import importlib.util
import io
import os
import re
from pathlib import Path

import pytest

SOURCE = Path(os.environ.get("ANNULUS_SOURCE", Path(__file__).resolve().parents[2]))
NEEDS = re.compile(r"<!-- needs: (\w+) -->")


def sections():
    """Of each section that has code: its page, what must be installed for it, and its blocks with what they print."""
    for page in [SOURCE / "README.md", *sorted(SOURCE.glob("docs/*.md"))]:
        for section in re.split(r"^## ", page.read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]:
            blocks = re.findall(r"^```(python|text)\n(.*?)^```", section, flags=re.MULTILINE | re.DOTALL)
            if any(language == "python" for language, _ in blocks):
                yield pytest.param(page, NEEDS.findall(section), blocks, id=f"{page.name}: {section.splitlines()[0]}")


@pytest.mark.parametrize("page, needs, blocks", list(sections()))
def test_section(page, needs, blocks, tmp_path, monkeypatch):
    for name in needs:
        if importlib.util.find_spec(name) is None:
            pytest.skip(f"{name} is not installed")
    monkeypatch.chdir(tmp_path)
    names, printed = {"__name__": "tutorial"}, ""
    for language, text in blocks:
        if language == "python":
            output = io.StringIO()
            with contextlib.redirect_stdout(output):
                exec(compile(text, str(page), "exec"), names)
            printed = output.getvalue()
        else:
            assert printed == text
