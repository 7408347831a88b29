// SPDX-License-Identifier: Apache-2.0
// Strict reading of JSON values, with the path of the first thing that is wrong.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/foundation/time.hpp"

namespace skein::trace_lines {

using Json = nlohmann::json;

/// Thrown inside the reader only; who reads lines turns it into a Failure.
struct WrongValue {
  std::string why;
};

/// A value with where it is in its document ("task.pre[0][1]"). The accessors throw WrongValue.
class Node {
 public:
  Node(const Json& json, std::string path) : json_(&json), path_(std::move(path)) {}

  [[noreturn]] void wrong(const std::string& why) const;
  /// An object with no other keys than these.
  void expect_keys(std::initializer_list<std::string_view> keys) const;
  bool has(std::string_view key) const;
  Node at(std::string_view key) const;
  std::vector<Node> items() const;

  std::string text() const;
  std::uint64_t id() const;
  bool flag() const;
  /// Seconds, within the range of mission time.
  MissionTime instant() const;
  std::vector<std::string> names() const;
  /// One of these words, as its place among them.
  std::size_t one_of(std::initializer_list<std::string_view> words) const;

  const Json& json() const { return *json_; }

 private:
  const Json* json_;
  std::string path_;
};

/// A whole document; the nesting is bounded and no object has a key twice.
Result<Json, Failure> parse(std::string_view text);

/// A line of a trace: its instant, "at", and what `input` makes of it; the failure says what was
/// wrong and where. Line: {MissionTime, what `input` gives}.
template <class Line, class Input>
Result<Line, Failure> read_timed(std::string_view text, const Input& input) {
  const Result<Json, Failure> json = parse(text);
  if (!json) return tl::unexpected<Failure>(json.error());
  try {
    const Node node(*json, "");
    const MissionTime at = node.at("at").instant();
    return Line{at, input(node)};
  } catch (const WrongValue& wrong) {
    return failure(wrong.why);
  } catch (const Json::exception& error) {
    return failure(error.what());
  }
}

}  // namespace skein::trace_lines
