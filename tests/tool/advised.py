# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared by the tests of `annulus advise`."""

import json

from tool import ToolTest


class AdviseTest(ToolTest):
    def advise(self, *words, warning=r"\Z"):
        """What it found; stderr begins with the pattern `warning`, by default nothing."""
        done = self.succeed("advise", *words, "--json")
        self.assertRegex(done.stderr, r"\A" + warning)
        return json.loads(done.stdout)

    def line(self, text, name):
        """The rest of the one line that begins with `name`."""
        (found,) = [line[15:] for line in text.splitlines() if line.startswith(name.ljust(15))]
        return found

    def motion(self, name, frames):
        """frames: dicts from ids to points."""
        head = "frame,id,x,y,z\n" if len(next(iter(frames[0].values()))) == 3 else "frame,id,x,y\n"
        return self.write(name, head + "".join(f"{f},{i}," + ",".join(repr(c) for c in p) + "\n"
                                               for f, frame in enumerate(frames) for i, p in frame.items()))
