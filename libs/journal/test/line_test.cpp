// SPDX-License-Identifier: Apache-2.0
#include "skein/journal/line.hpp"

#include <gtest/gtest.h>

#include "skein/journal/lines/deliberation.hpp"
#include "skein/journal/lines/execution.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/journal/lines/truth.hpp"

namespace skein::journal {
namespace {

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

lines::Task a_task() {
  return {.uav = "marvin", .task = 7, .type = "goto", .state = "running", .reason = "wind"};
}

std::string json(const Record& record) { return to_json(record); }

TEST(Line, IsWrittenInTheOrderOfItsFieldsWithoutWhatIsNotSaid) {
  EXPECT_EQ(json(record_of(at(1.5), "marvin", a_task())),
            R"({"at":1.5,"node":"marvin","kind":"task","uav":"marvin","task":7,"type":"goto",)"
            R"("state":"running","reason":"wind"})");
}

TEST(Line, HasTextThatIsRequiredEvenIfItIsEmpty) {
  EXPECT_EQ(json(record_of(at(0), "sim", lines::Fault{.what = "kill"})),
            R"({"at":0,"node":"sim","kind":"fault","what":"kill","target":""})");
}

TEST(Line, TellsAnAbsentFigureFromNought) {
  EXPECT_EQ(json(record_of(at(0), "sim", lines::Link{.from = "a", .to = "b", .up = true})),
            R"({"at":0,"node":"sim","kind":"link","from":"a","to":"b","up":true})");
  lines::Link limited{.from = "a", .to = "b", .up = true, .capacity = 0.0};
  EXPECT_EQ(json(record_of(at(0), "sim", limited)),
            R"({"at":0,"node":"sim","kind":"link","from":"a","to":"b","up":true,"capacity":0})");
}

TEST(Line, IsReadBackFromItsRecord) {
  const auto parsed = parse_record(json(record_of(at(1.5), "marvin", a_task())));
  ASSERT_TRUE(parsed.has_value());

  const auto task = read_as<lines::Task>(*parsed);

  ASSERT_TRUE(task);
  EXPECT_EQ(task->uav, "marvin");
  EXPECT_EQ(task->task, 7U);
  EXPECT_EQ(task->reason, "wind");
  EXPECT_EQ(task->device, "");
}

TEST(Line, OfAnotherKindIsNone) {
  EXPECT_FALSE(read_as<lines::Reach>(record_of(at(0), "marvin", a_task())));
}

TEST(Line, WithoutAFieldThatItMustHaveIsNone) {
  Record record(at(0), "marvin", "task");
  record.with("uav", "marvin").with("task", 7).with("type", "goto");

  EXPECT_FALSE(read_as<lines::Task>(record));
}

TEST(Line, WithAFieldOfAnotherShapeIsNone) {
  Record record(at(0), "marvin", "reach");
  record.with("peer", "heliv").with("reachable", "yes");

  EXPECT_FALSE(read_as<lines::Reach>(record));
}

TEST(Line, ANumberWithoutAFractionIsANumber) {
  const auto parsed = parse_record(
      R"({"at":0,"node":"marvin","kind":"decision","uav":"marvin","number":1,"operator":"plan",)"
      R"("cause":"","inputs":"","outcome":"","took":2})");
  ASSERT_TRUE(parsed.has_value());

  const auto decision = read_as<lines::Decision>(*parsed);

  ASSERT_TRUE(decision);
  EXPECT_EQ(decision->took, 2);
  EXPECT_EQ(decision->operator_, "plan");
}

TEST(Line, AGreatIdIsReadBackWhole) {
  lines::Task task = a_task();
  task.task = 18'446'744'073'709'551'615U;

  const auto back = read_as<lines::Task>(record_of(at(0), "marvin", task));

  ASSERT_TRUE(back);
  EXPECT_EQ(back->task, task.task);
}

TEST(Line, ANegativeIdIsNone) {
  Record record(at(0), "marvin", "expired");
  record.with("slot", "Alarm").with("to", "heliv").with("sequence", -1).with("from", "ground");

  EXPECT_FALSE(read_as<lines::Expired>(record));
}

}  // namespace
}  // namespace skein::journal
