// SPDX-License-Identifier: Apache-2.0
#include "skein/ground/inbox.hpp"

#include "skein/foundation/fingerprint.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/translation/functional_layer.hpp"
#include "skein/translation/missions.hpp"
#include "skein/translation/sensing.hpp"
#include "skein/translation/tasks.hpp"

namespace skein::ground {

namespace {

namespace gs = ground_station;
using translation::from_wire;
using Meaning = Result<std::optional<Inbox::Input>, wire::Violation>;

gs::PlanBoardReceived board_from(const std::string& uav, const wire::PlanBoard& board) {
  gs::PlanBoardReceived result{
      uav, board.degree, board.airborne, {}, MissionTime::nanoseconds(board.header.mission_time),
      {}};
  for (const wire::TaskEntry& task : board.tasks) {
    result.tasks.push_back({executive::TaskId(task.id), task.type, from_wire(task.state)});
  }
  for (const wire::ModelVersion& one : board.models) result.models[one.model] = one.version;
  return result;
}

// What a UAV says of its executive and its functional layer.
std::optional<Inbox::Input> execution_from(const std::string& uav, const wire::Sample& sample) {
  if (const auto* event = std::get_if<wire::TaskEvent>(&sample)) {
    return gs::TaskEventReceived{uav, executive::TaskId(event->id), event->type,
                                 from_wire(event->state), event->reason};
  }
  if (const auto* reply = std::get_if<wire::RequestReply>(&sample)) {
    return gs::RequestReplyReceived{gs::CommandNumber(reply->command), reply->accepted, reply->why};
  }
  if (const auto* status = std::get_if<wire::FunctionalStatus>(&sample)) {
    return gs::FunctionalStatusReceived{uav, from_wire(*status)};
  }
  if (const auto* sync = std::get_if<wire::SyncMessage>(&sample)) {
    const executive::SyncReceived message = from_wire(*sync);
    return gs::SyncReceived{message.id, message.from, sync->to, message.word, message.said};
  }
  if (const auto* board = std::get_if<wire::PlanBoard>(&sample)) return board_from(uav, *board);
  return std::nullopt;
}

// Where it is, and what its sensors see.
std::optional<Inbox::Input> senses_from(const std::string& uav, const wire::Sample& sample) {
  if (const auto* telemetry = std::get_if<wire::Telemetry>(&sample)) {
    world::Telemetry told = from_wire(*telemetry);
    told.uav = uav;
    return told;
  }
  const auto seen = [&](world::Perception perception) {
    perception.uav = uav;
    return gs::PerceptionReceived{std::move(perception)};
  };
  if (const auto* look = std::get_if<wire::PerceptionReport>(&sample))
    return seen(from_wire(*look));
  if (const auto* look = std::get_if<wire::Sighting>(&sample)) return seen(from_wire(*look));
  return std::nullopt;
}

template <class Received, class Read>
Meaning with_time(const std::string& uav, Read read, MissionTime at) {
  if (!read) return tl::unexpected(read.error());
  return Inbox::Input(Received{uav, std::move(*read), at});
}

// What a UAV that deliberates says of its missions.
Meaning mission_from(const std::string& uav, const wire::Sample& sample) {
  const auto at = MissionTime::nanoseconds(wire::header_of(sample).mission_time);
  if (const auto* plan = std::get_if<wire::MissionPlan>(&sample)) {
    return with_time<gs::MissionPlanReceived>(uav, from_wire(*plan), at);
  }
  if (const auto* hand_over = std::get_if<wire::HandOver>(&sample)) {
    return with_time<gs::HandOverReceived>(uav, from_wire(*hand_over), at);
  }
  if (const auto* decision = std::get_if<wire::Decision>(&sample)) {
    return Inbox::Input(gs::DecisionReceived{uav, from_wire(*decision)});
  }
  if (const auto* outcome = std::get_if<wire::MissionOutcome>(&sample)) {
    return Inbox::Input(gs::MissionOutcomeReceived{uav, from_wire(*outcome)});
  }
  return std::nullopt;
}

}  // namespace

Inbox::Inbox(const node::Roster& roster, ReadRequest read_request)
    : roster_(roster), read_request_(std::move(read_request)) {}

Inbox::Read Inbox::read(const node::Input& input, MissionTime now) {
  if (const auto* received = std::get_if<node::Received>(&input)) {
    if (const std::string why = why_not(*received); !why.empty()) {
      return {std::nullopt, refuse(*received, {"header.origin", why}, now)};
    }
    const auto meaning = input_from(*received);
    if (!meaning) return {std::nullopt, refuse(*received, meaning.error(), now)};
    return {*meaning, std::nullopt};
  }
  if (const auto* delivered = std::get_if<node::Delivered>(&input)) {
    return {gs::CommandDelivered{gs::CommandNumber(delivered->receipt)}, std::nullopt};
  }
  if (const auto* lost = std::get_if<node::Undelivered>(&input)) {
    // Of one that may have arrived the answer is waited for, as of any.
    if (lost->receipt == 0 || lost->may_have_arrived) return {};
    return {gs::CommandUndelivered{gs::CommandNumber(lost->receipt)}, std::nullopt};
  }
  const auto* reach = std::get_if<node::Reachability>(&input);
  if (reach == nullptr || !is_uav(reach->peer)) return {};
  return {gs::PeerReachable{roster_.name_of(reach->peer), reach->reachable, reach->restarted},
          std::nullopt};
}

std::optional<journal::Record> Inbox::refuse(const node::Received& received,
                                             const wire::Violation& violation, MissionTime now) {
  const wire::Slot slot = wire::slot_of(received.sample);
  const auto count = refused_.count({received.from, slot});
  if (!count) return std::nullopt;
  return journal::record_of(now, "ground",
                            journal::lines::Dropped{.slot = wire::slot_name(slot),
                                                    .origin = roster_.name_of(received.from),
                                                    .field = violation.field,
                                                    .why = violation.why + *count});
}

void Inbox::sent(std::uint64_t command, node::NodeNumber addressee) {
  addressees_.insert_or_assign(command, addressee);
  if (addressees_.size() > kAddressees) addressees_.erase(addressees_.begin());
}

bool Inbox::is_uav(node::NodeNumber number) const {
  const node::Member* member = roster_.find(number);
  return member != nullptr && member->role == wire::Role::kDdn;
}

std::string Inbox::why_not(const node::Received& received) const {
  if (std::holds_alternative<wire::OperatorRequest>(received.sample)) {
    return received.from == roster_.operators() ? "" : "not an operator";
  }
  if (!is_uav(received.from)) return "not a UAV of this mission";
  const auto* reply = std::get_if<wire::RequestReply>(&received.sample);
  if (reply == nullptr) return "";
  const auto addressee = addressees_.find(reply->command);
  const bool is_its = addressee == addressees_.end() || addressee->second == received.from;
  return is_its ? "" : "the command was another UAV's";
}

// A UAV is known by the node that sent the sample, whatever name the sample gives.
Meaning Inbox::input_from(const node::Received& received) const {
  const wire::Sample& sample = received.sample;
  if (const auto* request = std::get_if<wire::OperatorRequest>(&sample)) {
    return request_from(*request);
  }
  const std::string uav = roster_.name_of(received.from);
  if (auto sensed = senses_from(uav, sample)) return sensed;
  if (auto executed = execution_from(uav, sample)) return executed;
  return mission_from(uav, sample);
}

Inbox::Input Inbox::request_from(const wire::OperatorRequest& request) const {
  gs::OperatorRequest asked{request.who, request.number,
                            Fingerprint().put(request.request).value()};
  if (!read_request_) {
    asked.problems = {"this ground station takes no requests"};
  } else if (auto deeds = read_request_(request.request)) {
    asked.deeds = std::move(*deeds);
  } else {
    asked.problems = std::move(deeds.error());
  }
  return asked;
}

}  // namespace skein::ground
