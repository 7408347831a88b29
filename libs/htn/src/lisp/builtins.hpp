// SPDX-License-Identifier: Apache-2.0
// The functions of the language, in tables by theme, and what they share.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lisp/machine.hpp"

namespace skein::htn::lisp {

std::span<const Builtin> arithmetic_builtins();
std::span<const Builtin> comparison_builtins();
std::span<const Builtin> division_builtins();
std::span<const Builtin> list_builtins();
std::span<const Builtin> sequence_builtins();
std::span<const Builtin> mapping_builtins();
std::span<const Builtin> text_builtins();
std::span<const Builtin> table_builtins();
std::array<std::span<const Builtin>, 8> all_builtins();
/// Null for names that are not built in. Cost: a look at each.
const Builtin* builtin_of(std::string_view name);
/// What (setf (gethash key table) value) and (setf (aref array index…) value) call.
const Builtin& hash_setter();
const Builtin& array_setter();

/// "argument 2 is (a b), expected a number".
tl::unexpected<Failure> wrong_argument(Machine& machine, Arguments arguments, std::size_t at,
                                       std::string_view expected);
/// Null when the argument is no number.
const Number* number_at(Machine& machine, Arguments arguments, std::size_t at);
Result<std::int64_t, Failure> integer_at(Machine& machine, Arguments arguments, std::size_t at);
/// The items of a proper list.
Result<std::vector<Term>, Failure> items_at(Machine& machine, Arguments arguments, std::size_t at);

}  // namespace skein::htn::lisp
