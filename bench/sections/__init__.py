# SPDX-License-Identifier: GPL-3.0-or-later
"""What bench/run measures, a file a kind of section. Each has a function that takes a Bench and yields lines of
Markdown."""
