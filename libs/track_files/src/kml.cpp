// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "flown.hpp"
#include "skein/foundation/markup.hpp"
#include "skein/foundation/unix_time.hpp"

namespace skein::track_files {
namespace {

/// Blue, green, red as KML writes them; Okabe and Ito 2008, for the n-th UAV.
constexpr std::array<const char*, 7> kColours{"ffb27200", "ff009fe6", "ff739e00", "ffa779cc",
                                              "ffe9b456", "ff005ed5", "ff42e4f0"};

std::string coordinates(const world::GeodeticPoint& point, char between) {
  return degrees(point.longitude_degrees) + between + degrees(point.latitude_degrees) + between +
         metres(point.altitude);
}

std::string named(const std::string& name) { return "<name>" + escaped_markup(name) + "</name>"; }

std::string folder(const std::string& name, const std::string& inside) {
  return inside.empty() ? "" : "<Folder>" + named(name) + "\n" + inside + "</Folder>\n";
}

std::string line(const Track& track) {
  std::string text = "<LineString><altitudeMode>absolute</altitudeMode><coordinates>";
  for (const Fix& fix : track.fixes) text += "\n" + coordinates(fix.point, ',');
  return text + "\n</coordinates></LineString>";
}

/// Google's track: all instants, then all places.
std::string in_time(const Track& track) {
  std::string text = "<gx:Track><altitudeMode>absolute</altitudeMode>\n";
  for (const Fix& fix : track.fixes) text += "<when>" + utc_text(fix.at) + "</when>\n";
  for (const Fix& fix : track.fixes)
    text += "<gx:coord>" + coordinates(fix.point, ' ') + "</gx:coord>\n";
  return text + "</gx:Track>";
}

std::string track_text(const Track& track, std::size_t index) {
  if (track.fixes.size() < 2) return "";
  const std::string style = "<Style><LineStyle><color>" +
                            std::string(kColours.at(index % kColours.size())) +
                            "</color><width>3</width></LineStyle></Style>";
  const std::string about = "<description>" + escaped_markup(track.model) + "</description>";
  return folder(track.uav, "<Placemark>" + named(track.uav) + about + style + line(track) +
                               "</Placemark>\n" + "<Placemark>" + named(track.uav + " in time") +
                               style + in_time(track) + "</Placemark>\n");
}

std::string polygon(const std::string& name, const std::vector<report::GroundPoint>& corners,
                    const Flown& flown) {
  if (corners.size() < 3) return "";
  std::string ring;
  for (std::size_t i = 0; i <= corners.size(); ++i) {
    const report::GroundPoint& corner = corners[i % corners.size()];
    const auto at = flown.on_earth(corner.x, corner.y, 0);
    ring += "\n" + degrees(at.longitude_degrees) + "," + degrees(at.latitude_degrees);
  }
  return "<Placemark>" + named(name) + "<Polygon><outerBoundaryIs><LinearRing><coordinates>" +
         ring + "\n</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>\n";
}

std::string spots(const Flown& flown, const std::string& kind) {
  std::string text;
  for (const Spot& spot : flown.spots())
    if (spot.kind == kind)
      text += "<Placemark>" + named(spot.name) +
              "<Point><altitudeMode>absolute</altitudeMode><coordinates>" +
              coordinates(spot.point, ',') + "</coordinates></Point></Placemark>\n";
  return text;
}

}  // namespace

std::string to_kml(const report::RunInfo& info, const std::vector<journal::Record>& records,
                   const TrackOptions& options) {
  const Flown flown(info, records, options);
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<kml xmlns=\"http://www.opengis.net/kml/2.2\" "
      "xmlns:gx=\"http://www.google.com/kml/ext/2.2\">\n<Document>" +
      named(info.scenario) + "\n";
  for (std::size_t i = 0; i < flown.tracks().size(); ++i) text += track_text(flown.tracks()[i], i);
  std::string zones, air;
  for (const report::Zone& zone : info.zones) zones += polygon(zone.name, zone.polygon, flown);
  for (const report::ClosedAir& one : info.air) air += polygon(one.name, one.polygon, flown);
  return text + folder("zones", zones) + folder("closed air", air) +
         folder("places", spots(flown, "place")) + folder("alarms", spots(flown, "alarm")) +
         "</Document>\n</kml>\n";
}

}  // namespace skein::track_files
