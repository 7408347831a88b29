// SPDX-License-Identifier: Apache-2.0
// The decision node of one UAV.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "skein/ddn/contact.hpp"
#include "skein/executive/executive.hpp"
#include "skein/mission/autonomy.hpp"
#include "skein/node/node.hpp"
#include "skein/node/roster.hpp"
#include "skein/supervisor/supervisor.hpp"
#include "skein/translation/journal_lines.hpp"

namespace skein::ddn {

struct DdnConfig {
  std::string uav;
  int degree = 3;  ///< at the start, 1 to 4; 4 needs `knowledge`
  ContactPolicy contact_policy = ContactPolicy::kContinue;
  Duration contact_after = Duration::seconds(60);
  /// Where `kReturn` goes before it lands: x, y, z [m] ENU.
  std::vector<double> home = {0, 0, 50};
  std::optional<Duration> functional_timeout = Duration::seconds(120);
  std::optional<Duration> sync_validity = std::nullopt;  ///< see executive::Config
  std::optional<std::string> background_type;
  /// Null: the scenario has no planning domain, and degree 4 is refused.
  std::shared_ptr<const supervisor::Knowledge> knowledge;
  std::shared_ptr<const world::World> world;      ///< as at the start; null only without knowledge
  Duration horizon = Duration::seconds(15);       ///< commitment, see supervisor::Config
  Duration deliberation = Duration::seconds(10);  ///< for one plan, where there is a clock
  executive::TaskId first_task{1};                ///< of the supervisor's; below kFirstOwnTask
};

/// A DDN (T II): between the ground station and the functional layer of one UAV.
///
/// - Degree 1: a transparent connecting point. Elementary requests of the ground go to the
///   functional layer, its statuses and synchronisation messages of others go to the ground.
/// - Degree 2: the MLE runs partially ordered plans; its synchronisation messages go to the ground,
///   which relays them.
/// - Degree 3: they go straight to the MLE of the other UAV.
/// - Degree 4: the supervisor plans missions and feeds the MLE; its jobs go to the runtime, and
///   everything is answered while they run.
///
/// The degree is changed by the ground at any time. Each change is answered with the plan that is
/// held at that moment (HandOver). Degrees 2 to 4 execute here, so what runs goes on; at degree 1
/// the ground's executive takes over what the one here gives up, under the same ids, and brings it
/// back by START. With `interrupt` all is aborted, the highest id first, and what flies waits.
///
/// At every degree telemetry and perceptions are passed on to the ground, and the contact-loss
/// policy is carried out by the MLE on board, with task ids from kFirstOwnTask; at degree 4 the
/// supervisor then stops deciding until the ground gives the degree again. Such own tasks give way
/// to any task that moves the vehicle: they are aborted, and it is dispatched once they are over.
///
/// A command is executed once: its number, seen again from the same life of the ground station,
/// gets the same answer and nothing else. Requests are taken from the ground and statuses from the
/// simulator only. Source: T II.2, T III, T IV.4, spec 1.2, 6.2.
class DdnNode final : public node::Node {
 public:
  /// Own tasks are numbered from here on, by the millisecond of the mission in which they were
  /// made, so that a node that was restarted does not use a number twice. The ground's are below.
  static constexpr std::uint64_t kFirstOwnTask = 1'000'000'000;

  DdnNode(DdnConfig config, node::Roster roster);

  node::Effects handle(const node::Input& input, MissionTime now) override;
  std::optional<MissionTime> next_wakeup() const override;

 private:
  /// A command of the ground that is to be answered.
  struct Command {
    std::uint64_t incarnation = 0;  ///< of the ground
    std::uint64_t number = 0;
    wire::RequestKind kind = wire::RequestKind::kStart;
    std::uint64_t id = 0;  ///< of the task or unit mission
  };
  struct ForExecutive {
    executive::Input input;
    bool by_supervisor = false;
    std::optional<Command> command;
  };
  struct ForSupervisor {
    supervisor::Input input;
    std::optional<Command> command;
  };

  // ddn_node.cpp: inputs, and errands between the two components, done in the order given
  void on(const node::Started& started);
  void on(const node::Received& received);
  void on(const node::Reachability& reach);
  void on(const node::Undelivered&) {}
  void on(const node::JobDone& done);
  void on(const node::Wakeup&);
  std::string why_not(const node::Received& received) const;
  void drop(const node::Received& received, const std::string& why);
  void run(executive::Input input);
  void run(ForExecutive errand);
  void tell(supervisor::Input input, std::optional<Command> command = std::nullopt);
  void do_errands();
  void do_errand(const ForExecutive& errand);
  void do_errand(const ForSupervisor& errand);
  void send_to_ground(wire::Sample sample);
  void send_board_if_changed();
  void log(journal::Record record);
  journal::Record record(const char* kind) const;
  translation::Writer writer() const { return {now_, config_.uav}; }

  // requests.cpp: what comes in
  void take(const wire::TaskRequest& request);
  void take(const wire::MissionRequest& request);
  void take(const wire::WorldChange& change);
  void take(const wire::Alarm& alarm);
  void take(const wire::FunctionalRequest& request);
  void take(const wire::FunctionalStatus& status);
  void take(const wire::SyncMessage& message);
  void take(const wire::TaskEvent& event);
  void take(const wire::Telemetry& telemetry);
  void take(const wire::PerceptionReport& report);
  template <class Other>
  void take(const Other&) {}
  template <class Sample>
  std::optional<Command> new_command(const Sample& sample, wire::RequestKind kind,
                                     std::uint64_t id);
  void answer(const Command& command, bool accepted, const std::string& why);
  void refuse(const Command& command, const std::string& why) { answer(command, false, why); }
  std::string why_not_planned() const;
  void see_passed_through(const wire::FunctionalStatus& status);

  // execution.cpp: what the executive asks for
  void carry_out(const executive::TaskEvent& event);
  void carry_out(const executive::Dispatch& dispatch);
  void carry_out(const executive::Interrupt& interrupt);
  void carry_out(const executive::SendSync& sync);
  void carry_out(const executive::Reply& reply);
  void carry_out(const executive::Notice& notice);
  void carry_out(const executive::ForwardToSupervisor&) {}
  void dispatch_functional(wire::FunctionalRequest request);
  void interrupt_functional(std::uint64_t task);
  void release_waiting();
  bool executive_holds(std::uint64_t id) const;
  bool own_task(std::uint64_t id) const { return id >= kFirstOwnTask; }

  // autonomy.cpp: the degree and what is handed over with it
  void take(const wire::DegreeCommand& command);
  void change_degree(const mission::ChangeDegree& change, const std::string& asked_by);
  bool engaged() const { return supervisor_ && supervisor_->engaged(); }
  void engage(bool resume, const std::string& cause, bool executed_here);
  void disengage(const std::string& cause);
  void interrupt_everything();
  std::vector<mission::HeldTask> tasks_in_executive() const;
  void let_go(executive::TaskId below, const std::vector<mission::HeldTask>& tasks);
  void tell_degree();
  void send_hand_over(std::vector<mission::HeldTask> tasks);

  // deliberation.cpp: what the supervisor asks for
  void carry_out(const supervisor::Answer& answer);
  void carry_out(const supervisor::MissionDecided& decided);
  void carry_out(const supervisor::ToExecutive& request);
  void carry_out(const supervisor::StartDeliberation& start);
  void carry_out(const supervisor::StopDeliberation& stop);
  void carry_out(const supervisor::PlanChanged& changed);
  void carry_out(const supervisor::GoalChanged& changed);
  void carry_out(const supervisor::Decided& decided);
  void carry_out(const supervisor::HandedOver& handed_over);
  void carry_out(const supervisor::LoadJointTask& load);
  void carry_out(const supervisor::Notice& notice);

  // contact_policy.cpp: what it does by itself
  void carry_out_contact_policy();
  void keep_safe(ContactPolicy how);
  void come_home_in_time(const wire::Telemetry& telemetry);
  void start_safe_tasks();
  void start_own(const std::string& type, executive::Parameters parameters,
                 executive::InsertionMode mode);

  DdnConfig config_;
  node::Roster roster_;
  int degree_;
  executive::Executive executive_;
  std::optional<supervisor::Supervisor> supervisor_;
  ContactWatch contact_;
  bool airborne_ = false;

  /// The ground's tasks, by id with their types, that are under way and not in the executive.
  std::map<std::uint64_t, std::string> passed_through_;
  std::set<std::uint64_t> own_open_;                 ///< own tasks that are not terminal
  std::vector<wire::FunctionalRequest> waiting_;     ///< for own tasks to be over
  std::optional<ContactPolicy> safe_tasks_pending_;  ///< until nothing of the ground's is under way
  bool holds_ = false;  ///< by itself, as long as the energy lasts to come home after it
  std::uint64_t next_own_task_ = kFirstOwnTask;
  /// Received: the last of each synchronisation and sender.
  std::map<std::pair<std::uint64_t, std::string>, wire::SyncMessage> syncs_;

  /// Of the supervisor's tasks that the executive was given.
  std::map<executive::TaskId, mission::GoalId> origins_;
  std::vector<mission::HeldTask> handed_over_;  ///< by the supervisor, when it was disengaged
  std::map<std::uint64_t, wire::PlanEntry> logged_plan_;  ///< its tasks, as last logged

  /// By incarnation of the ground and command number.
  std::map<std::pair<std::uint64_t, std::uint64_t>, wire::RequestReply> answered_;
  std::set<std::pair<node::NodeNumber, wire::Slot>> dropped_;  ///< already logged
  std::optional<wire::PlanBoard> last_board_;

  // Of the call that is running.
  MissionTime now_;
  node::Effects out_;
  std::deque<std::variant<ForExecutive, ForSupervisor>> errands_;
  bool doing_errands_ = false;
  const ForExecutive* asked_executive_ = nullptr;
  const ForSupervisor* asked_supervisor_ = nullptr;
};

}  // namespace skein::ddn
