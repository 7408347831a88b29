// SPDX-License-Identifier: Apache-2.0
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include "gdal_session.hpp"
#include "skein/geodata/shapes.hpp"
#include "skein/geodesy/geodetic_frame.hpp"
#include "vector_file.hpp"

namespace skein::geodata {
namespace {

using world::Vector3;

/// A place in the coordinates that are written.
class Written {
 public:
  /// Null: local ones.
  explicit Written(const geodesy::GeodeticFrame* frame) : frame_(frame) {}
  OGRPoint operator()(const Vector3& at) const {
    if (frame_ == nullptr) return {at.x(), at.y(), at.z()};
    const world::GeodeticPoint point = frame_->to_geodetic(at);
    return {point.longitude_degrees, point.latitude_degrees, point.altitude};
  }

 private:
  const geodesy::GeodeticFrame* frame_;
};

std::unique_ptr<OGRGeometry> geometry_of(const Feature& feature, const Written& written) {
  const auto fill = [&](OGRLineString& line) {
    for (const Vector3& at : feature.points) {
      const OGRPoint point = written(at);
      line.addPoint(&point);
    }
  };
  if (feature.kind == Feature::Kind::kPoint)
    return std::make_unique<OGRPoint>(written(feature.points.front()));
  if (feature.kind == Feature::Kind::kLine) {
    auto line = std::make_unique<OGRLineString>();
    fill(*line);
    return line;
  }
  OGRLinearRing ring;
  fill(ring);
  ring.closeRings();
  auto polygon = std::make_unique<OGRPolygon>();
  polygon->addRing(&ring);
  return polygon;
}

tl::unexpected<Diagnostics> not_written(const std::string& path, GdalSession& session) {
  return wrong_file(path, "it cannot be written" + session.complaint());
}

Result<void, Diagnostics> write_wkt(const std::string& path, const std::vector<Feature>& features,
                                    GdalSession& session) {
  std::ofstream out(path, std::ios::binary);
  OGRWktOptions options;
  options.variant = wkbVariantIso;
  options.precision = 3;
  options.round = true;
  for (const Feature& feature : features)
    out << geometry_of(feature, Written(nullptr))->exportToWkt(options) << '\n';
  out.close();
  if (!out) return not_written(path, session);
  return {};
}

Result<void, Diagnostics> write_dataset(const std::string& path, const char* name,
                                        const std::vector<Feature>& features,
                                        const world::GeodeticOrigin& origin, GdalSession& session) {
  std::error_code error;
  std::filesystem::remove(path, error);  // neither format writes into what is there
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(name);
  const std::unique_ptr<GDALDataset> dataset(
      driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  if (!dataset) return not_written(path, session);
  OGRSpatialReference degrees = longitude_latitude();
  OGRLayer* layer = dataset->CreateLayer("skein", &degrees, wkbUnknown, nullptr);
  OGRFieldDefn field("name", OFTString);
  if (layer == nullptr || layer->CreateField(&field) != OGRERR_NONE)
    return not_written(path, session);
  const geodesy::GeodeticFrame frame(origin);
  for (const Feature& one : features) {
    OGRFeature feature(layer->GetLayerDefn());
    feature.SetField(0, one.name.c_str());
    feature.SetGeometryDirectly(geometry_of(one, Written(&frame)).release());
    if (layer->CreateFeature(&feature) != OGRERR_NONE) return not_written(path, session);
  }
  dataset->FlushCache();
  return {};
}

}  // namespace

Result<void, Diagnostics> write_features(const std::string& path,
                                         const std::vector<Feature>& features,
                                         const world::GeodeticOrigin& origin) {
  const VectorFormat format = vector_format_of(path);
  if (format == VectorFormat::kUnknown)
    return wrong_file(path, "its format is not known by its name", kEndings);
  GdalSession session;
  register_vector_formats();
  std::vector<Feature> whole;
  for (const Feature& feature : features)
    if (!feature.points.empty()) whole.push_back(feature);
  if (format == VectorFormat::kWkt) return write_wkt(path, whole, session);
  return write_dataset(path, driver_of(format), whole, origin, session);
}

}  // namespace skein::geodata
