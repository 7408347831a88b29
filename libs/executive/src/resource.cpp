// SPDX-License-Identifier: Apache-2.0
#include "skein/executive/resource.hpp"

#include <algorithm>

namespace skein::executive {

namespace {

std::string text_of(const Parameters& parameters, std::string_view name) {
  const Parameter* parameter = parameters.find(name);
  return parameter == nullptr ? "" : parameter->text;
}

}  // namespace

void TypeTable::declare(std::string type, std::vector<std::string> resources) {
  declared_[std::move(type)] = std::move(resources);
}

bool TypeTable::is_declared(std::string_view type) const {
  return declared_.find(type) != declared_.end() || types_.find(type) != nullptr;
}

std::vector<std::string> TypeTable::resources_of(const std::string& type,
                                                 const Parameters& parameters) const {
  std::vector<std::string> resources;
  if (const auto found = declared_.find(type); found != declared_.end()) {
    for (const std::string& one : found->second) {
      const bool named = !one.empty() && one.front() == '$';
      resources.push_back(named ? text_of(parameters, std::string_view(one).substr(1)) : one);
    }
  } else if (const functional::TaskType& known = types_.of(type); !known.is_joint()) {
    if (known.holds_vehicle()) resources.emplace_back(kMotion);
    for (const std::string& one : known.devices) resources.push_back(text_of(parameters, one));
  }
  std::sort(resources.begin(), resources.end());
  resources.erase(std::unique(resources.begin(), resources.end()), resources.end());
  return resources;
}

}  // namespace skein::executive
