# SPDX-License-Identifier: Apache-2.0
"""One qualified name, one type: two classes of one name in two files are merged by the linker, silently.

    check_one_definition.py ARCHITECTURE.json

The functions that a compiler makes for a class (its destructor, copies) are weak symbols: of two classes
`supervisor::Plan`, one gets those of the other, wherever they were not inlined. Looked at are the classes,
structs and enumerations at the level of a named namespace; a nested class (`class Plan::Impl`) and what is
in a namespace without a name have no such twin.
"""
import re
import sys

from sources import Architecture, code_files, finish, without_comments

ROOTS = ("libs", "sim", "daemons", "cli", "tests")
# A namespace with its name, a type that is defined there, or any other brace.
_PARTS = re.compile(r"\bnamespace\b\s*([\w:]*)\s*\{"
                    r"|^[ \t]*(?:class|struct|enum(?:\s+class|\s+struct)?)\s+(\w+)(?!\s*::)(?:\s+final)?\s*(?::(?!:)[^;{}]*)?\{"
                    r"|[{}]", re.M)


def types_in(text):
    """Qualified names of the types that a file defines at the level of named namespaces."""
    open_scopes = []  # a namespace's name ("" without one), or None for any other brace
    for part in _PARTS.finditer(without_comments(text)):
        if part.group(0) == "}":
            if open_scopes:
                open_scopes.pop()
        elif part.group(0).startswith("namespace"):
            open_scopes.append(part.group(1))
        else:
            if part.group(2) and open_scopes and all(open_scopes):
                yield "::".join([*open_scopes, part.group(2)])
            open_scopes.append(None)


def one_definition_problems(texts):
    """`texts`: the text of each file by its path."""
    places = {}
    for path, text in texts.items():
        for name in types_in(text):
            places.setdefault(name, []).append(path)
    for name, found in sorted(places.items()):
        if len(found) > 1:
            yield f"{name} is defined in {' and in '.join(found)}"


def main():
    architecture = Architecture(sys.argv[1])
    texts = {path: (architecture.source / path).read_text() for path in code_files(architecture.source, ROOTS)}
    finish(list(one_definition_problems(texts)), f"{len(texts)} files define each type once")


if __name__ == "__main__":
    main()
