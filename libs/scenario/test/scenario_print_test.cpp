// SPDX-License-Identifier: Apache-2.0
// What the fingerprint of a scenario depends on, and what not.
#include "skein/scenario/scenario_print.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "skein/config/parse.hpp"
#include "testing/files.hpp"

namespace skein::scenario {
namespace {

using config::Value;
using Sections = std::vector<std::string>;
using testing::planning_scenario_with;
using testing::read_valid;
using testing::scenario_with;
using testing::TemporaryFolder;

Sections differing(const Scenario& one, const Scenario& other) {
  return print_of(one).differing(print_of(other).text()).value();
}

/// Where the small scenario with another piece differs from the one without.
Sections changed(const std::string& piece, const std::string& instead) {
  return differing(read_valid(scenario_with()), read_valid(scenario_with(piece, instead)));
}
Sections planning_changed(const std::string& piece, const std::string& instead) {
  return differing(read_valid(planning_scenario_with()),
                   read_valid(planning_scenario_with(piece, instead)));
}

std::string text_of_file(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  EXPECT_FALSE(text.str().empty()) << path;
  return text.str();
}

/// The file with every key, from the documentation.
std::string every_key() {
  const std::string page = text_of_file(SKEIN_SOURCE_DIR "/docs/scenario-format.md");
  const std::size_t begin = page.find("```yaml\nscenario: every-key") + 8;
  return page.substr(begin, page.find("\n```", begin) + 1 - begin);
}

/// The folder in which the files are that the one with every key names.
class Folder {
 public:
  Folder() {
    const std::filesystem::path from = SKEIN_SOURCE_DIR "/scenarios";
    const std::filesystem::path to = folder_.path("");
    std::filesystem::create_directory_symlink(from / "comets/models", to / "models");
    std::filesystem::create_directory_symlink(from / "domains", to / "domains");
    std::filesystem::create_directory_symlink(from / "models/interaction", to / "interaction");
  }
  Result<Scenario, Diagnostics> read(const std::string& text) const {
    return read_scenario_text(text, folder_.path("text.yaml"));
  }

 private:
  TemporaryFolder folder_;
};

/// The whole text of a document whose maps are in the order that `order` gives.
class Writer {
 public:
  using Order = std::function<void(std::vector<const config::Entry*>&)>;
  explicit Writer(Order order) : order_(std::move(order)) {}

  std::string text(const Value& value) const {
    std::ostringstream out;
    write(value, out);
    return out.str();
  }

 private:
  void write(const Value& value, std::ostream& out) const {
    switch (value.kind) {
      case Value::Kind::kNull:
        return;
      case Value::Kind::kScalar:
        out << (value.quoted ? "\"" : "") << value.scalar << (value.quoted ? "\"" : "");
        return;
      case Value::Kind::kSequence:
        out << "[ # a list\n";
        for (const Value& item : value.items) {
          write(item, out);
          out << ",\n";
        }
        out << "]";
        return;
      case Value::Kind::kMap:
        break;
    }
    std::vector<const config::Entry*> entries;
    for (const config::Entry& entry : value.entries) entries.push_back(&entry);
    order_(entries);
    out << "{\n\n";
    for (const config::Entry* entry : entries) {
      out << '"' << entry->key << "\": ";
      write(entry->value, out);
      out << ", # " << entries.size() << "\n";
    }
    out << "}";
  }

  Order order_;
};

/// Of what the order says: vehicles get their numbers by it.
bool is_ordered(const std::vector<const config::Entry*>& entries) {
  const std::set<std::string> vehicles{"marvin", "heliv", "karma"};
  return std::ranges::all_of(
      entries, [&](const config::Entry* entry) { return vehicles.contains(entry->key); });
}

/// Every number of the document with the keys that lead to it, to be changed in place.
void each_number(Value& value, std::vector<std::string>& path,
                 const std::function<void(Value&, const std::vector<std::string>&)>& visit) {
  for (config::Entry& entry : value.entries) {
    path.push_back(entry.key);
    each_number(entry.value, path, visit);
    path.pop_back();
  }
  for (Value& item : value.items) each_number(item, path, visit);
  if (value.kind != Value::Kind::kScalar || value.quoted) return;
  const bool is_number =
      value.scalar.find_first_not_of("0123456789.-") == std::string::npos && value.scalar != "-";
  if (is_number) visit(value, path);
}

TEST(ScenarioPrint, DoesNotDependOnTheOrderOfKeysOrOnCommentsAndLayout) {
  const Value document = config::parse_yaml(every_key(), "every-key").value();
  const Folder folder;
  const auto as_written = folder.read(every_key());
  ASSERT_TRUE(as_written.has_value()) << to_text(as_written.error());
  const bool holds = rc::check([&] {
    const Writer writer([](std::vector<const config::Entry*>& entries) {
      if (is_ordered(entries)) return;
      for (std::size_t i = entries.size(); i > 1; --i)
        std::swap(entries[i - 1], entries[*rc::gen::inRange<std::size_t>(0, i)]);
    });
    const std::string text = writer.text(document);
    const auto read = folder.read(text);
    RC_ASSERT(read.has_value());
    RC_ASSERT(print_of(*read) == print_of(*as_written));
  });
  EXPECT_TRUE(holds);
}

// All of them, each by a thousandth or by one.
TEST(ScenarioPrint, ChangesWithEveryNumberThatNodesMustAgreeOnInItsSection) {
  const std::map<std::string, std::string> sections{
      {"epoch", "mission"},       {"duration_limit", "mission"},
      {"seed", "mission"},        {"uavs", "vehicles"},
      {"zones", "zones"},         {"volumes", "closed air"},
      {"places", "places"},       {"objects", "objects"},
      {"radio", "radio"},         {"slots", "radio"},
      {"planning", "planning"},   {"team", "team"},
      {"separation", "planning"}, {"ground", "ground station"},
      {"origin", "world"},        {"terrain", "world"},
      {"wind", "world"}};
  const std::set<std::string> left_out{"rate", "faults", "variations", "expect", "dds"};
  Value document = config::parse_yaml(every_key(), "every-key").value();
  const Writer writer([](auto&) {});
  const Folder folder;
  const SectionPrints own = print_of(folder.read(every_key()).value());
  std::size_t tried = 0;
  std::vector<std::string> path;
  each_number(document, path, [&](Value& number, const std::vector<std::string>& keys) {
    const std::string was = number.scalar;
    const std::string& key = keys[keys.front() == "world" ? 1 : 0];
    std::optional<SectionPrints> other;
    for (const double by : {0.001, -0.001, 1.0, -1.0}) {
      if (other) break;
      const bool whole = was.find('.') == std::string::npos && std::abs(by) == 1;
      const double changed = std::stod(was) + by;
      std::ostringstream text;
      if (whole) {
        text << static_cast<std::int64_t>(changed);
      } else {
        text.precision(15);
        text << changed;
      }
      number.scalar = text.str();
      const auto read = folder.read(writer.text(document));
      if (read) other = print_of(*read);
    }
    number.scalar = was;
    if (!other) return;
    ++tried;
    const Sections differ = own.differing(other->text()).value();
    std::string where;
    for (const std::string& one : keys) where += one + " ";
    if (left_out.contains(key)) {
      EXPECT_EQ(differ, Sections{}) << where << was;
    } else {
      ASSERT_TRUE(sections.contains(key)) << key;
      EXPECT_TRUE(std::ranges::count(differ, sections.at(key)) == 1) << where << was;
    }
  });
  EXPECT_GT(tried, 200U);
}

TEST(ScenarioPrint, NamesTheSectionThatDiffers) {
  EXPECT_EQ(changed("", ""), Sections{});
  EXPECT_EQ(changed("[200, 100]", "[200, 101]"), Sections{"zones"});
  EXPECT_EQ(changed("aside: [50, 60, 70]", "aside: [50, 60, 71]"), Sections{"places"});
  EXPECT_EQ(changed("radius: 5}", "radius: 6}"), Sections{"objects"});
  EXPECT_EQ(changed("degree: 2", "degree: 1"), Sections{"vehicles"});
  EXPECT_EQ(changed("until: 40", "until: 41"), Sections{"radio"});
  EXPECT_EQ(changed("{time: 5}", "{time: 6}"), Sections{"ground station"});
  EXPECT_EQ(planning_changed("ceiling: 90", "ceiling: 91"), Sections{"closed air"});
  EXPECT_EQ(planning_changed("{karma: 100}", "{karma: 101}"), Sections{"planning"});
}

TEST(ScenarioPrint, LeavesOutWhatMayDifferBetweenMachines) {
  EXPECT_EQ(changed("scenario: small", "scenario: other"), Sections{});
  EXPECT_EQ(changed("duration_limit: 600", "duration_limit: 600\nrate: 20\ndds: cyclonedds"),
            Sections{});
  EXPECT_EQ(changed("at: 100", "at: 101"), Sections{});
  EXPECT_EQ(changed("name: flies", "name: runs"), Sections{});
}

TEST(ScenarioPrint, DoesNotDependOnWhetherADefaultIsWritten) {
  EXPECT_EQ(changed("cell: 20, base: 10}", "base: 10.0}"), Sections{});
  EXPECT_EQ(changed("start: [0, 0]}", "start: [0, 0], heading: 0, degree: 3}"), Sections{});
}

TEST(ScenarioPrint, DependsOnTheOrderOfTheVehiclesOnly) {
  const std::string two =
      "  marvin: {model: models/marvin.yaml, start: [0, 0]}\n"
      "  heliv: {model: models/heliv.yaml, start: [10, 0], degree: 2}\n";
  const std::string other_way =
      "  heliv: {model: models/heliv.yaml, start: [10, 0], degree: 2}\n"
      "  marvin: {model: models/marvin.yaml, start: [0, 0]}\n";
  EXPECT_EQ(changed(two, other_way), Sections{"vehicles"});
}

// Another order of the last digits of a computed height is not another scenario.
TEST(ScenarioPrint, DoesNotDependOnTheLastDigitsOfFigures) {
  const Scenario scenario = read_valid(scenario_with());
  Scenario other = scenario;
  for (auto& [name, place] : other.world.places)
    for (int i = 0; i < 3; ++i) place(i) = std::nextafter(place(i), 1e9);
  EXPECT_EQ(differing(scenario, other), Sections{});
  other.world.places.at("aside").x() += 1e-6;
  EXPECT_EQ(differing(scenario, other), Sections{"places"});
}

/// A copy of the COMETS files, in which one file can be changed.
class Copied : public ::testing::Test {
 protected:
  Copied() {
    const std::filesystem::path from = SKEIN_SOURCE_DIR "/scenarios";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(from)) {
      const std::string name = std::filesystem::relative(entry.path(), from).string();
      const bool wanted = name.starts_with("comets/") || name.starts_with("domains/");
      if (entry.is_regular_file() && wanted) folder_.write(name, text_of_file(entry.path()));
    }
    folder_.write("comets/text.yaml", planning_scenario_with());
  }
  Scenario read() const {
    auto read = read_scenario(folder_.path("comets/text.yaml"));
    EXPECT_TRUE(read.has_value()) << to_text(read.error());
    return read ? std::move(*read) : Scenario();
  }
  void replace(const std::string& file, const std::string& piece, const std::string& instead) {
    std::string text = text_of_file(folder_.path(file));
    const std::size_t at = text.find(piece);
    ASSERT_NE(at, std::string::npos);
    folder_.write(file, text.replace(at, piece.size(), instead));
  }
  Sections differ() const { return differing(read_valid(planning_scenario_with()), read()); }

  TemporaryFolder folder_;
};

TEST_F(Copied, FilesOfTheSameContentElsewhereAreTheSame) { EXPECT_EQ(differ(), Sections{}); }

TEST_F(Copied, WhatAModelSaysCountsAndNotHowItsFileIsCalled) {
  const std::string model = text_of_file(folder_.path("comets/models/karma.yaml"));
  folder_.write("comets/models/other.yaml", "# another name\n" + model);
  replace("comets/text.yaml", "models/karma.yaml", "models/other.yaml");
  EXPECT_EQ(differ(), Sections{});
  replace("comets/models/other.yaml", "ceiling: 200", "ceiling: 201");
  EXPECT_EQ(differ(), Sections{"vehicles"});
}

TEST_F(Copied, WhatADomainSaysCountsAndNotItsComments) {
  const std::string domain = text_of_file(folder_.path("domains/comets.lisp"));
  folder_.write("domains/comets.lisp", ";; \"another\" comment\n\n" + domain + "\n#| and | one |#");
  EXPECT_EQ(differ(), Sections{});
  const std::size_t at = domain.find("(:method");
  folder_.write("domains/comets.lisp", domain.substr(0, at) + domain.substr(at + 1));
  EXPECT_EQ(differ(), Sections{"planning"});
}

TEST_F(Copied, ASharedWorldCountsWhereverItStands) {
  const std::string world = text_of_file(folder_.path("comets/text.yaml"));
  const std::size_t begin = world.find("world:\n") + 7, end = world.find("uavs:");
  folder_.write("worlds/it.yaml", "# shared\n" + world.substr(begin, end - begin));
  folder_.write("comets/text.yaml",
                world.substr(0, begin) + "  include: ../worlds/it.yaml\n" + world.substr(end));
  EXPECT_EQ(differ(), Sections{});
  replace("worlds/it.yaml", "base: [0, 0, 0]", "base: [0, 1, 0]");
  EXPECT_EQ(std::ranges::count(differ(), "places"), 1);
}

TEST(ScenarioPrint, OfTwoTextsTheSectionsAreNamed) {
  const std::string one = print_of(read_valid(scenario_with())).text();
  const std::string other = print_of(read_valid(scenario_with("[200, 100]", "[200, 101]"))).text();
  EXPECT_EQ(differing_sections(one, other), Sections{"zones"});
  EXPECT_EQ(differing_sections(one, one), Sections{});
  EXPECT_EQ(differing_sections(one, "2" + one.substr(1)), std::nullopt);
  EXPECT_EQ(differing_sections("", other), std::nullopt);
}

}  // namespace
}  // namespace skein::scenario
