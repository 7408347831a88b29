# SPDX-License-Identifier: Apache-2.0
"""Classes of C++ and how many member functions they declare: of any access, with constructors, operators and those in the class body."""
import re

from sources import matching, without_comments

CLASS = re.compile(r"(?<!enum )\b(?:class|struct)\s+(?:\[\[[^\]]*\]\]\s*)?([\w:]+)(?:\s*<[^;{}()]*>)?(?:\s+final)?"
                   r"\s*(?::(?!:)[^;{}()]*)?\{")
NESTED = re.compile(r"\b(class|struct|union|enum)\b[^()]*$")
OPERATOR = re.compile(r"\boperator\s*(?:\(\s*\)|\[\s*\]|[^\w\s(]+|[\w:<>\s*&]+)")
ACCESS = re.compile(r"\b(public|protected|private)\s*:(?!:)")
NO_FUNCTION = re.compile(r"\s*(friend|using|typedef|static_assert|enum)\b")
WITH_BRACKETS = re.compile(r"\[\[.*?\]\]|\b(alignas|decltype|explicit|noexcept)\s*\([^()]*\)")
ANGLES = re.compile(r"<[^<>]*>")


class Class:
    def __init__(self, name, first, functions):
        self.name, self.first, self.functions = name, first, functions


def declares_a_function(declaration):
    """Whether what stands in a class up to a semicolon or a body declares a member function."""
    declaration = ACCESS.sub(" ", declaration)
    if NO_FUNCTION.match(declaration):
        return False
    declaration = WITH_BRACKETS.sub(" ", OPERATOR.sub("operator_", declaration))
    while ANGLES.search(declaration):  # types, which may have the parameters of a function in them
        declaration = ANGLES.sub(" ", declaration)
    return bool(re.search(r"\w\s*\((?!\s*\*)", declaration.split("=")[0]))


def functions_in(body):
    """Of the inside of a class; nested classes have their own."""
    count, at, start, depth = 0, 0, 0, 0
    while at < len(body):
        depth += {"(": 1, ")": -1}.get(body[at], 0)
        if body[at] == ";" and depth == 0:
            count += declares_a_function(body[start:at])
            start = at + 1
        elif body[at] == "{":
            head, end = body[start:at], matching(body, at, 1, "{", "}")
            if end < 0:
                break
            initialises = depth > 0 or re.match(r"\s*[,{]", body[end + 1:])  # the body comes later, if there is one
            if not initialises and not NESTED.search(head) and declares_a_function(head):
                count += 1
                start = end + 1
            elif not initialises:  # up to the semicolon: a variable, or the name of a nested class
                body = body[:start] + " " * (end + 1 - start) + body[end + 1:]
            at = end
        at += 1
    return count


def classes_of(text):
    """All classes and structures with their bodies, nested ones and those in functions too."""
    code = without_comments(text)
    for match in CLASS.finditer(code):
        end = matching(code, match.end() - 1, 1, "{", "}")
        if end >= 0:
            yield Class(match.group(1), code.count("\n", 0, match.start()) + 1, functions_in(code[match.end():end]))
