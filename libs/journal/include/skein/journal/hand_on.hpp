// SPDX-License-Identifier: Apache-2.0
// Dispatch of a record, as a line of its kind, to a handler.
#pragma once

#include <string>

#include "skein/journal/line.hpp"

namespace skein::journal {

/// The instant and author of a line, and its record. Valid as long as the record lives.
struct Written {
  MissionTime at;
  const std::string& node;
  const Record& record;
};

/// Calls `hearer.hear(Line&&, Written)` if the record is of the kind of one of `Lines`; records of
/// other kinds are ignored. False: the record is of such a kind but lacks a mandatory field; then
/// `hearer` was not called. Cost: a comparison of names for each of `Lines`, and one line read.
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
