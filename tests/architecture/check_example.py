# SPDX-License-Identifier: Apache-2.0
"""The scenario of docs/scenario-format.md is read without an error, and has every key that the reader knows.

    check_example.py ARCHITECTURE.json SKEIN
"""
import pathlib
import re
import subprocess
import sys
import tempfile

from sources import Architecture, finish, without_comments


def example_of(page):
    return re.search(r"```yaml\n(.*?)```", page, re.S).group(1)


def known_keys(source):
    """Every key that is asked for in the readers of a scenario; requests of operators are not in scenarios."""
    keys = set()
    for path in (source / "libs/scenario/src").glob("*.cpp"):
        if path.name == "read_request.cpp":
            continue
        text = without_comments(path.read_text(), keep_strings=True)
        for given in re.findall(r"keys\(\s*\{(.*?)\}\)", text, re.S):
            keys |= set(re.findall(r'"([a-z_]+)"', given))
        keys |= set(re.findall(r'(?:optional|required)\("([a-z_]+)"\)', text))
    return keys


def main():
    source = Architecture(sys.argv[1]).source
    example = example_of((source / "docs/scenario-format.md").read_text())
    problems = [f"docs/scenario-format.md: the example does not use the key '{key}'"
                for key in sorted(known_keys(source)) if not re.search(rf"\b{key}:", example)]
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "every-key.yaml")
        file.write_text(example)
        pathlib.Path(folder, "models").symlink_to(source / "scenarios/comets/models")
        pathlib.Path(folder, "domains").symlink_to(source / "scenarios/domains")
        pathlib.Path(folder, "interaction").symlink_to(source / "scenarios/models/interaction")
        done = subprocess.run([sys.argv[2], "run", str(file), "--check"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        problems.append(done.stderr)
    finish(problems, "the example has every key, and is read without an error")


if __name__ == "__main__":
    main()
