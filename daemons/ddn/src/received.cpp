// SPDX-License-Identifier: Apache-2.0
#include "received.hpp"

#include "skein/foundation/overloaded.hpp"
#include "skein/team_translation/meetings.hpp"
#include "skein/team_translation/team.hpp"
#include "skein/translation/joint_tasks.hpp"
#include "skein/translation/merging.hpp"
#include "skein/translation/missions.hpp"
#include "skein/translation/sensing.hpp"
#include "skein/translation/tasks.hpp"

namespace skein::ddn {

namespace {

namespace dn = decision_node;
using dn::Input;
using translation::from_wire;

constexpr const char* kOfAnother = "it is said in the name of another";

template <class Sample>
dn::CommandKey key_of(const Sample& sample) {
  return {sample.header.incarnation, sample.command};
}

Input input_of(const wire::TaskRequest& sample) {
  if (sample.kind > wire::RequestKind::kSuppress) {
    return dn::UnreadableCommand{key_of(sample), from_wire(sample.kind), sample.id,
                                 "not a request to an executive"};
  }
  dn::Command command{key_of(sample), mission::Request()};
  std::visit([&](const auto& request) { command.request = request; }, from_wire(sample));
  return command;
}

Input input_of(const wire::MissionRequest& sample) {
  const auto read = from_wire(sample);
  if (!read) {
    const auto kind =
        sample.cancel ? mission::RequestKind::kCancel : mission::RequestKind::kMission;
    return dn::UnreadableCommand{key_of(sample), kind, sample.unit_mission,
                                 translation::to_text(read.error())};
  }
  dn::Command command{key_of(sample), mission::Request(), sample.asked_by};
  std::visit([&](const auto& request) { command.request = request; }, *read);
  return command;
}

Input input_of(const wire::DegreeCommand& sample) {
  const auto read = from_wire(sample);
  if (read) return dn::Command{key_of(sample), *read, sample.asked_by};
  return dn::UnreadableCommand{key_of(sample), mission::RequestKind::kDegree, 0,
                               translation::to_text(read.error())};
}

Input input_of(const wire::WorldChange& sample) {
  const auto read = from_wire(sample);
  if (read) return dn::Command{key_of(sample), *read};
  return dn::UnreadableCommand{key_of(sample), mission::RequestKind::kWorld, 0,
                               translation::to_text(read.error())};
}

dn::SyncMessage input_of(const wire::SyncMessage& sample) {
  const executive::SyncReceived read = from_wire(sample);
  return {read.id, read.from, sample.to, read.word, MissionTime::nanoseconds(sample.said)};
}

std::optional<Input> input_of(const wire::PlanFrontier& sample, const Sender& sender) {
  auto frontier = from_wire(sample);
  if (!frontier) return std::nullopt;
  return dn::FrontierTold{sample.uav, std::move(*frontier), sender.ground};
}

// What makes no sense is as if it had not come: it is said again.
template <class Told, class Sample>
std::optional<Input> told_by(const Sender& sender, const Sample& sample) {
  auto said = from_wire(sample);
  if (!said) return std::nullopt;
  return Told{sender.name, std::move(*said)};
}

}  // namespace

std::string why_not(const wire::Sample& sample, const Sender& sender) {
  switch (wire::slot_of(sample)) {
    case wire::Slot::kTaskRequest:
    case wire::Slot::kFunctionalRequest:
    case wire::Slot::kMissionRequest:
    case wire::Slot::kDegreeCommand:
    case wire::Slot::kWorldChange:
    case wire::Slot::kAlarm:
    case wire::Slot::kSeenObject:
      return sender.ground ? "" : "only the ground station makes requests";
    case wire::Slot::kTaskEvent:
      return sender.ground ? "" : "only the ground station has tasks of others";
    case wire::Slot::kTelemetry:
      if (std::get<wire::Telemetry>(sample).uav == sender.name) return "";
      [[fallthrough]];
    case wire::Slot::kFunctionalStatus:
    case wire::Slot::kPerceptionReport:
      return sender.functional ? "" : "only the functional layer tells of the vehicle";
    case wire::Slot::kNegotiationMessage:  // the ground plays roles: in the name of this UAV
      if (sender.ground) return "";
      return std::get<wire::NegotiationMessage>(sample).from == sender.name ? "" : kOfAnother;
    case wire::Slot::kJointTaskState:
      if (sender.ground) return "";
      return std::get<wire::JointTaskState>(sample).uav == sender.name ? "" : kOfAnother;
    case wire::Slot::kAutonomyDegree:
      return std::get<wire::AutonomyDegree>(sample).uav == sender.name ? "" : kOfAnother;
    case wire::Slot::kPlanFrontier:  // the ground tells of others
      if (sender.ground) return "";
      return std::get<wire::PlanFrontier>(sample).uav == sender.name ? "" : kOfAnother;
    default:
      return "";
  }
}

std::optional<Input> input_of(const wire::Sample& sample, const Sender& sender) {
  using Result = std::optional<Input>;
  return std::visit(
      Overloaded{
          [](const wire::TaskRequest& it) -> Result { return input_of(it); },
          [](const wire::MissionRequest& it) -> Result { return input_of(it); },
          [](const wire::DegreeCommand& it) -> Result { return input_of(it); },
          [](const wire::WorldChange& it) -> Result { return input_of(it); },
          // An alarm without a number is none.
          [](const wire::Alarm& it) -> Result {
            return it.id == 0 ? Result() : dn::PlaceTold{translation::change_of(it)};
          },
          [](const wire::SeenObject& it) -> Result {
            return it.name.empty() ? Result() : dn::PlaceTold{translation::change_of(it)};
          },
          [](const wire::FunctionalRequest& it) -> Result {
            return dn::ElementaryRequest{from_wire(it)};
          },
          [](const wire::TaskEvent& it) -> Result { return dn::GroundTaskSeen{from_wire(it)}; },
          [](const wire::FunctionalStatus& it) -> Result { return dn::StatusTold{from_wire(it)}; },
          [](const wire::SyncMessage& it) -> Result { return input_of(it); },
          [&](const wire::AutonomyDegree& it) -> Result {
            const bool is_one =
                it.degree >= mission::kLeastDegree && it.degree <= mission::kGreatestDegree;
            return is_one ? dn::DegreeTold{sender.name, it.degree} : Result();
          },
          [&](const wire::Telemetry& it) -> Result {
            if (sender.functional) return from_wire(it);
            return dn::PartnerSeen{from_wire(it)};
          },
          [&](const wire::NegotiationMessage& it) -> Result {
            if (sender.ground) return dn::GroundNegotiates{it.to, from_wire(it)};
            return from_wire(it);
          },
          [&](const wire::JointTaskState& it) -> Result {
            if (sender.ground) return dn::GroundPlays{from_wire(it)};
            return dn::JointTaskTold{from_wire(it),
                                     MissionTime::nanoseconds(it.header.mission_time)};
          },
          [&](const wire::TeamMessage& it) { return told_by<dn::TeamTold>(sender, it); },
          [&](const wire::TeamSale& it) { return told_by<dn::TeamTold>(sender, it); },
          [&](const wire::MergeMessage& it) { return told_by<dn::MergeTold>(sender, it); },
          [&](const wire::PlanFrontier& it) { return input_of(it, sender); },
          [](const wire::PerceptionReport& it) -> Result { return from_wire(it); },
          [](const auto&) -> Result { return std::nullopt; }},
      sample);
}

}  // namespace skein::ddn
