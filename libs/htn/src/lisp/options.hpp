// SPDX-License-Identifier: Apache-2.0
// Keyword arguments of the list functions.
#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>

#include "lisp/machine.hpp"

namespace skein::htn::lisp {

/// (… :test #'equal :key #'car …); of a function without them: eql and the item itself.
struct Options {
  std::optional<Term> test;
  std::optional<Term> key;
  std::optional<Term> initial;
  bool negated = false;  ///< :test-not
  bool from_end = false;

  Outcome key_of(Machine& machine, Term item) const;
  /// Whether the test holds between the wanted term and the key of an item.
  Result<bool, Failure> matches(Machine& machine, Term wanted, Term key_of_item) const;
};

/// Reads pairs of keyword and value from argument `from` on.
Result<Options, Failure> read_options(Machine& machine, Arguments arguments, std::size_t from,
                                      std::initializer_list<std::string_view> allowed);

}  // namespace skein::htn::lisp
