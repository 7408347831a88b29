# SPDX-License-Identifier: Apache-2.0
"""The help of every command of a program, found from the help itself: it ends with 0, is UTF-8, has no
control characters but line ends, and shows no numbers where words are meant ("value in {earliest->0")."""
import re
import subprocess
import sys
import unicodedata


def help_of(program, words):
    done = subprocess.run([program, *words, "--help"], capture_output=True, timeout=60)
    if done.returncode != 0:
        return None, f"exit code {done.returncode}: {done.stderr[:200]!r}"
    try:
        return done.stdout.decode("utf-8"), None
    except UnicodeDecodeError as error:
        return None, f"not UTF-8: {error}"


def subcommands_in(text):
    section = re.search(r"^Subcommands:\n((?:  .*\n)+)", text, re.MULTILINE)
    return re.findall(r"^  ([a-z][a-z-]*)\b", section.group(1), re.MULTILINE) if section else []


def faults_in(text):
    for line in text.split("\n"):
        raw = [f"U+{ord(c):04X}" for c in line if unicodedata.category(c) == "Cc"]
        if raw:
            yield f"control characters {', '.join(raw)} in {line!r}"
        if re.search(r"value in \{\w+->", line):
            yield f"what stands behind words is shown: {line!r}"


def main():
    program, faults, seen = sys.argv[1], [], 0
    waiting = [[]]
    while waiting:
        words = waiting.pop()
        text, fault = help_of(program, words)
        seen += 1
        name = " ".join(["skein", *words])
        if fault:
            faults.append(f"{name}: {fault}")
            continue
        faults += [f"{name}: {one}" for one in faults_in(text)]
        waiting += [[*words, one] for one in subcommands_in(text)]
    if seen < 10:
        faults.append(f"only {seen} commands found: has the form of the help changed?")
    print("\n".join(faults) or f"{seen} commands: their help can be read")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
