// SPDX-License-Identifier: Apache-2.0
// The supervisor's inside: one class, its functions in files by room.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "book/book.hpp"
#include "flight/retreat.hpp"
#include "schedule/plan_network.hpp"
#include "skein/supervisor/supervisor.hpp"
#include "watch/refusals.hpp"
#include "watch/wind_estimator.hpp"

namespace skein::supervisor {

class Supervisor::Core {
 public:
  explicit Core(Config config);
  Effects handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;
  bool engaged() const { return engaged_; }
  const mission::PlanReport& report() const { return report_; }

 private:
  /// A mission that waits for its insertion.
  struct Pending {
    mission::MissionId id;
    mission::Placement placement = mission::Placement::kBest;
    bool interrupt = false;
    bool any = false;
    std::string cause;
    MissionTime since;
    int attempts = 0;
  };
  /// A mission that is only to be evaluated.
  struct Evaluation {
    mission::UnitMission mission;
    std::string cause;
    MissionTime since;
  };
  /// Something happened to the plan that needs planning.
  struct Need {
    std::optional<GoalId> failed;
    bool refine = true;
    std::string cause;
    MissionTime since;
    int attempts = 0;
    bool home = false;  ///< even with nothing to plan: it must come down
    MissionTime not_before = {};
  };
  /// What a job supposes.
  struct Premises {
    std::vector<TaskId> standing;
    std::set<TaskId> withdrawn;  ///< to be told to stop when its result is applied
    std::vector<GoalId> goals;   ///< planned anew
    std::vector<GoalId> added;   ///< by operator 1
    std::uint64_t world = 0;
    std::set<std::string> broken;
    TaskId next_id;
    std::optional<world::Vector3> position;  ///< where it is, when nothing moves it
  };
  struct Job {
    std::uint64_t id = 0;
    std::optional<mission::MissionId> mission;  ///< an insertion; else a repair
    bool evaluation = false;                    ///< of a mission, that is not adopted
    Need need;
    Premises premises;
    std::optional<mission::HighLevelTask> retreat;  ///< a goal of its own, if nothing else serves
  };
  /// A joint task between LoadJointTask and its answer, or due before it.
  struct Joint {
    bool answered = false, loaded = false, due = false;
    std::string why;
  };
  /// What a Decided says, with its beginning.
  struct Application {
    std::string applied, cause, inputs, outcome;
    MissionTime began;
  };

  // Inputs: requests.cpp
  void on(const AddMission& input);
  void on(const CancelMission& input);
  void on(const WorldChanged& input);
  std::vector<std::string> problems_of_mission(const mission::UnitMission& mission) const;
  void enter(const mission::UnitMission& mission);
  std::vector<GoalId> goals_named(const mission::CancelGoals& named,
                                  std::vector<std::string>& problems) const;
  void cancel(const std::vector<GoalId>& goals, bool interrupt, const std::string& cause);
  std::vector<GoalId> left_to_plan(const std::vector<GoalId>& gone) const;
  void drop_cancelled_missions();
  void set_volume(const mission::ChangeWorld& change);

  // watch/world.cpp: places and ground
  void learn(const mission::ChangeWorld& change);
  void look_elsewhere(const std::string& place, bool far, const std::string& cause);
  void feel_wind();
  // safety/air.cpp
  void check_air(const std::string& cause);
  void watch_air();
  std::optional<MissionTime> next_closing() const;
  bool is_met(const Entry& entry, const world::Volume& volume) const;
  bool goes_through(const Entry& entry, const world::Volume& volume) const;
  bool stays_in(const Entry& entry, const world::Volume& volume) const;
  const world::Volume* met_by(const Entry& entry) const;
  std::optional<world::Vector3> stand_of(const Entry& entry) const;
  std::optional<world::Vector3> circled() const;
  world::Vector3 place() const { return circled().value_or(vehicle_.position); }
  const world::Volume* closed_around() const;
  bool is_leaving() const;
  bool is_nearly_down() const;
  std::vector<GoalId> goals_met(std::string& what) const;

  // hand_over.cpp
  void on(const Disengage& input);
  void on(const Engage& input);
  bool is_wholly_given(GoalId id) const;
  void hand_over_goal(GoalId id);
  std::vector<GoalId> take_back();
  void forget_but(const std::set<TaskId>& kept);

  // watch/observation.cpp, watch/dates.cpp
  void on(const TaskSeen& input);
  void on(const RequestAnswered& input);
  void on(const VehicleSeen& input);
  void on(const Tick&) {}
  void follow_ways(const world::Vector3& position);
  void tell_progress(GoalId id);
  void see_flight(const executive::TaskEvent& event);
  void see_loose(const executive::TaskEvent& event);
  Duration retry_after(const Loose& loose, const std::string& why);
  void see(Entry& entry, const executive::TaskEvent& event);
  void see_started(Entry& entry);
  void tell_beside_its_times(const Entry& entry, bool ends);
  void see_ended(Entry& entry);
  void see_aborted(Entry& entry);
  void refused(const Entry& entry, const std::string& what);
  void settle_done(Entry& entry);
  bool was_stopped_in_time(const Entry& entry) const;
  bool follows_lost_task(const Entry& entry) const;
  void reschedule();
  const Schedule& schedule() const { return network_.schedule(); }
  std::vector<TaskView> open_views() const;
  std::vector<Hold> holds_of(TaskId task) const;
  void tell_holds();
  void send_preconditions(const Entry& entry);
  void absorb_or_shift(const std::string& cause);
  void check_network(const std::string& cause);
  bool keeps_promises(Duration tolerance) const;
  void promise();
  void watch();
  bool is_overdue(const Entry& entry) const;
  bool is_late(const Entry& entry) const;
  MissionTime late_from(const Entry& entry) const;

  // watch/contingencies.cpp
  void fail_task(const Entry& entry, const std::string& cause);
  void fail_goal(GoalId id, const std::string& cause);
  void operator_aborted(const Entry& entry);
  void cancel_goal(GoalId id, const std::string& cause);
  void retire(const std::set<GoalId>& goals);
  std::vector<TaskId> withdraw(const std::set<GoalId>& goals);
  void stop(const std::vector<TaskId>& tasks);
  bool repairing() const { return need_ || (job_ && !job_->mission); }
  void need(std::optional<GoalId> failed, bool refine, const std::string& cause);
  void pause_need(const Entry& entry, int refused);
  void hurry();
  void check_devices(const std::set<std::string>& newly);
  void keep_safe();
  std::string why_idle() const;
  std::string begins_from(GoalId id) const;
  void wait_safely();
  void stop_safe_waits();

  // safety/energy.cpp
  Retreat retreat() const { return {*config_.knowledge, *world_, now_}; }
  Whereabouts end_of(const std::vector<mission::ElementaryTask>& tasks) const;
  double energy_to_come(const Entry& entry) const;
  double energy_to_come(const Entry& entry, const Retreat& retreat) const;
  double energy_wanted(const Retreat& retreat) const;
  double energy_in_hand() const;
  double energy_above_reserve() const;
  void check_energy();
  void run_short(double wanted);
  void give_up(const std::set<GoalId>& in_hand, const std::string& cause);
  void divert(const std::string& cause);
  std::optional<GoalId> waiting_in(const std::set<GoalId>& goals) const;
  bool comes_down() const;
  void come_down_at_once();

  // own_goals.cpp
  bool can_plan(std::string_view task) const;
  std::optional<mission::HighLevelTask> own_task(std::string_view name) const;
  GoalId enter_own(const mission::HighLevelTask& task);
  void tell_landing(const mission::ElementaryPlan& plan);
  std::string named(GoalId goal) const;

  // jobs/jobs.cpp
  void on(const JobFinished& input);
  void start_job();
  void start_insertion(const Pending& pending);
  void start_evaluation(const Evaluation& evaluation);
  void give_way();
  void abandon_job();
  void start_repair();
  void run(Job job, DeliberationRequest request);
  Premises premises_of_insertion(const Pending& pending) const;
  Premises premises_of_repair() const;
  Premises premises(const std::set<TaskId>& withdrawn) const;
  std::set<TaskId> to_interrupt(const Pending& pending) const;
  std::set<GoalId> goals_of(const std::set<TaskId>& tasks) const;
  bool all_done(const std::vector<TaskId>& then, const std::vector<TaskId>& now) const;
  bool hold(const Premises& then, const Premises& now) const;
  bool again(const Job& job, const std::string& why);

  // jobs/results.cpp
  void finish(const Job& job, const InsertionOutcome& outcome);
  void finish(const Job& job, const RepairOutcome& outcome);
  void refuse(const Job& job, const std::vector<std::string>& reasons,
              const std::vector<Dropped>& culprits = {});
  void leave_out(const std::vector<Dropped>& dropped);
  std::string in_words(const std::string& text) const;
  mission::MissionEstimate estimate(const Evaluation& evaluation,
                                    const InsertionOutcome& outcome) const;
  void answer_evaluation(const InsertionOutcome& outcome);
  void fail_safely(const Job& job, const std::vector<std::string>& reasons);
  std::string fault_of(const Premises& premises, const mission::ElementaryPlan& plan) const;
  bool fits_now(const Premises& premises, const mission::ElementaryPlan& plan);
  void adopt(const Premises& premises, const mission::ElementaryPlan& plan,
             const std::vector<mission::HighLevelTask>& order);
  void enter(const mission::ElementaryPlan& plan);
  void tell_refined(const Job& job, const mission::ElementaryPlan& plan);

  // jobs/situation.cpp
  PlanningRequest base_request(const Standing& standing, const std::set<TaskId>& withdrawn) const;
  Situation situation(const Standing& standing, const std::set<TaskId>& withdrawn) const;
  void place_after(const Standing& standing, Situation& result) const;
  void place_on_timelines(const Standing& standing, const std::set<TaskId>& withdrawn,
                          Situation& result) const;
  void place_loose(const std::set<TaskId>& withdrawn, Situation& result) const;
  void foresee_true_goals();
  void settle_true_goals();
  bool is_there(const Whereabouts& expected) const;
  Timeline timeline_after(const mission::ElementaryTask& task) const;
  double energy_after(const Standing& standing) const;

  // commitment/giving.cpp
  void on(const JointTaskDue& input);
  void on(const JointTaskAnswered& input);
  void commit();
  std::optional<GoalId> next_to_give() const;
  bool is_undated(GoalId goal) const;
  std::optional<MissionTime> due(GoalId goal) const;
  void give(GoalId goal);
  mission::ElementaryTask as_given(const mission::ElementaryTask& task) const;
  std::set<TaskId> loose_before(const mission::ElementaryTask& task) const;
  void end_waits();
  Duration safe_wait_ends_within() const;
  std::optional<MissionTime> end_of_safe_wait() const;
  void load(const Entry& entry);
  void report_joint(TaskId id, const std::string& why);

  // report.cpp
  void set_state(Goal& goal, GoalState state, const std::string& why = {});
  void decide(Application application);
  void notice(std::string text) { out_.push_back(Notice{std::move(text)}); }
  void send(executive::Input input) { out_.push_back(ToExecutive{std::move(input)}); }
  void publish();
  std::string plan_text() const;
  std::string extent() const;

  Config config_;
  std::shared_ptr<const world::World> world_;
  std::uint64_t world_revision_ = 0;
  Book book_;
  bool engaged_ = false;
  bool ever_gave_ = false;  ///< a task to the executive
  bool told_idle_ = false;  ///< that it flies and has nothing to do
  std::set<mission::MissionId> missions_;
  std::deque<Pending> pending_;
  std::deque<Evaluation> evaluations_;
  std::set<std::uint64_t> abandoned_;  ///< jobs whose results are still to come
  std::optional<Need> need_;
  std::optional<Job> job_;
  std::uint64_t last_job_ = 0;
  std::map<TaskId, Joint> joints_;
  std::set<TaskId> forgotten_;     ///< loose ones that are over
  std::vector<TaskId> end_waits_;  ///< by what is being given

  world::VehicleState vehicle_;
  WindEstimator wind_;
  Refusals refusals_;
  std::set<std::string> broken_;
  MissionTime grounded_until_;  ///< a state that says otherwise is older than the landing
  std::optional<MissionTime> wait_again_;  ///< no safe wait before
  bool energy_told_ = false;
  MissionTime air_watched_;      ///< closings before this have been dealt with
  std::uint64_t own_goals_ = 0;  ///< given so far

  PlanNetwork network_;
  std::uint64_t decisions_ = 0;
  mission::PlanReport report_;

  // Of the call that is running.
  MissionTime now_;
  Effects out_;
};

/// "goals 701 702", "tasks 100 101".
template <class Ids>
std::string list_of(const std::string& what, const Ids& ids) {
  std::string text = what;
  for (const auto& id : ids) text += " " + to_text(id);
  return text;
}

/// "a; b".
std::string joined(const std::vector<std::string>& texts);

}  // namespace skein::supervisor
