// SPDX-License-Identifier: Apache-2.0
// What comes after its window, on a machine that is late.
#include <gtest/gtest.h>

#include "skein/journal/lines/mission.hpp"
#include "skein/scenario/expectation.hpp"

namespace skein::scenario {
namespace {

using journal::Record;

Record told(double seconds, const std::string& state) {
  return journal::record_of(MissionTime::seconds(seconds), "ground",
                            journal::lines::Alarm{.alarm = 1, .state = state});
}
Window first_ten_seconds() { return {MissionTime(), MissionTime::seconds(10), {}, {}, {}}; }
Pattern alarm_of(const std::string& state) {
  return {{{"kind", {std::string("alarm")}}, {"state", {state}}}};
}

/// Of one expectation, where so many seconds are allowed.
Verdict verdict_of(const ExpectEvent& what, const std::vector<Record>& records, double allowed) {
  return check({{"it", what}}, records, Duration::seconds(allowed)).at(0);
}

TEST(LateEvent, MayComeByWhatIsAllowedAndThatIsTold) {
  Window window;
  window.after = alarm_of("raised");
  window.within = Duration::seconds(10);
  const auto with = [&](double seconds) {
    return verdict_of({alarm_of("confirmed"), window, 1, {}},
                      {told(5, "raised"), told(seconds, "confirmed")}, 4);
  };

  EXPECT_EQ(with(15).seen, "once at 15 s");
  EXPECT_EQ(with(19).seen, "once at 19 s, later than asked: by 15 s");
  EXPECT_TRUE(with(19).passed);
  EXPECT_FALSE(with(19.001).passed);
  EXPECT_FALSE(with(4).passed) << "not early";
}

TEST(LateEvent, ThatCameTooOftenDoesNotPassByBeingLate) {
  const std::vector<Record> records{told(1, "raised"), told(2, "raised"), told(11, "raised")};
  const Window window = first_ten_seconds();
  const auto passed = [&](std::size_t times) {
    return verdict_of({alarm_of("raised"), window, times, times}, records, 5).passed;
  };

  EXPECT_TRUE(passed(2)) << "what is in time counts as it is";
  EXPECT_TRUE(passed(3));
  EXPECT_FALSE(passed(1));
}

TEST(LateEvent, ThatMustNeverComeIsJudgedInItsWindowAsItStands) {
  const Window window = first_ten_seconds();
  const ExpectEvent never{alarm_of("raised"), window, 0, 0};

  EXPECT_TRUE(verdict_of(never, {told(11, "raised")}, 5).passed);
  EXPECT_FALSE(verdict_of(never, {told(9, "raised")}, 5).passed);
}

}  // namespace
}  // namespace skein::scenario
