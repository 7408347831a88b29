# SPDX-License-Identifier: Apache-2.0
"""What the checks share: the declared libraries, the source files, and C++ without its comments."""
import json
import pathlib
import re
import sys

CODE = (".hpp", ".cpp")
ROOTS = ("libs", "sim", "daemons", "cli")


class Library:
    """A library as skein_add_library declared it."""

    def __init__(self, entry):
        self.name = entry["name"]
        self.directory = entry["directory"]
        self.links = list(entry["depends"])
        self.types = list(entry.get("types", []))  # whose headers it includes and which it does not link
        self.depends = self.links + self.types
        self.test_depends = list(entry.get("test_depends", []))  # what only its tests use beside them


class Architecture:
    """The file that tests/architecture/CMakeLists.txt writes."""

    def __init__(self, path):
        data = json.loads(pathlib.Path(path).read_text())
        self.source = pathlib.Path(data["source"])
        self.build_type = data["build_type"]
        self.compiler = data["compiler"]
        self.werror = data["werror"]
        self.libraries = {entry["name"]: Library(entry) for entry in data["libraries"]}

    def owner(self, relative):
        """The library in whose directory a file lies: the innermost one, or None."""
        best = None
        for library in self.libraries.values():
            if relative.startswith(library.directory + "/"):
                if best is None or len(library.directory) > len(best.directory):
                    best = library
        return best

    def closure(self, name):
        """The library and everything it depends on, in the order of declaration."""
        return self._closure_of([name])

    def test_closure(self, name):
        """Likewise, with what its tests are declared to use."""
        return self._closure_of([name, *self.libraries[name].test_depends])

    def _closure_of(self, names):
        wanted, open_names = set(), list(names)
        while open_names:
            one = open_names.pop()
            if one in wanted:
                continue
            wanted.add(one)
            open_names += self.libraries[one].depends
        return [library for library in self.libraries if library in wanted]


def code_files(source, roots=ROOTS, suffixes=CODE):
    """Paths relative to the source tree, sorted."""
    found = []
    for root in roots:
        for path in (source / root).rglob("*"):
            if path.is_file() and path.suffix in suffixes:
                found.append(path.relative_to(source).as_posix())
    return sorted(found)


def is_test(relative):
    return bool(re.search(r"(^|/)(test|tests|bench|fuzz)/", relative))


_TOKENS = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"([^()\s]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)


def without_comments(text, keep_strings=False):
    """The same lines with comments (and the insides of literals) blanked out."""

    def blank(match):
        token = match.group(0)
        lines = "\n" * token.count("\n")
        if token.startswith("//") or token.startswith("/*"):
            return lines
        if keep_strings:
            return token
        return '""' + lines if token[0] in 'R"' else "' '"

    # 1'000'000 is a number, not a literal.
    text = re.sub(r"(?<=[0-9a-fA-F])'(?=[0-9a-fA-F])", "", text)
    return _TOKENS.sub(blank, text)


def matching(code, start, step, opening, closing):
    """Where the bracket opened (or closed) at `start` ends, going by `step`; -1 if it does not."""
    depth = 0
    while 0 <= start < len(code):
        depth += {opening: 1, closing: -1}.get(code[start], 0)
        if depth == 0:
            return start
        start += step
    return -1


def finish(problems, passed):
    """Prints every problem and ends the program; `passed` is the line for when there is none."""
    for problem in problems:
        print(problem)
    if problems:
        print(f"{len(problems)} problem{'s' if len(problems) > 1 else ''}")
        sys.exit(1)
    print(passed)
