// SPDX-License-Identifier: Apache-2.0
// A record handed to whoever takes lines of its kind.
#pragma once

#include <string>

#include "skein/journal/line.hpp"

namespace skein::journal {

/// When and by whom a line was written; `record` is the line itself. Valid while that lives.
struct Written {
  MissionTime at;
  const std::string& node;
  const Record& record;
};

/// Calls `hearer.hear(Line&&, Written)` if the record is of the kind of one of `Lines`; others
/// pass. False: it is of such a kind and lacks what a line of it must have, and nobody was called.
/// Cost: a comparison of names for each of `Lines`, and one line read.
template <class... Lines, class Hearer>
bool hand_on(const Record& record, Hearer& hearer) {
  bool sound = true;
  const auto hand = [&]<class Line>(std::type_identity<Line>) {
    if (record.kind() != Line::kKind) return false;
    auto line = read_as<Line>(record);
    sound = line.has_value();
    if (sound) hearer.hear(*std::move(line), Written{record.at(), record.node(), record});
    return true;
  };
  static_cast<void>((hand(std::type_identity<Lines>{}) || ...));
  return sound;
}

}  // namespace skein::journal
