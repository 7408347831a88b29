// SPDX-License-Identifier: Apache-2.0
// The ground station as a node.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/ground/air_desk.hpp"
#include "skein/ground/inbox.hpp"
#include "skein/ground/operator_boards.hpp"
#include "skein/ground/played_roles.hpp"
#include "skein/ground/temporal_desk.hpp"
#include "skein/ground_station/ground_control.hpp"
#include "skein/ground_station/team_desk.hpp"
#include "skein/node/node.hpp"
#include "skein/node/roster.hpp"
#include "skein/translation/journal_lines.hpp"
#include "skein/world/terrain.hpp"

namespace skein::ground {

/// Adapter between samples and records and GroundControl (the CDN: MPS, MCS, PPS). Incoming samples
/// go through the Inbox. Operators get boards and answers to their requests on the world channel.
/// Source: spec 1.1.
class GroundNode final : public node::Node {
 public:
  using ReadRequest = Inbox::ReadRequest;

  /// Without a reader every request of an operator is refused; `played`: UAVs for which the ground
  /// station can play roles.
  GroundNode(const ground_station::GroundConfig& config, world::Terrain terrain,
             node::Roster roster, ReadRequest read_request = {},
             std::optional<team::Config> team = std::nullopt,
             std::vector<decision_node::Config> played = {});

  /// Makes the node the witness of plan merging for these UAVs. Precondition: before the first
  /// input.
  void witness(const std::vector<std::string>& merging) { air_.emplace(roster_, merging); }

  node::Effects handle(const node::Input& input, MissionTime now) override;
  std::optional<MissionTime> next_wakeup() const override;
  void begin_recall() override { boards_.go_unread(); }
  node::Effects end_recall() override;

 private:
  using Input = Inbox::Input;

  template <class Effect>
  void tell_or_do(const Effect& effect);
  void carry_out(const ground_station::SendRequest& effect);
  void carry_out(const ground_station::SendFunctional& effect);
  void carry_out(const ground_station::SendSync& effect);
  void carry_out(const ground_station::AlarmEvent& effect);
  void carry_out(const ground_station::TellAlarm& effect);
  void carry_out(const ground_station::ObjectSeen& effect);
  void carry_out(const ground_station::OperatorAnswered& effect);
  void carry_out(const ground_station::CommandChanged& effect);
  void carry_out(const ground_station::LocalTaskEvent& effect);
  void carry_out(const ground_station::PhaseEntered& effect);
  void carry_out(const ground_station::DegreeChanged&) {}  // the UAV logs its own
  void carry_out(const ground_station::MissionFinished& effect);
  // the team
  void tell_team(const ground_station::TeamDesk::Input& input);
  void tell_control(const Input& input);
  bool hear_team(const node::Input& input);
  void carry_out(const ground_station::GiveGlobalMission& effect);
  void carry_out(const ground_station::DeclareLost& effect);
  void carry_out(const ground_station::DeclareFound& effect);
  void tell_if_lost(const std::string& uav);
  void tell_others(const std::string& uav, const std::string& message);
  void carry_out(const ground_station::TeamTell& effect);
  void carry_out(const ground_station::TeamTaskChanged& effect);
  void carry_out(const ground_station::GlobalMissionChanged& effect);
  void carry_out(const ground_station::TeamSaleTold& effect);
  // roles that are played here
  void carry_out(PlayedRoles::Outcome outcome);
  bool hear_of_roles(const node::Input& input);
  void carry_out(const ground_station::PlayRole& effect);
  void carry_out(const ground_station::StopRole& effect);

  void send(const std::string& uav, wire::Sample sample, MissionTime expires = MissionTime::max(),
            std::uint64_t receipt = 0);
  wire::Sample sample_of(const ground_station::SendRequest& effect) const;
  void log(std::optional<journal::Record> line);
  translation::Writer writer() const { return {now_, "ground"}; }
  template <class Line>
  requires requires { Line::kKind; }
  void log(Line line) { log(writer().record(std::move(line))); }

  world::Terrain terrain_;
  node::Roster roster_;
  Inbox inbox_;
  ground_station::GroundControl control_;
  std::optional<ground_station::TeamDesk> team_;
  std::set<std::string> out_of_reach_;   ///< team messages are not sent to them
  std::set<std::string> declared_lost_;  ///< and not found again
  PlayedRoles roles_;
  TemporalDesk dates_;
  std::optional<AirDesk> air_;  ///< absent: no plan merging
  bool alarms_age_;
  OperatorBoards boards_;

  // Of the call that is running.
  MissionTime now_;
  bool happened_ = false;
  node::Effects out_;
};

}  // namespace skein::ground
