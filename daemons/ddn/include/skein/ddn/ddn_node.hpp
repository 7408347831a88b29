// SPDX-License-Identifier: Apache-2.0
// The decision node of one UAV.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include "skein/ddn/contact.hpp"
#include "skein/executive/executive.hpp"
#include "skein/node/node.hpp"
#include "skein/node/roster.hpp"

namespace skein::ddn {

struct DdnConfig {
  std::string uav;
  int degree = 3;  ///< 1 to 3
  ContactPolicy contact_policy = ContactPolicy::kContinue;
  Duration contact_after = Duration::seconds(60);
  /// Where `kReturn` goes before it lands: x, y, z [m] ENU.
  std::vector<double> home = {0, 0, 50};
  std::optional<Duration> functional_timeout = Duration::seconds(120);
  std::optional<std::string> background_type;
};

/// A DDN (T II): between the ground station and the functional layer of one UAV.
///
/// - Degree 1: a transparent connecting point. Elementary requests of the ground go to the
/// functional
///   layer, its statuses and synchronisation messages of others go to the ground.
/// - Degree 2: the MLE runs partially ordered plans; its synchronisation messages go to the ground,
///   which relays them.
/// - Degree 3: they go straight to the MLE of the other UAV.
///
/// At every degree telemetry and perceptions are passed on to the ground, and the contact-loss
/// policy is carried out by the MLE on board, with task ids from kFirstOwnTask. A command is
/// executed once: its number, seen again from the same life of the ground station, gets the same
/// answer and nothing else. Requests are taken from the ground and statuses from the simulator
/// only. Source: T II.2, T III, spec 1.2.
class DdnNode final : public node::Node {
 public:
  /// Own tasks are numbered from here on, by the millisecond of the mission in which they were
  /// made, so that a node that was restarted does not use a number twice. The ground's are below.
  static constexpr std::uint64_t kFirstOwnTask = 1'000'000'000;

  DdnNode(DdnConfig config, node::Roster roster);

  node::Effects handle(const node::Input& input, MissionTime now) override;
  std::optional<MissionTime> next_wakeup() const override;

 private:
  void on(const node::Started& started);
  void on(const node::Received& received);
  void on(const node::Reachability& reach);
  void on(const node::Undelivered&) {}
  void on(const node::JobDone&) {}
  void on(const node::Wakeup&);

  std::string why_not(const node::Received& received) const;
  void refuse(const wire::TaskRequest& request, const char* why);
  void take(const wire::TaskRequest& request);
  void take(const wire::FunctionalRequest& request);
  void take(const wire::FunctionalStatus& status);
  void take(const wire::SyncMessage& message);
  void take(const wire::Telemetry& telemetry);
  void take(const wire::PerceptionReport& report);
  template <class Other>
  void take(const Other&) {}

  void run(const executive::Input& input);
  void carry_out(const executive::Effects& effects);
  void carry_out(const executive::TaskEvent& event);
  void carry_out(const executive::Dispatch& dispatch);
  void carry_out(const executive::Interrupt& interrupt);
  void carry_out(const executive::SendSync& sync);
  void carry_out(const executive::Reply& reply);
  void carry_out(const executive::Notice& notice);
  void carry_out(const executive::ForwardToSupervisor&) {}

  void carry_out_contact_policy();
  void start_safe_tasks();
  void interrupt_functional(std::uint64_t task);
  void start_own(const std::string& type, executive::Parameters parameters,
                 executive::InsertionMode mode);
  void answer(const wire::TaskRequest& request, wire::RequestReply reply);
  void send_to_ground(wire::Sample sample);
  void send_board_if_changed();
  void log(journal::Record record);
  journal::Record record(const char* kind) const;
  bool own_task(std::uint64_t id) const { return id >= kFirstOwnTask; }

  DdnConfig config_;
  node::Roster roster_;
  executive::Executive executive_;
  ContactWatch contact_;
  bool airborne_ = false;
  std::set<std::uint64_t> passed_through_;  ///< degree 1: the ground's tasks that are under way
  bool safe_tasks_pending_ = false;  ///< they begin when nothing of the ground's is under way
  std::uint64_t next_own_task_ = kFirstOwnTask;
  /// By incarnation of the ground and command number.
  std::map<std::pair<std::uint64_t, std::uint64_t>, wire::RequestReply> answered_;
  std::set<std::pair<node::NodeNumber, wire::Slot>> dropped_;  ///< already logged
  executive::InsertionMode mode_of_request_ = executive::InsertionMode::kSeq;
  std::optional<wire::PlanBoard> last_board_;

  // Of the call that is running.
  MissionTime now_;
  node::Effects out_;
};

}  // namespace skein::ddn
