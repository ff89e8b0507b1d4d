# SPDX-License-Identifier: GPL-3.0-or-later
"""The page `python_names` of the site: public names of the Python package, with signatures and docstrings, from the
sources (nothing is imported)."""

import ast
from pathlib import Path


def public(body):
    return [node for node in body
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)) and not node.name.startswith("_")]


def overloaded(node):
    return any(ast.unparse(d).endswith("overload") for d in getattr(node, "decorator_list", ()))


def signature(node, prefix=""):
    if any(ast.unparse(d).endswith("property") for d in node.decorator_list):
        return prefix + node.name
    arguments = ast.unparse(node.args)
    arguments = arguments.removeprefix("self, ") if arguments != "self" else ""
    returns = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    return f"{prefix}{node.name}({arguments}){returns}"


def entry(level, title, shown, text):
    fence = "~~~~"
    return f"{'#' * level} {title}\n\n{fence}{{.unparsed}}\n{shown}\n\n{text}\n{fence}\n\n"


class Package:
    """Public names of a folder of Python files; what `__init__` lists, and the modules without underscore."""

    def __init__(self, folder):
        self.trees = {p.stem: ast.parse(p.read_text(encoding="utf-8"))
                      for p in sorted(Path(folder).glob("*.py*")) if p.suffix in (".py", ".pyi")}
        self.named = {}
        for name, tree in self.trees.items():
            for node in tree.body:
                # The implementation follows its overloads; Python before the stub of what is compiled.
                if isinstance(node, (ast.ClassDef, ast.FunctionDef)) and not overloaded(node):
                    if name != "_core" or node.name not in self.named:
                        self.named[node.name] = node

    def members(self, node, seen):
        """Public members of a class and of its bases, the nearest first."""
        for member in public(node.body):
            if member.name not in seen and not overloaded(member):
                seen.add(member.name)
                yield member
        for base in node.bases:
            parent = self.named.get(ast.unparse(base).split("[")[0].split(".")[-1])
            if parent is not None:
                yield from self.members(parent, seen)

    def item(self, name, node):
        text = ast.get_docstring(node) or ""
        if isinstance(node, ast.FunctionDef):
            return entry(3, name, signature(node), text)
        start = next((m for m in node.body if isinstance(m, ast.FunctionDef) and m.name in ("__new__", "__init__")
                      and not overloaded(m)), None)
        shown = f"class {name}"
        if start is not None:
            arguments = ast.unparse(start.args).split(", ", 1)
            shown += f"({arguments[1] if len(arguments) > 1 else ''})"
        out = entry(3, name, shown, text)
        for member in self.members(node, set()):
            out += entry(4, f"{name}.{member.name}", signature(member) if isinstance(member, ast.FunctionDef)
                         else f"class {member.name}", ast.get_docstring(member) or "")
        return out

    def page(self):
        tree = self.trees["__init__"]
        listed = next(ast.literal_eval(node.value) for node in tree.body
                      if isinstance(node, ast.Assign) and node.targets[0].id == "__all__")
        out = "# Python: names {#python_names}\n\nDocstrings of the package, as `help()` shows them. "
        out += "[docs/python.md](@ref md_docs_python) is the tutorial.\n\n## annulus\n\n"
        out += "".join(self.item(name, self.named[name]) for name in listed if name in self.named)
        for name, module in self.trees.items():
            if not name.startswith("_"):
                out += f"## annulus.{name}\n\n"
                out += "".join(self.item(f"{name}.{node.name}", node) for node in public(module.body)
                               if not overloaded(node))
        return out
