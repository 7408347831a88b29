// SPDX-License-Identifier: Apache-2.0
// Port: functions the host offers to domains, for `call`, `eval`, `assign`, costs and :sort-by.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/htn/term_store.hpp"

namespace skein::htn {

/// Called with evaluated arguments. A failure ends the search with that reason and the place of the
/// call: it is an error of the domain or of the host, not a negative answer (that is kNil). The
/// result must depend on the arguments only: the search may ask again, or not ask at all.
using HostFunction = std::function<Result<Term, Failure>(TermStore&, std::span<const Term>)>;

struct TypedFunction;

/// The host's functions by name. Case does not count. Thread rule: fill before planning.
class Functions {
 public:
  struct Entry {
    HostFunction function;
    std::size_t least_arguments = 0;
    std::size_t most_arguments = 0;
  };
  void add(const std::string& name, std::size_t least_arguments, std::size_t most_arguments,
           HostFunction function);
  /// What `typed` of typed_function.hpp made of a C++ callable.
  void add(TypedFunction function);
  const Entry* find(std::string_view name) const;
  /// In alphabetical order.
  std::vector<std::string> names() const;

 private:
  std::map<std::string, Entry, std::less<>> entries_;
};

}  // namespace skein::htn
