# SPDX-License-Identifier: Apache-2.0
"""The checks find what they are for, and nothing in code that is right."""
import json
import pathlib
import sys
import tempfile
import unittest

import check_budgets
import check_daemons
import check_documents
import check_headers_alone
import check_includes
import check_one_definition
import classes
import sources


def architecture(**libraries):
    """libraries: name=[depends]; all live in libs/<name> of a source tree that does not exist."""
    entries = [{"name": name, "directory": f"libs/{name}", "depends": depends} for name, depends in libraries.items()]
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump({"source": "/nowhere", "build_type": "Release", "compiler": "c++", "werror": "ON",
                   "libraries": entries}, file)
        file.flush()
        return sources.Architecture(file.name)


class Comments(unittest.TestCase):
    def test_comments_and_literals_are_blanked_and_lines_stay(self):
        text = 'int a; // std::thread\n/* x\n y */ int b = 1\'000; const char* c = "{ // }"; char d = \'{\';\nR"(a " {)";'
        code = sources.without_comments(text)
        self.assertEqual(text.count("\n"), code.count("\n"))
        for gone in ("thread", "{", "}"):
            self.assertNotIn(gone, code)
        self.assertIn("1000", code)


class HeadersAlone(unittest.TestCase):
    def problems(self, **texts):
        """Of the header `one`."""
        headers = {f"skein/{name}.hpp": text for name, text in texts.items()}
        reached = check_headers_alone.Includes(headers).all_of("skein/one.hpp")
        return list(check_headers_alone.standard_problems("skein/one.hpp", texts["one"], reached))

    def test_a_name_comes_with_its_header(self):
        self.assertEqual([], self.problems(one="#include <vector>\nstd::vector<int> a;\n"))
        self.assertEqual(["skein/one.hpp: vector without <vector>"], self.problems(one="#include <map>\nstd::vector<int> a;\n"))

    def test_or_with_one_of_ours_that_has_it(self):
        self.assertEqual([], self.problems(one='#include "skein/two.hpp"\nstd::set<int> a;\n', two='#include "skein/three.hpp"\n',
                                           three="#include <set>\n"))

    def test_eigen_and_expected_likewise(self):
        self.assertEqual(["skein/one.hpp: Eigen without <Eigen/Core>", "skein/one.hpp: tl without <tl/expected.hpp>"],
                         self.problems(one="Eigen::Vector2d a;\ntl::expected<int, int> b;\n"))

    def test_what_no_table_has_is_said(self):
        self.assertIn("Add it", self.problems(one="std::frobnicator a;\n")[0])

    def test_what_a_unit_includes_first_is_built_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder, "one.cpp")
            unity = pathlib.Path(folder, "unity.cxx")
            source.write_text('#include "skein/one.hpp"\n#include "skein/two.hpp"\n')
            unity.write_text(f'/* several */\n#include "{source}"\n#include "{folder}/two.cpp"\n')
            self.assertEqual("skein/one.hpp", check_headers_alone.first_include(source))
            self.assertEqual("skein/one.hpp", check_headers_alone.first_include(unity))
            self.assertIsNone(check_headers_alone.first_include(pathlib.Path(folder, "none.cpp")))

    def test_comments_use_nothing(self):
        self.assertEqual([], self.problems(one="// std::vector\n"))


class OneDefinition(unittest.TestCase):
    def problems(self, **texts):
        return list(check_one_definition.one_definition_problems(texts))

    def test_two_types_of_one_name_are_told_with_both_files(self):
        self.assertEqual(["skein::a::Plan is defined in one and in two"],
                         self.problems(one="namespace skein::a {\nclass Plan {\n};\n}", two="namespace skein::a {\nstruct Plan : Base {};\n}"))

    def test_of_another_namespace_they_are_two(self):
        self.assertEqual([], self.problems(one="namespace skein::a {\nclass Plan {};\n}", two="namespace skein::b {\nclass Plan {};\n}"))

    def test_declarations_and_nested_types_are_none(self):
        self.assertEqual([], self.problems(one="namespace skein::a {\nclass Plan { struct Part {}; };\n}",
                                           two="namespace skein::a {\nclass Plan;\nclass Plan::Impl {};\nclass Other { struct Part {}; };\n}"))

    def test_nor_is_what_has_no_linkage(self):
        self.assertEqual([], self.problems(one="namespace skein::a {\nnamespace {\nclass Plan {};\n}\n}", two="namespace skein::a {\nclass Plan {};\n}"))

    def test_functions_between_them_do_not_matter(self):
        self.assertEqual(["skein::a::Plan is defined in one and in two"],
                         self.problems(one="namespace skein::a {\nint f() { if (true) { return 1; } }\nclass Plan {};\n}",
                                       two="namespace skein::a {\nenum class Plan : int { kOne };\n}"))


class Includes(unittest.TestCase):
    def setUp(self):
        self.architecture = architecture(foundation=[], world=["foundation"], executive=["foundation"])

    def problems(self, relative, text):
        return list(check_includes.include_problems(relative, text, self.architecture.owner(relative), self.architecture))

    def test_a_declared_dependency_may_be_included(self):
        self.assertEqual([], self.problems("libs/world/src/a.cpp", '#include "skein/foundation/time.hpp"\n'))

    def test_an_undeclared_one_may_not(self):
        self.assertIn("does not declare", self.problems("libs/executive/src/a.cpp", '#include "skein/world/wind.hpp"\n')[0])

    def test_a_commented_include_is_none(self):
        self.assertEqual([], self.problems("libs/executive/src/a.cpp", '// #include "skein/world/wind.hpp"\n'))

    def test_dds_headers_stay_in_the_adapters(self):
        dds = "#include <fastdds/dds/domain/DomainParticipant.hpp>\n"
        self.assertIn("adapters", self.problems("libs/world/src/a.cpp", dds)[0])
        self.assertEqual([], self.problems("libs/blackboard/adapters/fastdds/a.cpp", dds))

    def test_a_private_header_stays_in_its_library(self):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder)
            for header in ("libs/one/src/room/mine.hpp", "libs/two/src/room/theirs.hpp"):
                (source / header).parent.mkdir(parents=True)
                (source / header).touch()
            two = architecture(one=["two"], two=[])
            two.source = source
            owner = lambda header: check_includes.private_owner("libs/one/src/a.cpp", header, two.libraries["one"], two)
            self.assertIsNone(owner("room/mine.hpp"))
            self.assertIsNone(owner("gtest/gtest.h"))
            self.assertIsNone(owner("heirs.hpp"))
            self.assertEqual("two", owner("room/theirs.hpp").name)
            self.assertEqual("two", owner("theirs.hpp").name)

    def test_layers_hold_against_declarations(self):
        layers = check_includes.read_layers("foundation pure\nworld pure foundation\nexecutive pure\n")
        problems = list(check_includes.layer_problems(self.architecture, layers))
        self.assertEqual(1, len(problems))
        self.assertIn("executive must not depend on foundation", problems[0])

    def test_a_library_without_a_layer_is_a_problem(self):
        layers = check_includes.read_layers("foundation pure\nworld pure foundation\n")
        self.assertIn("no line", list(check_includes.layer_problems(self.architecture, layers))[0])

    def test_pure_code_has_no_clock_thread_file_or_chance(self):
        for text in ("auto t = std::chrono::steady_clock::now();", "#include <thread>\n", "std::ofstream out;",
                     "std::mt19937 r;", "if (getenv(name)) {}", "std::cout << 1;", "int x = rand();"):
            self.assertTrue(list(check_includes.purity_problems("libs/world/src/a.cpp", text, "pure")), text)

    def test_words_that_only_look_like_it_are_fine(self):
        text = 'int operand(int time); // the wall clock\nauto s = "std::thread"; std::string brand(5, 0);'
        self.assertEqual([], list(check_includes.purity_problems("libs/world/src/a.cpp", text, "pure")))

    def test_code_that_reads_files_still_has_no_clock(self):
        self.assertEqual([], list(check_includes.purity_problems("a.cpp", "#include <fstream>\n", "files")))
        self.assertTrue(list(check_includes.purity_problems("a.cpp", "std::chrono::system_clock::now()", "files")))

    def test_who_reads_the_wall_clock_is_known(self):
        for text in ("auto t = std::chrono::system_clock::now();", "clock_gettime(CLOCK_REALTIME, &t);", "time(nullptr)"):
            self.assertTrue(list(check_includes.wall_clock_problems("libs/node/src/host.cpp", text)), text)
            self.assertEqual([], list(check_includes.wall_clock_problems("libs/node/src/daemon.cpp", text)))
        for text in ("std::chrono::steady_clock::now()", "clock_gettime(CLOCK_MONOTONIC, &t);", "mission_time(now)"):
            self.assertEqual([], list(check_includes.wall_clock_problems("libs/node/src/host.cpp", text)), text)
        for relative in check_includes.WALL_CLOCK_READERS:
            text = (pathlib.Path(__file__).parents[2] / relative).read_text()
            self.assertTrue(check_includes.WALL_CLOCK.search(text), f"{relative} does not read it any more")

    def test_a_room_includes_itself_and_what_its_line_names(self):
        rooms = check_includes.read_rooms("world pure\nworld/low\nworld/high  low\n")

        def problems(relative, text):
            return list(check_includes.room_problems(relative, text, self.architecture.owner(relative), rooms))

        self.assertEqual([], problems("libs/world/src/high/a.cpp", '#include "high/b.hpp"\n#include "low/c.hpp"\n'))
        self.assertIn("must not know high", problems("libs/world/src/low/a.cpp", '#include "high/b.hpp"\n')[0])
        self.assertIn("no line", problems("libs/world/src/attic/a.cpp", "")[0])
        self.assertEqual([], problems("libs/world/src/a.cpp", '#include "high/b.hpp"\n'))
        self.assertEqual([], problems("libs/world/test/low/a.cpp", '#include "high/b.hpp"\n'))
        self.assertEqual([], problems("libs/executive/src/low/a.cpp", '#include "high/b.hpp"\n'))

    def test_rooms_that_are_named_have_a_line_and_go_in_no_circle(self):
        self.assertRaises(ValueError, check_includes.read_rooms, "world/low  high\n")
        for library, known in check_includes.read_rooms(check_includes.LAYERS.read_text()).items():
            done = set()
            while len(done) < len(known):
                ready = {room for room, others in known.items() if others <= done} - done
                self.assertTrue(ready, f"a circle among the rooms {set(known) - done} of {library}")
                done |= ready

    def test_the_layers_file_is_sound(self):
        layers = check_includes.read_layers(check_includes.LAYERS.read_text())
        for name in ("functional", "temporal", "htn"):
            self.assertLessEqual(layers[name][1], {"foundation", "config"})
        self.assertEqual({"foundation", "functional"}, layers["executive"][1])
        done = set()
        for name, (_, allowed) in layers.items():  # each line names only lines above it or below: no circle
            self.assertNotIn(name, allowed)
        while len(done) < len(layers):
            ready = {name for name, (_, allowed) in layers.items() if allowed <= done} - done
            self.assertTrue(ready, f"a circle among {set(layers) - done}")
            done |= ready


class Daemons(unittest.TestCase):
    def problems(self, table, **built_of):
        return list(check_daemons.problems(check_daemons.read_table(table), ["sim", "console"],
                                           lambda program: built_of[program.replace("-", "_")]))

    def test_a_daemon_without_what_it_does_not_run_is_right(self):
        self.assertEqual([], self.problems("skein-sim console # the page\n", skein_sim=["lib/libskein_sim.a", "a.o"]))

    def test_a_daemon_with_it_is_a_problem(self):
        found = self.problems("skein-sim console\n", skein_sim=["lib/libskein_sim.a", "lib/libskein_console.a"])
        self.assertEqual(["skein-sim is built of console, which its node does not run"], found)

    def test_names_that_are_no_library_or_no_program_are_problems(self):
        found = self.problems("skein-sim nothing\n", skein_sim=[])
        self.assertEqual(2, len(found))


class Budgets(unittest.TestCase):
    def names(self, text):
        return [(one.name, one.lines, one.parameters) for one in check_budgets.functions_of(text)]

    def test_functions_methods_and_constructors_are_found_with_their_lengths(self):
        text = """
namespace a { struct B : C {
  B(int x, std::map<int, int> y) : x_{x}, y_(y) {
    f();
  }
  bool operator==(const B&) const = default;
  B& operator=(B&& o) noexcept {
    return *this;
  }
  int x_{}; };
enum class E { kA, kB };
const std::vector<int> kList = {1, 2};
auto D::get(int a,
            int b) const -> std::optional<int> {
  if (a) { return {}; }
  for (;;) {}
  auto l = [&](int q) { return q; };
}
template <class T> requires std::same_as<T, int> void g(T) { }
} """
        self.assertEqual([("B", 3, 2), ("operator=", 3, 1), ("D::get", 6, 2), ("g", 1, 1)], self.names(text))

    def test_a_function_try_block_counts_as_one(self):
        self.assertEqual([("f", 4, 0)], self.names("int f() try {\n  g();\n} catch (...) {\n}\n"))

    def test_a_long_function_a_long_file_and_many_parameters_are_problems(self):
        long = "void f() {\n" + "  g();\n" * 60 + "}\n"
        self.assertIn("has 62 lines", list(check_budgets.problems_of("a.cpp", long))[0])
        self.assertIn("501 lines", list(check_budgets.problems_of("a.cpp", "\n" * 501))[0])
        self.assertIn("61 lines", list(check_budgets.problems_of("x/main.cpp", "\n" * 61))[0])
        self.assertIn("7 parameters", list(check_budgets.problems_of("a.cpp", "void f(int,int,int,int,int,int,int) {}"))[0])
        self.assertEqual([], list(check_budgets.problems_of("a.cpp", "void f() {\n" + "  g();\n" * 58 + "}\n")))

    def functions(self, text):
        return {one.name: one.functions for one in classes.classes_of(text)}

    def test_all_that_a_class_declares_counts_private_and_with_bodies(self):
        self.assertEqual({"A": 11}, self.functions("""
class A final : public std::vector<int>, private B<int> {
 public:
  A();
  explicit A(int x, std::map<int, int> y = {}) : x_{x}, y_(std::move(y)) { f(); }
  ~A() = default;
  A& operator=(const A&) = delete;
  bool operator()(int) const { return true; }
  explicit operator bool() const;
  [[nodiscard]] virtual std::function<void(int)> f(
      const std::vector<double>& heights = {0}) const = 0;
  template <class T> requires std::same_as<T, int> void g(T t) { h({t}); }

 private:
  static constexpr auto kMost = std::min(3, 4);
  void h() const;
  auto i() -> int { if (x_) { return 1; } return 2; }
  // void commented();
  int j() const noexcept(true) { return 0; }
  friend void swap(A& a, A& b);
  using F = void (*)(int);
  std::function<bool(const A&, int)> k_;
  void (*l_)(int) = nullptr;
  int x_{}, z_ = f(1);
  std::map<int, int> y_;
};"""))

    def test_nested_classes_count_for_themselves(self):
        self.assertEqual({"A": 1, "B": 2, "C": 0}, self.functions(
            "class A { struct B { void f(); void g() {} } b_{}; enum class E { kA }; void h(); struct C { int x = 0; }; };"))

    def test_a_class_with_too_many_member_functions_is_a_problem(self):
        self.assertEqual([], list(check_budgets.problems_of_classes({("a.hpp", "A"): 40}, {})))
        self.assertIn("A declares 41", list(check_budgets.problems_of_classes({("a.hpp", "A"): 41}, {}))[0])

    def test_one_that_is_known_to_be_large_may_shrink_and_not_grow(self):
        known = check_budgets.read_large_classes("# as they are\na.hpp A 45\n")
        found = lambda count: list(check_budgets.problems_of_classes({("a.hpp", "A"): count}, known))
        self.assertEqual([], found(45))
        self.assertIn("45 are allowed", found(46)[0])
        self.assertIn("is to say 44", found(44)[0])
        self.assertIn("is to go", found(40)[0])
        self.assertIn("is to go", list(check_budgets.problems_of_classes({}, known))[0])

    def test_code_without_tests_enough_is_told_how_many_lines_it_lacks(self):
        self.assertEqual([], list(check_budgets.problems_of_counts(0, 0)))
        self.assertEqual([], list(check_budgets.problems_of_counts(1000, 800)))
        self.assertEqual([], list(check_budgets.problems_of_counts(5, 4)))
        self.assertIn("1 more are needed", list(check_budgets.problems_of_counts(1000, 799))[0])
        self.assertIn("1 more are needed", list(check_budgets.problems_of_counts(1001, 800))[0])


class Documents(unittest.TestCase):
    def test_lines_of_the_log_are_structs_that_somebody_writes(self):
        files = [("libs/node/src/a.cpp", "log(lines::Reach{peer, true});")]
        found = list(check_documents.journal_line_problems({"Reach": "radio.hpp", "Lost": "radio.hpp"}, files))
        self.assertEqual(["radio.hpp: nobody writes a Lost"], found)

    def test_a_record_made_field_by_field_is_a_problem(self):
        files = [("libs/node/src/a.cpp", 'Record(at, "sim", "reach").with("peer", peer)')]
        self.assertIn("field by field", list(check_documents.journal_line_problems({}, files))[0])

    def test_exit_codes_are_read(self):
        self.assertEqual({0: "kExitOk", 1: "kExitNegative"}, check_documents.exit_codes_of(
            "inline constexpr int kExitOk = 0;  ///< x\ninline constexpr int kExitNegative =\n    1;\n"))

    def test_comments_in_package_lists_are_no_packages(self):
        self.assertEqual(["a", "b"], check_documents.packages_of("# x\na  # y\n\nb\n"))


if __name__ == "__main__":
    sys.path.insert(0, str(pathlib.Path(__file__).parent))
    unittest.main(argv=[sys.argv[0]])
