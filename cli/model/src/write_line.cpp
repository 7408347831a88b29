// SPDX-License-Identifier: Apache-2.0
// From effects of the engine to JSON, written as the shared example is: a blank after each comma
// and colon, instants as exact decimals.
#include <nlohmann/json.hpp>
#include <string_view>

#include "line.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::model_tool {

namespace {

std::string json_text(std::string_view text) {
  return nlohmann::json(std::string(text))
      .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string pair(std::string_view key, std::string_view text) {
  return ", \"" + std::string(key) + "\": " + json_text(text);
}

}  // namespace

std::string to_line(const interaction::Effect& effect) {
  using namespace interaction;
  const std::string said = std::visit(
      Overloaded{[](const StateChanged& e) {
                   return pair("componel", e.componel) + pair("state", to_text(e.state));
                 },
                 [](const Compute& e) { return pair("compute", e.parameter); },
                 [](const Run& e) { return pair("run", e.task); },
                 [](const Negotiate& e) { return pair("negotiate", e.action); },
                 [](const Interrupt& e) { return pair("interrupt", e.task); },
                 [](const Withdraw& e) { return pair("withdraw", e.action); },
                 [](const Read& e) { return pair("read", e.message) + pair("by", e.by); },
                 [](const ModelOver& e) {
                   return pair("model", to_text(e.state)) +
                          (e.why.empty() ? "" : pair("why", e.why));
                 }},
      effect.what);
  return "{\"at\": " + to_text(effect.at) + said + "}";
}

std::string refused_line(std::size_t number, const std::string& why) {
  return "{\"refused\": " + std::to_string(number) + pair("why", why) + "}";
}

}  // namespace skein::model_tool
