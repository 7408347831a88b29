# SPDX-License-Identifier: Apache-2.0
"""Sizes: functions, classes, files, mains and parameter lists stay small, and the code has tests enough; prints how they are spread.

With --list N also prints the N longest functions and the N classes with the most member functions.
"""
import math
import pathlib
import re
import sys

from classes import classes_of
from sources import Architecture, code_files, finish, is_test, matching, without_comments

FUNCTION_LINES = 60
FILE_LINES = 500
MAIN_LINES = 60
PARAMETERS = 6
MEMBER_FUNCTIONS = 40  # declared in a class; of those in large_classes.txt as many as stand there
TESTS_PER_LINE = 0.8  # of code; both without comments and empty lines

BRACES = re.compile(r"[{};]")
# What stands before the brace of a function body: a parameter list, then only what may follow one.
SIGNATURE = re.compile(
    r"\)\s*(const|noexcept(\s*\([^()]*\))?|override|final|mutable|&&?|try|\s|->\s*[\w:<>,&*\s]+)*$")
INITIALISERS = re.compile(r"\)\s*(noexcept\s*)?(try\s*)?:(?!:)(.*)$", re.S)
TYPE = re.compile(r"\b(class|struct|union|enum|namespace|concept)\b[^()=]*$")
INITIALISER = re.compile(r"(?<!operator)(?<!operator[=!<>+*/|&^%-])=\s*(\[[^\]]*\])?\s*\(?[^()]*$")
NAME = re.compile(r"(operator\s*[^\s\w]+|operator\s*\(\)|~?[\w:]+)\s*\($")


class Function:
    def __init__(self, name, first, last, parameters):
        self.name, self.first, self.last, self.parameters = name, first, last, parameters

    @property
    def lines(self):
        return self.last - self.first + 1


def parameter_list(head):
    """(start, end) of the parameter list in the text before a body, or None."""
    initialisers = INITIALISERS.search(head)
    while initialisers:  # the first ')' that a ':' follows and whose '(' follows a name
        end = initialisers.start()
        start = matching(head, end, -1, ")", "(")
        if start > 0:
            return start, end
        initialisers = INITIALISERS.search(head, end + 1)
    found = SIGNATURE.search(head)
    if not found:
        return None
    start = matching(head, found.start(), -1, ")", "(")
    return (start, found.start()) if start > 0 else None


def count_parameters(text):
    depth, count = 0, 1 if text.strip() else 0
    for character in text:
        depth += {"(": 1, "<": 1, "{": 1, "[": 1, ")": -1, ">": -1, "}": -1, "]": -1}.get(character, 0)
        count += character == "," and depth == 0
    return count


def functions_of(text):
    """Outermost functions with their bodies, from the first line of the declaration to the closing brace."""
    code = re.sub(r"^\s*#(?:[^\n]*\\\n)*[^\n]*", lambda m: "\n" * m.group(0).count("\n"), without_comments(text),
                  flags=re.M)
    at, statement, found = 0, 0, []
    while match := BRACES.search(code, at):
        at = match.end()
        if match.group(0) != "{":
            statement = at
            continue
        head = code[statement:match.start()]
        if TYPE.search(head.rsplit(")", 1)[-1]) and "(" not in head.rsplit(")", 1)[-1]:
            statement = at
            continue
        list_at = parameter_list(head)
        end = matching(code, match.start(), 1, "{", "}")
        if end < 0:
            break
        if list_at and not INITIALISER.search(head[:list_at[0]]):
            if INITIALISERS.search(head) and re.match(r"\s*[,{]", code[end + 1:]):
                at = end + 1  # the braces of a member's initialiser; the body is still to come
                continue
            found.append(function(code, head, statement, list_at, end))
            statement = at = end + 1
            catch = re.compile(r"\s*catch\s*\([^()]*\)\s*\{").match(code, at)
            while catch:  # of a function-try-block: part of the function
                end = matching(code, catch.end() - 1, 1, "{", "}")
                found[-1].last = code.count("\n", 0, end) + 1
                statement = at = end + 1
                catch = re.compile(r"\s*catch\s*\([^()]*\)\s*\{").match(code, at)
        elif "=" in head or not TYPE.search(head):
            at = end + 1  # an initialiser or a lambda outside functions
    return found


def function(code, head, statement, list_at, end):
    start = statement + len(head) - len(head.lstrip())
    name = NAME.search(head[:list_at[0] + 1])
    return Function(name.group(1) if name else "?", code.count("\n", 0, start) + 1, code.count("\n", 0, end) + 1,
                    count_parameters(head[list_at[0] + 1:list_at[1]]))


def problems_of(relative, text):
    lines = text.count("\n")
    limit = MAIN_LINES if relative.endswith("/main.cpp") else FILE_LINES
    if lines > limit:
        yield f"{relative}: {lines} lines, {limit} are allowed"
    for one in functions_of(text):
        if one.lines > FUNCTION_LINES:
            yield f"{relative}:{one.first}: {one.name} has {one.lines} lines, {FUNCTION_LINES} are allowed"
        if one.parameters > PARAMETERS:
            yield f"{relative}:{one.first}: {one.name} has {one.parameters} parameters, {PARAMETERS} are allowed"


def problems_of_classes(counts, known):
    """counts, known: (file, class) to its member functions; known are those that may have more, and may not grow."""
    for (relative, name), count in sorted(counts.items()):
        allowed = known.get((relative, name), MEMBER_FUNCTIONS)
        if count > allowed:
            yield f"{relative}: {name} declares {count} member functions, {allowed} are allowed"
    for (relative, name), allowed in sorted(known.items()):
        count = counts.get((relative, name), 0)
        if count < allowed:
            wanted = "its line is to go" if count <= MEMBER_FUNCTIONS else f"its line is to say {count}"
            yield f"large_classes.txt: {name} in {relative} declares {count} member functions by now: {wanted}"


def read_large_classes(text):
    lines = [line.split() for line in text.splitlines() if line.strip() and not line.startswith("#")]
    return {(relative, name): int(count) for relative, name, count in lines}


def problems_of_counts(code, tests):
    wanted = math.ceil(TESTS_PER_LINE * code - 1e-9)
    if tests < wanted:
        yield (f"{code} lines of code, {tests} of tests: {wanted - tests} more are needed, "
               f"{TESTS_PER_LINE} lines of tests are wanted for a line of code")


def spread(values):
    values = sorted(values)
    at = lambda share: values[min(len(values) - 1, int(share * len(values)))] if values else 0
    return f"median {at(0.5)}, p90 {at(0.9)}, p99 {at(0.99)}, most {at(1)}"


def main():
    architecture = Architecture(sys.argv[1])
    wanted = int(sys.argv[sys.argv.index("--list") + 1]) if "--list" in sys.argv else 0
    problems, sizes, longest, classes, code, tests = [], [], [], {}, 0, 0
    for relative in code_files(architecture.source, ("libs", "sim", "daemons", "cli", "tests")):
        text = (architecture.source / relative).read_text()
        problems += problems_of(relative, text)
        for one in classes_of(text):
            classes[relative, one.name] = max(one.functions, classes.get((relative, one.name), 0))
        lines = sum(1 for line in without_comments(text, keep_strings=True).splitlines() if line.strip())
        if is_test(relative):
            tests += lines
            continue
        code += lines
        sizes.append(text.count("\n"))
        longest += [(one.lines, f"{relative}:{one.first} {one.name}") for one in functions_of(text)]
    known = (pathlib.Path(__file__).parent / "large_classes.txt").read_text()
    problems += problems_of_classes(classes, read_large_classes(known))
    problems += problems_of_counts(code, tests)
    for lines, where in sorted(longest, reverse=True)[:wanted]:
        print(f"{lines:4} {where}")
    for count, relative, name in sorted(((n, *where) for where, n in classes.items()), reverse=True)[:wanted]:
        print(f"{count:4} {relative} {name}")
    print(f"functions: {spread([lines for lines, _ in longest])} lines; files: {spread(sizes)} lines; "
          f"classes: {spread(list(classes.values()))} member functions")
    finish(problems, f"{code} lines of code, {tests} of tests ({tests / code:.2f}): all within the budgets")


if __name__ == "__main__":
    main()
