# SPDX-License-Identifier: GPL-3.0-or-later
"""The measurements of bench/run, one file per kind of section. Each has a function that takes a Bench and yields lines
of Markdown."""
