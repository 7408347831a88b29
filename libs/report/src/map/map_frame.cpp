// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include "page/views.hpp"

namespace skein::report {

namespace {

constexpr double kWidth = 820.0;
constexpr double kLeastHeight = 540.0;
constexpr double kMostHeight = 640.0;
constexpr double kMargin = 46.0;       // room for labels [px]
constexpr double kLeastExtent = 60.0;  // [m]

class Hull {
 public:
  void add(double x, double y) {
    box_.west = std::min(box_.west, x);
    box_.east = std::max(box_.east, x);
    box_.south = std::min(box_.south, y);
    box_.north = std::max(box_.north, y);
  }
  bool empty() const { return box_.west > box_.east; }
  const Extents& box() const { return box_; }

 private:
  static constexpr double kFar = std::numeric_limits<double>::max();
  Extents box_{kFar, kFar, -kFar, -kFar};
};

Extents activity(const RunInfo& info, const Chronology& story) {
  Hull hull;
  for (const UavStory& uav : story.uavs) {
    for (const TrackPoint& p : uav.track) hull.add(p.position.x, p.position.y);
  }
  for (const AlarmStory& a : story.alarms) hull.add(a.position.x, a.position.y);
  for (const ObjectStory& o : story.objects) {
    for (const ObjectRecord& r : o.states) hull.add(r.position.x, r.position.y);
  }
  for (const Zone& zone : info.zones) {
    for (const GroundPoint& p : zone.polygon) hull.add(p.x, p.y);
  }
  for (const Place& p : info.places) hull.add(p.position.x, p.position.y);
  if (!hull.empty()) return hull.box();
  return info.extents.value_or(Extents{-100, -100, 100, 100});
}

}  // namespace

MapFrame frame_map(const RunInfo& info, const Chronology& story) {
  const Extents box = activity(info, story);
  const double east = std::max(box.east - box.west, kLeastExtent);
  const double north = std::max(box.north - box.south, kLeastExtent);
  const double inner = kWidth - 2.0 * kMargin;
  MapFrame frame;
  frame.width = kWidth;
  frame.height = std::clamp(inner * north / east + 2.0 * kMargin, kLeastHeight, kMostHeight);
  frame.scale = std::min(inner / east, (frame.height - 2.0 * kMargin) / north);
  const double x = (box.west + box.east) / 2.0, y = (box.south + box.north) / 2.0;
  const double half_width = frame.width / frame.scale / 2.0;
  const double half_height = frame.height / frame.scale / 2.0;
  frame.view = {x - half_width, y - half_height, x + half_width, y + half_height};
  return frame;
}

}  // namespace skein::report
