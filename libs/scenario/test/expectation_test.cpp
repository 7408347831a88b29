// SPDX-License-Identifier: Apache-2.0
#include "skein/scenario/expectation.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "skein/foundation/random.hpp"

namespace skein::scenario {
namespace {

using journal::Record;
using journal::Value;
using Quantity = ExpectMeasure::Quantity;

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

Record alarm(double seconds, const std::string& state) {
  return Record(at(seconds), "ground", "alarm").with("alarm", 1).with("state", state);
}
Record task(double seconds, const std::string& uav, int id, const std::string& state) {
  return Record(at(seconds), uav, "task").with("uav", uav).with("task", id).with("state", state);
}
Record telemetry(double seconds, const std::string& uav, std::vector<double> position,
                 bool airborne = true, double energy = 1) {
  return Record(at(seconds), "sim", "telemetry")
      .with("uav", uav)
      .with("position", std::move(position))
      .with("energy", energy)
      .with("airborne", airborne);
}

Pattern pattern(std::vector<std::pair<std::string, Value>> fields) {
  Pattern result;
  for (auto& [key, value] : fields) result.fields.push_back({key, {std::move(value)}});
  return result;
}
Pattern alarm_is(const std::string& state) {
  return pattern({{"kind", std::string("alarm")}, {"state", state}});
}

Verdict verdict_of(std::variant<ExpectEvent, ExpectFinally, ExpectMeasure> what,
                   const std::vector<Record>& records) {
  return check({{"it", std::move(what)}}, records).at(0);
}
bool passes(std::variant<ExpectEvent, ExpectFinally, ExpectMeasure> what,
            const std::vector<Record>& records) {
  return verdict_of(std::move(what), records).passed;
}
ExpectEvent event(Pattern what, Window window = {}) { return {std::move(what), window, 1, {}}; }
ExpectEvent never(Pattern what, Window window = {}) { return {std::move(what), window, 0, 0}; }

// ---- patterns ----

TEST(Pattern, MatchesWhenEveryFieldDoes) {
  const Record record = task(5, "marvin", 3, "ended");

  EXPECT_TRUE(pattern({{"kind", std::string("task")}}).matches(record));
  EXPECT_TRUE(
      pattern({{"node", std::string("marvin")}, {"task", std::int64_t{3}}}).matches(record));
  EXPECT_FALSE(pattern({{"kind", std::string("task")}, {"task", std::int64_t{4}}}).matches(record));
  EXPECT_FALSE(pattern({{"phase", std::string("x")}}).matches(record));
}

TEST(Pattern, OneOfSeveralValuesIsEnough) {
  const Pattern either{{{"state", {std::string("ended"), std::string("aborted")}}}};

  EXPECT_TRUE(either.matches(task(5, "marvin", 3, "ended")));
  EXPECT_TRUE(either.matches(task(5, "marvin", 3, "aborted")));
  EXPECT_FALSE(either.matches(task(5, "marvin", 3, "running")));
}

TEST(Pattern, NumbersCompareByValueAndNotWithText) {
  const Record record = Record(at(0), "n", "k").with("x", 3).with("y", 3.0).with("z", "3");

  EXPECT_TRUE(pattern({{"x", 3.0}}).matches(record));
  EXPECT_TRUE(pattern({{"y", std::int64_t{3}}}).matches(record));
  EXPECT_FALSE(pattern({{"z", std::int64_t{3}}}).matches(record));
  EXPECT_FALSE(pattern({{"x", std::string("3")}}).matches(record));
}

TEST(Pattern, IsWrittenAsAUserWould) {
  const Pattern some{{{"kind", {std::string("task")}},
                      {"task", {std::int64_t{3}, std::int64_t{4}}},
                      {"accepted", {false}}}};

  EXPECT_EQ(to_text(some), "{kind: task, task: [3, 4], accepted: false}");
}

// ---- events ----

TEST(ExpectedEvent, IsMetByOneAnywhere) {
  const Verdict verdict = verdict_of(event(alarm_is("raised")), {alarm(12.5, "raised")});

  EXPECT_TRUE(verdict.passed);
  EXPECT_EQ(verdict.name, "it");
  EXPECT_EQ(verdict.seen, "once at 12.5 s");
}

TEST(ExpectedEvent, ThatDidNotComeSaysWhatWasExpected) {
  const Verdict verdict = verdict_of(event(alarm_is("raised")), {alarm(3, "confirmed")});

  EXPECT_FALSE(verdict.passed);
  EXPECT_EQ(verdict.seen, "0 times; expected at least 1 of {kind: alarm, state: raised} from 0 s");
}

TEST(ExpectedEvent, CountsWithinItsWindowBothEndsIncluded) {
  const auto in_window = [](double seconds) {
    return passes(event(alarm_is("raised"), {at(10), at(20), {}, {}, {}}),
                  {alarm(seconds, "raised")});
  };

  EXPECT_TRUE(in_window(10));
  EXPECT_TRUE(in_window(20));
  EXPECT_FALSE(in_window(9.999));
  EXPECT_FALSE(in_window(20.001));
}

TEST(ExpectedEvent, OutsideOfItsWindowIsTold) {
  const Verdict verdict =
      verdict_of(event(alarm_is("raised"), {at(10), at(20), {}, {}, {}}), {alarm(25, "raised")});

  EXPECT_EQ(verdict.seen,
            "0 times; expected at least 1 of {kind: alarm, state: raised} from 10 s until 20 s; "
            "outside of that at 25 s");
}

TEST(ExpectedEvent, AfterCountsFromTheFirstReferenceOn) {
  Window window;
  window.after = alarm_is("raised");
  const auto with = [&](double seconds) {
    return passes(event(alarm_is("confirmed"), window),
                  {alarm(1, "confirmed"), alarm(5, "raised"), alarm(seconds, "confirmed"),
                   alarm(90, "raised")});
  };

  EXPECT_TRUE(with(5));
  EXPECT_TRUE(with(50));
  EXPECT_FALSE(
      passes(event(alarm_is("confirmed"), window), {alarm(1, "confirmed"), alarm(5, "raised")}));
}

TEST(ExpectedEvent, WithinEndsThatLongAfterTheReference) {
  Window window;
  window.after = alarm_is("raised");
  window.within = Duration::seconds(10);
  const auto with = [&](double seconds) {
    return passes(event(alarm_is("confirmed"), window),
                  {alarm(5, "raised"), alarm(seconds, "confirmed")});
  };

  EXPECT_TRUE(with(15));
  EXPECT_FALSE(with(15.001));
}

TEST(ExpectedEvent, AfterWhatNeverCameFails) {
  Window window;
  window.after = alarm_is("raised");

  const Verdict verdict = verdict_of(event(alarm_is("confirmed"), window), {alarm(5, "confirmed")});

  EXPECT_FALSE(verdict.passed);
  EXPECT_EQ(verdict.seen, "never saw {kind: alarm, state: raised}");
}

TEST(ExpectedEvent, BeforeExcludesTheInstantOfTheReference) {
  Window window;
  window.before = alarm_is("confirmed");
  const auto with = [&](double seconds) {
    std::vector<Record> records{task(seconds, "karma", 1, "started"), alarm(20, "confirmed")};
    if (seconds > 20) std::swap(records[0], records[1]);
    return passes(event(pattern({{"task", std::int64_t{1}}}), window), records);
  };

  EXPECT_TRUE(with(19.999));
  EXPECT_FALSE(with(20));
  EXPECT_FALSE(with(21));
}

TEST(ExpectedEvent, BeforeExcludesTheReferenceItself) {
  Window window;
  window.before = alarm_is("raised");

  EXPECT_FALSE(passes(event(alarm_is("raised"), window), {alarm(5, "raised"), alarm(6, "raised")}));
  EXPECT_TRUE(passes(never(alarm_is("raised"), window), {alarm(5, "raised"), alarm(6, "raised")}));
}

TEST(ExpectedEvent, BeforeWhatNeverCameIsAnyTime) {
  Window window;
  window.before = alarm_is("confirmed");

  EXPECT_TRUE(passes(event(alarm_is("raised"), window), {alarm(500, "raised")}));
}

TEST(ExpectedEvent, BeforeIsToldInTheWindow) {
  Window window;
  window.before = alarm_is("confirmed");

  const Verdict verdict =
      verdict_of(never(alarm_is("raised"), window), {alarm(5, "raised"), alarm(20, "confirmed")});

  EXPECT_EQ(verdict.seen,
            "once at 5 s; expected exactly 0 of {kind: alarm, state: raised} from 0 s before 20 s");
}

TEST(ExpectedEvent, CountsHaveBounds) {
  const std::vector<Record> twice{alarm(1, "raised"), alarm(2, "raised")};
  const auto with = [&](std::size_t low, std::optional<std::size_t> high) {
    return passes(ExpectEvent{alarm_is("raised"), {}, low, high}, twice);
  };

  EXPECT_TRUE(with(2, 2));
  EXPECT_TRUE(with(0, 3));
  EXPECT_TRUE(with(2, std::nullopt));
  EXPECT_FALSE(with(1, 1));
  EXPECT_FALSE(with(3, std::nullopt));
  EXPECT_FALSE(with(3, 5));
  EXPECT_EQ(verdict_of(ExpectEvent{alarm_is("raised"), {}, 3, 5}, twice).seen,
            "2 times, first at 1 s; expected 3 to 5 of {kind: alarm, state: raised} from 0 s");
}

TEST(ExpectedEvent, NoneIsEnoughWhereNoneIsAllowedAndTheReferenceNeverCame) {
  Window window;
  window.after = alarm_is("confirmed");

  EXPECT_TRUE(passes(ExpectEvent{alarm_is("raised"), window, 0, 3}, {alarm(1, "raised")}));
  EXPECT_FALSE(passes(ExpectEvent{alarm_is("raised"), window, 1, 3}, {alarm(1, "raised")}));
}

TEST(ExpectedNever, FailsAtTheFirst) {
  EXPECT_TRUE(passes(never(alarm_is("infirmed")), {alarm(1, "raised")}));
  EXPECT_FALSE(passes(never(alarm_is("infirmed")), {alarm(1, "infirmed")}));
  EXPECT_TRUE(passes(never(alarm_is("infirmed")), {}));
}

TEST(ExpectedNever, CountsOnlyInItsWindow) {
  Window window;
  window.after = alarm_is("infirmed");

  EXPECT_TRUE(
      passes(never(alarm_is("raised"), window), {alarm(1, "raised"), alarm(2, "infirmed")}));
  EXPECT_FALSE(passes(never(alarm_is("raised"), window),
                      {alarm(1, "raised"), alarm(2, "infirmed"), alarm(3, "raised")}));
}

// ---- finally ----

TEST(ExpectedFinally, OnlyTheLastRecordCounts) {
  const ExpectFinally on_ground{
      pattern({{"kind", std::string("telemetry")}, {"uav", std::string("marvin")}}),
      pattern({{"airborne", false}})};

  EXPECT_TRUE(passes(on_ground,
                     {telemetry(1, "marvin", {0, 0, 9}), telemetry(2, "marvin", {0, 0, 0}, false),
                      telemetry(3, "heliv", {0, 0, 9})}));
  EXPECT_FALSE(passes(
      on_ground, {telemetry(1, "marvin", {0, 0, 0}, false), telemetry(2, "marvin", {0, 0, 9})}));
}

TEST(ExpectedFinally, SaysWhatWasThereInstead) {
  const ExpectFinally confirmed{pattern({{"kind", std::string("alarm")}}),
                                pattern({{"state", std::string("confirmed")}})};

  EXPECT_EQ(verdict_of(confirmed, {alarm(7, "raised")}).seen,
            R"(last: {"at":7,"node":"ground","kind":"alarm","alarm":1,"state":"raised"})");
  EXPECT_EQ(verdict_of(confirmed, {}).seen, "never saw {kind: alarm}");
  EXPECT_FALSE(passes(confirmed, {}));
}

// ---- measures ----

TEST(MinimumSeparation, IsTheLeastDistanceInTheAir) {
  const std::vector<Record> records{telemetry(1, "a", {0, 0, 10}), telemetry(1, "b", {30, 40, 10}),
                                    telemetry(2, "a", {0, 0, 10}), telemetry(2, "b", {3, 4, 22})};

  const Verdict verdict =
      verdict_of(ExpectMeasure{Quantity::kMinimumSeparation, {}, 13, {}}, records);

  EXPECT_TRUE(verdict.passed);
  EXPECT_EQ(verdict.seen, "13 m (a and b at 2 s)");
}

TEST(MinimumSeparation, DoesNotCountOnTheGroundNorAtDifferentTimes) {
  const std::vector<Record> records{telemetry(1, "a", {0, 0, 0}, false),
                                    telemetry(1, "b", {1, 0, 0}), telemetry(2, "a", {0, 0, 10}),
                                    telemetry(2.8, "b", {1, 0, 10}),
                                    telemetry(3, "a", {50, 0, 10})};

  EXPECT_EQ(verdict_of(ExpectMeasure{Quantity::kMinimumSeparation, {}, 1, {}}, records).seen,
            "49 m (b and a at 3 s)");
}

TEST(MinimumSeparation, OfChosenUavsLeavesOutTheOthers) {
  const std::vector<Record> records{telemetry(1, "a", {0, 0, 0}), telemetry(1, "b", {1, 0, 0}),
                                    telemetry(1, "c", {5, 0, 0})};

  EXPECT_EQ(
      verdict_of(ExpectMeasure{Quantity::kMinimumSeparation, {"a", "c"}, 1, {}}, records).seen,
      "5 m (a and c at 1 s)");
}

TEST(MinimumSeparation, OfOneAloneIsNoFigure) {
  const Verdict verdict = verdict_of(ExpectMeasure{Quantity::kMinimumSeparation, {}, 0, {}},
                                     {telemetry(1, "a", {0, 0, 0})});

  EXPECT_FALSE(verdict.passed);
  EXPECT_EQ(verdict.seen, "nothing to measure: no two UAVs were airborne together");
}

TEST(DistanceFlown, IsTheSumOfAllWays) {
  const std::vector<Record> records{telemetry(1, "a", {0, 0, 0}), telemetry(1, "b", {0, 0, 0}),
                                    telemetry(2, "a", {3, 4, 0}), telemetry(2, "b", {0, 0, 2}),
                                    telemetry(3, "a", {3, 4, 12})};

  EXPECT_EQ(verdict_of(ExpectMeasure{Quantity::kDistanceFlown, {}, {}, 19}, records).seen, "19 m");
  EXPECT_EQ(verdict_of(ExpectMeasure{Quantity::kDistanceFlown, {"a"}, {}, 19}, records).seen,
            "17 m");
  EXPECT_FALSE(passes(ExpectMeasure{Quantity::kDistanceFlown, {}, {}, 18.999}, records));
  EXPECT_FALSE(passes(ExpectMeasure{Quantity::kDistanceFlown, {"c"}, 0, {}}, records));
}

TEST(MissionDuration, IsTheInstantItFinished) {
  const std::vector<Record> records{
      Record(at(0), "sim", "mission").with("state", "started"),
      Record(at(1234.5), "ground", "mission").with("state", "finished")};

  EXPECT_EQ(verdict_of(ExpectMeasure{Quantity::kMissionDuration, {}, {}, 2000}, records).seen,
            "1234.5 s");
  EXPECT_FALSE(passes(ExpectMeasure{Quantity::kMissionDuration, {}, {}, 1000}, records));
  EXPECT_EQ(verdict_of(ExpectMeasure{Quantity::kMissionDuration, {}, {}, 2000}, {}).seen,
            "nothing to measure: the mission did not finish");
}

TEST(EnergyLeft, IsTheLeastAtTheEnd) {
  const std::vector<Record> records{telemetry(1, "a", {0, 0, 0}, true, 0.1),
                                    telemetry(2, "a", {0, 0, 0}, true, 0.5),
                                    telemetry(2, "b", {0, 0, 0}, true, 0.4)};

  EXPECT_EQ(verdict_of(ExpectMeasure{Quantity::kEnergyLeft, {}, 0.2, {}}, records).seen, "0.4 (b)");
  EXPECT_EQ(verdict_of(ExpectMeasure{Quantity::kEnergyLeft, {"a"}, 0.2, {}}, records).seen,
            "0.5 (a)");
  EXPECT_FALSE(passes(ExpectMeasure{Quantity::kEnergyLeft, {}, 0.41, {}}, records));
  EXPECT_FALSE(passes(ExpectMeasure{Quantity::kEnergyLeft, {}, 0.2, {}}, {}));
}

TEST(Measures, TelemetryOfAnotherShapeIsLeftOut) {
  const std::vector<Record> records{
      Record(at(1), "sim", "telemetry").with("uav", "a").with("airborne", true),
      telemetry(1, "b", {1, 2}), telemetry(1, "c", {0, 0, 0})};

  EXPECT_FALSE(passes(ExpectMeasure{Quantity::kMinimumSeparation, {}, 0, {}}, records));
}

TEST(Check, GivesOneVerdictEachInOrder) {
  const std::vector<Expectation> expectations{
      {"first", event(alarm_is("raised"))},
      {"second", never(alarm_is("raised"))},
      {"third", ExpectMeasure{Quantity::kEnergyLeft, {}, 0, {}}}};

  const auto verdicts = check(expectations, {alarm(1, "raised")});

  ASSERT_EQ(verdicts.size(), 3U);
  EXPECT_EQ(verdicts[0].name, "first");
  EXPECT_TRUE(verdicts[0].passed);
  EXPECT_EQ(verdicts[1].name, "second");
  EXPECT_FALSE(verdicts[1].passed);
  EXPECT_EQ(verdicts[2].name, "third");
}

// ---- against an independent oracle ----

struct Sighting {
  double second;
  int uav;
  double x, y, z;
  bool airborne;
};

std::vector<Sighting> random_flights(Random& random) {
  std::vector<Sighting> all;
  const int uavs = 1 + static_cast<int>(random.below(4));
  for (int second = 0; second < 12; ++second) {
    for (int uav = 0; uav < uavs; ++uav) {
      if (random.chance(0.15)) continue;  // a sample that is not there
      all.push_back({static_cast<double>(second), uav, random.uniform(0, 100),
                     random.uniform(0, 100), random.uniform(0, 50), random.chance(0.7)});
    }
  }
  return all;
}

// The distance of every two samples of the same instant, the plain way.
double least_distance(const std::vector<Sighting>& all) {
  double least = std::numeric_limits<double>::infinity();
  for (const Sighting& a : all) {
    for (const Sighting& b : all) {
      if (a.second != b.second || a.uav >= b.uav || !a.airborne || !b.airborne) continue;
      const double d2 =
          (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z);
      least = std::min(least, std::sqrt(d2));
    }
  }
  return least;
}

RC_GTEST_PROP(MinimumSeparation, IsThatOfAllPairs, (std::uint64_t seed)) {
  Random random(seed);
  const auto flights = random_flights(random);
  std::vector<Record> records;
  for (const Sighting& one : flights) {
    records.push_back(telemetry(one.second, "uav-" + std::to_string(one.uav), {one.x, one.y, one.z},
                                one.airborne));
  }
  const double least = least_distance(flights);

  const auto with = [&](double bound) {
    return passes(ExpectMeasure{Quantity::kMinimumSeparation, {}, bound, {}}, records);
  };

  if (std::isinf(least)) {
    RC_ASSERT(!with(0));
  } else {
    RC_ASSERT(with(least - 1e-9));
    RC_ASSERT(!with(least + 1e-9));
  }
}

// An event's count against counting by hand.
RC_GTEST_PROP(ExpectedEvent, CountsAsByHand, (std::uint64_t seed)) {
  Random random(seed);
  const std::vector<std::string> states{"raised", "confirmed", "infirmed"};
  std::vector<Record> records;
  double now = 0;
  for (std::uint64_t n = random.below(15); n > 0; --n) {
    now += static_cast<double>(random.below(3));
    records.push_back(alarm(now, states[random.below(3)]));
  }
  Window window{at(static_cast<double>(random.below(5))),
                at(static_cast<double>(random.below(25))),
                {},
                {},
                {}};
  if (random.chance(0.5)) window.after = alarm_is("confirmed");
  if (window.after && random.chance(0.5)) window.within = Duration::seconds(4);
  if (random.chance(0.5)) window.before = alarm_is("infirmed");

  const auto second = [](const Record& record) { return std::lround(record.at().to_seconds()); };
  long after = -1, before = 1'000'000;
  for (auto it = records.rbegin(); it != records.rend(); ++it) {
    if (it->text("state") == "confirmed") after = second(*it);
    if (it->text("state") == "infirmed") before = second(*it);
  }
  std::size_t count = 0;
  for (const Record& record : records) {
    const long t = second(record);
    bool counts = record.text("state") == "raised" && record.at() >= window.from &&
                  record.at() <= window.until;
    if (window.after) counts = counts && after >= 0 && t >= after;
    if (window.within) counts = counts && t <= after + 4;
    if (window.before) counts = counts && t < before;
    if (counts) ++count;
  }

  RC_ASSERT(passes(ExpectEvent{alarm_is("raised"), window, count, {}}, records));
  RC_ASSERT(!passes(ExpectEvent{alarm_is("raised"), window, count + 1, {}}, records));
}

}  // namespace
}  // namespace skein::scenario
