// SPDX-License-Identifier: Apache-2.0
#include "skein/journal/line.hpp"

#include <charconv>

namespace skein::journal::detail {

namespace {

template <class T>
bool take_as(const Value& value, T& to) {
  const T* found = std::get_if<T>(&value);
  if (found != nullptr) to = *found;
  return found != nullptr;
}

}  // namespace

bool take(const Value& value, bool& to) { return take_as(value, to); }
bool take(const Value& value, std::int64_t& to) { return take_as(value, to); }
bool take(const Value& value, std::string& to) { return take_as(value, to); }
bool take(const Value& value, std::vector<double>& to) { return take_as(value, to); }

// A great one is written as text.
bool take(const Value& value, std::uint64_t& to) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    to = static_cast<std::uint64_t>(*whole);
    return *whole >= 0;
  }
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr) return false;
  const auto read = std::from_chars(text->data(), text->data() + text->size(), to);
  return read.ec == std::errc() && read.ptr == text->data() + text->size();
}

// A number without a fraction reads as a whole one.
bool take(const Value& value, double& to) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    to = static_cast<double>(*whole);
    return true;
  }
  return take_as(value, to);
}

}  // namespace skein::journal::detail
