// SPDX-License-Identifier: Apache-2.0
#include "skein/journal/record.hpp"

#include <cmath>
#include <limits>

namespace skein::journal {

Value Record::from_unsigned(std::uint64_t number) {
  if (number > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
    return std::to_string(number);
  }
  return static_cast<std::int64_t>(number);
}

const Value* Record::find(std::string_view key) const {
  for (const auto& [name, value] : fields_) {
    if (name == key) return &value;
  }
  return nullptr;
}

std::string_view Record::text(std::string_view key) const {
  const Value* value = find(key);
  const auto* text = value == nullptr ? nullptr : std::get_if<std::string>(value);
  return text == nullptr ? std::string_view{} : *text;
}

double Record::number(std::string_view key, double otherwise) const {
  const Value* value = find(key);
  if (value == nullptr) return otherwise;
  if (const auto* number = std::get_if<double>(value)) return *number;
  if (const auto* number = std::get_if<std::int64_t>(value)) return static_cast<double>(*number);
  return otherwise;
}

bool Record::truth(std::string_view key) const {
  const Value* value = find(key);
  const bool* truth = value == nullptr ? nullptr : std::get_if<bool>(value);
  return truth != nullptr && *truth;
}

std::vector<double> Record::numbers(std::string_view key) const {
  const Value* value = find(key);
  const auto* numbers = value == nullptr ? nullptr : std::get_if<std::vector<double>>(value);
  return numbers == nullptr ? std::vector<double>{} : *numbers;
}

double rounded(double x) { return std::round(x * 1000.0) / 1000.0; }

std::vector<double> rounded(std::vector<double> xs) {
  for (double& x : xs) x = rounded(x);
  return xs;
}

}  // namespace skein::journal
