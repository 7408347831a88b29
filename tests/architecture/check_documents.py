# SPDX-License-Identifier: Apache-2.0
"""What the documents say is what the code does: exit codes, event log, packages, links, last lines."""
import pathlib
import re
import sys

from sources import Architecture, code_files, finish, is_test, without_comments

# A line of the event log is a struct of skein/journal/lines/; `.with("field", …)` on a record is for tests.
LINES = "libs/journal/include/skein/journal/lines/"
LINE = re.compile(r"^struct (\w+) \{\n  static constexpr std::string_view kKind", re.M)
BY_HAND = re.compile(r'\.with\(\s*"[a-z_]+"\s*,')


def exit_codes_of(header):
    """{number: constant} of exit_code.hpp."""
    return {int(number): name for name, number in
            re.findall(r"inline constexpr int (\w+)\s*=\s*(\d+)", header)}


def exit_code_problems(source):
    codes = exit_codes_of((source / "libs/foundation/include/skein/foundation/exit_code.hpp").read_text())
    page = (source / "docs/exit-codes.md").read_text()
    rows = {int(number): name for number, name in re.findall(r"^\| (\d+) \| `(\w+)` \|", page, re.M)}
    for number in sorted(codes.keys() | rows.keys()):
        if codes.get(number) != rows.get(number):
            yield (f"docs/exit-codes.md: {number} is {rows.get(number, 'absent')} there, "
                   f"{codes.get(number, 'absent')} in exit_code.hpp")


def journal_line_problems(lines, files):
    """`lines`: {name: header} of all structs; `files`: (path, text) of what is no test."""
    unwritten = dict(lines)
    for relative, text in files:
        code = without_comments(text, keep_strings=True)
        if BY_HAND.search(code) and not relative.startswith(("libs/journal/", "libs/scenario/")):
            yield f"{relative}: makes a record field by field; use a struct of skein/journal/lines/"
        for name in re.findall(r"\blines::(\w+)\b", code):
            unwritten.pop(name, None)
    for name, header in sorted(unwritten.items()):
        yield f"{header}: nobody writes a {name}"


def journal_problems(source):
    lines = {name: relative for relative in code_files(source) if relative.startswith(LINES)
             for name in LINE.findall((source / relative).read_text())}
    files = ((relative, (source / relative).read_text()) for relative in code_files(source)
             if not is_test(relative) and not relative.startswith("libs/journal/"))
    yield from journal_line_problems(lines, files)


def packages_of(text):
    return [line.strip() for line in re.sub(r"#.*", "", text).splitlines() if line.strip()]


def package_problems(source):
    described = set(re.findall(r"^\| `([a-z0-9.+-]+)` \|", (source / "docs/dependencies.md").read_text(), re.M))
    listed = set()
    for path in sorted((source / "scripts").glob("packages*.txt")):
        listed |= set(packages_of(path.read_text()))
    for package in sorted(listed - described):
        yield f"docs/dependencies.md: no reason for the package {package}"
    for package in sorted(described - listed):
        yield f"docs/dependencies.md: {package} is in no scripts/packages*.txt"


def documents(source):
    found = [*source.glob("*.md"), *source.glob("docs/**/*.md"), *source.glob("docker/*.md")]
    for root in ("libs", "sim", "daemons", "cli", "idl", "tests"):
        found += source.glob(f"{root}/**/*.md")
    return sorted(found)


def link_problems(source):
    """Every relative link and image leads somewhere; every decision and page of docs/ is linked from README.md."""
    for path in documents(source):
        text = re.sub(r"```.*?```", "", path.read_text(), flags=re.S)
        for target in re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", text):
            if not re.match(r"[a-z]+:", target) and not (path.parent / target).exists():
                yield f"{path.relative_to(source)}: the link {target} leads nowhere"
    readme = (source / "README.md").read_text()
    for path in sorted(source.glob("docs/*.md")):
        if f"docs/{path.name}" not in readme:
            yield f"README.md: does not mention docs/{path.name}"


def last_line_problems(source):
    """The last lines that README.md promises are the ones the scripts print."""
    readme = (source / "README.md").read_text()
    expectations = len(re.findall(r"^  - \{name:", (source / "scenarios/comets/confirmed.yaml").read_text(), re.M))
    promised = f"{expectations} of {expectations} expectations met; report: out/comets-confirmed/report.html"
    if promised not in readme:
        yield f"README.md: the last line of ./demo is '{promised}'"
    passed = re.search(r'echo "(skein: all [^"]*)"', (source / "check").read_text())
    if not passed or passed.group(1) not in readme:
        yield "README.md: the last line of ./check is not the one it prints"


def header_problems(source):
    for relative in code_files(source, ("libs", "sim", "daemons", "cli", "tests", "idl", "cmake"),
                               (".hpp", ".cpp", ".idl", ".py")):
        lines = (source / relative).read_text().split("\n", 2)
        first = lines[1] if lines[0].startswith("#!") else lines[0]  # a script that is run by its name
        if first not in ("// SPDX-License-Identifier: Apache-2.0", "# SPDX-License-Identifier: Apache-2.0"):
            yield f"{relative}: the first line is not the licence"


CHECKS = (exit_code_problems, journal_problems, package_problems, link_problems, last_line_problems, header_problems)


def main():
    source = pathlib.Path(Architecture(sys.argv[1]).source)
    problems = []
    for check in CHECKS:
        try:
            problems += check(source)
        except (FileNotFoundError, AttributeError) as error:
            problems.append(f"{check.__name__}: {error}")
    finish(problems, f"{len(documents(source))} documents say what the code does")


if __name__ == "__main__":
    main()
