// SPDX-License-Identifier: Apache-2.0
// Karma's mission of the seeds from request to landing: planner, refiners, networks and executive
// together. Source: T VI.2.3 (figures VI.8, VI.9), spec 3.5.
#include <deque>
#include <functional>
#include <map>
#include <set>

#include "skein/executive/executive.hpp"
#include "skein/foundation/overloaded.hpp"
#include "testing/core_harness.hpp"
#include "testing/planning_lab.hpp"

namespace skein::supervisor {
namespace {

using namespace std::string_literals;
using ::testing::Contains;
using ::testing::ElementsAre;
using testing::GoalId;
using ::testing::StartsWith;
using testing::TaskId;
using testing::TaskState;

executive::Config executive_config() {
  executive::Config config;
  config.name = "karma";
  return config;
}

Config supervisor_config() {
  const testing::PlanningLab lab;
  Config config;
  config.knowledge = std::make_shared<Knowledge>(lab.knowledge);
  config.world = std::make_shared<world::World>(lab.world);
  config.first_id = TaskId{100};
  return config;
}

/// The functional layer takes the middle of each duration; a job takes half a second.
class Karma {
 public:
  Karma() { give(Engage{true, "start"}); }

  void give(const Input& input) {
    inputs_.push_back(input);
    if (inputs_.size() > 1) return;
    for (; !inputs_.empty(); inputs_.pop_front()) {
      for (const Effect& effect : supervisor.handle(inputs_.front(), now)) {
        std::visit(
            Overloaded{[this](const StartDeliberation& one) { deliberate_later(one); },
                       [this](const ToExecutive& one) { execute(one.input); },
                       [this](const Decided& one) { decisions.push_back(one.decision.applied); },
                       [](const auto&) {}},
            effect);
      }
    }
  }
  void execute(const executive::Input& input) {
    for (const executive::Effect& effect : executive_.handle(input, now)) {
      std::visit(
          Overloaded{[this](const executive::TaskEvent& e) { give(TaskSeen{e}); },
                     [this](const executive::Reply& r) { give(RequestAnswered{r}); },
                     [this](const executive::Dispatch& d) { dispatch(d.id); },
                     [this](const executive::Interrupt& i) {
                       later(0.2, executive::FunctionalStatus{i.id, TaskState::kAborted, ""});
                     },
                     [](const auto&) {}},
          effect);
    }
  }
  void run_until(double s) {
    const MissionTime until = MissionTime::seconds(s);
    while (true) {
      auto next = earliest(executive_.next_wakeup(), supervisor.next_wakeup());
      if (!coming_.empty()) next = earliest(next, coming_.begin()->first);
      if (!next || *next > until) break;
      now = std::max(now, *next);
      if (!coming_.empty() && coming_.begin()->first <= now) {
        const auto what = coming_.begin()->second;
        coming_.erase(coming_.begin());
        what();
      } else {
        execute(executive::Tick{});
        give(Tick{});
      }
    }
    now = until;
  }
  std::vector<std::string> states() const {
    std::vector<std::string> words;
    for (const auto& goal : supervisor.report().goals) {
      words.push_back(to_text(goal.id) + " " + std::string(to_text(goal.state)));
    }
    return words;
  }

  Supervisor supervisor{supervisor_config()};
  MissionTime now;
  std::vector<std::string> decisions, begun;
  std::set<std::string> fails;  ///< the next task of each of these types does

 private:
  template <class What>
  void later(double seconds, What what) {
    coming_.emplace(now + Duration::seconds(seconds), [this, what] {
      if constexpr (std::is_same_v<What, executive::FunctionalStatus>) {
        execute(what);
      } else {
        give(what);
      }
    });
  }
  void deliberate_later(const StartDeliberation& job) {
    later(0.5, JobFinished{job.job, deliberate(*job.request)});
  }
  void dispatch(TaskId id) {
    const std::string type = executive_.find(id)->type;
    begun.push_back(type + " " + to_text(id));
    later(0.1, executive::FunctionalStatus{id, TaskState::kRunning, ""});
    for (const auto& one : supervisor.report().tasks) {
      if (one.task.id != id || one.task.open_ended || !one.task.stop.empty()) continue;
      const mission::Interval& d = one.task.duration;
      const double seconds = (d.least.to_seconds() + d.most.to_seconds()) / 2;
      const TaskState outcome = fails.erase(type) != 0 ? TaskState::kAborted : TaskState::kEnded;
      later(seconds, executive::FunctionalStatus{id, outcome, "by chance"});
      if (outcome == TaskState::kEnded && !one.task.way.empty()) {
        world::VehicleState there;
        there.position = one.task.way.back();
        there.airborne = type != "land";
        later(seconds, VehicleSeen{there, {}});
      }
    }
  }

  executive::Executive executive_{executive_config()};
  std::deque<Input> inputs_;
  std::multimap<MissionTime, std::function<void()>> coming_;
};

mission::UnitMission mission_of_karma() {
  mission::UnitMission mission;
  mission.id = mission::MissionId{1};
  mission.placement = mission::Placement::kLast;
  mission.asked_by = "operator";
  mission.tasks = {{GoalId{700}, "general-takeoff", {}, {}},
                   {GoalId{701}, "general-combined-goto-and-takeshot", {"P1"s, 20.0}, {}},
                   {GoalId{702}, "perform-detection", {"Z2"s, "P2"s, 300.0}, {}},
                   {GoalId{703}, "general-land", {}, {}}};
  return mission;
}

TEST(Deliberation, FliesTheMissionOfKarmaFromRequestToLanding) {
  Karma karma;

  karma.give(AddMission{mission_of_karma()});
  karma.run_until(500);

  EXPECT_THAT(karma.begun,
              ElementsAre("takeoff 100", "goto 101", "wait 102", "takeshot 103", "goto 104",
                          "goto 105", "takeshot 106", "goto 107", "land 108"));
  EXPECT_THAT(karma.states(),
              ElementsAre("700 achieved", "701 achieved", "702 achieved", "703 achieved"));
  EXPECT_THAT(karma.decisions, Contains(StartsWith("1 insert")));
  EXPECT_THAT(karma.decisions, Not(Contains(StartsWith("6 repair"))));
}

TEST(Deliberation, TakesUpAgainWhatFailedInTheAir) {
  Karma karma;
  karma.give(AddMission{mission_of_karma()});
  karma.run_until(15);  // on the spot of P1
  karma.fails.insert("goto");

  karma.run_until(600);

  EXPECT_THAT(karma.decisions, Contains("6 repair: re-refine"));
  EXPECT_THAT(karma.states(),
              ElementsAre("700 achieved", "701 achieved", "702 achieved", "703 achieved"));
  EXPECT_THAT(karma.begun, Contains(StartsWith("land")));
}

TEST(Deliberation, RefusesPlacesThatAreNotThere) {
  Karma karma;
  mission::UnitMission mission = mission_of_karma();
  mission.tasks[1].arguments = {"nowhere"s, 20.0};

  karma.give(AddMission{mission});

  EXPECT_TRUE(karma.supervisor.report().goals.empty());
}

}  // namespace
}  // namespace skein::supervisor
