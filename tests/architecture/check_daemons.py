# SPDX-License-Identifier: Apache-2.0
"""Each daemon is built of the libraries of its node and without those of the others (daemons.txt).

    check_daemons.py ARCHITECTURE.json BUILD_TREE

Asks Ninja for everything that the program is made of.
"""
import pathlib
import re
import subprocess
import sys

from sources import Architecture, finish

LIBRARY = re.compile(r"^lib/libskein_(\w+)\.a$")


def read_table(text):
    """{program: [library]} of daemons.txt."""
    lines = (line.split("#")[0].split() for line in text.splitlines())
    return {words[0]: words[1:] for words in lines if words}


def problems(table, libraries, inputs_of):
    """`inputs_of(program)`: files that it is made of, as paths in the build tree."""
    for program, without in table.items():
        built_of = {match[1] for match in map(LIBRARY.match, inputs_of(program)) if match}
        if not built_of:
            yield f"daemons.txt: {program} is built of no library"
        for library in without:
            if library not in libraries:
                yield f"daemons.txt: {program}: there is no library '{library}'"
            elif library in built_of:
                yield f"{program} is built of {library}, which its node does not run"


def main():
    architecture = Architecture(sys.argv[1])
    tree = sys.argv[2]

    def inputs_of(program):
        done = subprocess.run(["ninja", "-C", tree, "-t", "inputs", f"bin/{program}"], text=True, check=True,
                              stdout=subprocess.PIPE)
        return done.stdout.splitlines()

    table = read_table((pathlib.Path(__file__).parent / "daemons.txt").read_text())
    finish(list(problems(table, architecture.libraries, inputs_of)), f"{len(table)} daemons")


if __name__ == "__main__":
    main()
