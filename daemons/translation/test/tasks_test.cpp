// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/tasks.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "testing/generators.hpp"

namespace skein::translation {
namespace {

template <class Kind>
Kind over_the_wire(const Kind& request) {
  return std::get<Kind>(from_wire(to_wire(Request(request))));
}

// ---- enumerations: both sides mean the same by every name ----

class EveryTaskState : public ::testing::TestWithParam<executive::TaskState> {};

TEST_P(EveryTaskState, KeepsItsNameOnTheWireAndBack) {
  const executive::TaskState state = GetParam();

  EXPECT_EQ(wire::name_of(to_wire(state)), executive::to_text(state));
  EXPECT_EQ(from_wire(to_wire(state)), state);
}

INSTANTIATE_TEST_SUITE_P(
    Tasks, EveryTaskState,
    ::testing::Values(executive::TaskState::kScheduled, executive::TaskState::kStarted,
                      executive::TaskState::kRunning, executive::TaskState::kAborting,
                      executive::TaskState::kEnded, executive::TaskState::kAborted),
    [](const auto& one) { return std::string(to_text(one.param)); });

class EveryRequestKind : public ::testing::TestWithParam<executive::RequestKind> {};

TEST_P(EveryRequestKind, KeepsItsNameOnTheWire) {
  EXPECT_EQ(wire::name_of(to_wire(GetParam())), executive::to_text(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Tasks, EveryRequestKind,
                         ::testing::Values(executive::RequestKind::kStart,
                                           executive::RequestKind::kAbort,
                                           executive::RequestKind::kProcessMessage,
                                           executive::RequestKind::kUpdateConditions,
                                           executive::RequestKind::kSuppress));

class EveryInsertionMode : public ::testing::TestWithParam<executive::InsertionMode> {};

TEST_P(EveryInsertionMode, KeepsItsNameOnTheWireAndBack) {
  const executive::Start start{{}, GetParam()};

  EXPECT_EQ(wire::name_of(to_wire(Request(start)).mode), executive::to_text(GetParam()));
  EXPECT_EQ(over_the_wire(start).mode, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Tasks, EveryInsertionMode,
                         ::testing::Values(executive::InsertionMode::kSeq,
                                           executive::InsertionMode::kVut,
                                           executive::InsertionMode::kDep,
                                           executive::InsertionMode::kNut),
                         [](const auto& one) { return std::string(to_text(one.param)); });

// ---- round trips ----

RC_GTEST_PROP(Tasks, AFormulaComesBackAsItWas, ()) {
  const executive::Formula formula = testing::any_formula();

  RC_ASSERT(from_wire(to_wire(formula)) == formula);
}

RC_GTEST_PROP(Tasks, ATaskComesBackAsItWas, ()) {
  const executive::Task task = testing::any_task();

  RC_ASSERT(from_wire(to_wire(task)) == task);
}

RC_GTEST_PROP(Tasks, AStartComesBackAsItWas, ()) {
  const executive::Start start{testing::any_task(), testing::any_mode()};

  const executive::Start back = over_the_wire(start);

  RC_ASSERT(back.task == start.task);
  RC_ASSERT(back.mode == start.mode);
}

RC_GTEST_PROP(Tasks, AnUpdateComesBackAndWhatIsAbsentStaysAbsent, ()) {
  const executive::UpdateConditions update = testing::any_update();

  const executive::UpdateConditions back = over_the_wire(update);

  RC_ASSERT(back.id == update.id);
  RC_ASSERT(back.preconditions == update.preconditions);
  RC_ASSERT(back.exit == update.exit);
}

RC_GTEST_PROP(Tasks, AbortSuppressAndMessageComeBackAsTheyWere, ()) {
  const executive::TaskId id(testing::any_id());
  const std::string text = testing::any_text();

  RC_ASSERT(over_the_wire(executive::Abort{id}).id == id);
  RC_ASSERT(over_the_wire(executive::Suppress{id}).id == id);
  RC_ASSERT(over_the_wire(executive::ProcessMessage{text}).message == text);
}

// An update with an empty formula is not an update without one.
TEST(Tasks, AnEmptyFormulaOfAnUpdateIsNotAnAbsentOne) {
  const executive::UpdateConditions update{executive::TaskId(4), executive::Formula(),
                                           std::nullopt};

  const executive::UpdateConditions back = over_the_wire(update);

  EXPECT_EQ(back.preconditions, executive::Formula());
  EXPECT_EQ(back.exit, std::nullopt);
}

TEST(Tasks, ASynchronisationWithoutADeadlineIsNotOneWithADeadlineAtZero) {
  executive::Task without;
  without.synchronisation = executive::Synchronisation{551, {"a"}, {"b"}, std::nullopt};
  executive::Task at_zero = without;
  at_zero.synchronisation->deadline = MissionTime();

  EXPECT_EQ(from_wire(to_wire(without)).synchronisation->deadline, std::nullopt);
  EXPECT_EQ(from_wire(to_wire(at_zero)).synchronisation->deadline, MissionTime());
}

RC_GTEST_PROP(Tasks, WhatIsTranslatedKeepsTheRulesOfTheWire, ()) {
  wire::TaskRequest request =
      to_wire(Request(executive::Start{testing::any_task(), testing::any_mode()}));

  RC_ASSERT(!wire::find_violation(wire::Sample(request)).has_value());
}

// ---- the rest ----

TEST(Tasks, ARequestBecomesTheExecutivesInputOfTheSameKind) {
  EXPECT_TRUE(std::holds_alternative<executive::Start>(to_input(executive::Start{})));
  EXPECT_TRUE(std::holds_alternative<executive::Abort>(to_input(executive::Abort{})));
  EXPECT_TRUE(
      std::holds_alternative<executive::ProcessMessage>(to_input(executive::ProcessMessage{})));
  EXPECT_TRUE(
      std::holds_alternative<executive::UpdateConditions>(to_input(executive::UpdateConditions{})));
  EXPECT_TRUE(std::holds_alternative<executive::Suppress>(to_input(executive::Suppress{})));
}

TEST(Tasks, ATaskEventCarriesWhoseItIsAndWhen) {
  const executive::TaskEvent event{executive::TaskId(7), "goto", executive::TaskState::kAborted,
                                   "no way", executive::AbortCause::kNoAir};

  const wire::TaskEvent sample = to_wire("karma", event, MissionTime::seconds(1.5));

  EXPECT_EQ(sample.uav, "karma");
  EXPECT_EQ(sample.id, 7U);
  EXPECT_EQ(sample.type, "goto");
  EXPECT_EQ(sample.state, wire::TaskState::kAborted);
  EXPECT_EQ(sample.reason, "no way");
  EXPECT_EQ(sample.cause, wire::AbortCause::kNoAir);
  EXPECT_EQ(sample.at, 1'500'000'000);
  EXPECT_EQ(from_wire(sample), event);
}

// ---- the port to the vehicle ----

RC_GTEST_PROP(Port, ParametersComeBackInOrderRepeatedNamesIncluded, ()) {
  const functional::Parameters parameters = testing::any_parameters();

  RC_ASSERT(from_wire(to_wire(parameters)) == parameters);
}

RC_GTEST_PROP(Port, ARequestReachesTheFunctionalLayerUnchanged, ()) {
  const functional::Request request{
      *rc::gen::element(functional::Verb::kDispatch, functional::Verb::kInterrupt),
      functional::TaskId(*rc::gen::arbitrary<std::uint64_t>()), testing::any_text(),
      testing::any_parameters()};

  const wire::FunctionalRequest sample = to_wire("marvin", request);

  RC_ASSERT(sample.uav == "marvin");
  RC_ASSERT(from_wire(sample) == request);
}

RC_GTEST_PROP(Port, AStatusComesBackUnchanged, ()) {
  const functional::Status status{
      functional::TaskId(*rc::gen::arbitrary<std::uint64_t>()),
      *rc::gen::element(functional::TaskState::kRunning, functional::TaskState::kEnded,
                        functional::TaskState::kAborted),
      testing::any_text(),
      *rc::gen::element(functional::AbortCause::kOther, functional::AbortCause::kRequested,
                        functional::AbortCause::kNoAir)};

  RC_ASSERT(from_wire(to_wire("marvin", status)) == status);
}

}  // namespace
}  // namespace skein::translation
