// SPDX-License-Identifier: Apache-2.0
// KML: polygons, lines and points, with the folders that they are in.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>

#include "readers.hpp"
#include "skein/mission_files/read.hpp"
#include "skein/xml/element.hpp"

namespace skein::mission_files {
namespace {

using xml::Element;

constexpr std::string_view kBlanks = " \t\r\n";

/// Without the prefix of KML's own names, which some programs write.
std::string_view name_of(const Element& element) {
  const std::string_view name = element.name;
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos) return name;
  const std::string_view prefix = name.substr(0, colon);
  const bool foreign = prefix == "gx" || prefix == "atom" || prefix == "xal";
  return foreign ? name : name.substr(colon + 1);
}

const Element* child(const Element& element, std::string_view name) {
  for (const Element& one : element.children)
    if (name_of(one) == name) return &one;
  return nullptr;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

std::string text_of(const Element& element, std::string_view name) {
  const Element* found = child(element, name);
  return found == nullptr ? "" : std::string(trimmed(found->text).substr(0, 200));
}

/// How things look, and words about them: nothing that a mission is made of.
bool is_about_looks(std::string_view name) {
  static const std::set<std::string_view> kLooks{
      "name",      "description",  "open",         "visibility",
      "Style",     "StyleMap",     "styleUrl",     "Snippet",
      "snippet",   "LookAt",       "Camera",       "Region",
      "Schema",    "ExtendedData", "address",      "phoneNumber",
      "TimeStamp", "TimeSpan",     "atom:author",  "atom:link",
      "Metadata",  "tessellate",   "gx:drawOrder", "gx:balloonVisibility"};
  return kLooks.contains(name);
}

struct Corner {
  LatLon at;
  double height = 0;
};

class KmlReader {
 public:
  KmlReader(Contents& contents, Findings& findings) : contents_(contents), findings_(findings) {}

  void read(const Element& root) {
    if (name_of(root) != "kml")
      return findings_.wrong(mark(root), "the root element is '" + root.name + "'", "<kml>");
    read_container(root);
  }

 private:
  /// Of what stands in a feature: its place in the file and the feature's name.
  Mark mark(const Element& element) const {
    return {element.line, feature_.empty() ? std::string(name_of(element))
                                           : std::string(name_of(element)) + " '" + feature_ + "'"};
  }

  void read_container(const Element& container) {
    for (const Element& one : container.children) {
      const std::string_view name = name_of(one);
      if (name == "Document" || name == "Folder") {
        folders_.push_back(text_of(one, "name"));
        read_container(one);
        folders_.pop_back();
      } else if (name == "Placemark") {
        read_placemark(one);
      } else if (!is_about_looks(name)) {
        findings_.leave_out(mark(one), "<" + std::string(name) + ">");
      }
    }
  }

  void read_placemark(const Element& placemark) {
    feature_ = text_of(placemark, "name");
    read_geometries(placemark);
    feature_.clear();
  }

  void read_geometries(const Element& parent) {
    for (const Element& one : parent.children) {
      const std::string_view name = name_of(one);
      if (name == "MultiGeometry") {
        read_geometries(one);
      } else if (name == "Point" || name == "LineString" || name == "LinearRing" ||
                 name == "Polygon") {
        if (has_room(one)) read_geometry(one, name);
      } else if (!is_about_looks(name)) {
        findings_.leave_out(mark(one), "<" + std::string(name) + ">");
      }
    }
  }

  bool has_room(const Element& element) {
    const std::size_t all =
        contents_.areas.size() + contents_.ways.size() + contents_.places.size();
    if (all < kMostParts) return true;
    if (!full_)
      findings_.wrong(mark(element), "more than " + std::to_string(kMostParts) + " geometries");
    full_ = true;
    return false;
  }

  void read_geometry(const Element& element, std::string_view name) {
    if (name == "Polygon") return read_polygon(element);
    const auto over = height_mode(element);
    tell_unknown(element, {"coordinates", "extrude", "altitudeMode", "gx:altitudeMode"});
    const auto corners = coordinates(element);
    if (name == "Point" && corners.size() == 1) {
      contents_.places.push_back({feature_, position(corners[0], over), mark(element)});
    } else if (name != "Point" && corners.size() >= 2) {
      Way way{feature_, {}, mark(element)};
      for (const Corner& corner : corners) way.points.push_back(position(corner, over));
      contents_.ways.push_back(std::move(way));
    } else if (!bad_coordinates_) {
      findings_.wrong(mark(element), std::to_string(corners.size()) + " coordinates",
                      name == "Point" ? "one" : "two at least");
    }
  }

  void read_polygon(const Element& polygon) {
    const auto over = height_mode(polygon);
    tell_unknown(polygon, {"outerBoundaryIs", "innerBoundaryIs", "extrude", "altitudeMode",
                           "gx:altitudeMode"});
    if (const Element* hole = child(polygon, "innerBoundaryIs"))
      findings_.leave_out(mark(*hole), "a hole in a polygon");
    const Element* outer = child(polygon, "outerBoundaryIs");
    const Element* ring = outer == nullptr ? nullptr : child(*outer, "LinearRing");
    if (ring == nullptr)
      return findings_.wrong(mark(polygon), "no border", "<outerBoundaryIs> with a <LinearRing>");
    auto corners = coordinates(*ring);
    if (corners.size() > 1 && corners.front().at == corners.back().at) corners.pop_back();
    if (corners.size() < 3 && !bad_coordinates_)
      return findings_.wrong(mark(*ring), "no polygon", "three corners at least");
    Area area{feature_, folders_, {}, top_of(polygon, corners, over), mark(polygon)};
    for (const Corner& corner : corners) area.ring.push_back(corner.at);
    contents_.areas.push_back(std::move(area));
  }

  /// The highest corner of what stands on the ground.
  std::optional<Height> top_of(const Element& polygon, const std::vector<Corner>& corners,
                               std::optional<HeightOver> over) {
    if (!over || corners.empty()) return std::nullopt;
    const auto highest =
        std::max_element(corners.begin(), corners.end(),
                         [](const Corner& a, const Corner& b) { return a.height < b.height; });
    const std::string extrude = text_of(polygon, "extrude");
    if (extrude == "1" || extrude == "true") return Height{highest->height, *over};
    if (highest->height != 0)
      findings_.leave_out(mark(polygon), "the height of a polygon that does not reach the ground");
    return std::nullopt;
  }

  void tell_unknown(const Element& element, std::initializer_list<std::string_view> known) {
    for (const Element& one : element.children) {
      const std::string_view name = name_of(one);
      if (!is_about_looks(name) && std::find(known.begin(), known.end(), name) == known.end())
        findings_.leave_out(mark(one), "<" + std::string(name) + ">");
    }
  }

  /// What heights count from; nothing on the ground, where they do not count.
  std::optional<HeightOver> height_mode(const Element& element) {
    const std::string mode = text_of(element, "altitudeMode");
    const std::string other = text_of(element, "gx:altitudeMode");
    if (!other.empty()) findings_.leave_out(mark(element), "altitude mode '" + other + "'");
    if (mode == "absolute") return HeightOver::kSeaLevel;
    if (mode == "relativeToGround") return HeightOver::kGround;
    if (!mode.empty() && mode != "clampToGround")
      findings_.wrong(mark(element), "altitude mode '" + mode + "'",
                      "clampToGround, relativeToGround or absolute");
    return std::nullopt;
  }

  static Position position(const Corner& corner, std::optional<HeightOver> over) {
    Position made{corner.at, std::nullopt};
    if (over) made.height = Height{corner.height, *over};
    return made;
  }

  /// "longitude,latitude[,height]" between blanks.
  std::vector<Corner> coordinates(const Element& geometry) {
    bad_coordinates_ = false;
    const Element* element = child(geometry, "coordinates");
    std::vector<Corner> corners;
    if (element == nullptr) {
      findings_.wrong(mark(geometry), "no <coordinates>");
      bad_coordinates_ = true;
      return corners;
    }
    std::string_view rest = trimmed(element->text);
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find_first_of(kBlanks), rest.size());
      const auto corner = tuple(rest.substr(0, end), *element);
      rest = trimmed(rest.substr(end));
      if (corner && corners.size() < kMostParts) {
        corners.push_back(*corner);
        continue;
      }
      bad_coordinates_ = true;
      if (corner) {
        findings_.wrong(mark(*element), "more than " + std::to_string(kMostParts) + " points");
        break;
      }
    }
    return corners;
  }

  std::optional<Corner> tuple(std::string_view text, const Element& element) {
    std::array<double, 3> values{};
    std::size_t count = 0;
    const char* at = text.data();
    const char* const end = at + text.size();
    bool right = true;
    for (; right && count < 3; ++count) {
      const auto [after, error] = std::from_chars(at, end, values.at(count));
      right = error == std::errc{} && std::isfinite(values.at(count));
      at = after;
      if (!right || at == end || *at != ',') break;
      ++at;
    }
    if (!right || at != end || count == 0 || std::abs(values[2]) > 1e5) {
      findings_.wrong(mark(element), "'" + std::string(text.substr(0, 40)) + "'",
                      "longitude,latitude or longitude,latitude,height between blanks");
      return std::nullopt;
    }
    const Corner corner{{values[1], values[0]}, values[2]};
    return check(corner.at, mark(element), findings_) ? std::optional(corner) : std::nullopt;
  }

  Contents& contents_;
  Findings& findings_;
  std::vector<std::string> folders_;
  std::string feature_;
  bool bad_coordinates_ = false;
  bool full_ = false;
};

}  // namespace

void read_kml(std::string_view text, Contents& contents, Findings& findings) {
  const auto root = xml::parse(text, findings.file(), xml::Encoding::kDeclared, {64, 1'000'000});
  if (!root) return findings.errors().add(root.error());
  KmlReader(contents, findings).read(*root);
}

}  // namespace skein::mission_files
