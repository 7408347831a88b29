// SPDX-License-Identifier: Apache-2.0
// The decision node of one UAV as a node.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "skein/ddn/jobs.hpp"
#include "skein/ddn/sighting_budget.hpp"
#include "skein/decision_node/decision_node.hpp"
#include "skein/foundation/tally.hpp"
#include "skein/node/node.hpp"
#include "skein/node/roster.hpp"
#include "skein/translation/journal_lines.hpp"

namespace skein::ddn {

/// `others` is filled in from the roster.
struct DdnConfig : decision_node::Config {
  Duration deliberation = Duration::seconds(10);  ///< time limit of one plan, with a real clock
};

/// Adapter between samples and records and DecisionNode, which decides. Accepts requests only from
/// the ground station and statuses only from the UAV's functional layer; other samples are dropped,
/// with one record per sender and slot. Source: T II.2, spec 1.2.
class DdnNode final : public node::Node {
 public:
  DdnNode(DdnConfig config, node::Roster roster);

  node::Effects handle(const node::Input& input, MissionTime now) override;
  std::optional<MissionTime> next_wakeup() const override { return decision_.next_wakeup(); }

 private:
  std::optional<decision_node::Input> input_of(const node::Input& input);
  void drop(const node::Received& received, const std::string& why);
  /// Sends this UAV's degree to another one that has come into reach.
  void note_reach(const node::Reachability& reach);

  // to the ground station
  void carry_out(const decision_node::Answer& effect);
  void carry_out(const decision_node::TaskChanged& effect);
  void carry_out(const decision_node::StatusPassedOn& effect);
  void carry_out(const decision_node::TelemetryPassedOn& effect);
  void carry_out(const decision_node::PerceptionPassedOn& effect);
  void carry_out(const decision_node::SyncPassedOn& effect);
  void carry_out(const decision_node::NegotiationPassedOn& effect);
  void carry_out(const decision_node::PartnerPassedOn& effect);
  void carry_out(const decision_node::DegreeChanged& effect);
  void carry_out(const decision_node::HandedOver& effect);
  void carry_out(const decision_node::BoardChanged& effect);
  void carry_out(const supervisor::MissionDecided& effect);
  void carry_out(const supervisor::PlanChanged& effect);
  void carry_out(const supervisor::Decided& effect);
  // to others
  void carry_out(const decision_node::ToVehicle& effect);
  void carry_out(const decision_node::SendSync& effect);
  void carry_out(const decision_node::SendNegotiation& effect);
  void carry_out(const decision_node::SendTeam& effect);
  void carry_out(const decision_node::SendMerge& effect);
  void carry_out(const decision_node::SendFrontier& effect);
  void carry_out(const decision_node::JointTaskChanged& effect);
  void carry_out(const decision_node::SpokenFor& effect);
  void carry_out(const decision_node::ShareTelemetry& effect);
  // for the journal, and jobs
  template <class Noted>
  void carry_out(const Noted& effect);
  void carry_out(const decision_node::SaleNoted& effect);

  void send(node::NodeNumber to, wire::Sample sample, MissionTime expires = MissionTime::max());
  void send_to_ground(wire::Sample sample) { send(roster_.ground(), std::move(sample)); }
  void note(const node::Undelivered& lost);
  void log(journal::Record record);
  template <class Line>
  requires requires { Line::kKind; }
  void log(Line line) { log(writer().record(std::move(line))); }
  translation::Writer writer() const { return {now_, uav_}; }

  std::string uav_;
  node::Roster roster_;
  node::NodeNumber functional_;  ///< the functional layer of its UAV
  wire::AutonomyDegree degree_;  ///< as last told
  std::set<node::NodeNumber> uavs_in_reach_;
  Jobs jobs_;
  team::Roster team_;
  std::vector<wire::ModelVersion> models_;  ///< of joint tasks, that it has
  decision_node::DecisionNode decision_;
  SightingBudget sightings_;
  std::map<std::uint64_t, wire::PlanEntry> logged_plan_;  ///< its tasks, as last logged
  Tally<std::pair<node::NodeNumber, wire::Slot>> dropped_{256};

  // Of the call that is running.
  MissionTime now_;
  node::Effects out_;
};

}  // namespace skein::ddn
