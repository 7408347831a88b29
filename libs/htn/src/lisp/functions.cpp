// SPDX-License-Identifier: Apache-2.0
#include "skein/htn/functions.hpp"

#include <algorithm>

#include "skein/foundation/contract.hpp"
#include "skein/htn/typed_function.hpp"

namespace skein::htn {

namespace {

std::string lowered(std::string_view name) {
  std::string out(name);
  std::transform(out.begin(), out.end(), out.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return out;
}

}  // namespace

void Functions::add(const std::string& name, std::size_t least_arguments,
                    std::size_t most_arguments, HostFunction function) {
  SKEIN_EXPECTS(least_arguments <= most_arguments);
  entries_[lowered(name)] = {std::move(function), least_arguments, most_arguments};
}

void Functions::add(TypedFunction function) {
  add(function.name, function.arguments, function.arguments, std::move(function.function));
}

const Functions::Entry* Functions::find(std::string_view name) const {
  auto at = entries_.find(name);
  if (at == entries_.end()) at = entries_.find(lowered(name));
  return at == entries_.end() ? nullptr : &at->second;
}

std::vector<std::string> Functions::names() const {
  std::vector<std::string> out;
  out.reserve(entries_.size());
  for (const auto& [name, entry] : entries_) out.push_back(name);
  return out;
}

}  // namespace skein::htn
