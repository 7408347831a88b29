// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/wire.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "testing/random_sample.hpp"

namespace skein::wire {
namespace {

using blackboard::testing::for_each_slot_type;
using blackboard::testing::random_value;
using ::testing::HasSubstr;

TEST(Slot, NamesAndNumbersCorrespond) {
  for (std::size_t i = 0; i < kSlotCount; ++i) {
    const auto slot = static_cast<Slot>(i);

    EXPECT_EQ(slot_from_name(slot_name(slot)), slot);
  }
  EXPECT_EQ(slot_from_name("Nonsense"), std::nullopt);
}

TEST(Slot, ClassesAreThoseOfTheSpecification) {
  EXPECT_EQ(slot_class(Slot::kDirectoryEntry), SlotClass::kState);
  EXPECT_EQ(slot_class(Slot::kMissionState), SlotClass::kState);
  EXPECT_EQ(slot_class(Slot::kMissionPlan), SlotClass::kState);
  EXPECT_EQ(slot_class(Slot::kJointTaskState), SlotClass::kState);
  EXPECT_EQ(slot_class(Slot::kPlanFrontier), SlotClass::kState);
  EXPECT_EQ(slot_class(Slot::kSeenObject), SlotClass::kState);
  EXPECT_EQ(slot_class(Slot::kGroundBoard), SlotClass::kState);
  EXPECT_EQ(slot_class(Slot::kNeighbours), SlotClass::kState);
  EXPECT_EQ(slot_class(Slot::kTaskRequest), SlotClass::kEvent);
  EXPECT_EQ(slot_class(Slot::kMissionRequest), SlotClass::kEvent);
  EXPECT_EQ(slot_class(Slot::kDecision), SlotClass::kEvent);
  EXPECT_EQ(slot_class(Slot::kNegotiationMessage), SlotClass::kEvent);
  EXPECT_EQ(slot_class(Slot::kTeamMessage), SlotClass::kEvent);
  EXPECT_EQ(slot_class(Slot::kTeamSale), SlotClass::kEvent);
  EXPECT_EQ(slot_class(Slot::kMergeMessage), SlotClass::kEvent);
  EXPECT_EQ(slot_class(Slot::kOperatorRequest), SlotClass::kEvent);
  EXPECT_EQ(slot_class(Slot::kJournalEntry), SlotClass::kEvent);
  EXPECT_EQ(slot_class(Slot::kTelemetry), SlotClass::kStream);
  EXPECT_EQ(slot_class(Slot::kHeartbeat), SlotClass::kStream);
}

TEST(Slot, ASampleKnowsItsSlot) {
  EXPECT_EQ(slot_of(Sample(Clock{})), Slot::kClock);
  EXPECT_EQ(slot_of(Sample(Alarm{})), Slot::kAlarm);
  EXPECT_EQ(slot_of(Sample(Heartbeat{})), Slot::kHeartbeat);
}

TEST(FindViolation, AcceptsEveryWellFormedSample) {
  Random random(1);
  for_each_slot_type([&]<class T>() {
    for (int i = 0; i < 50; ++i) {
      const Sample sample = random_value<T>(random);

      EXPECT_EQ(find_violation(sample), std::nullopt) << to_text(sample);
    }
  });
}

TEST(FindViolation, NamesTheFieldOfAnEnumerationOutOfRange) {
  TaskRequest request;
  request.task.preconditions.resize(2);
  request.task.preconditions[1].literals.resize(1);
  request.task.preconditions[1].literals[0].state = static_cast<TaskState>(6);

  const auto violation = find_violation(request);

  ASSERT_TRUE(violation);
  EXPECT_EQ(violation->field, "task.preconditions[1].literals[0].state");
  EXPECT_EQ(violation->why, "6 is not a value of the enumeration");
}

TEST(FindViolation, RejectsWhatIsNotFinite) {
  Telemetry telemetry;
  telemetry.velocity.y = std::numeric_limits<double>::quiet_NaN();
  LinkState link;
  link.capacity = std::numeric_limits<double>::infinity();

  EXPECT_EQ(find_violation(telemetry)->field, "velocity.y");
  EXPECT_EQ(find_violation(link)->field, "capacity");
}

TEST(FindViolation, RejectsWhatIsTooLong) {
  JournalEntry entry;
  entry.record = std::string(kMaximumString, 'x');
  PlanBoard board;
  board.tasks.resize(kMaximumSequence);

  EXPECT_FALSE(find_violation(entry));
  EXPECT_FALSE(find_violation(board));
  entry.record += "x";
  board.tasks.emplace_back();
  EXPECT_EQ(find_violation(entry)->why, "too long");
  EXPECT_EQ(find_violation(board)->why, "too many elements");
}

TEST(FindViolation, RejectsTextThatIsNotUtf8) {
  const std::vector<std::string> wrong = {
      "\x80",             // continuation without lead
      "\xC3",             // cut short
      "\xC0\xAF",         // overlong
      "\xE0\x80\x80",     // overlong
      "\xED\xA0\x80",     // surrogate
      "\xF4\x90\x80\x80"  // above U+10FFFF
  };
  for (const std::string& text : wrong) {
    MissionState state;
    state.phase = text;

    const auto violation = find_violation(state);

    ASSERT_TRUE(violation) << text;
    EXPECT_EQ(*violation, (Violation{"phase", "not UTF-8"}));
  }
}

TEST(FindViolation, RejectsAZeroByteInAText) {
  MissionState state;
  state.outcome = std::string("a\0b", 3);

  EXPECT_EQ(find_violation(state)->field, "outcome");
}

TEST(ToJson, KeepsEveryFieldOfEverySlot) {
  Random random(2);
  for_each_slot_type([&]<class T>() {
    const T value = random_value<T>(random);

    const auto json = nlohmann::json::parse(to_json(value));

    EXPECT_EQ(json.at("slot"), std::string(slot_name(slot_of(Sample(value)))));
    EXPECT_EQ(json.at("header").at("sequence_number"), value.header.sequence_number);
    visit_fields([&](const char* name, const auto&) { EXPECT_TRUE(json.contains(name)) << name; },
                 value);
  });
}

TEST(ToJson, WritesEnumerationsByName) {
  TaskEvent event;
  event.state = TaskState::kAborting;

  EXPECT_THAT(to_json(event), HasSubstr(R"("state":"aborting")"));
}

TEST(ToJson, NeverFails) {
  JournalEntry entry;
  entry.record = "\xFF";
  Telemetry telemetry;
  telemetry.heading = std::numeric_limits<double>::quiet_NaN();
  TaskEvent event;
  event.state = static_cast<TaskState>(99);

  EXPECT_FALSE(to_json(entry).empty());
  EXPECT_THAT(to_json(telemetry), HasSubstr(R"("heading":null)"));
  EXPECT_THAT(to_json(event), HasSubstr(R"("state":"?")"));
}

TEST(ToText, IsOneLineWithWhoAndWhat) {
  SyncMessage message;
  message.header.origin = 3;
  message.header.destination = 1;
  message.header.sequence_number = 17;
  message.id = 551;
  message.from = "marvin";
  message.to = "heliv";
  message.word = SyncWord::kWithdrawn;
  message.said = 5;

  EXPECT_EQ(to_text(message),
            R"(SyncMessage 3>1 #17 id=551 from="marvin" to="heliv" word="withdrawn" said=5)");
}

}  // namespace
}  // namespace skein::wire
