// SPDX-License-Identifier: Apache-2.0
// The data that the page's script moves markers with: columns of rounded numbers.
#include <algorithm>
#include <cmath>

#include "page/views.hpp"
#include "reading/field_reader.hpp"

namespace skein::report {

namespace {

using PageJson = nlohmann::json;

constexpr std::size_t kMostSamplesInAll = 30'000;
constexpr std::size_t kMostTasks = 20'000;

double rounded(double value, double per_unit) { return std::round(value * per_unit) / per_unit; }

PageJson track_columns(const UavStory& uav, std::size_t most, const MapFrame& frame) {
  PageJson t = PageJson::array(), x = PageJson::array(), y = PageJson::array(),
           z = PageJson::array(), heading = PageJson::array(), speed = PageJson::array(),
           energy = PageJson::array();
  const std::size_t stride = uav.track.size() / std::max<std::size_t>(most, 2) + 1;
  for (std::size_t i = 0; i < uav.track.size(); ++i) {
    if (i % stride != 0 && i + 1 != uav.track.size()) continue;
    const TrackPoint& p = uav.track[i];
    const Point at = frame(p.position);
    t.push_back(rounded(p.t, 10));
    x.push_back(rounded(at.x, 10));
    y.push_back(rounded(at.y, 10));
    z.push_back(rounded(p.position.z, 10));
    heading.push_back(std::round(-p.heading * 180.0 / M_PI));
    speed.push_back(rounded(p.speed, 10));
    energy.push_back(rounded(p.energy, 1000));
  }
  return {{"t", t}, {"x", x}, {"y", y}, {"z", z}, {"h", heading}, {"v", speed}, {"e", energy}};
}

PageJson tasks_of(const Chronology& story) {
  PageJson tasks = PageJson::array();
  for (const TaskBar& bar : story.tasks) {
    const std::optional<Span> active = bar.active();
    if (!active || tasks.size() == kMostTasks) continue;
    const std::string name = std::to_string(bar.id) + " " + shortened(bar.type, 22);
    tasks.push_back(
        PageJson::array({bar.uav, rounded(active->from, 10), rounded(active->to, 10), name}));
  }
  return tasks;
}

// Inside a script element no "</" or "<!--" may stand.
std::string without_markup(const std::string& json) {
  std::string safe;
  for (const char c : json) {
    if (c == '<') {
      safe += "\\u003c";
    } else if (c == '&') {
      safe += "\\u0026";
    } else {
      safe += c;
    }
  }
  return safe;
}

}  // namespace

std::string page_data(const Run& run, const MapFrame& frame) {
  const std::size_t most = kMostSamplesInAll / std::max<std::size_t>(run.story.uavs.size(), 1);
  PageJson uavs = PageJson::array(), phases = PageJson::array();
  for (const UavStory& uav : run.story.uavs) uavs.push_back(track_columns(uav, most, frame));
  for (const NamedSpan& p : run.story.phases) {
    phases.push_back(PageJson::array({rounded(p.span.from, 10), p.name}));
  }
  return without_markup(
      safe_dump(PageJson{{"uavs", uavs}, {"tasks", tasks_of(run.story)}, {"phases", phases}}));
}

}  // namespace skein::report
