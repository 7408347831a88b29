# SPDX-License-Identifier: Apache-2.0
"""Each public header compiles alone, with nothing but what its library declares.

    check_headers_alone.py ARCHITECTURE.json COMPILE_COMMANDS.json [LIBRARY…]

Headers are compiled over the precompiled header of the build, which takes a third of the time; those that a
unit of their library includes first were compiled so by the build. What the precompiled header
would hide, a forgotten header of the standard library, of Eigen or of tl::expected, is looked for in the text:
each name that a header uses comes with a header that it, or one of ours that it includes, includes.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

from sources import Architecture, finish, without_comments

ONCE = re.compile(r"^\s*#\s*pragma\s+once\b", re.M)
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)
NAME = re.compile(r"\bstd::(\w+)|\b(Eigen|tl)::")

# Where names of the standard library (and, last, of other namespaces) come from: any of the headers.
PROVIDERS = {
    "algorithm": "clamp copy count_if equal fill find find_if max max_element min min_element none_of any_of all_of sort transform",
    "any": "any any_cast",
    "array": "array to_array",
    "atomic": "atomic atomic_bool",
    "bit": "bit_cast endian",
    "bitset": "bitset",
    "chrono": "chrono",
    "cmath": "abs atan2 cos fabs floor hypot isfinite isnan pow sin sqrt",
    "condition_variable": "condition_variable",
    "cstdint": "int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t",
    "cstddef": "byte nullptr_t",
    "cstring": "memcpy memcmp",
    "deque": "deque",
    "filesystem": "filesystem",
    "functional": "function greater hash less",
    "initializer_list": "initializer_list",
    "iosfwd": "istream ostream ostringstream",
    "iterator": "back_inserter begin end",
    "limits": "numeric_limits",
    "list": "list",
    "map": "map multimap",
    "memory": "make_shared make_unique shared_ptr unique_ptr weak_ptr",
    "mutex": "lock_guard mutex unique_lock",
    "optional": "in_place nullopt nullopt_t optional",
    "queue": "priority_queue queue",
    "random": "mt19937_64",
    "set": "set multiset",
    "span": "span",
    "string": "erase erase_if string to_string",
    "string_view": "string_view",
    "thread": "thread",
    "tuple": "apply tie tuple",
    "type_traits": "decay_t enable_if_t integral_constant is_aggregate_v is_arithmetic_v is_base_of_v is_convertible_v is_enum_v is_integral_v is_same_v remove_const_t "
                   "remove_cvref_t type_identity underlying_type_t",
    "concepts": "convertible_to same_as",
    "unordered_map": "unordered_map",
    "unordered_set": "unordered_set",
    "utility": "as_const exchange forward index_sequence index_sequence_for make_index_sequence move pair swap",
    "variant": "get get_if holds_alternative monostate variant variant_size_v visit",
    "vector": "erase erase_if vector",
    "tl/expected.hpp": "tl",
    "Eigen/Core": "Eigen",
}
# What else has them: headers that are specified to, or that nobody can do without.
ALSO = {
    "iosfwd": {"ostream", "istream", "iostream", "sstream", "fstream", "string"},
    "functional": {"string", "set", "map", "memory"},      # less, hash
    "utility": {"map", "tuple", "optional", "variant", "vector", "memory", "string", "functional", "array"},  # move, pair
    "initializer_list": {"vector", "string", "map", "set", "utility"},
    "optional": {"utility", "variant", "any"},              # in_place
    "variant": {"array", "tuple", "utility"},               # get
    "string_view": {"string"},
    "Eigen/Core": {"Eigen/Dense", "Eigen/Geometry"},
    "iterator": {"vector", "string", "map", "set", "array", "span", "deque", "list"},
    "chrono": {"thread", "condition_variable"},
    "concepts": {"iterator"},
}
ANYWHERE = {"size_t"}  # of every container


def first_errors(output):
    lines = [line for line in output.splitlines() if re.search(r"error|Error|undefined", line)]
    return "\n    ".join((lines or output.splitlines()[-5:])[:5])


def providers_of(name):
    """The headers a name may come from; empty for one that the table does not have."""
    found = {header for header, names in PROVIDERS.items() if name in names.split()}
    return found.union(*(ALSO.get(header, set()) for header in found))


class Includes:
    """What public headers include, directly and by others of ours. `texts`: {"skein/…": text}."""

    def __init__(self, texts):
        self.direct = {name: set(INCLUDE.findall(text)) for name, text in texts.items()}

    def all_of(self, name):
        reached, open_names = set(), [name]
        while open_names:
            for one in self.direct.get(open_names.pop(), ()):
                if one not in reached:
                    reached.add(one)
                    open_names.append(one)
        return reached


def standard_problems(name, text, reached):
    """Names used in a header whose own header it does not reach."""
    used = {std or other for std, other in NAME.findall(without_comments(text))} - ANYWHERE
    for one in sorted(used):
        wanted = providers_of(one)
        if not wanted:
            yield f"{name}: where does std::{one} come from? Add it to PROVIDERS"
        elif not wanted & reached:
            yield f"{name}: {one} without <{min(wanted & PROVIDERS.keys())}>"


def first_include(unit):
    """The header that is read first where this source, or unity of sources, is compiled; None if there is none."""
    path = pathlib.Path(unit)
    while path.exists():
        found = INCLUDE.search(path.read_text())
        if not found or not found[1].startswith("/"):
            return found and found[1]
        path = pathlib.Path(found[1])
    return None


class Headers:
    """The public headers of one library and how they are compiled."""

    def __init__(self, architecture, commands, name, work):
        self.name = name
        self.work = work
        self.directory = architecture.source / architecture.libraries[name].directory
        self.entries = [entry for entry in commands if f"/skein_{name}.dir/" in entry["command"]]
        self.built = {first_include(entry["file"]) for entry in self.entries}
        include = self.directory / "include"
        self.texts = {path.relative_to(include).as_posix(): path.read_text() for path in sorted(include.rglob("*.hpp"))}

    def problems(self, includes):
        if self.texts and not self.entries:
            yield f"{self.name}: no compile command"
            return
        for relative, text in self.texts.items():
            if not ONCE.search(text):
                yield f"{self.name}: {relative} has no #pragma once"
            yield from standard_problems(relative, text, includes.all_of(relative))
            if relative not in self.built:
                yield from self.compile_problems(relative)

    def compile_problems(self, relative):
        source = self.work / self.name / f"{relative.replace('/', '_')}.cpp"
        source.parent.mkdir(parents=True, exist_ok=True)
        source.write_text(f'#include "{relative}"\n')
        done = subprocess.run([*self.compile_command(), "-fsyntax-only", "-c", source], text=True, check=False,
                              cwd=self.entries[0]["directory"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            yield f"{self.name}: {relative} does not compile alone:\n    {first_errors(done.stdout)}"

    def compile_command(self):
        """That of the library's sources, without its private directory."""
        words = shlex.split(self.entries[0]["command"])
        private = f"-I{self.directory}/src"
        return [word for word in words[:words.index("-o")] if word != private]


def main():
    architecture = Architecture(sys.argv[1])
    commands = json.loads(pathlib.Path(sys.argv[2]).read_text())
    work = pathlib.Path(sys.argv[2]).resolve().parent / "headers_alone"
    every = {name: Headers(architecture, commands, name, work) for name in architecture.libraries}
    includes = Includes({relative: text for one in every.values() for relative, text in one.texts.items()})
    libraries = [every[name] for name in sys.argv[3:] or every]
    with concurrent.futures.ThreadPoolExecutor(max_workers=max(1, len(os.sched_getaffinity(0)))) as pool:
        results = pool.map(lambda one: list(one.problems(includes)), libraries)
        problems = [problem for result in results for problem in result]
    finish(problems, f"{sum(len(one.texts) for one in libraries)} public headers compile alone")


if __name__ == "__main__":
    main()
