# SPDX-License-Identifier: Apache-2.0
"""The help of every command of a program, found from the help itself: it ends with 0, is UTF-8, has no
control characters but line ends, and shows no numbers where words are meant ("value in {earliest->0").
And every command comes to the program that carries it out, as far as an error of its own."""
import re
import subprocess
import sys
import unicodedata


# Arguments with which each command ends at once, for want of a file mostly; None: it listens to DDS for seconds
# first (`cli/operate` and tests/dds start those).
NO_FILE = ["/nonexistent"]
ENDS_AT_ONCE = {
    "allocate": NO_FILE, "batch": NO_FILE, "compare": NO_FILE * 2, "completion": ["bash"], "export": NO_FILE,
    "functional": [*NO_FILE, "--virtual"], "import": NO_FILE, "judge": NO_FILE, "manual": ["/dev/null/pages"],
    "mastn": ["run", *NO_FILE, "--algorithm", "cip"], "mle": NO_FILE, "model": ["check", *NO_FILE],
    "model edit": [*NO_FILE, "--port", "0"], "operate": None, "plan": NO_FILE, "refine": NO_FILE, "replay": NO_FILE,
    "report": NO_FILE, "run": NO_FILE, "series": NO_FILE, "spy": ["play", *NO_FILE], "state": ["show", *NO_FILE],
    "status": None, "stn": ["check", *NO_FILE], "storm": ["--laws"], "terrain": ["show", *NO_FILE],
}


def fault_of_carrying_out(program, command, arguments):
    """A command that nobody takes, or that comes to a program that does not carry it out."""
    try:
        done = subprocess.run([program, *command.split(), *arguments], capture_output=True, timeout=10, text=True)
    except subprocess.TimeoutExpired:
        return None  # it serves a page
    said = done.stdout + done.stderr
    if "start `skein`" in said or "cannot be started" in said or not said.strip():
        return f"skein {command}: comes to nobody who carries it out: {said.strip()!r}"
    return None


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


def faults_below_zero(program, words, text):
    """Whole numbers from 0 that take one below."""
    for option in re.findall(r"^  (?:-\w,)?(--[a-z-]+) UINT", text, re.MULTILINE):
        done = subprocess.run([program, *words, option, "-3"], capture_output=True, timeout=60, text=True)
        if done.returncode == 0 or "-3" not in done.stdout + done.stderr:
            yield f"{option} takes -3: {done.stderr[:200]!r}"


WRONG_WORDS = {
    "rn": "there is no command 'rn'; did you mean 'run'?",
    "frobnicate": "there is no command 'frobnicate'",
    "run --virtul a.yaml": "there is no option '--virtul'; did you mean '--virtual'?",
    "operate --domain 5 taek marvin": "there is no command 'taek'; did you mean 'take'?",
    "operate --interface 10.0.0.1 10.0.0.2 take marvin --intrupt": "there is no option '--intrupt'; did you mean '--interrupt'?",
    "run a.yaml --console 99999": "--console: '99999': expected ADDRESS:PORT, with a port from 0 to 65535",
    "replay out/a --console 127.0.0.1:port": "--console: '127.0.0.1:port': expected ADDRESS:PORT, with a port from 0 to 65535",
    "spy ech": "there is no command 'ech'; did you mean 'echo'?",
}


def faults_of_wrong_words(program):
    """What is no command and no option is said, with the nearest that is one."""
    for words, expected in WRONG_WORDS.items():
        done = subprocess.run([program, *words.split()], capture_output=True, timeout=60, text=True)
        if done.returncode != 2 or expected not in done.stderr.splitlines():
            yield f"skein {words}: {done.returncode}, {done.stderr[:200]!r}"


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
        faults += [f"{name}: {one}" for one in [*faults_in(text), *faults_below_zero(program, words, text)]]
        waiting += [[*words, one] for one in subcommands_in(text)]
        if len(words) == 1 and words[0] not in ENDS_AT_ONCE:
            faults.append(f"{name}: ENDS_AT_ONCE does not say how it ends at once")
    for command, arguments in ENDS_AT_ONCE.items():
        fault = arguments is not None and fault_of_carrying_out(program, command, arguments)
        if fault:
            faults.append(fault)
    faults += faults_of_wrong_words(program)
    if seen < 10:
        faults.append(f"only {seen} commands found: has the form of the help changed?")
    print("\n".join(faults) or f"{seen} commands: their help can be read")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
