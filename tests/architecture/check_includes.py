# SPDX-License-Identifier: Apache-2.0
"""Includes follow the declared dependencies, these follow the layers, and pure code is pure."""
import functools
import pathlib
import re
import sys

from sources import Architecture, code_files, finish, is_test, without_comments

LAYERS = pathlib.Path(__file__).with_name("layers.txt")
KINDS = ("pure", "files", "shell")
INCLUDE = re.compile(r'^\s*#\s*include\s*(<[^>]+>|"[^"]+")', re.M)
DDS_HEADER = re.compile(r"^(fastdds|fastrtps|fastcdr|dds|ddsc|rti)/|^(ddsc|idl)\b")
DDS_ADAPTERS = re.compile(
    r"^libs/blackboard/(adapters/(fastdds|cyclonedds)/|test/|bench/)|^(libs/ros2|daemons/ros2_out)/test/")

# Sans-IO parts of libraries that are shells as a whole.
PURE_PARTS = re.compile(
    r"^libs/blackboard/(src|include|adapters/memory)/|^libs/node/src/(host|roster|virtual_runtime|mission_clock)\.cpp")

# Headers and names that pure code does not use, by what they would bring in.
FILES = (r"<(fstream|filesystem|iostream|sys/.*|unistd\.h|fcntl\.h)>",
         r"\b(std::)?(fopen|freopen|tmpfile|ifstream|ofstream|fstream)\b|\bstd::(cout|cerr|clog|cin|filesystem)\b")
CLOCKS = (r"<(time\.h|sys/time\.h)>",  # <chrono> and <ctime> also have calendars, which are no clocks
          r"\b(system_clock|steady_clock|high_resolution_clock|clock_gettime|gettimeofday|localtime|gmtime)\b"
          r"|\bstd::(time|clock)\(|\btime\((nullptr|NULL|0)\)|\bsleep_(for|until)\b|\b(usleep|nanosleep)\b")
THREADS = (r"<(thread|mutex|shared_mutex|atomic|condition_variable|future|semaphore|latch|barrier|stop_token|csignal)>",
           r"\bstd::(thread|jthread|async|mutex|atomic|promise|future|condition_variable)\b|\bthread_local\b")
CHANCE = (r"<random>", r"\b(random_device|mt19937(_64)?|default_random_engine)\b|\b(std::)?s?rand\(")
SURROUNDINGS = (r"<(spdlog/.*|netinet/.*|arpa/.*)>", r"\b(getenv|secure_getenv|spdlog::)\b|\bgetpid\b")
FORBIDDEN = {"pure": {"file": FILES, "clock": CLOCKS, "thread": THREADS, "random source": CHANCE,
                      "environment or logging": SURROUNDINGS}}
FORBIDDEN["files"] = {what: FORBIDDEN["pure"][what] for what in ("clock", "thread", "random source")}
# The one random source everybody is given, and the one place that stops the process.
EXCEPTIONS = {("libs/foundation/include/skein/foundation/random.hpp", "random source"),
              ("libs/foundation/src/random.cpp", "random source"),
              ("libs/foundation/src/contract.cpp", "file")}
# A wall clock jumps: nobody may wait by it, expire by it or decide by it. Who reads it, and what for.
WALL_CLOCK = re.compile(r"\b(system_clock|utc_clock|CLOCK_REALTIME\w*|gettimeofday|timespec_get|pthread_cond_timedwait)\b"
                        r"|\bstd::time\(|\btime\((nullptr|NULL|0)\)")
WALL_CLOCK_READERS = {
    "libs/node/src/daemon.cpp": "the number of an incarnation, where nothing is kept on disk",
    "daemons/daemon_main/src/memory.cpp": "the least number of an incarnation; on disk they are counted",
    "libs/blackboard/adapters/cyclonedds/wall_clock.hpp": "compared with the steady clock: the middleware waits by it",
    "libs/blackboard/adapters/fastdds/sightings.cpp": "when a sample was heard, beside when it says that it was sent: shown",
    "cli/spy/src/doctor/machine.cpp": "compared with the steady clock: shown",
    "cli/operate/src/operate.cpp": "the number of an operator's request",
    "daemons/ros2_out/src/ros2_out.cpp": "the number of an operator's request"}
# Namespaces of libraries that are not named after them.
NAMESPACES = {"blackboard": "blackboard|wire", "foundation": "", "negotiation": "interaction", "ground_orders": "ground_station",
              "team_translation": "translation"}


def read_layers(text):
    """{library: (kind, {allowed})}; ValueError on a line that is none."""
    layers = {}
    for line in text.splitlines():
        words = line.split("#")[0].split()
        if not words or "/" in words[0]:
            continue
        if len(words) < 2 or words[1] not in KINDS:
            raise ValueError(f"layers.txt: '{line}' is not: library kind dependencies")
        layers[words[0]] = (words[1], set(words[2:]))
    return layers


def read_rooms(text):
    """{library: {room: {rooms it may include}}}; ValueError on a room that has no line of its own."""
    rooms = {}
    for line in text.splitlines():
        words = line.split("#")[0].split()
        if words and "/" in words[0]:
            library, room = words[0].split("/")
            rooms.setdefault(library, {})[room] = set(words[1:])
    for library, known in rooms.items():
        for other in set().union(*known.values()) - set(known):
            raise ValueError(f"layers.txt: {library}/{other} has no line")
    return rooms


def room_problems(relative, text, library, rooms):
    """What a file of one room of a library includes of the other rooms."""
    known = rooms.get(library.name) if library else None
    parts = relative.removeprefix(f"{library.directory}/src/").split("/") if known else []
    if not known or not relative.startswith(f"{library.directory}/src/") or len(parts) < 2:
        return
    room = parts[0]
    if room not in known:
        yield f"{relative}: room {library.name}/{room} has no line in tests/architecture/layers.txt"
        return
    for header in includes_of(text):
        other = header.split("/")[0]
        if other in known and other != room and other not in known[room]:
            yield f"{relative}: {header}: room {room} of {library.name} must not know {other} (layers.txt)"


def layer_problems(architecture, layers):
    """Declared dependencies against the layers."""
    for library in architecture.libraries.values():
        if library.name not in layers:
            yield f"{library.directory}: library '{library.name}' has no line in tests/architecture/layers.txt"
            continue
        for other in library.depends:
            if other not in layers[library.name][1]:
                yield f"{library.directory}/CMakeLists.txt: {library.name} must not depend on {other} (layers.txt)"
    for name, (_, allowed) in layers.items():
        for other in sorted(allowed - set(layers)):
            yield f"layers.txt: {name} may depend on '{other}', which has no line"


def includes_of(text):
    return [match[1:-1] for match in INCLUDE.findall(without_comments(text, keep_strings=True))]


def include_problems(relative, text, library, architecture):
    """What one file of a library includes against what the library declares."""
    allowed = {library.name, *library.depends} if library else set(architecture.libraries)
    if library and relative.endswith("/main.cpp"):
        allowed = {"daemon_main"}  # a program, not part of the library beside it
    if library and is_test(relative):
        allowed = set(architecture.test_closure(library.name))
    for header in includes_of(text):
        if DDS_HEADER.search(header) and not DDS_ADAPTERS.search(relative):
            yield f"{relative}: {header}: DDS headers stay in libs/blackboard/adapters"
        if not header.startswith("skein/"):
            stranger = library and "." in header and private_owner(relative, header, library, architecture)
            if stranger:
                yield f"{relative}: {header}: not a header of {library.name} but of {stranger.name}; public ones are skein/{stranger.name}/…"
            continue
        other = header.split("/")[1]
        if other not in allowed:
            yield (f"{relative}: {header}: "
                   + (f"{library.name} does not declare a dependency on {other}" if other in architecture.libraries
                      else f"there is no library {other}"))


def private_owner(relative, header, library, architecture):
    """Another library in whose directory alone a header without skein/ is found; else None."""
    def holds(one):
        return header in endings_of_headers(architecture.source / one.directory)

    if (architecture.source / relative).parent.joinpath(header).is_file() or holds(library):
        return None
    return next((other for other in architecture.libraries.values() if holds(other)), None)


@functools.lru_cache(maxsize=None)
def endings_of_headers(directory):
    """Every way to name a header somewhere below a directory: its name, with one folder before it, with two, …"""
    return {"/".join(path.parts[-n:]) for path in directory.rglob("*.*") if path.is_file()
            for n in range(1, len(path.parts) - len(directory.parts) + 1)}


def purity_problems(relative, text, kind):
    """Clocks, threads, files and so on in code that must not know them."""
    code = without_comments(text)
    headers = [f"<{header}>" for header in includes_of(text)]
    for what, (header_pattern, name_pattern) in FORBIDDEN.get(kind, {}).items():
        if (relative, what) in EXCEPTIONS:
            continue
        for header in headers:
            if re.fullmatch(header_pattern, header):
                yield f"{relative}: {header} brings a {what} into {kind} code"
        for match in re.finditer(name_pattern, code):
            line = code.count("\n", 0, match.start()) + 1
            yield f"{relative}:{line}: {match.group(0)} brings a {what} into {kind} code"


def wall_clock_problems(relative, text):
    """Whoever reads the wall clock and is not known to."""
    if is_test(relative) or "/bench/" in relative or relative in WALL_CLOCK_READERS or not WALL_CLOCK.search(text):
        return
    code = without_comments(text)
    for match in WALL_CLOCK.finditer(code):
        line = code.count("\n", 0, match.start()) + 1
        yield f"{relative}:{line}: {match.group(0)} reads a clock that jumps (check_includes.py says who may)"


def kind_of(relative, library, layers):
    if library is None or relative.endswith("/main.cpp") or is_test(relative):
        return "shell"
    return "pure" if PURE_PARTS.search(relative) else layers.get(library.name, ("shell",))[0]


def unused_problems(architecture, used):
    """Dependencies that are declared and not needed."""
    for library in architecture.libraries.values():
        for other in sorted(set(library.depends) - used[library.name]):
            yield f"{library.directory}/CMakeLists.txt: {library.name} declares {other} and does not use it"


def main():
    architecture = Architecture(sys.argv[1])
    layers, rooms = read_layers(LAYERS.read_text()), read_rooms(LAYERS.read_text())
    problems = list(layer_problems(architecture, layers))
    used = {name: set() for name in architecture.libraries}
    files = code_files(architecture.source)
    for relative in files:
        text = (architecture.source / relative).read_text()
        library = architecture.owner(relative)
        problems += include_problems(relative, text, library, architecture)
        problems += room_problems(relative, text, library, rooms)
        problems += purity_problems(relative, text, kind_of(relative, library, layers))
        problems += wall_clock_problems(relative, text)
        if library and not is_test(relative):
            used[library.name] |= used_by(text, library)
    problems += unused_problems(architecture, used)
    finish(problems, f"{len(files)} files of {len(architecture.libraries)} libraries: includes follow the layers")


def used_by(text, library):
    """Declared dependencies that a file includes or whose namespace it names."""
    headers, code = includes_of(text), without_comments(text)
    return {other for other in library.depends
            if any(header.startswith(f"skein/{other}/") for header in headers)
            or any(f"{other}.hpp" == header for header in headers)
            or re.search(rf"\b({NAMESPACES.get(other, other)})::", code)}


if __name__ == "__main__":
    main()
