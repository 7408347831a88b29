// SPDX-License-Identifier: Apache-2.0
// Laws over random lives of a decision node: any commands, elementary requests, statuses, changes
// of degree, messages and losses of contact, in any order.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <set>

#include "skein/functional/task_types.hpp"
#include "testing/flown_node.hpp"

namespace skein::decision_node {
namespace {

using functional::TaskId;
using functional::TaskState;
using functional::Verb;
using testing::FlownNode;

bool holds_vehicle(const std::string& type) {
  return functional::TaskTypes::shipped().of(type).holds_vehicle();
}

int below(int limit) { return *rc::gen::inRange(0, limit); }

/// What a user, a vehicle and a radio do to a node, at random.
class Life {
 public:
  Life()
      : node_(*rc::gen::inRange(1, 4),
              *rc::gen::element(ContactPolicy::kContinue, ContactPolicy::kHold,
                                ContactPolicy::kReturn)) {}

  void live(int steps) {
    for (int i = 0; i < steps; ++i) see(node_.give(any_input()));
  }

 private:
  Input any_input() {
    switch (below(10)) {
      case 0:
        return again_or(start());
      case 1:
        return again_or(executive::Abort{any_task()});
      case 2:
        return again_or(mission::ChangeDegree{*rc::gen::inRange(1, 4), below(2) == 0});
      case 3:
        return ElementaryRequest{
            {below(3) == 0 ? Verb::kInterrupt : Verb::kDispatch, any_task(), any_type()}};
      case 4:
        return Contact{"ground", true, below(2) == 0};
      case 5:
        return testing::flying(below(4) > 0);
      case 6:
        return SyncMessage{5, "heliv", "marvin", executive::SyncWord::kThere, node_.now()};
      case 7:
        see(node_.wake_at(node_.now().to_seconds() + below(40)));
        return Tick{};
      case 8:
        return LayerForgot{};
      default:
        return StatusTold{any_status()};
    }
  }
  executive::Start start() {
    executive::Start start = testing::start_of(any_task().value(), any_type());
    start.mode = *rc::gen::element(executive::InsertionMode::kSeq, executive::InsertionMode::kVut,
                                   executive::InsertionMode::kNut);
    return start;
  }
  TaskId any_task() { return TaskId(static_cast<std::uint64_t>(*rc::gen::inRange(1, 12))); }
  std::string any_type() {
    return *rc::gen::element<std::string>("goto", "takeoff", "land", "wait", "takeshot");
  }
  // Of what was dispatched, mostly; a vehicle may also speak of what it was never asked.
  functional::Status any_status() {
    TaskId id = any_task();
    if (!dispatched_.empty() && below(5) > 0) {
      id = *rc::gen::elementOf(std::vector<TaskId>(dispatched_.begin(), dispatched_.end()));
    }
    return {id, *rc::gen::element(TaskState::kRunning, TaskState::kEnded, TaskState::kAborted), ""};
  }
  Command again_or(mission::Request request) {
    if (!commands_.empty() && below(4) == 0) return *rc::gen::elementOf(commands_);
    commands_.push_back({{1, commands_.size() + 1}, std::move(request)});
    return commands_.back();
  }

  void see(const Effects& effects) {
    for (const Effect& effect : effects) {
      std::visit([this](const auto& one) { judge(one); }, effect);
    }
    RC_ASSERT(!passes_syncs_on_ || degree_ <= mission::kLeastDegree);
    passes_syncs_on_ = false;
  }
  // One command, one answer.
  void judge(const Answer& answer) {
    const auto [known, fresh] = answers_.emplace(answer.key, answer);
    RC_ASSERT(fresh || (known->second.accepted == answer.accepted &&
                        known->second.why == answer.why && known->second.kind == answer.kind));
  }
  // What holds the vehicle is not dispatched while the node keeps it safe by a task of its own.
  void judge(const ToVehicle& asked) {
    const functional::Request& request = asked.request;
    if (request.verb == Verb::kInterrupt) return;
    const bool own = request.id >= functional::kFirstOwnId;
    RC_ASSERT(own || own_open_.empty() || !holds_vehicle(request.type));
    dispatched_.insert(request.id);
  }
  void judge(const TaskChanged& changed) {
    const executive::TaskEvent& event = changed.event;
    if (event.id < functional::kFirstOwnId) return;
    if (is_terminal(event.state)) {
      own_open_.erase(event.id);
    } else {
      own_open_.insert(event.id);
    }
  }
  void judge(const BoardChanged& board) {
    RC_ASSERT(!last_board_ || !(*last_board_ == board));
    last_board_ = board;
  }
  // What is handed over is in the order of ids, none twice and none over.
  void judge(const HandedOver& told) {
    TaskId last;
    for (const mission::HeldTask& one : told.hand_over.tasks) {
      RC_ASSERT(last < one.task.id);
      RC_ASSERT(!is_terminal(one.state));
      last = one.task.id;
    }
  }
  // At degree 1 only, or when it gets there, the executive at the ground waits for others.
  void judge(const DegreeChanged& changed) { degree_ = changed.degree; }
  void judge(const SyncPassedOn&) { passes_syncs_on_ = true; }
  template <class Other>
  void judge(const Other&) {}

  FlownNode node_;
  int degree_ = 0;  ///< 0: as at the start
  bool passes_syncs_on_ = false;
  std::vector<Command> commands_;
  std::map<CommandKey, Answer> answers_;
  std::set<TaskId> dispatched_, own_open_;
  std::optional<BoardChanged> last_board_;
};

RC_GTEST_PROP(DecisionNode, KeepsItsLawsWhateverComes, ()) {
  Life life;
  life.live(*rc::gen::inRange(10, 120));
}

// The highest id first: nothing is dispatched for want of what it waited for.
TEST(DecisionNode, InterruptedOnTheWayDownDispatchesNothingMoreAndHolds) {
  FlownNode node(3);
  node.give(testing::flying(true));
  node.give(Command{{1, 1}, testing::start_of(1, "goto")});
  executive::Start second = testing::start_of(2, "land");
  second.mode = executive::InsertionMode::kDep;
  node.give(Command{{1, 2}, second});
  node.give(StatusTold{{TaskId(1), TaskState::kRunning, ""}});

  const Effects effects = node.give(Command{{1, 3}, mission::ChangeDegree{1, true}});

  std::vector<std::string> asked;
  for (const ToVehicle& one : testing::all<ToVehicle>(effects)) {
    asked.push_back((one.request.verb == Verb::kInterrupt ? "interrupt " : "dispatch ") +
                    std::to_string(one.request.id.value()) + " " + one.request.type);
  }
  ASSERT_FALSE(asked.empty());
  EXPECT_EQ(asked[0], "interrupt 1 ");
  for (const std::string& one : asked) EXPECT_NE(one, "dispatch 2 land");
}

}  // namespace
}  // namespace skein::decision_node
