# SPDX-License-Identifier: Apache-2.0
"""Manual pages and completion of every program against its own --help: no command and no option is missing,
groff has nothing to complain of, and bash, zsh and fish complete what a user types (zsh and fish where they are).
   check_manual.py PROGRAMS GUIDES"""
import pathlib
import re
import shutil
import subprocess
import sys

PROGRAMS, GUIDES = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
DAEMONS = ["skein-ground", "skein-ddn", "skein-sim", "skein-mavlink"]
faults = []


def run(command, text=None):
    return subprocess.run(command, input=text, capture_output=True, text=True, timeout=60)


def help_of(words):
    return run([str(PROGRAMS / words[0]), *words[1:], "--help"]).stdout


def subcommands_in(text):
    section = re.search(r"^Subcommands:\n((?:  .*\n)+)", text, re.MULTILINE)
    return re.findall(r"^  ([a-z][a-z-]*)\b", section.group(1), re.MULTILINE) if section else []


def options_in(text):
    """Of the first column of the list of options."""
    heads = re.findall(r"^  (-\S*(?:,-\S*)*)", text, re.MULTILINE)
    names = {re.sub(r"[{=].*", "", name) for head in heads for name in head.split(",")}
    return sorted(name for name in names if name.startswith("-"))


def commands_of(program):
    waiting, all_commands = [[program]], []
    while waiting:
        words = waiting.pop(0)
        text = help_of(words)
        all_commands.append((words, options_in(text), subcommands_in(text)))
        waiting += [[*words, one] for one in subcommands_in(text)]
    return all_commands


def page_text(words):
    if words[0] in DAEMONS:
        file = GUIDES / "man8" / f"{words[0]}.8"
    else:
        file = GUIDES / "man1" / ("-".join(words[:2]) + ".1")
    if not file.exists():
        faults.append(f"{file}: no such page")
        return ""
    return file.read_text()


def check_pages(commands):
    for words, options, below in commands:
        text = page_text(words).replace("\\-", "-")
        faults.extend(f"{' '.join(words)}: {one} is not on its page" for one in options if f"\\fB{one}\\fR" not in text)
        missing = [one for one in below if " ".join([*words, one]) not in text and "-".join([*words, one]) not in text]
        faults.extend(f"{' '.join(words)}: {one} is not on its page" for one in missing)


def check_groff():
    if not shutil.which("groff"):
        return
    for file in sorted(GUIDES.glob("man?/*")):
        made = run(["groff", "-man", "-Tutf8", "-Kutf8", "-ww", "-z", str(file)])
        # Without groff's whole package there is no preconv; then characters beyond ASCII are warned of.
        said = [line for line in made.stderr.splitlines() if "character" not in line and "preconv" not in line]
        faults.extend(f"groff: {line}" for line in said[:3])


def bash_answers(program, words):
    script = """
compopt() { [[ $2 == default ]] && echo "(files)"; }
source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
_%s
printf '%%s\\n' "${COMPREPLY[@]}"
""" % program.replace("-", "_")
    done = run(["bash", "-c", script, "bash", str(GUIDES / "bash" / program), *words])
    if done.returncode != 0 or done.stderr:
        faults.append(f"bash, {' '.join(words)}: {done.stderr[:200]}")
    return done.stdout.split()


def check_bash(commands):
    for words, options, below in commands:
        offered = bash_answers(words[0], [*words, "-"])
        faults.extend(f"bash, {' '.join(words)}: {one} is not offered" for one in options if one not in offered)
        if below:
            offered = bash_answers(words[0], [*words, ""])
            faults.extend(f"bash, {' '.join(words)}: {one} is not offered" for one in below if one not in offered)


def check_bash_cases():
    for words, meant in [
            (["skein", "ru"], ["run"]),
            (["skein", "run", "--virt"], ["--virtual"]),
            (["skein", "run", "x.yaml", "--out", "o", "--mc"], ["--mcap"]),
            (["skein", "spy", "--domain", "5", "ec"], ["echo"]),
            (["skein", "export", "out", "--compression", "z"], ["zstd"]),
            (["skein", "completion", "f"], ["fish"]),
            (["skein", "run", "sce"], ["(files)"]),
            (["skein", "run", "--out", ""], ["(files)"]),
            (["skein-ground", "--log-level", "w"], ["warn"]),
            (["skein-ground", "--mavlink"], ["--mavlink-out"])]:
        if (seen := bash_answers(words[0], words)) != meant:
            faults.append(f"bash, {' '.join(words)}: {seen}, not {meant}")


def check_others():
    for shell, command in [("zsh", ["zsh", "-n"]), ("fish", ["fish", "--no-execute"])]:
        if not shutil.which(shell):
            continue
        for file in sorted((GUIDES / shell).iterdir()):
            done = run([*command, str(file)])
            if done.returncode != 0:
                faults.append(f"{shell}: {file.name}: {done.stderr[:200]}")
    if shutil.which("fish"):
        for line, meant in [("skein ru", "run"), ("skein run --virt", "--virtual"), ("skein export x --compression z", "zstd")]:
            done = run(["fish", "-c", f"source {GUIDES}/fish/skein; complete -C '{line}'"])
            if not any(one.split("\t")[0] == meant for one in done.stdout.splitlines()):
                faults.append(f"fish, {line}: {done.stdout[:200]!r}, not {meant}")


def main():
    commands = [one for program in ["skein", *DAEMONS] for one in commands_of(program)]
    if len(commands) < 20 or sum(len(options) for _, options, _ in commands) < 150:
        faults.append(f"only {len(commands)} commands found: has the form of the help changed?")
    check_pages(commands)
    check_groff()
    check_bash(commands)
    check_bash_cases()
    check_others()
    print("\n".join(faults) or f"{len(commands)} commands, {sum(len(o) for _, o, _ in commands)} options: "
                              "all on their pages, all completed")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
