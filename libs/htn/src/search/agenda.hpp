// SPDX-License-Identifier: Apache-2.0
// The tasks still to accomplish, with undo.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compile/compiled_domain.hpp"

namespace skein::htn {

using NodeId = std::uint32_t;
inline constexpr NodeId kNoNodeId = 0xFFFFFFFFU;

/// A node of the decomposition during the search: a group of a task network or a task. A reduced
/// task has the network of its reduction as its only child, so the nodes are the plan's tree too.
struct AgendaNode {
  NetworkKind kind = NetworkKind::kTask;
  bool immediate = false;
  Term task;  // may hold variables
  NodeId parent = kNoNodeId;
  NodeId next_sibling = kNoNodeId;
  NodeId first_child = kNoNodeId;
  std::uint32_t unfinished = 0;  // children, of an unordered group
  NodeId entry = kNoNodeId;      // its place on the agenda: where the neighbours below are
  NodeId holder = kNoNodeId;     // the task whose place this is
  NodeId previous = kNoNodeId;
  NodeId next = kNoNodeId;
  NodeId previous_immediate = kNoNodeId;
  NodeId next_immediate = kNoNodeId;
  std::uint32_t note = 0xFFFFFFFFU;  // how it was accomplished: index given by the search
};

/// The task network with its agenda: the tasks without unfinished predecessors. As in SHOP2, a task
/// that leaves the agenda frees its place and new tasks are appended, so the threads of an
/// unordered network take turns. SHOP2 identifies tasks by their terms, not by their position: of
/// equal tasks on the agenda the first in the network is expanded, whichever comes up (`twin`).
/// Cost of every operation: the number of tasks it moves.
class Agenda {
 public:
  explicit Agenda(TermStore& store) : nothing_(store.pair(store.symbol("!!inop"), kNil)) {}
  NodeId first() const { return holder(first_); }
  NodeId first_immediate() const { return holder(first_immediate_); }
  /// The task behind this one on the agenda.
  NodeId next(NodeId task) const { return holder(nodes_[nodes_[task].entry].next); }
  /// The next task on the agenda that equals none before it, since trying an equal task again would
  /// give the same result.
  /// Number of tasks that next_distinct has skipped.
  std::uint64_t repeats() const { return repeats_; }
  NodeId next_distinct(NodeId task) const;
  /// The task to expand when `task` comes up: of the equal tasks the first in the network.
  /// Exchanges its place with that of the first equal task on the agenda, so that this place
  /// becomes free.
  NodeId twin(NodeId task);
  bool empty() const { return first_ == kNoNodeId; }
  const AgendaNode& operator[](NodeId node) const { return nodes_[node]; }
  std::size_t size() const { return nodes_.size(); }

  /// Starts with the task network of a problem.
  void start(const TaskNetwork& tasks);
  /// Puts the network of a branch in the place of a task. `tasks` are its leaves in order,
  /// `forced` which nodes of the body are immediate.
  void reduce(NodeId task, const Branch& branch, const Forcing& forced, const Term* tasks,
              std::uint32_t note);
  /// The task is accomplished by a step.
  void finish(NodeId task, std::uint32_t note);
  void set_note(NodeId task, std::uint32_t note) { nodes_[task].note = note; }

  struct Mark {
    std::uint32_t nodes = 0;
    std::uint32_t trail = 0;
  };
  Mark mark() const {
    return {static_cast<std::uint32_t>(nodes_.size()), static_cast<std::uint32_t>(trail_.size())};
  }
  void undo(Mark mark);
  void forget_trail() { trail_.clear(); }
  std::size_t memory_bytes() const {
    return nodes_.capacity() * sizeof(AgendaNode) + trail_.capacity() * sizeof(Undo);
  }

 private:
  enum class Change : std::uint8_t { kAppended, kRemoved, kFinishedChild, kReduced, kSwapped };
  struct Undo {
    Change change;
    NodeId node;
    NodeId other = kNoNodeId;
  };
  NodeId holder(NodeId entry) const {
    return entry == kNoNodeId ? kNoNodeId : nodes_[entry].holder;
  }
  bool stands_before(NodeId left, NodeId right) const;
  void swap_places(NodeId left, NodeId right);
  std::uint32_t& alike(NodeId task);
  bool equal(NodeId left, NodeId right) const {
    return nodes_[left].task == nodes_[right].task &&
           nodes_[left].immediate == nodes_[right].immediate;
  }
  NodeId add(NetworkKind kind, NodeId parent);
  void set_task(NodeId node, Term task, bool immediate) {
    nodes_[node].task = task;
    nodes_[node].immediate = immediate || task == nothing_;
  }
  void add_network(const TaskNetwork& tasks, NodeId parent);
  void link_children(NodeId from);
  void append_tops(NodeId node);
  void append(NodeId task);
  void remove(NodeId task);
  void relink(NodeId task);
  void unlink_last(NodeId task);

  std::vector<AgendaNode> nodes_;
  std::vector<Undo> trail_;
  std::vector<std::uint32_t> alike_;  // tasks on the agenda that are this term, by its pair
  std::vector<NodeId> open_;
  std::vector<NodeId> last_child_;
  Term nothing_;  // the step of an empty reduction: always immediate
  NodeId first_ = kNoNodeId;
  NodeId last_ = kNoNodeId;
  NodeId first_immediate_ = kNoNodeId;
  NodeId last_immediate_ = kNoNodeId;
  mutable std::uint64_t repeats_ = 0;
};

}  // namespace skein::htn
