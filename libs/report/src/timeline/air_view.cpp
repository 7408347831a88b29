// SPDX-License-Identifier: Apache-2.0
// Who waited for the air of a way, for whom, and who had it when: a row for each UAV. Source:
// spec 6.4.
#include "story/air_story.hpp"
#include "text.hpp"
#include "timeline/timeline.hpp"

namespace skein::report {

namespace {

constexpr double kAirBand = 15.0, kAirGap = 4.0;
constexpr std::size_t kMostText = 40;

std::string style_of(const std::string& state) {
  if (state == "waits") return "joint-loading";
  return state == "unasked" ? "violated" : "joint-running";
}

/// "heliv, karma" of "heliv to leave; karma to be answered itself".
std::string names_in(const std::string& whys) {
  std::string names;
  for (std::size_t at = 0; at < whys.size();) {
    const std::size_t end = std::min(whys.find("; ", at), whys.size());
    const std::string why = whys.substr(at, end - at);
    names += (names.empty() ? "" : ", ") + why.substr(0, why.find(" to "));
    at = end + 2;
  }
  return names;
}

void draw_use(Sheet& sheet, const AirUse& one) {
  sheet.plot.open("g", {{"class", "joint air " + colour_class(one.uav)}});
  sheet.plot.title(one.what + ": " + one.state + (one.why.empty() ? "" : ", " + one.why) + "\n" +
                   clock_text(one.span.from) + " to " + clock_text(one.span.to));
  sheet.bar(one.span, sheet.y, kAirBand - 2, style_of(one.state));
  if (one.state == "waits") {
    const std::string text = shortened("for " + names_in(one.why), kMostText);
    const double from = sheet.x(one.span.from), to = sheet.x(one.span.to);
    const double need = text_width(text, kBarFont) + 8;
    sheet.plot.element("text",
                       {{"class", to - from >= need ? "inside" : "inside off"},
                        {"x", from},
                        {"dx", 4},
                        {"y", sheet.y + kAirBand / 2 + 2.5},
                        {"data-from", from},
                        {"data-to", to},
                        {"data-need", need}},
                       text);
  }
  sheet.plot.close();
}

}  // namespace

void draw_air_rows(Sheet& sheet) {
  const std::vector<AirUse> uses = tell_air(sheet.run.journal, sheet.run.story);
  if (uses.empty()) return;
  sheet.heading("Air of ways: waited for, had");
  for (std::size_t uav = 0; uav < sheet.run.story.uavs.size(); ++uav) {
    bool first = true;
    for (const AirUse& one : uses) {
      if (one.uav != uav || one.state == "ahead") continue;
      if (std::exchange(first, false))
        sheet.row_name(sheet.y + kAirBand - 4, sheet.run.story.uavs[uav].name);
      draw_use(sheet, one);
    }
    if (!first) sheet.y += kAirBand + kAirGap;
  }
}

}  // namespace skein::report
