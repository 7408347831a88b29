// SPDX-License-Identifier: Apache-2.0
// Numbers of members, tasks and missions as lists on the wire.
#pragma once

#include <set>
#include <utility>
#include <vector>

namespace skein::translation {

template <class Number>
using ValueOf = decltype(std::declval<Number>().value());

template <class Number>
std::vector<ValueOf<Number>> values_of(const std::set<Number>& numbers) {
  std::vector<ValueOf<Number>> values;
  for (const Number number : numbers) values.push_back(number.value());
  return values;
}

template <class Number>
std::vector<ValueOf<Number>> values_of(const std::vector<Number>& numbers) {
  std::vector<ValueOf<Number>> values;
  for (const Number number : numbers) values.push_back(number.value());
  return values;
}

template <class Number>
std::set<Number> set_of(const std::vector<ValueOf<Number>>& values) {
  std::set<Number> numbers;
  for (const auto value : values) numbers.insert(Number(value));
  return numbers;
}

template <class Number>
std::vector<Number> list_of(const std::vector<ValueOf<Number>>& values) {
  std::vector<Number> numbers;
  for (const auto value : values) numbers.push_back(Number(value));
  return numbers;
}

}  // namespace skein::translation
