// SPDX-License-Identifier: Apache-2.0
#include "request_body.hpp"

#include <nlohmann/json.hpp>

#include "skein/console/nesting.hpp"

namespace skein::console {

namespace {

using Json = nlohmann::json;

/// Of the header: a station beside those at the shell, which choose theirs at random.
constexpr std::uint32_t kInstance = 1;

}  // namespace

Result<wire::OperatorRequest, std::vector<std::string>> request_of(const std::string& body) {
  if (is_too_deep(body)) return tl::unexpected(std::vector<std::string>{"nested too deeply"});
  const Json said = Json::parse(body, nullptr, false);
  std::vector<std::string> problems;
  if (!said.is_object()) return tl::unexpected(std::vector<std::string>{"expected a JSON object"});
  wire::OperatorRequest request;
  if (said.contains("who") && said["who"].is_string()) {
    request.who = said["who"].get<std::string>();
  } else {
    problems.emplace_back("who: expected an operator's name");
  }
  if (said.contains("number") && said["number"].is_number_unsigned()) {
    request.number = said["number"].get<std::uint64_t>();
  } else {
    problems.emplace_back("number: expected a whole number that grows from request to request");
  }
  if (said.contains("actions") && said["actions"].is_array()) {
    request.request = said["actions"].dump(-1, ' ', false, Json::error_handler_t::replace);
  } else {
    problems.emplace_back("actions: expected a list");
  }
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  if (const auto wrong = wire::find_violation(request)) {
    return tl::unexpected(std::vector<std::string>{wrong->field + ": " + wrong->why});
  }
  request.header.instance = kInstance;
  return request;
}

}  // namespace skein::console
