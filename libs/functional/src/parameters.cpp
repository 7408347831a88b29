// SPDX-License-Identifier: Apache-2.0
#include "skein/functional/parameters.hpp"

#include <algorithm>
#include <utility>

namespace skein::functional {

Parameters& Parameters::add(std::string name, std::string text) {
  all_.push_back({std::move(name), std::move(text), {}});
  return *this;
}

Parameters& Parameters::add(std::string name, std::vector<double> numbers) {
  all_.push_back({std::move(name), {}, std::move(numbers)});
  return *this;
}

Parameters& Parameters::add(std::string name, std::initializer_list<double> numbers) {
  return add(std::move(name), std::vector<double>(numbers));
}

Parameters& Parameters::add(std::string name, double number) {
  return add(std::move(name), std::vector<double>{number});
}

const Parameter* Parameters::find(std::string_view name) const {
  const auto found =
      std::find_if(all_.begin(), all_.end(), [&](const Parameter& p) { return p.name == name; });
  return found == all_.end() ? nullptr : &*found;
}

}  // namespace skein::functional
