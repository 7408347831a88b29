// SPDX-License-Identifier: Apache-2.0
// The agenda: what comes up, in which order, and undo.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

#include "compile/network_compiler.hpp"
#include "search/agenda.hpp"

namespace skein::htn {
namespace {

/// An agenda whose tasks are words: "a" is (a), "!a" is the immediate task (a).
class Tasks {
 public:
  TermStore store;
  Agenda agenda{store};

  TaskNetwork task(const std::string& word) {
    TaskNetwork made;
    made.kind = NetworkKind::kTask;
    made.immediate = word.starts_with('!');
    made.task = store.pair(store.symbol(made.immediate ? word.substr(1) : word), kNil);
    return made;
  }
  static TaskNetwork group(NetworkKind kind, std::vector<TaskNetwork> children) {
    TaskNetwork made;
    made.kind = kind;
    made.children = std::move(children);
    return made;
  }
  TaskNetwork ordered(const std::vector<std::string>& words) {
    return group(NetworkKind::kOrdered, tasks(words));
  }
  TaskNetwork unordered(const std::vector<std::string>& words) {
    return group(NetworkKind::kUnordered, tasks(words));
  }
  std::vector<TaskNetwork> tasks(const std::vector<std::string>& words) {
    std::vector<TaskNetwork> made;
    for (const std::string& word : words) made.push_back(task(word));
    return made;
  }

  /// The agenda from first to last.
  std::string all() {
    std::string out;
    for (NodeId at = agenda.first(); at != kNoNodeId; at = agenda.next(at)) {
      out += (out.empty() ? "" : " ") + word(at);
    }
    return out;
  }
  std::string word(NodeId node) {
    return node == kNoNodeId ? "none" : std::string(store.name(store.car(agenda[node].task)));
  }
  NodeId find(const std::string& wanted) {
    for (NodeId at = agenda.first(); at != kNoNodeId; at = agenda.next(at)) {
      if (word(at) == wanted) return at;
    }
    ADD_FAILURE() << "no task " << wanted;
    return kNoNodeId;
  }
  void finish(const std::string& wanted) { agenda.finish(find(wanted), 0); }

  /// A network of a method, as it is compiled.
  void reduce(NodeId node, const TaskNetwork& network) {
    Branch branch;
    std::vector<Term> leaves;
    append(network, kAbsent, branch, leaves);
    Forcing forced;
    for (const std::uint32_t leaf : branch.leaves) {
      if (branch.body[leaf].immediate) forced.push_back(leaf);
    }
    agenda.reduce(node, branch, forced, leaves.data(), 0);
  }
  void reduce(const std::string& wanted, const TaskNetwork& network) {
    reduce(find(wanted), network);
  }

 private:
  void append(const TaskNetwork& network, std::uint32_t parent, Branch& branch,
              std::vector<Term>& leaves) {
    BodyNode node;
    node.kind = network.kind;
    node.parent = parent;
    node.immediate = network.immediate;
    const auto self = static_cast<std::uint32_t>(branch.body.size());
    branch.body.push_back(node);
    if (network.kind == NetworkKind::kTask) {
      branch.leaves.push_back(self);
      leaves.push_back(network.task);
    }
    for (const TaskNetwork& child : network.children) append(child, self, branch, leaves);
  }
};

TEST(Agenda, HoldsOnlyTheFirstOfTasksInOrder) {
  Tasks tasks;
  tasks.agenda.start(tasks.ordered({"a", "b", "c"}));

  EXPECT_EQ(tasks.all(), "a");
  tasks.finish("a");
  EXPECT_EQ(tasks.all(), "b");
  tasks.finish("b");
  tasks.finish("c");
  EXPECT_TRUE(tasks.agenda.empty());
}

TEST(Agenda, HoldsAllTasksWithoutOrderInTheOrderOfTheText) {
  Tasks tasks;
  tasks.agenda.start(tasks.unordered({"a", "b", "c"}));

  EXPECT_EQ(tasks.all(), "a b c");
  tasks.finish("b");
  EXPECT_EQ(tasks.all(), "a c");
}

TEST(Agenda, AppendsWhatComesUp) {
  Tasks tasks;
  tasks.agenda.start(Tasks::group(NetworkKind::kUnordered,
                                  {tasks.ordered({"a1", "a2"}), tasks.ordered({"b1", "b2"})}));

  tasks.finish("a1");
  EXPECT_EQ(tasks.all(), "b1 a2");
  tasks.reduce("b1", tasks.unordered({"x", "y"}));
  EXPECT_EQ(tasks.all(), "a2 x y");
  tasks.finish("x");
  EXPECT_EQ(tasks.all(), "a2 y");
  tasks.finish("y");
  EXPECT_EQ(tasks.all(), "a2 b2");
}

TEST(Agenda, GoesOnAfterAGroupWhenAllOfItIsDone) {
  Tasks tasks;
  tasks.agenda.start(Tasks::group(
      NetworkKind::kOrdered,
      {tasks.task("start"),
       Tasks::group(NetworkKind::kUnordered, {tasks.task("a"), tasks.ordered({"b", "c"})}),
       tasks.task("end")}));

  tasks.finish("start");
  EXPECT_EQ(tasks.all(), "a b");
  tasks.finish("b");
  EXPECT_EQ(tasks.all(), "a c");
  tasks.finish("c");
  EXPECT_EQ(tasks.all(), "a");
  tasks.finish("a");
  EXPECT_EQ(tasks.all(), "end");
}

TEST(Agenda, PutsAReductionInThePlaceOfItsTask) {
  Tasks tasks;
  tasks.agenda.start(tasks.ordered({"travel", "rest"}));

  tasks.reduce("travel", tasks.ordered({"go", "come"}));
  EXPECT_EQ(tasks.all(), "go");
  tasks.reduce("go", tasks.ordered({"step"}));
  tasks.finish("step");
  tasks.finish("come");

  EXPECT_EQ(tasks.all(), "rest");
}

TEST(Agenda, GivesAnEmptyGroupAStepThatDoesNothing) {
  Tasks tasks;
  tasks.agenda.start(Tasks::group(NetworkKind::kUnordered,
                                  {tasks.task("a"), Tasks::group(NetworkKind::kOrdered, {})}));

  EXPECT_EQ(tasks.all(), "a !!inop");
  EXPECT_EQ(tasks.word(tasks.agenda.first_immediate()), "!!inop");
}

TEST(Agenda, KnowsTheFirstOfTheImmediateTasks) {
  Tasks tasks;
  tasks.agenda.start(tasks.unordered({"a", "!b", "!c"}));

  EXPECT_EQ(tasks.word(tasks.agenda.first_immediate()), "b");
  tasks.finish("b");
  EXPECT_EQ(tasks.word(tasks.agenda.first_immediate()), "c");
  tasks.finish("c");
  EXPECT_EQ(tasks.agenda.first_immediate(), kNoNodeId);
  EXPECT_EQ(tasks.all(), "a");
}

TEST(Agenda, MakesTheForcedTasksOfAReductionImmediate) {
  Tasks tasks;
  tasks.agenda.start(tasks.unordered({"a", "b"}));

  tasks.reduce("b", tasks.ordered({"!first", "second"}));

  EXPECT_EQ(tasks.word(tasks.agenda.first_immediate()), "first");
  tasks.finish("first");
  EXPECT_EQ(tasks.agenda.first_immediate(), kNoNodeId);
  EXPECT_EQ(tasks.all(), "a second");
}

TEST(AgendaTwin, IsTheTaskItselfWhenNoOtherSaysTheSame) {
  Tasks tasks;
  tasks.agenda.start(tasks.unordered({"a", "b"}));

  EXPECT_EQ(tasks.agenda.twin(tasks.find("b")), tasks.find("b"));
}

// Of equal tasks the first in the network is worked on; the place of the first on the agenda gets
// free.
TEST(AgendaTwin, IsTheFirstInTheNetworkOfTheTasksThatSayTheSame) {
  Tasks tasks;
  tasks.agenda.start(Tasks::group(NetworkKind::kUnordered,
                                  {tasks.ordered({"a", "same"}), tasks.ordered({"same", "b"})}));
  tasks.finish("a");
  ASSERT_EQ(tasks.all(), "same same");
  const NodeId in_front = tasks.agenda.first();
  const NodeId behind = tasks.agenda.next(in_front);

  const NodeId twin = tasks.agenda.twin(in_front);

  EXPECT_EQ(twin, behind);
  EXPECT_EQ(tasks.agenda.first(), behind);
  tasks.agenda.finish(twin, 0);
  EXPECT_EQ(tasks.agenda.first(), in_front);
  tasks.agenda.finish(in_front, 0);
  EXPECT_EQ(tasks.all(), "b");
}

TEST(AgendaTwin, IsNoTaskThatIsImmediateWhenTheOtherIsNot) {
  Tasks tasks;
  tasks.agenda.start(tasks.unordered({"!same", "same"}));
  const NodeId second = tasks.agenda.next(tasks.agenda.first());

  EXPECT_EQ(tasks.agenda.twin(second), second);
}

TEST(AgendaTwin, ChangesPlacesThatUndoGivesBack) {
  Tasks tasks;
  tasks.agenda.start(Tasks::group(NetworkKind::kUnordered,
                                  {tasks.ordered({"a", "same"}), tasks.ordered({"same", "b"})}));
  tasks.finish("a");
  const Agenda::Mark mark = tasks.agenda.mark();
  const NodeId in_front = tasks.agenda.first();
  tasks.agenda.finish(tasks.agenda.twin(in_front), 0);

  tasks.agenda.undo(mark);

  EXPECT_EQ(tasks.agenda.first(), in_front);
  EXPECT_EQ(tasks.all(), "same same");
  EXPECT_EQ(tasks.agenda.size(), mark.nodes);
}

TEST(Agenda, UndoesReductionsAndSteps) {
  Tasks tasks;
  tasks.agenda.start(tasks.unordered({"a", "b", "!c"}));
  const Agenda::Mark mark = tasks.agenda.mark();

  tasks.reduce("a", tasks.ordered({"!x", "y"}));
  tasks.finish("x");
  tasks.finish("c");
  tasks.finish("b");
  tasks.finish("y");
  ASSERT_TRUE(tasks.agenda.empty());
  tasks.agenda.undo(mark);

  EXPECT_EQ(tasks.all(), "a b c");
  EXPECT_EQ(tasks.word(tasks.agenda.first_immediate()), "c");
}

TEST(Agenda, NeverRecursOnALongChainOfReductions) {
  constexpr int kLong = 200'000;
  Tasks tasks;
  tasks.agenda.start(tasks.ordered({"loop", "end"}));
  const TaskNetwork body = tasks.ordered({"loop"});
  for (int round = 0; round < kLong; ++round) tasks.reduce(tasks.agenda.first(), body);

  tasks.finish("loop");

  EXPECT_EQ(tasks.all(), "end");
}

// ---- forcing ---------------------------------------------------------------------------------

BodyNode node(NetworkKind kind, std::uint32_t parent, bool immediate = false) {
  BodyNode made;
  made.kind = kind;
  made.parent = parent;
  made.immediate = immediate;
  return made;
}

TEST(Forcings, MakeTheFirstTaskOfAnOrderedNetworkImmediate) {
  EXPECT_EQ(forcings({node(NetworkKind::kOrdered, kAbsent), node(NetworkKind::kTask, 0),
                      node(NetworkKind::kTask, 0)}),
            (std::vector<Forcing>{{1}}));
}

TEST(Forcings, AreOneForEachBranchOfAnUnorderedNetwork) {
  EXPECT_EQ(forcings({node(NetworkKind::kUnordered, kAbsent), node(NetworkKind::kTask, 0),
                      node(NetworkKind::kOrdered, 0), node(NetworkKind::kTask, 2),
                      node(NetworkKind::kTask, 2), node(NetworkKind::kTask, 0)}),
            (std::vector<Forcing>{{1}, {3}, {5}}));
}

TEST(Forcings, LeaveANetworkAsItIsThatBeginsWithAnImmediateTask) {
  EXPECT_EQ(forcings({node(NetworkKind::kUnordered, kAbsent), node(NetworkKind::kTask, 0),
                      node(NetworkKind::kTask, 0, true)}),
            (std::vector<Forcing>{{2}}));
}

TEST(Forcings, KeepTheImmediateTasksOfTheText) {
  EXPECT_EQ(forcings({node(NetworkKind::kOrdered, kAbsent), node(NetworkKind::kTask, 0),
                      node(NetworkKind::kTask, 0, true)}),
            (std::vector<Forcing>{{2, 1}}));
}

// ---- against values that are copied ----------------------------------------------------------

/// A network as nested values, with the agenda as a list of paths into it.
struct Model {
  using Path = std::vector<std::size_t>;
  TaskNetwork network;
  std::vector<Path> agenda;

  TaskNetwork& at(const Path& path, std::size_t length) {
    TaskNetwork* node = &network;
    for (std::size_t step = 0; step < length; ++step) node = &node->children[path[step]];
    return *node;
  }
  void append(const Path& path) {
    const TaskNetwork& node = at(path, path.size());
    if (node.kind == NetworkKind::kTask && node.children.empty()) {
      agenda.push_back(path);
      return;
    }
    const std::size_t tops = node.kind == NetworkKind::kUnordered ? node.children.size() : 1;
    for (std::size_t child = 0; child < tops; ++child) {
      Path inner = path;
      inner.push_back(child);
      append(inner);
    }
  }
  void start(const TaskNetwork& tasks) {
    network = tasks;
    append({});
  }
  // A reduced task keeps the network that replaces it as its only child.
  void reduce(std::size_t position, const TaskNetwork& body) {
    Path path = agenda[position];
    agenda.erase(agenda.begin() + static_cast<std::ptrdiff_t>(position));
    at(path, path.size()).children = {body};
    path.push_back(0);
    append(path);
  }
  // `immediate` on what is done marks it as finished.
  void finish(std::size_t position) {
    Path path = agenda[position];
    agenda.erase(agenda.begin() + static_cast<std::ptrdiff_t>(position));
    at(path, path.size()).immediate = true;
    while (!path.empty()) {
      const std::size_t child = path.back();
      TaskNetwork& parent = at(path, path.size() - 1);
      if (parent.kind == NetworkKind::kOrdered && child + 1 < parent.children.size()) {
        ++path.back();
        return append(path);
      }
      for (const TaskNetwork& other : parent.children) {
        if (parent.kind == NetworkKind::kUnordered && !other.immediate) return;
      }
      path.pop_back();
      parent.immediate = true;
    }
  }
  std::string text(TermStore& store) {
    std::string out;
    for (const Path& path : agenda) {
      const Term task = at(path, path.size()).task;
      out += (out.empty() ? "" : " ") + std::string(store.name(store.car(task)));
    }
    return out;
  }
};

TaskNetwork random_network(Tasks& tasks, std::uint8_t byte, int& named) {
  const auto name = [&named] { return "t" + std::to_string(named++); };
  switch (byte % 4) {
    case 0:
      return tasks.ordered({name(), name(), name()});
    case 1:
      return tasks.unordered({name(), name()});
    case 2:
      return Tasks::group(NetworkKind::kUnordered,
                          {tasks.ordered({name(), name()}), tasks.task(name())});
    default:
      return Tasks::group(NetworkKind::kOrdered, {tasks.unordered({name(), name()}),
                                                  tasks.task(name()), tasks.unordered({name()})});
  }
}

RC_GTEST_PROP(AgendaProperty, AgreesWithNetworksThatAreCopied,
              (const std::vector<std::pair<std::uint8_t, std::uint8_t>>& changes)) {
  Tasks tasks;
  Model model;
  int named = 0;
  const TaskNetwork whole = Tasks::group(
      NetworkKind::kUnordered, {random_network(tasks, 0, named), random_network(tasks, 3, named)});
  tasks.agenda.start(whole);
  model.start(whole);
  std::vector<std::pair<Agenda::Mark, Model>> saved;
  for (const auto& [change, what] : changes) {
    if (change % 8 == 0) {
      saved.emplace_back(tasks.agenda.mark(), model);
    } else if (change % 8 == 1 && !saved.empty()) {
      tasks.agenda.undo(saved.back().first);
      model = saved.back().second;
      saved.pop_back();
    } else if (!model.agenda.empty()) {
      const std::size_t position = what % model.agenda.size();
      NodeId node = tasks.agenda.first();
      for (std::size_t step = 0; step < position; ++step) node = tasks.agenda.next(node);
      if (change % 8 < 5) {
        const TaskNetwork body = random_network(tasks, change / 8, named);
        tasks.reduce(node, body);
        model.reduce(position, body);
      } else {
        tasks.agenda.finish(node, 0);
        model.finish(position);
      }
    }
    RC_ASSERT(tasks.all() == model.text(tasks.store));
  }
}

}  // namespace
}  // namespace skein::htn
