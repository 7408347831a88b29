// SPDX-License-Identifier: Apache-2.0
#include "story/air_story.hpp"

#include <algorithm>
#include <map>

#include "text.hpp"

namespace skein::report {

namespace {

constexpr std::size_t kNumbers = 7;  // of a piece

/// When the task is over, or the log.
double end_of(const Chronology& story, std::size_t uav, std::uint64_t task) {
  for (const TaskBar& bar : story.tasks) {
    if (bar.uav == uav && bar.id == task) return bar.span.to;
  }
  return story.time.to;
}

std::vector<AirPiece> pieces_of(const std::vector<double>& air) {
  std::vector<AirPiece> pieces;
  for (std::size_t i = 0; i + kNumbers <= air.size(); i += kNumbers) {
    pieces.push_back(
        {{air[i], air[i + 1]}, {air[i + 2], air[i + 3]}, air[i + 4], air[i + 5], air[i + 6]});
  }
  return pieces;
}

}  // namespace

std::vector<AirUse> tell_air(const Journal& journal, const Chronology& story) {
  std::vector<AirUse> uses;
  std::map<std::size_t, std::size_t> last, ahead;
  for (const auto& [stamp, line] : journal.air) {
    const double t = seconds(stamp);
    const auto uav = story.uav_index(line.uav);
    if (!uav) continue;
    const bool is_ahead = line.state == "ahead";  // what it flies it has beside that
    for (auto* open : {&ahead, &last}) {
      const auto before = open->find(*uav);
      if (before == open->end() || (is_ahead && open == &last)) continue;
      Span& span = uses[before->second].span;
      span.to = std::min(span.to, t);
    }
    ahead.erase(*uav);
    if (line.state == "given-up") {
      last.erase(*uav);
      continue;
    }
    (is_ahead ? ahead : last)[*uav] = uses.size();
    const double raised = line.raised.value_or(0);
    uses.push_back({*uav,
                    {t, std::max(t, end_of(story, *uav, line.task))},
                    line.state,
                    std::to_string(line.task) + " " + line.type,
                    raised > 0 ? short_number(raised, 0) + " m higher" : std::string(line.for_),
                    pieces_of(line.air),
                    line.type != "land" || line.state == "aside"});
  }
  return uses;
}

}  // namespace skein::report
