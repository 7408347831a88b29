// SPDX-License-Identifier: Apache-2.0
// The satisfiers of a condition.
#pragma once

#include <cstdint>
#include <vector>

#include "proof/bindings.hpp"
#include "proof/row_set.hpp"
#include "skein/htn/plan.hpp"

namespace skein::htn {

/// Values for some variables, one row for each satisfier. Variables made during the proof are kept
/// as kLocal terms and become fresh cells when a row is applied.
struct Answers {
  std::vector<Term> cells;                       ///< the variables
  std::vector<Term> values;                      ///< row after row
  std::vector<std::uint32_t> locals;             ///< for each row, how many kLocal terms it uses
  std::vector<std::vector<CausalLink>> support;  ///< for each row, while recording

  std::size_t count() const { return locals.size(); }
  std::size_t memory_bytes() const {
    return (cells.capacity() + values.capacity()) * sizeof(Term) +
           locals.capacity() * sizeof(std::uint32_t) + support.capacity() * sizeof(support[0]);
  }
  void clear();
  /// Adds the present values of the cells as a row; `younger` is the first cell made since.
  void record(Bindings& bindings, std::uint32_t younger);
  /// Binds the variables to the values of a row.
  void apply(std::size_t row, Bindings& bindings) const;
  /// Exchanges the rows [first, middle) with [middle, end).
  void rotate(std::size_t first, std::size_t middle);
  /// Row `order[i]` becomes row i.
  void reorder(const std::vector<std::size_t>& order);
  /// Reverses the rows and drops each that equals an earlier one.
  void finish(RowSet& seen);

 private:
  void move_row(std::size_t from, std::size_t to);
};

}  // namespace skein::htn
