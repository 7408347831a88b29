// SPDX-License-Identifier: Apache-2.0
// From effects of the executive to JSON. Keys stand in the order of spec 2.8, which a JSON library
// that sorts them would not keep; an instant is an exact decimal, an integer without a point.
#include <nlohmann/json.hpp>

#include "line.hpp"

namespace skein::mle_tool {

namespace {

std::string json_text(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_text(std::string_view text) { return json_text(std::string(text)); }

std::string opening(MissionTime at) { return "{\"at\":" + to_text(at); }

struct LineOf {
  MissionTime at;
  using Line = std::optional<std::string>;

  Line operator()(const executive::TaskEvent& e) const {
    return opening(at) + ",\"task\":" + to_text(e.id) +
           ",\"state\":" + json_text(executive::to_text(e.state)) + "}";
  }
  Line operator()(const executive::Dispatch& e) const {
    return opening(at) + ",\"dispatch\":" + to_text(e.id) + "}";
  }
  Line operator()(const executive::Interrupt& e) const {
    return opening(at) + ",\"interrupt\":" + to_text(e.id) + "}";
  }
  Line operator()(const executive::SendSync& e) const {
    return opening(at) + ",\"sync\":{\"id\":" + std::to_string(e.id) +
           ",\"to\":" + json_text(e.to) +
           (e.word == executive::SyncWord::kThere
                ? ""
                : ",\"word\":" + json_text(executive::to_text(e.word))) +
           "}}";
  }
  Line operator()(const executive::Reply& e) const {
    if (e.accepted) return std::nullopt;
    std::string line = opening(at) + ",\"refused\":" + json_text(executive::to_text(e.request));
    if (e.id) line += ",\"id\":" + to_text(*e.id);
    return line + ",\"why\":" + json_text(e.why) + "}";
  }
  Line operator()(const executive::ForwardToSupervisor&) const { return std::nullopt; }
  Line operator()(const executive::Notice&) const { return std::nullopt; }
};

}  // namespace

std::optional<std::string> to_line(const executive::Effect& effect, MissionTime at) {
  return std::visit(LineOf{at}, effect);
}

std::string wrong_line(MissionTime at, std::size_t number, const std::string& why) {
  return opening(at) + ",\"refused\":\"line\",\"line\":" + std::to_string(number) +
         ",\"why\":" + json_text(why) + "}";
}

}  // namespace skein::mle_tool
