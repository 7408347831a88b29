// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/observer.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace skein::blackboard {
namespace {

constexpr std::array<std::string_view, 4> kDurabilities{"volatile", "transient-local", "transient",
                                                        "persistent"};

std::string_view name_of(Durability durability) {
  return kDurabilities[static_cast<std::size_t>(durability)];
}

const std::vector<std::string>& with_default(const std::vector<std::string>& partitions) {
  static const std::vector<std::string> kDefault{""};
  return partitions.empty() ? kDefault : partitions;
}

bool is_pattern(const std::string& name) { return name.find_first_of("*?[") != std::string::npos; }

bool meet(const std::string& a, const std::string& b) {
  if (a == b) return true;
  if (is_pattern(a) == is_pattern(b)) return false;
  const auto& [pattern, name] = is_pattern(a) ? std::tie(a, b) : std::tie(b, a);
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

}  // namespace

std::vector<std::string> refusals(const Endpoint& writer, const Endpoint& reader) {
  std::vector<std::string> causes;
  const auto add = [&](const std::string& offered, const std::string& asked) {
    causes.push_back("the writer offers " + offered + ", the reader asks for " + asked);
  };
  const EndpointQos &offer = writer.qos, &ask = reader.qos;
  if (writer.type != reader.type) add("the type " + writer.type, reader.type);
  if (writer.keyed != reader.keyed)
    add(writer.keyed ? "a key" : "no key", reader.keyed ? "one" : "none");
  if (ask.reliable && !offer.reliable) add("best effort", "reliable");
  if (ask.durability > offer.durability)
    add(std::string(name_of(offer.durability)), std::string(name_of(ask.durability)));
  if (offer.exclusive != ask.exclusive)
    add(offer.exclusive ? "exclusive ownership" : "shared ownership",
        ask.exclusive ? "exclusive" : "shared");
  if (offer.deadline > ask.deadline) add("a longer deadline", "a shorter one");
  return causes;
}

bool partitions_meet(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  return std::ranges::any_of(with_default(a), [&](const std::string& one) {
    return std::ranges::any_of(with_default(b),
                               [&](const std::string& other) { return meet(one, other); });
  });
}

}  // namespace skein::blackboard
