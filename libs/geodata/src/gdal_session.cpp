// SPDX-License-Identifier: Apache-2.0
#include "gdal_session.hpp"

#include <gdal.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>

#include <array>
#include <utility>

namespace skein::geodata {
namespace {

constexpr GIntBig kCacheBytes = 64 << 20;
constexpr std::size_t kLongestComplaint = 300;

/// Only files of these formats: others could name further files or servers.
bool register_formats() {
  GDALRegister_GTiff();
  GDALRegister_AAIGrid();
  GDALRegister_SRTMHGT();
  GDALSetCacheMax64(kCacheBytes);
  OSRSetPROJEnableNetwork(0);
  return true;
}

}  // namespace

GdalSession::GdalSession() {
  static const bool registered = register_formats();
  static_cast<void>(registered);
  CPLPushErrorHandlerEx(&GdalSession::keep, this);
}

GdalSession::~GdalSession() { CPLPopErrorHandler(); }

/// The first failure says the cause; what follows are its consequences.
void GdalSession::keep(CPLErr severity, CPLErrorNum, const char* message) {
  auto* session = static_cast<GdalSession*>(CPLGetErrorHandlerUserData());
  if (severity >= CE_Failure && session != nullptr && session->complaint_.empty())
    session->complaint_ = std::string(": ") + message;
}

std::string GdalSession::complaint() {
  std::string text = std::exchange(complaint_, {});
  if (text.size() > kLongestComplaint) text = text.substr(0, kLongestComplaint) + " …";
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

const char* const* gdal_drivers() {
  static constexpr std::array<const char*, 4> kDrivers = {"GTiff", "AAIGrid", "SRTMHGT", nullptr};
  return kDrivers.data();
}

}  // namespace skein::geodata
