// SPDX-License-Identifier: Apache-2.0
#include "air_story.hpp"

#include <algorithm>
#include <map>

#include "line.hpp"
#include "text.hpp"

namespace skein::report {

namespace {

constexpr std::size_t kNumbers = 7;  // of a piece

/// When the task is over, or the log.
double end_of(const Chronology& story, std::size_t uav, std::int64_t task) {
  for (const TaskBar& bar : story.tasks) {
    if (bar.uav == uav && bar.id == static_cast<std::uint64_t>(task)) return bar.span.to;
  }
  return story.time.to;
}

std::vector<AirPiece> pieces_of(const Line& line) {
  std::vector<AirPiece> pieces;
  const auto found = line.keys.find("air");
  if (found == line.keys.end() || !found->is_array()) return pieces;
  const auto number = [&](std::size_t i) {
    const auto& one = (*found)[i];
    return one.is_number() ? one.get<double>() : 0.0;
  };
  for (std::size_t i = 0; i + kNumbers <= found->size(); i += kNumbers) {
    pieces.push_back({{number(i), number(i + 1)},
                      {number(i + 2), number(i + 3)},
                      number(i + 4),
                      number(i + 5),
                      number(i + 6)});
  }
  return pieces;
}

}  // namespace

std::vector<AirUse> tell_air(const Journal& journal, const Chronology& story) {
  std::vector<AirUse> uses;
  std::map<std::size_t, std::size_t> last;
  for (const OtherRecord& record : journal.others) {
    if (record.kind != "air") continue;
    const auto line = line_of(record);
    if (!line) continue;
    const auto uav = story.uav_index(line->text("uav"));
    if (!uav) continue;
    if (const auto before = last.find(*uav); before != last.end()) {
      Span& span = uses[before->second].span;
      span.to = std::min(span.to, line->t);
    }
    const auto task = line->whole("task").value_or(0);
    const double raised = line->number("raised");
    const std::string type = line->text("type"), state = line->text("state");
    if (state == "given-up") {
      last.erase(*uav);
      continue;
    }
    last[*uav] = uses.size();
    uses.push_back({*uav,
                    {line->t, std::max(line->t, end_of(story, *uav, task))},
                    state,
                    std::to_string(task) + " " + type,
                    raised > 0 ? short_number(raised, 0) + " m higher" : line->text("for"),
                    pieces_of(*line),
                    type != "land" || state == "aside"});
  }
  return uses;
}

}  // namespace skein::report
