// SPDX-License-Identifier: Apache-2.0
// QGroundControl's plans. JSON is read as the YAML that it is, for the places of its errors.
#include <algorithm>
#include <cmath>
#include <optional>

#include "mission_item.hpp"
#include "readers.hpp"
#include "skein/config/parse.hpp"
#include "skein/config/reader.hpp"
#include "skein/mission_files/read.hpp"

namespace skein::mission_files {
namespace {

using config::Reader;

Mark mark_of(const Reader& reader) { return {reader.line(), reader.path()}; }

/// A number, or what nothing and null stand for.
double number_or_nothing(const Reader& reader) { return reader.number(kNotGiven, {-1e9, 1e9, ""}); }

class PlanReader {
 public:
  PlanReader(Contents& contents, Findings& findings) : contents_(contents), findings_(findings) {}

  void read(const Reader& root) {
    if (!root.is_map()) return root.error("no plan", "a JSON object with fileType: Plan");
    if (const Reader type = root.required("fileType"); type.present() && type.text() != "Plan")
      return type.error("'" + type.text() + "'", "Plan");
    version(root.required("version"), 1, 1);
    tell_unknown(root,
                 {"fileType", "version", "groundStation", "mission", "geoFence", "rallyPoints"});
    read_mission(root.required("mission"));
    read_fences(root.optional("geoFence"));
    read_rally_points(root.optional("rallyPoints"));
  }

 private:
  void version(const Reader& reader, int least, int most) {
    if (!reader.present()) return;
    const std::int64_t is = reader.integer(least);
    if (is < least || is > most)
      reader.error("version " + std::to_string(is), "version " + std::to_string(most));
  }

  /// What a later version may have added.
  void tell_unknown(const Reader& reader, std::initializer_list<std::string_view> known) {
    for (const auto& [key, value] : reader.entries())
      if (std::find(known.begin(), known.end(), key) == known.end())
        findings_.leave_out({value.line(), value.path()}, "'" + key.substr(0, 40) + "'");
  }

  void read_mission(const Reader& mission) {
    if (!mission.present()) return;
    if (!mission.is_map()) return mission.error("no mission", "an object with items");
    version(mission.optional("version"), 2, 2);
    tell_unknown(mission, {"version", "firmwareType", "vehicleType", "cruiseSpeed", "hoverSpeed",
                           "globalPlanAltitudeMode", "items", "plannedHomePosition"});
    read_home(mission.optional("plannedHomePosition"));
    for (const Reader& item : mission.required("items").items()) read_item(item);
  }

  void read_home(const Reader& home) {
    if (!home.present()) return;
    const auto numbers = home.items();
    if (numbers.size() != 3) return home.error("no place", "[latitude, longitude, height]");
    const LatLon at = {numbers[0].number(0), numbers[1].number(0)};
    if (at == LatLon{}) return;  // what generators write that know none
    const double over_sea = number_or_nothing(numbers[2]);
    if (!check(at, mark_of(home), findings_)) return;
    contents_.home =
        Home{at, std::isnan(over_sea) ? std::nullopt : std::optional(over_sea), mark_of(home)};
  }

  void read_item(const Reader& item) {
    if (!item.is_map()) return item.error("no item", "an object");
    const std::string type = item.required("type").text();
    if (type == "SimpleItem") return read_simple_item(item);
    if (type == "ComplexItem") return read_complex_item(item);
    item.optional("type").error("'" + type + "'", "SimpleItem or ComplexItem");
  }

  void read_simple_item(const Reader& reader) {
    MissionItem item;
    item.command = reader.required("command").integer(0, 0, 0xffff);
    item.frame = reader.required("frame").integer(0, 0, 0xff);
    item.goes_on = reader.optional("autoContinue").boolean(true);
    item.mark = mark_of(reader);
    const Reader params = reader.required("params");
    const auto values = params.items();
    if (values.size() != 7 && params.present())
      return params.error(std::to_string(values.size()) + " parameters", "7");
    for (std::size_t i = 0; i < values.size(); ++i)
      item.params.at(i) = number_or_nothing(values[i]);
    take(item, contents_, findings_);
  }

  /// Surveys and corridors carry the items that they come to; what does not is told by its name.
  void read_complex_item(const Reader& item) {
    const std::string type = item.required("complexItemType").text();
    const Reader items = item.optional("TransectStyleComplexItem").optional("Items");
    if ((type != "survey" && type != "CorridorScan") || !items.present())
      return findings_.leave_out(mark_of(item), "a complex item '" + type.substr(0, 40) + "'");
    for (const Reader& one : items.items()) {
      if (one.is_map())
        read_simple_item(one);
      else
        one.error("no item", "an object");
    }
    if (const Reader polygon = item.optional("polygon"); polygon.present() && has_room(item))
      contents_.areas.push_back({type, {}, read_ring(polygon), {}, mark_of(item)});
  }

  bool has_room(const Reader& reader) {
    const std::size_t all =
        contents_.areas.size() + contents_.fences.size() + contents_.places.size();
    if (all == kMostParts)
      reader.error("more than " + std::to_string(kMostParts) + " areas, fences and points");
    return all < kMostParts;
  }

  std::optional<LatLon> read_place(const Reader& reader, std::size_t size) {
    const auto numbers = reader.items();
    if (numbers.size() < size) {
      reader.error("no place",
                   size == 2 ? "[latitude, longitude]" : "[latitude, longitude, height over home]");
      return std::nullopt;
    }
    const LatLon at{numbers[0].number(0), numbers[1].number(0)};
    return check(at, mark_of(reader), findings_) ? std::optional(at) : std::nullopt;
  }

  std::vector<LatLon> read_ring(const Reader& reader) {
    std::vector<LatLon> ring;
    for (const Reader& corner : reader.items())
      if (const auto at = read_place(corner, 2)) ring.push_back(*at);
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() < 3) reader.error("no polygon", "three corners at least");
    return ring;
  }

  void read_fences(const Reader& fences) {
    if (!fences.present()) return;
    if (!fences.is_map()) return fences.error("no fences", "an object with circles and polygons");
    version(fences.optional("version"), 1, 2);
    tell_unknown(fences, {"version", "circles", "polygons", "polygon"});
    if (const Reader old = fences.optional("polygon"); old.present() && !old.items().empty())
      findings_.leave_out(mark_of(old), "a fence of version 1");
    for (const Reader& polygon : fences.optional("polygons").items())
      if (has_room(polygon))
        contents_.fences.push_back({read_ring(polygon.required("polygon")),
                                    polygon.required("inclusion").boolean(), mark_of(polygon)});
    for (const Reader& circle : fences.optional("circles").items())
      if (has_room(circle)) read_circle(circle);
  }

  void read_circle(const Reader& fence) {
    const Reader circle = fence.required("circle");
    const auto centre = read_place(circle.required("center"), 2);
    const double radius = circle.required("radius").number(1, {0.01, 1e6, "m"});
    const bool inclusion = fence.required("inclusion").boolean();
    if (centre) contents_.fences.push_back({Circle{*centre, radius}, inclusion, mark_of(fence)});
  }

  void read_rally_points(const Reader& rally) {
    if (!rally.present()) return;
    if (!rally.is_map()) return rally.error("no rally points", "an object with points");
    version(rally.optional("version"), 1, 2);
    tell_unknown(rally, {"version", "points"});
    for (const Reader& point : rally.optional("points").items()) {
      const auto at = read_place(point, 3);
      if (!at || !has_room(point)) continue;
      const Height over_home{point.items()[2].number(0, {-20'000, 20'000, "m"}), HeightOver::kHome};
      contents_.places.push_back({"rally", {*at, over_home}, mark_of(point)});
    }
  }

  Contents& contents_;
  Findings& findings_;
};

}  // namespace

void read_plan(std::string_view text, Contents& contents, Findings& findings) {
  const auto document = config::parse_yaml(text, findings.file());
  if (!document) return findings.errors().append(document.error());
  PlanReader(contents, findings).read(Reader(*document, findings.file(), findings.errors()));
}

}  // namespace skein::mission_files
