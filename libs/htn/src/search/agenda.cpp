// SPDX-License-Identifier: Apache-2.0
#include "search/agenda.hpp"

#include <algorithm>

#include "skein/foundation/contract.hpp"

namespace skein::htn {

NodeId Agenda::add(NetworkKind kind, NodeId parent) {
  AgendaNode node;
  node.kind = kind;
  node.parent = parent;
  node.entry = node.holder = static_cast<NodeId>(nodes_.size());
  nodes_.push_back(node);
  return static_cast<NodeId>(nodes_.size() - 1);
}

void Agenda::start(const TaskNetwork& tasks) {
  struct Open {
    const TaskNetwork* network;
    NodeId parent;
  };
  std::vector<Open> open{{&tasks, kNoNodeId}};
  while (!open.empty()) {
    const Open next = open.back();
    open.pop_back();
    const NodeId self = add(next.network->kind, next.parent);
    if (next.network->kind == NetworkKind::kTask) {
      set_task(self, next.network->task, next.network->immediate);
    }
    const auto& children = next.network->children;
    for (auto child = children.rbegin(); child != children.rend(); ++child) {
      open.push_back({&*child, self});
    }
    if (children.empty() && next.network->kind != NetworkKind::kTask) {
      set_task(add(NetworkKind::kTask, self), nothing_, true);
    }
  }
  link_children(0);
  append_tops(0);
}

// Sets the siblings and counts of the nodes from `from` on, whose parents stand before them.
void Agenda::link_children(NodeId from) {
  last_child_.assign(nodes_.size() - from, kNoNodeId);
  for (NodeId node = from; node < nodes_.size(); ++node) {
    const NodeId parent = nodes_[node].parent;
    if (parent == kNoNodeId || parent < from) continue;
    NodeId& last = last_child_[parent - from];
    (last == kNoNodeId ? nodes_[parent].first_child : nodes_[last].next_sibling) = node;
    last = node;
    ++nodes_[parent].unfinished;
  }
}

void Agenda::reduce(NodeId task, const Branch& branch, const Forcing& forced, const Term* tasks,
                    std::uint32_t note) {
  remove(task);
  const auto from = static_cast<NodeId>(nodes_.size());
  std::size_t leaf = 0;
  for (const BodyNode& body : branch.body) {
    const NodeId self = add(body.kind, body.parent == kAbsent ? task : from + body.parent);
    if (body.kind == NetworkKind::kTask) set_task(self, tasks[leaf++], false);
  }
  for (const std::uint32_t node : forced) nodes_[from + node].immediate = true;
  link_children(from);
  nodes_[task].first_child = from;
  nodes_[task].note = note;
  trail_.push_back({Change::kReduced, task});
  append_tops(from);
}

void Agenda::finish(NodeId task, std::uint32_t note) {
  remove(task);
  nodes_[task].note = note;
  NodeId node = task;
  while (nodes_[node].parent != kNoNodeId) {
    const NodeId parent = nodes_[node].parent;
    if (nodes_[parent].kind == NetworkKind::kUnordered) {
      trail_.push_back({Change::kFinishedChild, parent});
      if (--nodes_[parent].unfinished > 0) return;
    } else if (nodes_[parent].kind == NetworkKind::kOrdered &&
               nodes_[node].next_sibling != kNoNodeId) {
      append_tops(nodes_[node].next_sibling);
      return;
    }
    node = parent;
  }
}

void Agenda::append_tops(NodeId node) {
  open_.assign(1, node);
  while (!open_.empty()) {
    const NodeId at = open_.back();
    open_.pop_back();
    if (nodes_[at].kind == NetworkKind::kTask) {
      append(at);
    } else if (nodes_[at].kind == NetworkKind::kOrdered) {
      open_.push_back(nodes_[at].first_child);
    } else {
      const std::size_t bottom = open_.size();
      for (NodeId child = nodes_[at].first_child; child != kNoNodeId;
           child = nodes_[child].next_sibling) {
        open_.push_back(child);
      }
      std::reverse(open_.begin() + static_cast<std::ptrdiff_t>(bottom), open_.end());
    }
  }
}

std::uint32_t& Agenda::alike(NodeId task) {
  const std::uint32_t index = nodes_[task].task.index();
  if (index >= alike_.size()) alike_.resize(index + 1 + index / 2, 0);
  return alike_[index];
}

void Agenda::append(NodeId task) {
  const NodeId self = nodes_[task].entry;
  AgendaNode& entry = nodes_[self];
  entry.previous = last_;
  entry.next = kNoNodeId;
  (last_ == kNoNodeId ? first_ : nodes_[last_].next) = self;
  last_ = self;
  if (nodes_[task].immediate) {
    entry.previous_immediate = last_immediate_;
    entry.next_immediate = kNoNodeId;
    (last_immediate_ == kNoNodeId ? first_immediate_ : nodes_[last_immediate_].next_immediate) =
        self;
    last_immediate_ = self;
  }
  ++alike(task);
  trail_.push_back({Change::kAppended, task});
}

void Agenda::remove(NodeId task) {
  const AgendaNode& entry = nodes_[nodes_[task].entry];
  (entry.previous == kNoNodeId ? first_ : nodes_[entry.previous].next) = entry.next;
  (entry.next == kNoNodeId ? last_ : nodes_[entry.next].previous) = entry.previous;
  if (nodes_[task].immediate) {
    (entry.previous_immediate == kNoNodeId ? first_immediate_
                                           : nodes_[entry.previous_immediate].next_immediate) =
        entry.next_immediate;
    (entry.next_immediate == kNoNodeId ? last_immediate_
                                       : nodes_[entry.next_immediate].previous_immediate) =
        entry.previous_immediate;
  }
  --alike(task);
  trail_.push_back({Change::kRemoved, task});
}

// The neighbours are again what they were when the task left: changes are undone in reverse order.
void Agenda::relink(NodeId task) {
  const NodeId self = nodes_[task].entry;
  const AgendaNode& entry = nodes_[self];
  (entry.previous == kNoNodeId ? first_ : nodes_[entry.previous].next) = self;
  (entry.next == kNoNodeId ? last_ : nodes_[entry.next].previous) = self;
  ++alike(task);
  if (!nodes_[task].immediate) return;
  (entry.previous_immediate == kNoNodeId ? first_immediate_
                                         : nodes_[entry.previous_immediate].next_immediate) = self;
  (entry.next_immediate == kNoNodeId ? last_immediate_
                                     : nodes_[entry.next_immediate].previous_immediate) = self;
}

void Agenda::unlink_last(NodeId task) {
  const AgendaNode& entry = nodes_[nodes_[task].entry];
  SKEIN_ENSURES(last_ == nodes_[task].entry);
  --alike(task);
  last_ = entry.previous;
  (last_ == kNoNodeId ? first_ : nodes_[last_].next) = kNoNodeId;
  if (!nodes_[task].immediate) return;
  last_immediate_ = entry.previous_immediate;
  (last_immediate_ == kNoNodeId ? first_immediate_ : nodes_[last_immediate_].next_immediate) =
      kNoNodeId;
}

NodeId Agenda::next_distinct(NodeId task) const {
  const auto repeats = [this](NodeId candidate) {
    if (alike_[nodes_[candidate].task.index()] < 2) return false;
    NodeId at = first();
    while (!equal(at, candidate)) at = next(at);
    return at != candidate;
  };
  NodeId at = next(task);
  for (; at != kNoNodeId && repeats(at); at = next(at)) ++repeats_;
  return at;
}

NodeId Agenda::twin(NodeId task) {
  if (alike(task) < 2) return task;
  NodeId front = kNoNodeId;
  NodeId found = task;
  for (NodeId at = first(); at != kNoNodeId; at = next(at)) {
    if (!equal(at, task)) continue;
    if (front == kNoNodeId) front = at;
    if (at != found && stands_before(at, found)) found = at;
  }
  if (found == front) return found;
  swap_places(front, found);
  trail_.push_back({Change::kSwapped, front, found});
  return found;
}

void Agenda::swap_places(NodeId left, NodeId right) {
  std::swap(nodes_[left].entry, nodes_[right].entry);
  nodes_[nodes_[left].entry].holder = left;
  nodes_[nodes_[right].entry].holder = right;
}

// By their ways from the root: where they part, siblings are numbered in the order of the text.
bool Agenda::stands_before(NodeId left, NodeId right) const {
  const auto way = [this](NodeId node) {
    std::vector<NodeId> nodes;
    for (; node != kNoNodeId; node = nodes_[node].parent) nodes.push_back(node);
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
  };
  return way(left) < way(right);
}

void Agenda::undo(Mark mark) {
  while (trail_.size() > mark.trail) {
    const Undo undo = trail_.back();
    trail_.pop_back();
    switch (undo.change) {
      case Change::kAppended:
        unlink_last(undo.node);
        break;
      case Change::kSwapped:
        swap_places(undo.node, undo.other);
        break;
      case Change::kRemoved:
        relink(undo.node);
        break;
      case Change::kFinishedChild:
        ++nodes_[undo.node].unfinished;
        break;
      case Change::kReduced:
        nodes_[undo.node].first_child = kNoNodeId;
        break;
    }
  }
  nodes_.resize(mark.nodes);
}

}  // namespace skein::htn
