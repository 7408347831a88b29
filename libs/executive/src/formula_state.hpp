// SPDX-License-Identifier: Apache-2.0
// A formula of one task, compiled, with counters that follow the truth of its literals.
#pragma once

#include <cstdint>
#include <vector>

#include "truth.hpp"

namespace skein::executive {

/// 16 bytes. `key` is the task's id, the message's index, or the instant [ns].
struct CompiledLiteral {
  enum class Kind : std::uint8_t { kTask, kMessage, kTime };
  static constexpr std::uint8_t kNegated = 1, kOptional = 2, kImplicit = 4;

  std::uint64_t key = 0;
  std::uint32_t clause = 0;
  Kind kind = Kind::kTask;
  std::uint8_t wanted = 0;  ///< task state, or for an instant whether it is to have passed
  std::uint8_t flags = 0;   ///< implicit: the deadline of a synchronisation, not part of Ξ
  Truth value = Truth::kFalse;

  Truth truth(Standing standing) const {
    return truth_of(standing, (flags & kNegated) != 0,
                    (flags & kOptional) != 0 ? Modality::kOptional : Modality::kMandatory);
  }
};

/// A formula that knows at any time whether it is satisfied or false for ever. Cost of a change of
/// a literal: O(1). Invariant: the counters agree with the values of the literals.
class FormulaState {
 public:
  /// Replaces the formula; every earlier watch of it becomes stale.
  /// `literals` are grouped by clause, clauses are numbered from 0 to clauses-1.
  void assign(std::vector<CompiledLiteral> literals, std::uint32_t clauses);
  /// Removes all clauses and frees their memory.
  void clear() { assign({}, 0); }

  /// Changes with every assign(); a watch made under another version is stale.
  std::uint32_t version() const { return version_; }
  bool empty() const { return clauses_.empty(); }
  /// Every clause holds (so also without clauses).
  bool satisfied() const { return unsatisfied_ == 0; }
  /// Some clause is false for ever.
  bool dead() const { return dead_ > 0; }

  const CompiledLiteral& literal(std::uint32_t index) const { return literals_[index]; }
  const std::vector<CompiledLiteral>& literals() const { return literals_; }
  std::uint32_t clauses() const { return static_cast<std::uint32_t>(clauses_.size()); }

  void set(std::uint32_t index, Truth value);

 private:
  struct ClauseCount {
    std::uint32_t size = 0, holding = 0, dead = 0;
  };
  void count(const CompiledLiteral& literal, bool in);

  std::vector<CompiledLiteral> literals_;
  std::vector<ClauseCount> clauses_;
  std::uint32_t unsatisfied_ = 0, dead_ = 0, version_ = 0;
};

}  // namespace skein::executive
