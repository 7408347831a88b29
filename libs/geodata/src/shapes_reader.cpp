// SPDX-License-Identifier: Apache-2.0
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <memory>

#include "gdal_session.hpp"
#include "skein/geodata/shapes.hpp"
#include "skein/geodesy/geodetic_frame.hpp"
#include "skein/world/polygon_rings.hpp"
#include "vector_file.hpp"

namespace skein::geodata {
namespace {

using world::Polygon;
using world::Vector2;

/// From the coordinates of a file to the local frame.
class ToLocal {
 public:
  /// Null: they are local ones already.
  ToLocal(const OGRSpatialReference* reference, const world::GeodeticOrigin& origin)
      : frame_(origin), local_(reference == nullptr) {
    if (local_) return;
    OGRSpatialReference own = *reference;
    own.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const OGRSpatialReference degrees = longitude_latitude();
    to_degrees_.reset(OGRCreateCoordinateTransformation(&own, &degrees));
  }
  bool is_usable() const { return local_ || to_degrees_ != nullptr; }

  std::optional<Vector2> operator()(double x, double y) const {
    if (local_) return Vector2(x, y);
    if (!to_degrees_->Transform(1, &x, &y) || !(std::abs(y) <= 90 && std::abs(x) <= 360))
      return std::nullopt;
    world::GeodeticPoint point;
    point.longitude_degrees = std::remainder(x, 360);
    point.latitude_degrees = y;
    point.altitude = frame_.origin().altitude;
    return Vector2(frame_.to_local(point).head<2>());
  }

 private:
  geodesy::GeodeticFrame frame_;
  bool local_;
  std::unique_ptr<OGRCoordinateTransformation> to_degrees_;
};

class ShapeCollector {
 public:
  ShapeCollector(const ToLocal& to_local, std::vector<Shape>& shapes)
      : to_local_(to_local), shapes_(shapes) {}

  /// The polygons of a geometry; false when a corner is nowhere on Earth.
  bool take(const OGRGeometry& geometry, const std::string& name) {
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (type == wkbPolygon) return take_polygon(*geometry.toPolygon(), name);
    if (type != wkbMultiPolygon && type != wkbGeometryCollection) return true;
    const OGRGeometryCollection& all = *geometry.toGeometryCollection();
    for (int i = 0; i < all.getNumGeometries(); ++i)
      if (!take(*all.getGeometryRef(i), name)) return false;
    return true;
  }

 private:
  bool take_polygon(const OGRPolygon& polygon, const std::string& name) {
    if (polygon.getExteriorRing() == nullptr || shapes_.size() > kMostShapes) return true;
    Shape shape{name, {}, {}};
    if (!take_ring(*polygon.getExteriorRing(), shape.outer)) return false;
    for (int i = 0; i < polygon.getNumInteriorRings(); ++i)
      if (!take_ring(*polygon.getInteriorRing(i), shape.holes.emplace_back())) return false;
    shapes_.push_back(std::move(shape));
    return true;
  }
  bool take_ring(const OGRLinearRing& ring, Polygon& out) const {
    for (int i = 0; i < ring.getNumPoints(); ++i) {
      const auto at = to_local_(ring.getX(i), ring.getY(i));
      if (!at) return false;
      out.push_back(*at);
    }
    out = world::without_closing_corner(std::move(out));
    return true;
  }

  const ToLocal& to_local_;
  std::vector<Shape>& shapes_;
};

std::string name_of(const OGRFeature& feature) {
  for (const char* field : {"name", "Name", "NAME", "id"})
    if (const int index = feature.GetFieldIndex(field); index >= 0)
      return feature.GetFieldAsString(index);
  return {};
}

constexpr const char* kNowhere = "a corner of it is nowhere on Earth";

Result<std::vector<Shape>, Diagnostics> read_dataset(const std::string& path, const char* driver,
                                                     const world::GeodeticOrigin& origin,
                                                     GdalSession& session) {
  const std::array<const char*, 2> drivers = {driver, nullptr};
  const std::unique_ptr<GDALDataset> dataset(
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers.data()));
  if (!dataset)
    return wrong_file(path, "it cannot be read as " + std::string(driver) + session.complaint(),
                      "a whole file of the format that its ending names");
  std::vector<Shape> shapes;
  for (OGRLayer* layer : dataset->GetLayers()) {
    const OGRSpatialReference degrees = longitude_latitude();
    const OGRSpatialReference* own = layer->GetSpatialRef();
    const ToLocal to_local(own != nullptr ? own : &degrees, origin);
    if (!to_local.is_usable())
      return wrong_file(path, "its coordinates are of no use" + session.complaint());
    ShapeCollector collector(to_local, shapes);
    for (const auto& feature : *layer)
      if (const OGRGeometry* geometry = feature->GetGeometryRef())
        if (!collector.take(*geometry, name_of(*feature))) return wrong_file(path, kNowhere);
  }
  if (const std::string complaint = session.complaint(); shapes.empty() && !complaint.empty())
    return wrong_file(path, "it cannot be read" + complaint);
  return shapes;
}

Result<std::vector<Shape>, Diagnostics> read_wkt(const std::string& path, const std::string& crs,
                                                 const world::GeodeticOrigin& origin,
                                                 GdalSession& session) {
  OGRSpatialReference given;
  if (!crs.empty() &&
      given.SetFromUserInput(
          crs.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) != OGRERR_NONE)
    return wrong_file(path,
                      "unknown coordinate reference system '" + crs + "'" + session.complaint(),
                      "EPSG:4326");
  const ToLocal to_local(crs.empty() ? nullptr : &given, origin);
  if (!to_local.is_usable()) return wrong_file(path, "its coordinates are of no use");
  std::ifstream in(path, std::ios::binary);
  std::vector<Shape> shapes;
  ShapeCollector collector(to_local, shapes);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    OGRGeometry* made = nullptr;
    const OGRErr error = OGRGeometryFactory::createFromWkt(line.c_str(), nullptr, &made);
    const std::unique_ptr<OGRGeometry> geometry(made);
    if (error != OGRERR_NONE || !geometry)
      return wrong_file(path, "line " + std::to_string(number) + " is no WKT" + session.complaint(),
                        "POLYGON ((0 0, 10 0, 10 10, 0 0)), one geometry a line");
    if (!collector.take(*geometry, {})) return wrong_file(path, kNowhere);
  }
  return shapes;
}

}  // namespace

Result<std::vector<Shape>, Diagnostics> read_shapes(const std::string& path,
                                                    const world::GeodeticOrigin& origin,
                                                    const std::string& crs) {
  const VectorFormat format = vector_format_of(path);
  if (format == VectorFormat::kUnknown)
    return wrong_file(path, "its format is not known by its name", kEndings);
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    return wrong_file(path, "there is no such file");
  if (format != VectorFormat::kWkt && !crs.empty())
    return wrong_file(path, "it says itself in which coordinates it is", "no crs");
  GdalSession session;
  register_vector_formats();
  auto shapes = format == VectorFormat::kWkt
                    ? read_wkt(path, crs, origin, session)
                    : read_dataset(path, driver_of(format), origin, session);
  if (!shapes) return shapes;
  if (shapes->empty()) return wrong_file(path, "there is no polygon in it");
  if (shapes->size() > kMostShapes)
    return wrong_file(path, "there are more than " + std::to_string(kMostShapes) + " polygons");
  return shapes;
}

}  // namespace skein::geodata
