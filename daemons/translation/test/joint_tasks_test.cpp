// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/joint_tasks.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace skein::translation {
namespace {

std::string text() { return *rc::gen::element<std::string>("", "heliv", "marvin", "roles", "é"); }
std::uint64_t number() { return *rc::gen::arbitrary<std::uint64_t>(); }
MissionTime instant() {
  return MissionTime::nanoseconds(*rc::gen::inRange<std::int64_t>(0, 1 << 30));
}

template <class Make>
auto some(Make make) {
  std::vector<decltype(make())> all;
  for (int n = *rc::gen::inRange(0, 4); n > 0; --n) all.push_back(make());
  return all;
}

interaction::Rows rows() {
  return some([] {
    return interaction::Row{text(), text(), some([] { return double(*rc::gen::inRange(-9, 9)); })};
  });
}

interaction::Entry entry() {
  return {text(),
          *rc::gen::arbitrary<bool>(),
          rows(),
          *rc::gen::element(interaction::Entry::Vow::kNone, interaction::Entry::Vow::kPromised,
                            interaction::Entry::Vow::kRefused),
          number(),
          text(),
          *rc::gen::arbitrary<bool>()};
}

RC_GTEST_PROP(JointTasks, AMessageOfANegotiationCrossesTheWire, ()) {
  interaction::SessionMessage message;
  message.from = text();
  message.terms = {text(),     *rc::gen::arbitrary<std::uint32_t>(),
                   text(),     some(text),
                   {number()}, rows(),
                   text(),     instant(),
                   instant()};
  message.entries = some(entry);
  message.wants_echo = *rc::gen::arbitrary<bool>();

  RC_ASSERT(from_wire(to_wire(message, "to")) == message);
}

RC_GTEST_PROP(JointTasks, AStateOfAJointTaskCrossesTheWire, ()) {
  interaction::JointTaskStatus status;
  status.uav = text();
  status.subject = text();
  status.task = number();
  status.model = text();
  status.variant = text();
  status.hash = {number()};
  status.phase =
      *rc::gen::element(interaction::JointPhase::kLoading, interaction::JointPhase::kRunning,
                        interaction::JointPhase::kNotLoaded);
  status.why = text();
  for (const std::string& uav : some(text)) status.holders[uav] = text();
  status.active_blocks = some(text);
  status.violated = some(text);
  if (*rc::gen::arbitrary<bool>()) status.agreed_start = instant();
  status.left = rows();

  RC_ASSERT(from_wire(to_wire(status)) == status);
}

TEST(JointTasks, EachOfTheJointTasksOfAUavIsAValueOfItsOwn) {
  interaction::JointTaskStatus one, other;
  one.task = 7;
  other.task = 8;

  EXPECT_NE(to_wire(one).header.instance, to_wire(other).header.instance);
}

}  // namespace
}  // namespace skein::translation
