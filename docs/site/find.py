# SPDX-License-Identifier: GPL-3.0-or-later
"""The page find.html of the site: all text of its pages, section by section, and all names of the reference, searched
by a script in the page, without a server."""

import html
import json
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HEADING = re.compile(r'<h[1-4][^>]*>(.*?)</h[1-4]>', re.DOTALL)
ANCHOR = re.compile(r'<a class="anchor" id="([^"]+)"')


def plain(text):
    text = re.sub(r"<(script|style)\b.*?</\1>", " ", text, flags=re.DOTALL)
    text = html.unescape(re.sub(r"<[^>]*>", " ", text))
    return re.sub(r"\s+", " ", re.sub(r"</?tt>", "", text)).strip()  # Doxygen's titles have them escaped


def sections(file):
    """[address, page, heading, text] of each section of a page that Doxygen made."""
    text = file.read_text(encoding="utf-8")
    title = plain(re.search(r'<div class="title">(.*?)</div>', text, re.DOTALL).group(1))
    body = text[text.index('<div class="contents">'):text.rindex("<!-- contents -->")]
    starts = list(HEADING.finditer(body))
    yield [file.name, title, title, plain(body[:starts[0].start() if starts else len(body)])]
    for number, heading in enumerate(starts):
        end = starts[number + 1].start() if number + 1 < len(starts) else len(body)
        anchor = ANCHOR.search(heading.group(0))
        yield [f"{file.name}#{anchor.group(1)}" if anchor else file.name, title, plain(heading.group(1)),
               plain(body[heading.end():end])]


def names(tags, headers):
    """[address, kind, name, arguments] of classes, functions, constants and types, those of `headers` first."""
    public = set(re.findall(r"^(?:class|struct) (\w+)", "\n".join(p.read_text(encoding="utf-8") for p in headers),
                            re.MULTILINE))
    found = {}
    for compound in ElementTree.parse(tags).getroot():
        kind, scope, file = compound.get("kind"), compound.findtext("name"), compound.findtext("filename")
        if kind in ("class", "struct", "concept"):
            found[scope] = [file, kind, scope, ""]
        if kind in ("class", "struct", "namespace", "file"):
            for member in compound.findall("member"):
                name = member.findtext("name")
                full = name if kind == "file" else f"{scope}::{name}"
                address = f"{member.findtext('anchorfile')}#{member.findtext('anchor')}"
                found.setdefault(full, [address, member.get("kind"), full, member.findtext("arglist") or ""])
    return sorted(found.values(), key=lambda entry: public.isdisjoint(entry[2].split("::")))


def write(folder, tags, script, headers):
    """find.html in `folder`, in the frame of the page index.html."""
    folder = Path(folder)
    entries = [entry for file in sorted([*folder.glob("md_*.html"), *folder.glob("index.html"),
                                         *folder.glob("python_names.html")]) for entry in sections(file)]
    entries += names(tags, headers)
    frame = (folder / "index.html").read_text(encoding="utf-8")
    start, end = frame.index('<div class="header">'), frame.rindex("<!-- contents -->")
    data = json.dumps(entries, ensure_ascii=False, separators=(",", ":")).replace("</", "<\\/")
    body = ('<div class="header"><div class="headertitle"><div class="title">Search all text</div></div></div>\n'
            '<div class="contents"><p><label for="find-words">Words, all of which a section has:</label></p>\n'
            '<p><input id="find-words" type="search" autofocus></p>\n<p id="find-count" role="status"></p>\n'
            '<ol id="find-found"></ol>\n<noscript>The search is a script.</noscript>\n'
            f"<script>const ENTRIES = {data};\n{Path(script).read_text(encoding='utf-8')}</script>\n</div>")
    page = frame[:start] + body + frame[end:]
    page = page.replace("initNavTree('index.html'", "initNavTree('find.html'")
    (folder / "find.html").write_text(page, encoding="utf-8")
    return len(entries)
