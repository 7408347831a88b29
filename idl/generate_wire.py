#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the plain structs of the wire (libs/blackboard/include/skein/blackboard/wire_*.hpp) from
idl/*.idl, which say everything once; the subset of IDL and the comments it reads are in README.md.
    idl/generate_wire.py            writes what has changed
    idl/generate_wire.py --check    writes nothing; exit 1 when something would be written
    idl/generate_wire.py --idl DIR --out DIR"""
import argparse
import difflib
import re
import sys
from dataclasses import dataclass, field
from pathlib import Path

CLASSES = ("state", "event", "stream")  # in the order of the slots
TYPES = {"boolean": "bool", "octet": "std::uint8_t", "float": "float", "double": "double",
         "string": "std::string",
         "unsigned long": "std::uint32_t", "unsigned long long": "std::uint64_t",
         "long": "std::int32_t", "long long": "std::int64_t"}
# Of OMG IDL 4.2, and what the compilers of Debian 12 make of it in C++.
KEYWORDS = set("""abstract any alias attribute bitfield bitmask bitset boolean case char component connector const consumes
    context custom default double exception emits enum eventtype factory false finder fixed float getraises getter home
    import in inout interface local long manages map mirrorport module multiple native object octet oneway out port
    porttype primarykey private provides public publishes raises readonly setraises sequence short string struct supports
    switch true truncatable typedef typeid typename typeprefix union unsigned uses valuebase valuetype void wchar wstring
    int8 uint8 int16 int32 int64 uint16 uint32 uint64""".split())
WIDTH = 100
MARK = "// Written by idl/generate_wire.py from idl/{}: change that, and run it."


class Mistakes(Exception):
    """All that is wrong in the IDL, a line each."""


@dataclass
class Field:
    kind: str
    name: str
    default: str | None
    comment: str | None
    doc: list


@dataclass
class Type:
    name: str
    source: str  # state, of state.idl
    header: str  # wire_state.hpp
    is_slot: bool
    doc: list
    literals: list = field(default_factory=list)  # (C++ name, name for people, comment)
    fields: list = field(default_factory=list)

    @property
    def is_enum(self):
        return bool(self.literals)


@dataclass
class Wire:
    types: dict = field(default_factory=dict)
    headers: dict = field(default_factory=dict)  # name -> lines about the file

    def slots(self):
        return [t for of in CLASSES for t in self.types.values() if t.is_slot and t.source == of]


class Reader:
    """One IDL file, line by line."""

    SKIPPED = re.compile(r"|// .*|#include .*|module \w+ \{|@final")
    OPENED = re.compile(r"(enum|struct) (\w+)( : \w+)? \{")
    TAIL = r"(?:  //= (?P<default>[^/]+?))?(?:  ///< (?P<comment>.+))?"
    LITERAL = re.compile(r"  [A-Z]+_(?P<name>[A-Z_]+),?" + TAIL)
    FIELD = re.compile(r"  (?:@key )?(?P<type>[\w<> ]+) (?P<name>\w+);" + TAIL)

    def __init__(self, path, wire, mistakes):
        self.path, self.wire, self.mistakes = path, wire, mistakes
        self.header, self.doc, self.open, self.final = None, [], None, False

    def read(self):
        for number, line in enumerate(self.path.read_text().splitlines(), 1):
            problem = self.take(line)
            if problem:
                self.mistakes.append(f"{self.path}:{number}: {problem}")

    def take(self, line):
        if line.strip().startswith("/// "):
            self.doc.append(line.strip())
            return None
        if self.open:
            return self.inside(line)
        if line.startswith("//% "):
            return self.about_the_header(line[4:])
        final, self.final = self.final, line == "@final"
        if opened := self.OPENED.fullmatch(line):
            return self.begin(*opened.groups(), final)
        if line == "};" or self.SKIPPED.fullmatch(line):
            return None
        return f"'{line}'; expected an enum, a struct or a comment"

    def about_the_header(self, text):
        if re.fullmatch(r"wire_\w+\.hpp", text):
            self.header = text
            self.wire.headers.setdefault(text, [])
        elif self.header is None:
            return "no header was named before, as in //% wire_state.hpp"
        else:
            self.wire.headers[self.header].append(text)
        return None

    def begin(self, kind, name, base, final):
        self.open = Type(name, self.path.stem, self.header, base is not None, self.doc)
        self.kind, self.doc = kind, []
        if self.header is None:
            return "the header it goes to is not named: //% wire_NAME.hpp"
        if name in self.wire.types:
            return f"'{name}' is there already, in {self.wire.types[name].source}.idl"
        if base and base != " : SampleHeader":
            return f"'{name}' extends '{base[3:]}'; expected SampleHeader, which makes it a slot, or nothing"
        if kind == "struct" and not final:
            return f"'{name}' is not final; expected a line @final before it: the two IDL compilers differ else"
        if base and self.path.stem not in CLASSES:
            return f"a slot; expected in one of {', '.join(f'{c}.idl' for c in CLASSES)}"
        return None

    def inside(self, line):
        if line == "};":
            self.wire.types[self.open.name] = self.open
            done, self.open = self.open, None
            return None if done.literals or done.fields or done.is_slot else f"'{done.name}' is empty"
        return self.literal(line) if self.kind == "enum" else self.member(line)

    def literal(self, line):
        found = self.LITERAL.fullmatch(line)
        if not found:
            return f"'{line.strip()}'; expected PREFIX_NAME, with //= \"what people read\" if it differs"
        words = found["name"].lower().split("_")
        shown = (found["default"] or "-".join(words)).strip('"')
        self.open.literals.append(("k" + "".join(map(str.capitalize, words)), shown, found["comment"]))
        return None

    def member(self, line):
        found = self.FIELD.fullmatch(line)
        if not found:
            return f"'{line.strip()}'; expected TYPE NAME; with //= DEFAULT and ///< what it means"
        kind = re.fullmatch(r"sequence<(.+)>", found["type"])
        inner = kind[1] if kind else found["type"]
        if inner not in TYPES and inner not in self.wire.types:
            return f"'{inner}' is no type; expected one of {', '.join(TYPES)}, or one declared before"
        if found["name"].lower() in KEYWORDS:
            return f"'{found['name']}' is a word of IDL; expected another name, as sequence_number for sequence"
        if any(found["name"].lower() == one.name.lower() for one in self.open.fields):
            return f"'{found['name']}' is there already, but for capital letters"
        self.open.fields.append(
            Field(found["type"], found["name"], found["default"], found["comment"], self.doc))
        self.doc = []
        return None


def read(folder):
    wire, mistakes = Wire(), []
    for name in ("common", *CLASSES):
        Reader(folder / f"{name}.idl", wire, mistakes).read()
    if mistakes:
        raise Mistakes("\n".join(mistakes))
    return wire


class Writer:
    """The headers, as lines."""

    def __init__(self, wire):
        self.wire = wire

    def files(self):
        files = {name: self.header(name) for name in self.wire.headers}
        files["wire_slots.hpp"] = self.slots()
        return {name: "\n".join(lines) + "\n" for name, lines in files.items()}

    def header(self, name):
        types = [t for t in self.wire.types.values() if t.header == name]
        lines = self.top(types[0].source + ".idl", self.wire.headers[name], self.includes(name, types))
        for one in types:
            lines += ["", *one.doc, *(self.enum(one) if one.is_enum else self.struct(one))]
        return lines + ["", "}  // namespace skein::wire"]

    @staticmethod
    def top(source, about, includes):
        return ["// SPDX-License-Identifier: Apache-2.0", *[f"// {line}" for line in about],
                MARK.format(source), "// clang-format off", "#pragma once", "", *includes, "",
                "namespace skein::wire {"]

    def includes(self, name, types):
        used = {self.wire.types[inner].header for t in types for f in t.fields
                if (inner := re.sub(r"sequence<(.+)>", r"\1", f.kind)) in self.wire.types}
        if any(t.is_slot for t in types):
            used.add(self.wire.types["SampleHeader"].header)
        own = sorted(used - {name}) or ["wire_fields.hpp"]
        standard = ["array", "cstdint", "string", "string_view", "vector"]
        text = "\n".join(line for t in types for line in (self.enum(t) if t.is_enum else self.struct(t)))
        needed = [s for s in standard if re.search(r"std::(to_array|u?int\d+_t)" if s in ("array", "cstdint")
                                                   else rf"std::{s}\b", text)]
        if "std::to_array" not in text and "array" in needed:
            needed.remove("array")
        return [*[f"#include <{s}>" for s in needed], "", *[f'#include "skein/blackboard/{h}"' for h in own]]

    @staticmethod
    def remark(text):
        return f"  ///< {text}" if text else ""

    def enum(self, one):
        lines = [f"enum class {one.name} : std::uint32_t {{"]
        lines += [f"  {name},{self.remark(comment)}" for name, _, comment in one.literals]
        names = [f'"{shown}"' for _, shown, _ in one.literals]
        return lines + ["  kCount", "};", f"constexpr auto names_of({one.name}) {{",
                        *wrapped("  return std::to_array<std::string_view>({", names, "});"), "}"]

    def struct(self, one):
        lines = [f"struct {one.name} {{"]
        if one.is_slot:
            lines.append("  SampleHeader header;")
        for each in one.fields:
            lines += [f"  {line}" for line in each.doc]
            default = each.default or self.default(each.kind)
            value = f" = {default}" if default else ""
            lines.append(f"  {self.cpp(each.kind)} {each.name}{value};{self.remark(each.comment)}")
        lines += [f"  bool operator==(const {one.name}&) const = default;", "};"]
        names = [one.name, *(["header"] if one.is_slot else []), *[f.name for f in one.fields]]
        return lines + wrapped("SKEIN_WIRE_FIELDS(", names, ")")

    def cpp(self, kind):
        if inner := re.fullmatch(r"sequence<(.+)>", kind):
            return f"std::vector<{self.cpp(inner[1])}>"
        return TYPES.get(kind, kind)

    def default(self, kind):
        if kind in TYPES:
            return {"string": None, "boolean": "false"}.get(kind, "0")
        declared = self.wire.types.get(kind)
        return f"{kind}::{declared.literals[0][0]}" if declared and declared.is_enum else None

    def slots(self):
        slots = self.wire.slots()
        names = [s.name for s in slots]
        includes = ["#include <array>", "#include <cstdint>", "#include <string_view>", "#include <variant>", "",
                    *[f'#include "skein/blackboard/{h}"' for h in sorted({s.header for s in slots})]]
        last = {of: [s.name for s in slots if s.source == of][-1] for of in CLASSES}
        return [
            *self.top("*.idl", ["All slots, in their order: states, events, streams; in each class as in its IDL."],
                      includes), "",
            "/// The value of one slot. The order of the alternatives is the order of `Slot`.",
            *wrapped("using SampleVariant = std::variant<", names, ">;"), "", *SAMPLE, "",
            *wrapped("enum class Slot : std::uint8_t {", [f"k{n}" for n in names], "};"), "",
            "/// By slot; also those of the IDL types and of the DDS topics.",
            *wrapped("inline constexpr auto kSlotNames = std::to_array<std::string_view>({",
                     [f'"{n}"' for n in names], "});"), "",
            "/// Source: spec 1.3, the table of delivery classes.",
            "enum class SlotClass : std::uint8_t { kState, kEvent, kStream };", "",
            "constexpr SlotClass slot_class(Slot slot) {",
            f"  if (slot <= Slot::k{last['state']}) return SlotClass::kState;",
            f"  return slot <= Slot::k{last['event']} ? SlotClass::kEvent : SlotClass::kStream;", "}", "",
            "/// `macro(Type)` for each slot.",
            *wrapped("#define SKEIN_FOR_EACH_SLOT(macro) ", [f"macro({n})" for n in names], "", separator="",
                     ending=" \\"),
            "", "}  // namespace skein::wire"]


# A variant of that many structs takes seconds to compile wherever it is copied: it is copied in one place.
SAMPLE = """\
/// A SampleVariant whose copies, moves and end are compiled once (wire.cpp), not wherever one is kept.
class Sample : public SampleVariant {
 public:
  using SampleVariant::SampleVariant;
  using SampleVariant::operator=;
  Sample();
  Sample(const Sample& other);
  Sample(Sample&& other) noexcept;
  Sample& operator=(const Sample& other);
  Sample& operator=(Sample&& other) noexcept;
  ~Sample();
};""".splitlines()


def wrapped(before, items, after, separator=",", ending=""):
    """before items after, in lines of at most WIDTH; each but the last ends with `ending`."""
    lines = [before]
    for number, item in enumerate(items):
        text = item + (after if number + 1 == len(items) else separator)
        gap = "" if lines[-1].endswith(("(", "{", "<", " ")) or lines[-1] == "    " else " "
        if len(lines[-1]) + len(gap) + len(text) + len(ending) > WIDTH:
            lines.append("    ")
            gap = ""
        lines[-1] += gap + text
    return [line.rstrip() + ending for line in lines[:-1]] + [lines[-1].rstrip()]


def write(files, out, check):
    """Whether all was as it should be."""
    fresh = True
    for name, text in files.items():
        path = out / name
        before = path.read_text() if path.exists() else ""
        if before == text:
            continue
        fresh = False
        if check:
            change = list(difflib.unified_diff(before.splitlines(), text.splitlines(), str(path), "from idl/", lineterm=""))
            print("\n".join(change[:40]), file=sys.stderr)
        else:
            path.write_text(text)
            print(f"written: {path}")
    return fresh


def main():
    here = Path(__file__).resolve().parent
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--check", action="store_true", help="only say what would be written")
    arguments.add_argument("--idl", type=Path, default=here, help="folder of common, state, event and stream.idl")
    arguments.add_argument("--out", type=Path, default=here.parent / "libs/blackboard/include/skein/blackboard")
    given = arguments.parse_args()
    try:
        fresh = write(Writer(read(given.idl)).files(), given.out, given.check)
    except Mistakes as mistakes:
        print(mistakes, file=sys.stderr)
        return 2
    if given.check and not fresh:
        print("the structs of the wire are not those of idl/: run idl/generate_wire.py", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
