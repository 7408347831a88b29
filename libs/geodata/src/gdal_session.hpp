// SPDX-License-Identifier: Apache-2.0
// GDAL as this library uses it: few formats, nothing printed, no network.
#pragma once

#include <cpl_error.h>

#include <string>

namespace skein::geodata {

/// While one lives, on its thread, what GDAL complains of is kept here instead of being printed.
/// The first registers the formats that are read (thread-safe).
class GdalSession {
 public:
  GdalSession();
  ~GdalSession();
  GdalSession(const GdalSession&) = delete;
  GdalSession& operator=(const GdalSession&) = delete;

  /// ": what GDAL said" since the last call, for the end of a message; empty when it said nothing.
  std::string complaint();

 private:
  static void keep(CPLErr severity, CPLErrorNum number, const char* message);

  std::string complaint_;
};

/// The formats that are read, by GDAL's names; ended by a null.
const char* const* gdal_drivers();

}  // namespace skein::geodata
