# SPDX-License-Identifier: Apache-2.0
"""A library that uses what it does not declare fails to build: shown on a project of two libraries.

    check_undeclared.py ARCHITECTURE.json SCRATCH

The libraries are declared with the project's own skein_add_library. What is built first is right; each
mutation after it takes the declaration away and uses the other library all the same.
"""
import pathlib
import subprocess
import sys

from sources import Architecture, finish

PROJECT = """cmake_minimum_required(VERSION 3.25)
project(undeclared LANGUAGES CXX)
enable_testing()
option(SKEIN_BUILD_TESTS "" ON)
list(APPEND CMAKE_MODULE_PATH "{cmake}")
include(SkeinOptions)
include(SkeinUnity)
include(SkeinLibrary)
add_subdirectory(lower)
add_subdirectory(upper)
"""
LOWER = "skein_add_library(lower SOURCES src/lower.cpp)\n"
FILES = {"lower/include/skein/lower/lower.hpp": "#pragma once\nnamespace skein::lower { int value(); struct Pair { int one = 1; }; }\n",
         "lower/src/lower.cpp": '#include "skein/lower/lower.hpp"\nint skein::lower::value() { return 1; }\n',
         "upper/include/skein/upper/upper.hpp": "#pragma once\nnamespace skein::upper { int twice(); }\n"}
INCLUDES = '#include "skein/upper/upper.hpp"\n\n#include "skein/lower/lower.hpp"\n'
NAMES = '#include "skein/upper/upper.hpp"\n\nnamespace skein::lower { int value(); }\n'
TWICE = "int skein::upper::twice() { return 2 * lower::value(); }\n"
ONE = "int skein::upper::twice() { return 2 * lower::Pair().one; }\n"
DECLARED = "skein_add_library(upper SOURCES src/upper.cpp DEPENDS lower)\n"
TYPES = "skein_add_library(upper SOURCES src/upper.cpp TYPES lower)\n"
ALONE = "skein_add_library(upper SOURCES src/upper.cpp)\n"

# name, what declares the upper library, its source, target, whether it builds, what the compiler says
CASES = [("what is declared may be used", DECLARED, INCLUDES + TWICE, "skein_upper_alone", True, ""),
         ("a type of a library that is declared for its types", TYPES, INCLUDES + ONE, "skein_upper_alone", True, ""),
         ("a function of a library that is declared for its types", TYPES, INCLUDES + TWICE, "skein_upper_alone", False,
          "skein::lower::value()"),
         ("an include without a declaration", ALONE, INCLUDES + TWICE, "skein_upper", False, "skein/lower/lower.hpp"),
         ("a name without a declaration, in the library", ALONE, NAMES + TWICE, "skein_upper", True, ""),
         ("a name without a declaration, linked alone", ALONE, NAMES + TWICE, "skein_upper_alone", False,
          "skein::lower::value()")]


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    return done.returncode, done.stdout


def main():
    architecture, scratch = Architecture(sys.argv[1]), pathlib.Path(sys.argv[2])
    write(scratch / "CMakeLists.txt", PROJECT.format(cmake=architecture.source / "cmake"))
    write(scratch / "lower/CMakeLists.txt", LOWER)
    for name, text in FILES.items():
        write(scratch / name, text)
    problems = []
    for name, declaration, source, target, builds, said in CASES:
        write(scratch / "upper/CMakeLists.txt", declaration)
        write(scratch / "upper/src/upper.cpp", source)
        code, output = run("cmake", "-S", str(scratch), "-B", str(scratch / "build"), "-G", "Ninja",
                           f"-DCMAKE_CXX_COMPILER={architecture.compiler}")
        if code == 0:
            code, output = run("cmake", "--build", str(scratch / "build"), "--target", target)
        if (code == 0) != builds or said not in output:
            problems.append(f"{name}: {target} {'builds' if code == 0 else 'does not build'}:\n{output}")
    finish(problems, f"{len(CASES)} cases: what is not declared cannot be used")


if __name__ == "__main__":
    main()
