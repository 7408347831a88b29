// SPDX-License-Identifier: Apache-2.0
// Random values of the domain, for round trips over the wire.
#pragma once

#include <rapidcheck.h>

#include <string>
#include <vector>

#include "skein/functional/parameters.hpp"
#include "skein/translation/missions.hpp"
#include "skein/translation/tasks.hpp"
#include "skein/world/perception.hpp"
#include "skein/world/telemetry.hpp"

namespace skein::translation::testing {

inline double any_number() {
  return static_cast<double>(*rc::gen::inRange<std::int64_t>(-1'000'000'000, 1'000'000'000)) / 977;
}

/// What the wire takes for text whatever follows it: ASCII without the zero.
inline std::string any_text() {
  const auto byte =
      rc::gen::map(rc::gen::inRange(1, 128), [](int i) { return static_cast<char>(i); });
  return *rc::gen::container<std::string>(byte);
}

inline std::uint64_t any_id() { return *rc::gen::arbitrary<std::uint64_t>(); }

inline MissionTime any_instant() {
  return MissionTime::nanoseconds(*rc::gen::arbitrary<std::int64_t>());
}

/// Up to three of what `make` makes.
template <class Make>
auto some(Make make) {
  std::vector<decltype(make())> all;
  const int count = *rc::gen::inRange(0, 4);
  for (int i = 0; i < count; ++i) all.push_back(make());
  return all;
}

inline world::Vector3 any_vector() { return {any_number(), any_number(), any_number()}; }

/// That single precision can say.
inline double any_float() { return static_cast<float>(any_number()); }
inline world::Vector3 any_float_vector() { return {any_float(), any_float(), any_float()}; }

inline world::VehicleState any_vehicle_state() {
  return {any_float_vector(), any_float_vector(),          any_float(),
          any_float(),        *rc::gen::arbitrary<bool>(), any_text()};
}

inline world::Telemetry any_telemetry() {
  return {any_text(), any_vehicle_state(), any_instant(), some(any_text)};
}

inline world::Detection any_detection() {
  return {any_text(), any_float_vector(), any_float(), any_float()};
}

inline world::Perception any_perception() {
  return {any_text(),  any_text(),  any_float_vector(),  any_float_vector(),
          any_float(), any_float(), some(any_detection), any_instant()};
}

inline functional::Parameters any_parameters() {
  return functional::Parameters(some([] {
    return functional::Parameter{any_text(), any_text(), some(any_number)};
  }));
}

inline executive::TaskState any_state() {
  return static_cast<executive::TaskState>(*rc::gen::inRange(0, 6));
}

inline executive::Condition any_condition() {
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      return executive::TaskInState{executive::TaskId(any_id()), any_state()};
    case 1:
      return executive::MessageReceived{any_text()};
    default:
      return executive::TimeIs{any_instant(), *rc::gen::arbitrary<bool>()};
  }
}

inline executive::Literal any_literal() {
  return {any_condition(), *rc::gen::arbitrary<bool>(),
          *rc::gen::arbitrary<bool>() ? executive::Modality::kOptional
                                      : executive::Modality::kMandatory};
}

inline executive::Formula any_formula() {
  return some([] { return some(any_literal); });
}

inline executive::Synchronisation any_synchronisation() {
  executive::Synchronisation sync{any_id(), some(any_text), some(any_text), std::nullopt};
  if (*rc::gen::arbitrary<bool>()) sync.deadline = any_instant();
  return sync;
}

inline executive::Task any_task() {
  executive::Task task;
  task.id = executive::TaskId(any_id());
  task.type = any_text();
  task.parameters = any_parameters();
  task.preconditions = any_formula();
  task.exit = any_formula();
  if (*rc::gen::arbitrary<bool>()) task.synchronisation = any_synchronisation();
  return task;
}

inline executive::UpdateConditions any_update() {
  executive::UpdateConditions update{executive::TaskId(any_id()), std::nullopt, std::nullopt};
  if (*rc::gen::arbitrary<bool>()) update.preconditions = any_formula();
  if (*rc::gen::arbitrary<bool>()) update.exit = any_formula();
  return update;
}

inline executive::InsertionMode any_mode() {
  return static_cast<executive::InsertionMode>(*rc::gen::inRange(0, 4));
}

// ---- missions ----

inline bool any_truth() { return *rc::gen::arbitrary<bool>(); }

/// A name as the domain and the scenario have it: no spaces.
inline std::string any_word() {
  const auto letter =
      rc::gen::map(rc::gen::inRange(0, 26), [](int i) { return static_cast<char>('a' + i); });
  return *rc::gen::nonEmpty(rc::gen::container<std::string>(letter));
}

inline std::uint64_t any_positive() {
  return *rc::gen::inRange<std::uint64_t>(1, std::uint64_t{1} << 62U);
}

inline std::optional<MissionTime> perhaps_an_instant() {
  if (any_truth()) return std::nullopt;
  return MissionTime::nanoseconds(*rc::gen::inRange<std::int64_t>(-1'000'000, 1'000'000'000));
}

inline mission::TimeConstraints any_time_constraints() {
  return {perhaps_an_instant(), perhaps_an_instant(), perhaps_an_instant(), perhaps_an_instant()};
}

inline mission::Argument any_argument() {
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return any_word();
    case 1:
      return any_number();
    case 2:
      return any_vector();
    default:
      return some(any_word);
  }
}

inline mission::GoalBound any_goal_bound() {
  const auto least = Duration::nanoseconds(*rc::gen::inRange<std::int64_t>(0, 1'000'000'000));
  return {mission::GoalId(any_positive()), any_truth(), least,
          any_truth() ? Duration::max() : least + Duration::seconds(5)};
}

inline mission::HighLevelTask any_high_level_task() {
  return {mission::GoalId(any_positive()), any_text(), some(any_argument), any_time_constraints(),
          some(any_goal_bound)};
}

inline mission::MissionEstimate any_estimate() {
  return {static_cast<mission::Placement>(*rc::gen::inRange(0, 5)),
          any_number(),
          any_number(),
          any_instant(),
          any_instant(),
          any_instant()};
}

inline mission::UnitMission any_unit_mission() {
  return {mission::MissionId(any_positive()),
          some(any_high_level_task),
          static_cast<mission::Placement>(*rc::gen::inRange(0, 5)),
          any_truth(),
          any_truth(),
          any_text(),
          any_truth()};
}

inline mission::CancelGoals any_cancellation() {
  return {some([] { return mission::GoalId(any_positive()); }), mission::MissionId(any_id()),
          any_truth()};
}

inline mission::GoalStatus any_goal() {
  return {mission::GoalId(any_id()),
          mission::MissionId(any_id()),
          any_text(),
          static_cast<mission::GoalState>(
              *rc::gen::inRange(0, static_cast<int>(mission::GoalState::kCount))),
          any_text(),
          any_text(),
          any_text()};
}

/// Ascending ids.
inline std::vector<mission::HeldTask> any_held_tasks() {
  std::uint64_t id = 0;
  return some([&] {
    mission::HeldTask held{any_task(), static_cast<executive::TaskState>(*rc::gen::inRange(0, 4)),
                           any_truth(), mission::GoalId(any_id())};
    held.task.id = executive::TaskId(id += *rc::gen::inRange<std::uint64_t>(1, 1000));
    return held;
  });
}

inline mission::Dependence any_dependence() {
  return {static_cast<mission::DependenceKind>(*rc::gen::inRange(0, 3)),
          executive::TaskId(any_id())};
}

/// What the wire has fields for; the rest as constructed.
inline mission::PlannedTask any_planned_task(std::uint64_t id) {
  mission::PlannedTask planned;
  planned.task.id = executive::TaskId(id);
  planned.task.type = any_text();
  planned.task.origin = mission::GoalId(any_id());
  planned.task.dependences = some(any_dependence);
  planned.task.stop = some(any_dependence);
  planned.task.way = some(any_vector);
  planned.task.methods = some(any_word);
  const auto later = [](MissionTime t) {
    return any_truth() ? MissionTime::max() : t + Duration::seconds(std::abs(any_number()));
  };
  const auto start = MissionTime::seconds(any_number());
  const auto end = MissionTime::seconds(any_number());
  planned.dates = {start, later(start), end, later(end)};
  planned.committed = any_truth();
  return planned;
}

inline mission::PlanReport any_plan_report() {
  std::uint64_t id = any_positive();
  return {any_id(), any_instant(), some([&] { return any_planned_task(id++); }), some(any_goal)};
}

}  // namespace skein::translation::testing
