// SPDX-License-Identifier: Apache-2.0
#include "lisp/options.hpp"

#include <algorithm>
#include <array>

namespace skein::htn::lisp {

Outcome Options::key_of(Machine& machine, Term item) const {
  return key ? machine.call(*key, std::array{item}) : Outcome(item);
}

Result<bool, Failure> Options::matches(Machine& machine, Term wanted, Term key_of_item) const {
  if (!test) {
    if (!machine.charge(1)) return failure(Machine::kTooLong);
    return wanted == key_of_item;
  }
  const Outcome outcome = machine.call(*test, std::array{wanted, key_of_item});
  if (!outcome) return tl::unexpected(outcome.error());
  return (*outcome != kNil) != negated;
}

Result<Options, Failure> read_options(Machine& machine, Arguments arguments, std::size_t from,
                                      std::initializer_list<std::string_view> allowed) {
  Options options;
  for (std::size_t at = from; at < arguments.size(); at += 2) {
    const std::string keyword = machine.store().to_text(arguments[at]);
    if (std::find(allowed.begin(), allowed.end(), keyword) == allowed.end()) {
      std::string known;
      for (const std::string_view name : allowed)
        known.append(known.empty() ? "" : ", ").append(name);
      return failure("unknown option " + keyword + ", expected " + known);
    }
    if (at + 1 == arguments.size()) return failure("option " + keyword + " without value");
    const Term value = arguments[at + 1];
    if (keyword == ":test") options.test = value;
    if (keyword == ":test-not") {
      options.test = value;
      options.negated = true;
    }
    if (keyword == ":key" && value != kNil) options.key = value;
    if (keyword == ":initial-value") options.initial = value;
    if (keyword == ":from-end") options.from_end = value != kNil;
  }
  return options;
}

}  // namespace skein::htn::lisp
