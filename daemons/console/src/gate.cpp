// SPDX-License-Identifier: Apache-2.0
#include "gate.hpp"

#include <algorithm>

#include "limits.hpp"

namespace skein::console {

namespace {

constexpr std::string_view kApi = "/api/";
constexpr std::string_view kSession = "/api/session";

bool is_ipv4(const std::string& host) {
  return !host.empty() && host.find_first_not_of("0123456789.") == std::string::npos &&
         std::count(host.begin(), host.end(), '.') == 3;
}

// In a time that does not tell how much of it is right.
bool is_same(std::string_view a, std::string_view b) {
  unsigned difference = a.size() == b.size() ? 0U : 1U;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  }
  return difference == 0;
}

// Of "a=1; b=2".
std::string value_of(const std::string& cookies, const std::string& name) {
  std::size_t begin = 0;
  while (begin < cookies.size()) {
    std::size_t end = cookies.find(';', begin);
    if (end == std::string::npos) end = cookies.size();
    const std::string one = cookies.substr(begin, end - begin);
    const std::size_t first = one.find_first_not_of(' ');
    if (first != std::string::npos && one.compare(first, name.size() + 1, name + "=") == 0) {
      return one.substr(first + name.size() + 1);
    }
    begin = end + 1;
  }
  return "";
}

}  // namespace

Gate::Gate(std::uint16_t port, std::vector<std::string> names, std::string token)
    : port_(port), names_(std::move(names)), token_(std::move(token)) {
  names_.emplace_back("localhost");
}

bool Gate::is_token(std::string_view text) const { return needs_token() && is_same(text, token_); }

bool Gate::is_own_host(const std::string& host) const {
  const std::string port = ":" + std::to_string(port_);
  if (host.size() <= port.size() || !host.ends_with(port)) return false;
  const std::string name = host.substr(0, host.size() - port.size());
  return is_ipv4(name) || std::find(names_.begin(), names_.end(), name) != names_.end();
}

bool Gate::has_token(const Asked& asked) const {
  constexpr std::string_view kBearer = "Bearer ";
  const std::string& said = asked.authorization;
  const bool bears = said.starts_with(kBearer) && is_token(said.substr(kBearer.size()));
  return bears || is_token(value_of(asked.cookie, cookie_name()));
}

Verdict Gate::judge(const Asked& asked) const {
  if (!is_own_host(asked.host)) return {421, "this is not the host you asked for"};
  if (!asked.origin.empty() && asked.origin != "http://" + asked.host) {
    return {403, "asked from another page"};
  }
  const bool is_post = asked.method == "POST";
  if (!is_post && asked.method != "GET" && asked.method != "HEAD") {
    return {405, "only GET and POST"};
  }
  if (is_post) {
    if (Verdict verdict = judge_post(asked); !verdict.passes()) return verdict;
  }
  const bool is_open = !asked.path.starts_with(kApi) || asked.path == kSession;
  if (needs_token() && !is_open && !has_token(asked)) return {401, "the token is missing"};
  return {};
}

Verdict Gate::judge_post(const Asked& asked) const {
  if (asked.chunked) return {411, "the length of the request must be said"};
  if (asked.content_length > most_bytes(asked.path)) return {413, "the request is too long"};
  const std::string type = asked.content_type.substr(0, asked.content_type.find(';'));
  if (type != "application/json") return {415, "expected application/json"};
  if (asked.origin.empty() && asked.authorization.empty()) {
    return {403, "a request from no page needs the header Authorization"};
  }
  return {};
}

}  // namespace skein::console
