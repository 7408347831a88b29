// SPDX-License-Identifier: Apache-2.0
// Temporal messages as vertical bars, from the rail of who sent to those of who heard it. Source: M
// figure 7.
#include <algorithm>

#include "story/encounters.hpp"
#include "text.hpp"
#include "timeline/timeline.hpp"

namespace skein::report {

namespace {

constexpr std::size_t kMostBars = 3000;
constexpr double kTick = 1.6;

void draw_one(Sheet& sheet, const TemporalMessage& one) {
  const auto rail_of = [&](std::size_t uav) {
    return sheet.rails.find(sheet.run.story.uavs[uav].name);
  };
  const auto from = rail_of(one.sender);
  if (from == sheet.rails.end()) return;
  double top = from->second, bottom = from->second;
  std::string heard_by;
  Markup ticks;
  for (const std::size_t uav : one.heard_by) {
    const auto rail = rail_of(uav);
    if (rail == sheet.rails.end()) continue;
    top = std::min(top, rail->second);
    bottom = std::max(bottom, rail->second);
    heard_by += (heard_by.empty() ? "" : ", ") + sheet.run.story.uavs[uav].name;
    ticks.leaf("line", {{"x1", sheet.x(one.t)},
                        {"x2", sheet.x(one.t)},
                        {"y1", rail->second - kTick},
                        {"y2", rail->second + kTick},
                        {"class", "heard"}});
  }
  sheet.under.open("g", {{"class", colour_class(one.sender)}});
  sheet.under.title(clock_text(one.t) + " what lies between the meetings of " + from->first +
                    ", heard by " + heard_by);
  sheet.under.leaf("line",
                   {{"x1", sheet.x(one.t)}, {"x2", sheet.x(one.t)}, {"y1", top}, {"y2", bottom}});
  sheet.under.raw(ticks.take()).close();
}

}  // namespace

void draw_temporal_messages(Sheet& sheet) {
  const auto messages = temporal_messages_of(sheet.run.journal, sheet.run.story);
  if (messages.empty()) return;
  const std::size_t stride = messages.size() / kMostBars + 1;
  sheet.under.open("g", {{"class", "temporal"}});
  for (std::size_t i = 0; i < messages.size(); i += stride) draw_one(sheet, messages[i]);
  sheet.under.close();
}

}  // namespace skein::report
