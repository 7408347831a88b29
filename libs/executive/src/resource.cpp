// SPDX-License-Identifier: Apache-2.0
#include "skein/executive/resource.hpp"

#include <algorithm>

namespace skein::executive {

TypeTable TypeTable::elementary() {
  TypeTable table;
  for (const char* type : {"takeoff", "land", "goto", "wait"}) {
    table.declare(type, {std::string(kMotion)});
  }
  table.declare("takeshot", {"$device"});
  table.declare(std::string(kSynchroniseType), {});
  return table;
}

void TypeTable::declare(std::string type, std::vector<std::string> resources) {
  types_[std::move(type)] = std::move(resources);
}

bool TypeTable::is_declared(std::string_view type) const {
  return is_joint(type) || types_.find(type) != types_.end();
}

std::vector<std::string> TypeTable::resources_of(const std::string& type,
                                                 const Parameters& parameters) const {
  const auto found = types_.find(type);
  if (found == types_.end()) return {};
  std::vector<std::string> resources;
  for (const std::string& resource : found->second) {
    if (resource.empty() || resource.front() != '$') {
      resources.push_back(resource);
    } else {
      const Parameter* parameter = parameters.find(std::string_view(resource).substr(1));
      resources.push_back(parameter == nullptr ? "" : parameter->text);
    }
  }
  std::sort(resources.begin(), resources.end());
  resources.erase(std::unique(resources.begin(), resources.end()), resources.end());
  return resources;
}

}  // namespace skein::executive
