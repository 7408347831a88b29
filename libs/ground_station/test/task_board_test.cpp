// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/task_board.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using executive::TaskId;
using executive::TaskState;
using testing::at;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TaskEventReceived told_of(std::uint64_t task, TaskState state) {
  return {"marvin", TaskId(task), "goto", state};
}
std::vector<std::uint64_t> ids_of(const std::vector<const TaskOnBoard*>& tasks) {
  std::vector<std::uint64_t> ids;
  for (const TaskOnBoard* task : tasks) ids.push_back(task->id.value());
  return ids;
}

TEST(TaskBoard, TellsOpenTasksByIdAndOthersByWhenTheyChanged) {
  TaskBoard board;
  board.learn(told_of(3, TaskState::kRunning), at(1));
  board.learn(told_of(1, TaskState::kScheduled), at(1));
  board.learn(told_of(2, TaskState::kEnded), at(2));
  board.learn(told_of(4, TaskState::kAborted), at(3));
  board.learn(told_of(5, TaskState::kEnded), at(3));

  EXPECT_THAT(board.open(), ElementsAre(TaskId(1), TaskId(3)));
  EXPECT_THAT(ids_of(board.last_over(2)), ElementsAre(4, 5));
  EXPECT_THAT(ids_of(board.last_over(9)), ElementsAre(4, 5, 2));
}

TEST(TaskBoard, LosesWhatIsOpenAndForgetsTheBackgroundRoutine) {
  TaskBoard board;
  const std::uint64_t routine = executive::kFirstBackgroundId.value();
  board.learn(told_of(1, TaskState::kRunning), at(1));
  board.learn(told_of(2, TaskState::kEnded), at(2));
  board.learn(told_of(routine, TaskState::kEnded), at(3));
  board.learn(told_of(routine + 1, TaskState::kRunning), at(4));

  EXPECT_THAT(board.lose(), ElementsAre(TaskId(1)));

  EXPECT_THAT(board.open(), IsEmpty());
  EXPECT_THAT(ids_of(board.last_over(9)), ElementsAre(2, 1));
  EXPECT_FALSE(board.find(TaskId(routine)).has_value());
  EXPECT_FALSE(board.has_told(TaskId(1), TaskState::kRunning));
}

TEST(TaskBoard, TakesALostTaskForOpenOnceItIsScheduledAnew) {
  TaskBoard board;
  board.learn(told_of(1, TaskState::kRunning), at(1));
  board.lose();

  EXPECT_FALSE(board.learn(told_of(1, TaskState::kEnded), at(2)));
  EXPECT_THAT(ids_of(board.last_over(9)), ElementsAre(1));
  EXPECT_TRUE(board.learn(told_of(1, TaskState::kScheduled), at(3)));

  EXPECT_THAT(board.open(), ElementsAre(TaskId(1)));
  EXPECT_THAT(board.last_over(9), IsEmpty());
  EXPECT_TRUE(board.learn(told_of(1, TaskState::kRunning), at(4)));
}

TEST(TaskBoard, KnowsHowATaskWentHoweverManyCameAfterIt) {
  TaskBoard board;
  constexpr std::uint64_t kTasks = 20 * TaskBoard::kKept;
  for (std::uint64_t id = 1; id <= kTasks; ++id) {
    board.learn(told_of(id, TaskState::kRunning), at(static_cast<double>(id)));
    const auto last = id % 7 == 0 ? TaskState::kAborted : TaskState::kEnded;
    board.learn(told_of(id, last), at(static_cast<double>(id) + 0.5));
  }

  const std::vector<const TaskOnBoard*> last = board.last_over(kTasks);
  ASSERT_EQ(last.size(), TaskBoard::kKept);
  EXPECT_EQ(last.front()->id, TaskId(kTasks));
  EXPECT_EQ(last.back()->id, TaskId(kTasks - TaskBoard::kKept + 1));
  for (std::uint64_t id = 1; id <= kTasks; ++id) {
    const auto state = id % 7 == 0 ? TaskState::kAborted : TaskState::kEnded;
    ASSERT_EQ(board.find(TaskId(id))->state, state);
    ASSERT_FALSE(board.learn(told_of(id, state), at(1e6))) << "it was told before";
  }
}

/// What a board is by its definition: all that was told of each task, gone through at each
/// question.
class Reference {
 public:
  bool learn(const TaskEventReceived& event, MissionTime now) {
    Life& life = lives_[event.task];
    if (life.lost && event.state != TaskState::kScheduled) return false;
    if (life.lost) life = {};
    const bool is_news = life.told.insert(event.state).second;
    const bool first = life.history.empty();
    const bool over = !first && executive::is_terminal(life.history.back());
    if (first || (is_news && !over && event.state > life.history.back())) {
      life.history.push_back(event.state);
      life.since = now;
    }
    return is_news;
  }
  void lose() {
    for (auto& [id, life] : lives_)
      if (!executive::is_terminal(life.history.back())) life.lost = true;
  }
  std::vector<TaskId> open() const {
    std::vector<TaskId> open;
    for (const auto& [id, life] : lives_)
      if (is_open(life)) open.push_back(id);
    return open;
  }
  std::vector<TaskId> over() const {
    std::vector<TaskId> over;
    for (const auto& [id, life] : lives_)
      if (!is_open(life)) over.push_back(id);
    std::stable_sort(over.begin(), over.end(), [this](TaskId a, TaskId b) {
      return lives_.at(a).since > lives_.at(b).since;
    });
    return over;
  }
  bool has_told(TaskId id, TaskState state) const {
    const auto life = lives_.find(id);
    return life != lives_.end() && !life->second.lost && life->second.told.contains(state);
  }
  TaskState state_of(TaskId id) const { return lives_.at(id).history.back(); }

 private:
  struct Life {
    std::vector<TaskState> history;
    std::set<TaskState> told;
    MissionTime since;
    bool lost = false;
  };
  static bool is_open(const Life& life) {
    return !life.lost && !executive::is_terminal(life.history.back());
  }
  std::map<TaskId, Life> lives_;
};

/// Some of the others, in their order.
bool is_part_of(const std::vector<TaskId>& some, const std::vector<TaskId>& others) {
  auto from = others.begin();
  for (const TaskId one : some) {
    from = std::find(from, others.end(), one);
    if (from == others.end()) return false;
    ++from;
  }
  return true;
}

RC_GTEST_PROP(TaskBoardLaws, ItIsWhatGoingThroughAllThatWasToldGives, ()) {
  constexpr std::size_t kAll = 7;
  const auto kept = *rc::gen::inRange<std::size_t>(0, kAll + 1);
  TaskBoard board(kept);
  Reference reference;
  const int inputs = *rc::gen::inRange(1, 80);
  double now = 0;
  for (int i = 0; i < inputs; ++i) {
    now += *rc::gen::inRange(0, 2);
    if (*rc::gen::inRange(0, 12) == 0) {
      board.lose();
      reference.lose();
      continue;
    }
    const auto event = told_of(*rc::gen::inRange<std::uint64_t>(1, 8),
                               static_cast<TaskState>(*rc::gen::inRange(0, 6)));
    RC_ASSERT(board.learn(event, at(now)) == reference.learn(event, at(now)));
    RC_ASSERT(board.find(event.task)->state == reference.state_of(event.task));
    RC_ASSERT(std::vector<TaskId>(board.open().begin(), board.open().end()) == reference.open());
    std::vector<TaskId> over;
    for (const TaskOnBoard* task : board.last_over(100)) over.push_back(task->id);
    const std::vector<TaskId> expected = reference.over();
    RC_ASSERT(over.size() <= kept);
    RC_ASSERT(is_part_of(over, expected));
    if (kept == kAll) RC_ASSERT(over == expected);
    for (std::uint64_t id = 1; id < 8; ++id)
      for (int state = 0; state < 6; ++state)
        RC_ASSERT(board.has_told(TaskId(id), static_cast<TaskState>(state)) ==
                  reference.has_told(TaskId(id), static_cast<TaskState>(state)));
  }
}

}  // namespace
}  // namespace skein::ground_station
