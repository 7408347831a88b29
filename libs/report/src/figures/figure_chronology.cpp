// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "markup.hpp"
#include "plot.hpp"
#include "skein/report/figures.hpp"
#include "story/encounters.hpp"

namespace skein::report {

namespace {

constexpr double kChronologyWidth = 1100, kChronologyLeft = 80, kChronologyRight = 14,
                 kChronologyTop = 14, kChronologyRow = 30, kBar = 14;
constexpr double kFont = 11, kSmall = 9, kBelow = 56;
constexpr double kBetweenTicks = 60;  // [px]

struct Chart {
  Markup out;
  const Chronology& story;
  Axis axis;

  double middle(std::size_t row) const {
    return kChronologyTop + kChronologyRow * (static_cast<double>(row) + 0.5);
  }
  double bottom() const {
    return kChronologyTop + kChronologyRow * static_cast<double>(story.uavs.size());
  }
};

struct Look {
  const char *fill, *stroke, *name;
};
constexpr Look kMoves{"#c9d6e4", "#7b8fa5", "motion"}, kLooks{"#f3c17a", "#b9791a", "observation"},
    kMeets{"#a9d8b0", "#3d8a4b", "meeting"}, kRests{"#eeeeee", "#aaaaaa", "wait"};

Look look_of(const std::string& type) {
  if (type == "goto" || type == "takeoff" || type == "land") return kMoves;
  if (type == "rendezvous" || type == "synchronise") return kMeets;
  return type == "wait" ? kRests : kLooks;
}

/// Of a meeting: with whom; that whose end is nearest to its own.
std::string partner_of(const TaskBar& bar, const std::vector<Encounter>& encounters,
                       const Chronology& story) {
  constexpr double kNear = 1;  // [s]
  std::string partner;
  double nearest = kNear;
  for (const Encounter& one : encounters) {
    if (one.one != bar.uav && one.other != bar.uav) continue;
    const double through = one.one == bar.uav ? one.one_through : one.other_through;
    if (std::abs(through - bar.span.to) > nearest) continue;
    nearest = std::abs(through - bar.span.to);
    partner = story.uavs[one.one == bar.uav ? one.other : one.one].name;
  }
  return partner;
}

void draw_grid(Chart& chart) {
  const Axis& axis = chart.axis;
  const double step =
      round_time_step((axis.to - axis.from) * kBetweenTicks / (axis.high - axis.low));
  for (const double t : ticks(axis.from, axis.to, step)) {
    const double x = axis(t);
    chart.out.leaf("path",
                   {{"d", path_data(std::vector<Point>{{x, kChronologyTop}, {x, chart.bottom()}})},
                    {"stroke", "#e3e3e3"}});
    chart.out.element("text", {{"x", x}, {"y", chart.bottom() + 14}, {"text-anchor", "middle"}},
                      clock_text(t));
  }
  for (std::size_t i = 0; i < chart.story.uavs.size(); ++i)
    chart.out.element(
        "text", {{"x", kChronologyLeft - 8}, {"y", chart.middle(i) + 4}, {"text-anchor", "end"}},
        chart.story.uavs[i].name);
}

void draw_bars(Chart& chart, const std::vector<Encounter>& encounters) {
  for (const TaskBar& bar : chart.story.tasks) {
    const auto active = bar.active();
    if (!active) continue;
    const Look look = look_of(bar.type);
    const double left = chart.axis(active->from), right = chart.axis(active->to);
    const double y = chart.middle(bar.uav) - kBar / 2;
    chart.out.open("rect", {{"x", left},
                            {"y", y},
                            {"width", std::max(0.8, right - left)},
                            {"height", kBar},
                            {"fill", look.fill},
                            {"stroke", look.stroke},
                            {"stroke-width", 0.6}});
    chart.out.title(bar.type + " " + std::to_string(bar.id)).close();
    if (look.name != kMeets.name) continue;
    const std::string partner = partner_of(bar, encounters, chart.story);
    if (partner.empty()) continue;
    chart.out.element("text",
                      {{"x", right},
                       {"y", y - 2},
                       {"text-anchor", "end"},
                       {"font-size", kSmall},
                       {"fill", kMeets.stroke}},
                      partner);
  }
}

void draw_messages(Chart& chart, const std::vector<TemporalMessage>& messages) {
  for (const TemporalMessage& one : messages) {
    const auto [first, last] = std::minmax_element(one.heard_by.begin(), one.heard_by.end());
    const double x = chart.axis(one.t);
    const double top = chart.middle(std::min(one.sender, *first));
    const double bottom = chart.middle(std::max(one.sender, *last));
    chart.out.open("g", {{"stroke", figure_colour(one.sender)}, {"stroke-opacity", 0.75}});
    chart.out.title(chart.story.uavs[one.sender].name + " at " + clock_text(one.t));
    chart.out.leaf("path", {{"d", path_data(std::vector<Point>{{x, top}, {x, bottom}})},
                            {"stroke-width", 0.7}});
    for (const std::size_t row : one.heard_by) {
      const double y = chart.middle(row);
      chart.out.leaf("path", {{"d", path_data(std::vector<Point>{{x - 1.6, y}, {x + 1.6, y}})}});
    }
    chart.out.leaf("circle", {{"cx", x},
                              {"cy", chart.middle(one.sender)},
                              {"r", 1.8},
                              {"fill", figure_colour(one.sender)}});
    chart.out.close();
  }
}

void draw_key(Chart& chart, std::size_t messages) {
  const double y = chart.bottom() + 40;
  double x = kChronologyLeft;
  for (const Look& look : {kMoves, kLooks, kMeets, kRests}) {
    chart.out.leaf("rect", {{"x", x},
                            {"y", y - 10},
                            {"width", 18},
                            {"height", 11},
                            {"fill", look.fill},
                            {"stroke", look.stroke}});
    chart.out.element("text", {{"x", x + 23}, {"y", y}}, look.name);
    x += 45 + text_width(look.name, kFont);
  }
  chart.out.leaf("path", {{"d", path_data(std::vector<Point>{{x + 4, y - 12}, {x + 4, y + 2}})},
                          {"stroke", "#111"}});
  chart.out.leaf("circle", {{"cx", x + 4}, {"cy", y - 12}, {"r", 2}});
  chart.out.element(
      "text", {{"x", x + 12}, {"y", y}},
      "temporal message: from the dot to all ticks (" + counted(messages, "message") + ")");
}

}  // namespace

std::string chronology_svg(const RunInfo& info, const Journal& journal) {
  const Chronology story = tell(info, journal);
  Chart chart{
      {},
      story,
      {story.time.from, story.time.to, kChronologyLeft, kChronologyWidth - kChronologyRight}};
  const auto encounters = encounters_of(story);
  const auto messages = temporal_messages_of(journal, story);
  const double height = chart.bottom() + kBelow;
  chart.out.open("svg",
                 {{"xmlns", "http://www.w3.org/2000/svg"},
                  {"width", kChronologyWidth},
                  {"height", height},
                  {"viewBox", "0 0 " + short_number(kChronologyWidth) + " " + short_number(height)},
                  {"font-family", "sans-serif"},
                  {"font-size", kFont}});
  chart.out.leaf("rect", {{"width", kChronologyWidth}, {"height", height}, {"fill", "#fff"}});
  draw_grid(chart);
  draw_bars(chart, encounters);
  draw_messages(chart, messages);
  draw_key(chart, messages.size());
  chart.out.close();
  return chart.out.take();
}

}  // namespace skein::report
