// SPDX-License-Identifier: Apache-2.0
#include "for_all.hpp"

#include <nlohmann/json.hpp>

namespace skein::operate_tool {

namespace {

using Json = nlohmann::ordered_json;

Json parsed(const std::string& request) { return Json::parse(request, nullptr, false); }

bool is_for_all(const Json& action) {
  if (!action.is_object() || action.size() != 1) return false;
  const Json& what = action.begin().value();
  return what.is_object() && what.contains("uav") && what["uav"] == "all";
}

bool concerns(const std::string& kind, const wire::UavBoard& board, const std::string& who) {
  if (kind == "give_back" || kind == "keep" || kind == "let_go") return board.holder == who;
  if (kind == "ask") return !board.holder.empty() && board.holder != who;
  return true;
}

}  // namespace

bool names_all(const std::string& request) {
  const Json actions = parsed(request);
  if (!actions.is_array()) return false;
  for (const Json& action : actions) {
    if (is_for_all(action)) return true;
  }
  return false;
}

std::string for_all(const std::string& request, const std::string& who, const Boards& boards) {
  Json each = Json::array();
  for (const Json& action : parsed(request)) {
    if (!is_for_all(action)) {
      each.push_back(action);
      continue;
    }
    for (const std::string& uav : boards.ground->uavs) {
      if (!concerns(action.begin().key(), boards.uavs.at(uav), who)) continue;
      Json one = action;
      one.begin().value()["uav"] = uav;
      each.push_back(std::move(one));
    }
  }
  return each.dump();
}

}  // namespace skein::operate_tool
