// SPDX-License-Identifier: Apache-2.0
#include "skein/trace_lines/json_node.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "skein/foundation/nearest.hpp"

namespace skein::trace_lines {

namespace {

constexpr int kDeepest = 32;
constexpr double kLatest = 9.2e9;  // [s], just inside the 64-bit range of nanoseconds

constexpr std::size_t kLongestQuote = 64;  // [bytes]

// A long word is cut, not within a character of UTF-8.
std::string in_quotes(std::string_view text) {
  if (text.size() <= kLongestQuote) return "'" + std::string(text) + "'";
  std::size_t end = kLongestQuote;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return "'" + std::string(text.substr(0, end)) + "…'";
}

std::string hint(std::string_view word, std::initializer_list<std::string_view> words) {
  const std::vector<std::string> candidates(words.begin(), words.end());
  return word.size() > kLongestQuote ? "" : did_you_mean(nearest_name(word, candidates));
}

// What JSON allows and a trace does not, found while parsing: deep nesting, keys that come twice.
class Strictness {
 public:
  bool accepts(int depth, Json::parse_event_t event, const Json& value) {
    if (!problem_.empty()) return false;
    if (depth > kDeepest) problem_ = "nested more than " + std::to_string(kDeepest) + " deep";
    if (event == Json::parse_event_t::object_start) keys_.emplace_back();
    if (event == Json::parse_event_t::object_end && !keys_.empty()) keys_.pop_back();
    if (event == Json::parse_event_t::key && !keys_.empty()) note(value.get<std::string>());
    return problem_.empty();
  }

  const std::string& problem() const { return problem_; }

 private:
  void note(const std::string& key) {
    if (!keys_.back().insert(key).second) problem_ = "key " + in_quotes(key) + " comes twice";
  }

  std::vector<std::set<std::string>> keys_;  ///< of each object that is open
  std::string problem_;
};

}  // namespace

void Node::wrong(const std::string& why) const {
  throw WrongValue{path_.empty() ? why : path_ + ": " + why};
}

void Node::expect_keys(std::initializer_list<std::string_view> keys) const {
  if (!json_->is_object()) wrong("expected an object");
  for (const auto& [key, value] : json_->items()) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      wrong("unknown key " + in_quotes(key) + hint(key, keys));
    }
  }
}

bool Node::has(std::string_view key) const {
  return json_->is_object() && json_->contains(std::string(key));
}

Node Node::at(std::string_view key) const {
  if (!json_->is_object()) wrong("expected an object");
  const auto found = json_->find(std::string(key));
  if (found == json_->end()) wrong("missing key " + in_quotes(key));
  return Node(*found, path_.empty() ? std::string(key) : path_ + "." + std::string(key));
}

std::vector<Node> Node::items() const {
  if (!json_->is_array()) wrong("expected an array");
  std::vector<Node> all;
  for (const Json& one : *json_) {
    all.emplace_back(one, path_ + "[" + std::to_string(all.size()) + "]");
  }
  return all;
}

std::string Node::text() const {
  if (!json_->is_string()) wrong("expected a string");
  return json_->get<std::string>();
}

std::uint64_t Node::id() const {
  if (!json_->is_number_unsigned()) wrong("expected an integer from 0 to 18446744073709551615");
  return json_->get<std::uint64_t>();
}

bool Node::flag() const {
  if (!json_->is_boolean()) wrong("expected true or false");
  return json_->get<bool>();
}

MissionTime Node::instant() const {
  if (!json_->is_number()) wrong("expected a number of seconds");
  const double s = json_->get<double>();
  if (!std::isfinite(s) || std::abs(s) > kLatest) wrong("not an instant of mission time");
  return MissionTime::seconds(s);
}

std::vector<std::string> Node::names() const {
  std::vector<std::string> all;
  for (const Node& one : items()) {
    all.push_back(one.text());
    if (all.back().empty()) one.wrong("expected a name");
  }
  return all;
}

std::size_t Node::one_of(std::initializer_list<std::string_view> words) const {
  const std::string word = text();
  const auto* found = std::find(words.begin(), words.end(), word);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string expected;
  for (const std::string_view one : words) {
    expected += (expected.empty() ? "" : ", ") + std::string(one);
  }
  wrong("unknown word; expected one of " + expected + hint(word, words));
}

Result<Json, Failure> parse(std::string_view text) {
  Strictness strictness;
  const Json::parser_callback_t check = [&](int depth, Json::parse_event_t event, Json& value) {
    return strictness.accepts(depth, event, value);
  };
  try {
    Json json = Json::parse(text.begin(), text.end(), check);
    if (!strictness.problem().empty()) return failure(strictness.problem());
    return json;
  } catch (const Json::parse_error& error) {
    return failure("not JSON, from column " + std::to_string(error.byte) + " on");
  } catch (const Json::exception&) {
    return failure("not JSON: a number out of range");
  }
}

}  // namespace skein::trace_lines
