# SPDX-License-Identifier: Apache-2.0
"""idl/generate_wire.py: what it makes of an IDL, and what it says of one that is wrong."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

GENERATOR = pathlib.Path(__file__).resolve().parents[2] / "idl/generate_wire.py"

COMMON = """//% wire_common.hpp
//% What is shared.

@final
struct SampleHeader {
  @key unsigned long origin;
  long long expires;  //= kNever  ///< [ns] not to be handled after it
};

enum DoorState {
  DOOR_OPEN,
  DOOR_LEFT_AJAR,  ///< nobody closed it
  DOOR_SHUT  //= "SHUT TIGHT"
};

};
"""
STATE = """//% wire_state.hpp
//% States.

/// A door of the house.
@final
struct Door : SampleHeader {
  string name;
  DoorState state;  //= DoorState::kShut
  /// Who went through it.
  sequence<string> through;
};

//% wire_garden.hpp
//% The garden.

@final
struct Gate : SampleHeader {
  sequence<DoorState> states;
};

};
"""
EVENT = """//% wire_event.hpp
//% Events.

@final
struct Knock : SampleHeader {
  double loudness;  ///< [dB]
};
"""
STREAM = """//% wire_stream.hpp
//% Streams.

@final
struct Draught : SampleHeader {
};
"""


class Generator(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.idl = pathlib.Path(self.folder.name)
        self.idl_of(common=COMMON, state=STATE, event=EVENT, stream=STREAM)

    def idl_of(self, **files):
        for name, text in files.items():
            (self.idl / f"{name}.idl").write_text(text)

    def run_it(self, *options):
        return subprocess.run([sys.executable, "-B", str(GENERATOR), "--idl", str(self.idl), "--out", str(self.idl),
                               *options], capture_output=True, text=True, check=False)

    def header(self, name):
        run = self.run_it()
        self.assertEqual(run.returncode, 0, run.stderr)
        return (self.idl / name).read_text()

    def complains(self, message, **files):
        self.idl_of(**files)
        run = self.run_it()
        self.assertEqual(run.returncode, 2)
        self.assertIn(message, run.stderr)
        self.assertFalse(list(self.idl.glob("*.hpp")), "nothing is written of an IDL that is wrong")

    def test_a_slot_has_its_header_its_documents_and_the_value_that_it_starts_with(self):
        self.assertIn("""/// A door of the house.
struct Door {
  SampleHeader header;
  std::string name;
  DoorState state = DoorState::kShut;
  /// Who went through it.
  std::vector<std::string> through;
  bool operator==(const Door&) const = default;
};
SKEIN_WIRE_FIELDS(Door, header, name, state, through)
""", self.header("wire_state.hpp"))

    def test_enumerators_lose_their_prefix_and_have_names_for_people(self):
        text = self.header("wire_common.hpp")
        self.assertIn("  kOpen,\n  kLeftAjar,  ///< nobody closed it\n  kShut,\n  kCount\n", text)
        self.assertIn('{"open", "left-ajar", "SHUT TIGHT"}', text)

    def test_a_default_is_written_as_given(self):
        self.assertIn("  std::int64_t expires = kNever;  ///< [ns] not to be handled after it\n",
                      self.header("wire_common.hpp"))

    def test_what_is_under_another_heading_is_in_another_header_that_includes_what_it_needs(self):
        text = self.header("wire_garden.hpp")
        self.assertIn('#include "skein/blackboard/wire_common.hpp"', text)
        self.assertIn("  std::vector<DoorState> states;\n", text)
        self.assertNotIn("Gate", self.header("wire_state.hpp"))

    def test_slots_are_in_the_order_of_their_classes(self):
        text = self.header("wire_slots.hpp")
        self.assertIn("std::variant<Door, Gate, Knock, Draught>", text)
        self.assertIn("if (slot <= Slot::kGate) return SlotClass::kState;", text)
        self.assertIn("slot <= Slot::kKnock ? SlotClass::kEvent", text)

    def test_what_is_fresh_is_left_alone_and_what_is_not_is_told(self):
        self.assertEqual(self.run_it("--check").returncode, 1)
        self.run_it()
        self.assertEqual(self.run_it("--check").returncode, 0)
        self.idl_of(event=EVENT.replace("loudness", "noise"))
        stale = self.run_it("--check")
        self.assertEqual(stale.returncode, 1)
        self.assertIn("+  double noise = 0;", stale.stderr)
        self.assertIn("loudness", (self.idl / "wire_event.hpp").read_text())

    def test_what_the_two_compilers_would_not_take_alike_is_refused_with_its_line(self):
        self.complains("event.idl:4: 'Knock' is not final", event=EVENT.replace("@final\n", ""))
        self.complains("event.idl:5: 'Knock' extends 'SampleHeaders'; expected SampleHeader",
                       event=EVENT.replace("SampleHeader", "SampleHeaders"))
        self.complains("event.idl:6: 'sequence' is a word of IDL", event=EVENT.replace("loudness", "sequence"))
        self.complains("event.idl:7: 'Loudness' is there already",
                       event=EVENT.replace("[dB]\n", "[dB]\n  double Loudness;\n"))

    def test_a_type_that_nobody_declared_is_refused_with_its_line(self):
        self.complains("state.idl:7: 'text' is no type", state=STATE.replace("  string name", "  text name"))

    def test_a_line_that_is_no_field_is_refused(self):
        self.complains("event.idl:6: 'double;  ///< [dB]'; expected TYPE NAME;", event=EVENT.replace("double loudness;", "double;"))

    def test_a_name_given_twice_is_refused(self):
        self.complains("event.idl:5: 'Door' is there already, in state.idl", event=EVENT.replace("Knock", "Door"))

    def test_a_slot_among_what_is_shared_is_refused(self):
        self.complains("common.idl:5: a slot; expected in one of",
                       common=COMMON.replace("struct SampleHeader {", "struct Oddity : SampleHeader {"))

    def test_everything_wrong_is_told_at_once(self):
        self.idl_of(state=STATE.replace("  string name", "  text name"), event=EVENT.replace("double loudness;", "double;"))
        run = self.run_it()
        self.assertIn("state.idl:7", run.stderr)
        self.assertIn("event.idl:6", run.stderr)


if __name__ == "__main__":
    unittest.main()
