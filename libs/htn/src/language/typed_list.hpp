// SPDX-License-Identifier: Apache-2.0
// PDDL's typed lists: a b - type c - (either d e) f.
#pragma once

#include <vector>

#include "language/read_context.hpp"

namespace skein::htn {

enum class TypedNames : std::uint8_t { kVariables, kNames };

struct TypedName {
  Expression name;
  std::vector<Expression> types;  ///< empty: none given
};

/// The list's items from `from` on (its first child if absent); what is wrong goes to the errors,
/// what is right is returned. nil is the empty list.
std::vector<TypedName> read_typed_list(const ReadContext& context, Expression list, TypedNames kind,
                                       Expression from = {});

}  // namespace skein::htn
