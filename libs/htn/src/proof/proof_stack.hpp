// SPDX-License-Identifier: Apache-2.0
// State of a proof: choice points, running queries, continuations.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "compile/compiled_domain.hpp"
#include "proof/answers.hpp"
#include "proof/fact_base.hpp"

namespace skein::htn {

/// The stacks of a proof. `sets` are the answers of queries and the rows that frames go through.
struct ProofStack {
  enum class Purpose : std::uint8_t {
    kTop,
    kNot,
    kEach,
    kEnforce,
    kAlternative,
    kForallBounds,
    kForallPart,
    kExistsBounds,
    kExistsPart,
    kCollect,
    kHolds  ///< a ground atom, by its axioms
  };
  enum class ContinuationKind : std::uint8_t { kGoals, kCut, kEmit };
  struct Continuation {
    ContinuationKind kind = ContinuationKind::kEmit;
    std::uint32_t position = 0;  // kGoals: next goal; kCut: the frame
    std::uint32_t done = 0;      // kGoals: those behind it that were tried before their turn (bits)
    const std::vector<GoalIndex>* goals = nullptr;
    Base base = 0;
    std::uint32_t next = 0;
  };
  enum class FrameKind : std::uint8_t { kQuery, kAtom, kRows, kOr, kForall, kExists, kItems };
  struct Frame {
    FrameKind kind = FrameKind::kQuery;
    bool committed = false;  // kAtom: a tail of the axiom held
    bool once = false;       // kAtom: one answer of this axiom is enough
    Bindings::Mark mark;
    std::uint32_t continuations = 0;
    std::uint32_t support = 0;
    std::uint32_t after = 0;  // continuation behind the goal
    GoalIndex goal = 0;
    Base base = 0;
    std::uint32_t at = 0;              // row, alternative, or axiom
    std::uint32_t tail = 0;            // kAtom
    std::uint32_t set = 0;             // kRows, kForall, kExists
    std::uint32_t answers_first = 0;   // kAtom: answers of the query when the goal came up
    std::uint32_t answers_middle = 0;  // kAtom: when its axioms began
    bool axioms_begun = false;
    FactBase::Cursor cursor;
    Term items;  // kItems
  };
  struct Query {
    Purpose purpose = Purpose::kTop;
    bool just_one = false;
    bool test = false;       // whether it holds is all that is asked: no answers are kept
    bool any_order = false;  // a test of what is Condition::finite
    std::uint32_t frame = 0;
    std::uint32_t set = 0;
    std::uint32_t after = 0;
    GoalIndex goal = 0;
    Base base = 0;
  };

  explicit ProofStack(Bindings& cells) : bindings(cells) {}

  Frame& push_frame(FrameKind kind, GoalIndex goal, Base base, std::uint32_t after) {
    Frame& frame = frames.emplace_back();
    frame.kind = kind;
    frame.mark = bindings.mark();
    frame.continuations = static_cast<std::uint32_t>(continuations.size());
    frame.support = static_cast<std::uint32_t>(support.size());
    frame.after = after;
    frame.goal = goal;
    frame.base = base;
    frame.set = sets_open;
    return frame;
  }
  Frame& push_atom(GoalIndex goal, Base base, std::uint32_t after) {
    Frame& frame = push_frame(FrameKind::kAtom, goal, base, after);
    frame.answers_first = answers_so_far();
    return frame;
  }
  void restore(const Frame& frame) {
    bindings.undo(frame.mark);
    continuations.erase(continuations.begin() + frame.continuations, continuations.end());
    if (recording) support.resize(frame.support);
  }
  /// Keeps the first `count` frames. Rows that nobody goes through any more are given back, those
  /// of an innermost query apart.
  void pop_frames(std::size_t count);
  void pop_frame() { pop_frames(frames.size() - 1); }
  /// What follows after the goals from `position` on; `done` as in Continuation.
  std::uint32_t push_goals(const std::vector<GoalIndex>& goals, std::uint32_t position, Base base,
                           std::uint32_t next, std::uint32_t done = 0) {
    for (; (done & 1U) != 0; done >>= 1U) ++position;
    if (position == goals.size()) return next;
    continuations.push_back({ContinuationKind::kGoals, position, done >> 1U, &goals, base, next});
    return static_cast<std::uint32_t>(continuations.size() - 1);
  }
  /// Whether a test succeeds at this continuation: no goal follows that could fail.
  bool ends_test(std::uint32_t after) const {
    return queries.back().test && continuations[after].kind == ContinuationKind::kEmit;
  }
  std::uint32_t open_set();
  Answers& set(std::uint32_t index) { return sets[index]; }
  std::uint32_t answers_so_far() {
    const Query& query = queries.back();
    return query.test ? 0 : static_cast<std::uint32_t>(set(query.set).count());
  }
  /// Keeps the support of a part of a quantifier after the part is done.
  void keep_support(Frame& frame, const std::vector<CausalLink>& links);
  void clear();
  std::size_t memory_bytes() const;

  Bindings& bindings;
  std::vector<Continuation> continuations;
  std::vector<Frame> frames;
  std::vector<Query> queries;
  std::deque<Answers> sets;
  std::uint32_t sets_open = 0;
  std::uint32_t current = 0;  ///< what is to be proved next
  std::uint32_t once_frames = 0;
  bool recording = false;  ///< which facts each answer rests on
  std::vector<CausalLink> support;
};

}  // namespace skein::htn
