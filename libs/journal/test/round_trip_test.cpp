// SPDX-License-Identifier: Apache-2.0
// Laws of every kind of line: what was written is read back, and what is no such line is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/journal/hand_on.hpp"
#include "skein/journal/kinds.hpp"
#include "skein/journal/lines/deliberation.hpp"
#include "skein/journal/lines/execution.hpp"
#include "skein/journal/lines/joint.hpp"
#include "skein/journal/lines/mission.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/journal/lines/run.hpp"
#include "skein/journal/lines/team.hpp"
#include "skein/journal/lines/truth.hpp"

namespace skein::journal {
namespace {

/// Any value of the type of a field, of every magnitude; of an optional one also none.
class AnyField {
 public:
  explicit AnyField(std::uint64_t seed) : random_(seed) {}

  void operator()(const char*, bool& to) { to = random_.chance(0.5); }
  void operator()(const char*, std::int64_t& to) {
    to = static_cast<std::int64_t>(random_.bits() >> random_.below(64));
    if (random_.chance(0.5)) to = -to;
  }
  void operator()(const char*, std::uint64_t& to) { to = random_.bits() >> random_.below(64); }
  void operator()(const char*, double& to) {
    to =
        random_.chance(0.3) ? static_cast<double>(random_.below(1000)) : random_.uniform(-1e6, 1e6);
  }
  void operator()(const char*, std::string& to) {
    static const std::vector<std::string> kParts = {"a", "\"", "\\", "\n", "\t",
                                                    "é", "🚁",  "{",  ":"};
    to.clear();
    for (std::uint64_t i = random_.below(6); i > 0; --i) to += kParts[random_.below(kParts.size())];
  }
  void operator()(const char*, std::vector<double>& to) {
    to.clear();
    for (std::uint64_t i = random_.below(5); i > 0; --i) to.push_back(random_.uniform(-1e4, 1e4));
  }
  template <class T>
  void operator()(const char* name, std::optional<T>& to) {
    to.reset();
    if (random_.chance(0.5)) (*this)(name, to.emplace());
  }

 private:
  Random random_;
};

template <class Line>
Line any(std::uint64_t seed) {
  Line line;
  AnyField draw(seed);
  Line::fields(line, [&](const char* name, auto& field) { draw(name, field); });
  return line;
}

template <class Line>
Record record_of_any(std::uint64_t seed) {
  return record_of(MissionTime::nanoseconds(static_cast<std::int64_t>(seed) * 1'000'003), "marvin",
                   any<Line>(seed));
}

/// The record with one field taken out, or with another value in it.
Record without(const Record& record, const std::string& name) {
  Record rest(record.at(), record.node(), record.kind());
  for (const auto& [key, value] : record.fields())
    if (key != name) rest.with(key, value);
  return rest;
}
Record with_other(const Record& record, const std::string& name, const Value& other) {
  Record changed(record.at(), record.node(), record.kind());
  for (const auto& [key, value] : record.fields()) changed.with(key, key == name ? other : value);
  return changed;
}

/// What nobody takes for a field that holds `value`.
Value of_another_shape(const Value& value) {
  if (std::holds_alternative<std::vector<double>>(value)) return std::string("a text");
  return std::vector<double>{1, 2, 3};
}

// ---- the laws, for one kind ----

template <class Line>
void is_read_back(std::uint64_t seed) {
  const Record written = record_of_any<Line>(seed);

  const auto parsed = parse_record(to_json(written));
  ASSERT_TRUE(parsed.has_value()) << to_json(written);
  const auto line = read_as<Line>(*parsed);

  ASSERT_TRUE(line.has_value()) << to_json(written);
  EXPECT_EQ(to_json(record_of(written.at(), written.node(), *line)), to_json(written));
}

template <class Line>
void needs_each_required_field(std::uint64_t seed) {
  const Record written = record_of_any<Line>(seed);
  for (const Kind::Field& field : kind_of<Line>().fields) {
    EXPECT_EQ(read_as<Line>(without(written, field.name)).has_value(), field.optional)
        << written.kind() << " without " << field.name;
  }
}

template <class Line>
void refuses_another_shape_of_each_field(std::uint64_t seed) {
  const Record written = record_of_any<Line>(seed);
  for (const auto& [name, value] : written.fields()) {
    const Record wrong = with_other(written, name, of_another_shape(value));
    EXPECT_FALSE(read_as<Line>(wrong).has_value()) << to_json(wrong);
  }
}

template <class Line>
void has_its_required_fields_even_if_nothing_was_said(std::uint64_t) {
  const Record empty = record_of(MissionTime(), "marvin", Line{});
  std::vector<std::string> names, required;
  for (const auto& [name, value] : empty.fields()) names.push_back(name);
  for (const Kind::Field& field : kind_of<Line>().fields)
    if (!field.optional) required.push_back(field.name);

  EXPECT_EQ(names, required) << empty.kind();
  EXPECT_TRUE(read_as<Line>(empty).has_value()) << empty.kind();
}

template <class Line>
struct Hearer {
  std::string heard;
  void hear(Line line, const Written& written) {
    heard = to_json(record_of(written.at, written.node, std::move(line)));
  }
};

template <class Line>
void is_handed_on_unless_something_is_missing(std::uint64_t seed) {
  const Record written = record_of_any<Line>(seed);
  Hearer<Line> hearer;
  EXPECT_TRUE(hand_on<Line>(written, hearer));
  EXPECT_EQ(hearer.heard, to_json(written));

  for (const Kind::Field& field : kind_of<Line>().fields) {
    if (field.optional) continue;
    Hearer<Line> deaf;
    EXPECT_FALSE(hand_on<Line>(without(written, field.name), deaf)) << field.name;
    EXPECT_EQ(deaf.heard, "") << written.kind() << " without " << field.name;
  }
}

template <class Line>
void does_not_care_for_the_order_of_its_fields(std::uint64_t seed) {
  const Record written = record_of_any<Line>(seed);
  auto fields = written.fields();
  std::reverse(fields.begin(), fields.end());
  Record turned(written.at(), written.node(), written.kind());
  turned.with("unheard-of", true);
  for (const auto& [name, value] : fields) turned.with(name, value);

  const auto line = read_as<Line>(turned);

  ASSERT_TRUE(line.has_value()) << to_json(turned);
  EXPECT_EQ(to_json(record_of(written.at(), written.node(), *line)), to_json(written));
}

// ---- all kinds ----

struct Laws {
  std::string kind;
  std::function<void(std::uint64_t)> read_back, required, shapes, empty, handed_on, order;
};

template <class... Line>
std::vector<Laws> laws_of() {
  return {Laws{std::string(Line::kKind), is_read_back<Line>, needs_each_required_field<Line>,
               refuses_another_shape_of_each_field<Line>,
               has_its_required_fields_even_if_nothing_was_said<Line>,
               is_handed_on_unless_something_is_missing<Line>,
               does_not_care_for_the_order_of_its_fields<Line>}...};
}

std::vector<Laws> all_laws() {
  using namespace lines;
  return laws_of<Mission, Phase, Step, Operator, Asked, Hand, Command, Degree, Held, LostUav,
                 FoundUav, Contact, Notice, Alarm, Perception, Seen, Request, Task, Sync,
                 Functional, Goal, lines::Plan, Planned, Decision, Answer, Air, Meeting, Frontier,
                 Joint, Role, RoleTask, Place, Scm, Negotiation, GlobalMission, Owner, Token, Sale,
                 Bid, TeamTask, Message, Resumed, Route, Reach, Expired, Lost, Unsent, Dropped,
                 Transport, Link, Telemetry, Object, Fault, Process, Waiting, Expectation>();
}

void for_each_kind(std::function<void(std::uint64_t)> Laws::*law) {
  for (const Laws& laws : all_laws()) {
    SCOPED_TRACE(laws.kind);
    for (std::uint64_t seed = 1; seed <= 40; ++seed) (laws.*law)(seed);
  }
}

TEST(LineLaws, AreAskedOfEveryKind) {
  std::vector<std::string> asked, all;
  for (const Laws& one : all_laws()) asked.push_back(one.kind);
  for (const Kind& one : kinds()) all.push_back(one.name);
  EXPECT_EQ(asked, all);
}

TEST(LineLaws, EveryLineIsReadBackFromItsText) { for_each_kind(&Laws::read_back); }

TEST(LineLaws, ALineWithoutAFieldIsNoneUnlessThatMayBeLeftOut) { for_each_kind(&Laws::required); }

TEST(LineLaws, ALineWithAFieldOfAnotherShapeIsNone) { for_each_kind(&Laws::shapes); }

TEST(LineLaws, WhatMustBeThereIsWrittenEvenIfNothingWasSaid) { for_each_kind(&Laws::empty); }

TEST(LineLaws, WhoHearsAKindHearsOnlyWholeLinesOfIt) { for_each_kind(&Laws::handed_on); }

TEST(LineLaws, TheOrderOfFieldsAndWhatIsUnheardOfDoNotMatter) { for_each_kind(&Laws::order); }

}  // namespace
}  // namespace skein::journal
