// SPDX-License-Identifier: Apache-2.0
// How often each variable occurs in a part of a clause.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "language/read_context.hpp"

namespace skein::htn {

/// Counts ?x but not the anonymous ?_ and ?_x.
class VariableCounts {
 public:
  struct Entry {
    std::size_t count = 0;
    Expression first;
  };
  void add(const ReadContext& context, Expression part);
  bool has(Term variable) const { return entries_.contains(variable.bits()); }
  const std::map<std::uint32_t, Entry>& entries() const { return entries_; }

 private:
  std::map<std::uint32_t, Entry> entries_;  // by the bits of the variable
};

/// Warns of the variables that occur once in `counts` and nowhere in `others`.
void warn_singletons(const ReadContext& context, const VariableCounts& counts,
                     const std::vector<const VariableCounts*>& others, const std::string& where);

}  // namespace skein::htn
