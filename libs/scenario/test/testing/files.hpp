// SPDX-License-Identifier: Apache-2.0
// A folder that goes away with the test, and a small scenario to change pieces of.
#pragma once

#include <string>

#include "skein/scenario/scenario.hpp"
#include "temporary_folder.hpp"

namespace skein::scenario::testing {

class TemporaryFolder {
 public:
  /// Gives the path of the new file; makes folders on the way.
  std::string write(const std::string& name, const std::string& text) const;
  std::string path(const std::string& name) const;

 private:
  skein::testing::TemporaryFolder folder_;
};

/// A valid scenario with the UAVs heliv and marvin (models of the COMETS scenarios), zone Z and the
/// places base and aside, in which one piece of text is replaced by another; the piece must be
/// there. Lines are those of the text in files.cpp.
std::string scenario_with(const std::string& piece = "", const std::string& instead = "");

/// Likewise of one with planning on board: karma at degree 4 is sent mission 1 with the high-level
/// tasks 700 and 701 in step start; heliv at degree 3; no-fly volume tower, zone Z, place base.
std::string planning_scenario_with(const std::string& piece = "", const std::string& instead = "");

/// What reading it reports, one line each, without the file's name and folder; empty when it is
/// fine.
std::string errors_of(const std::string& text);

/// Reads text that must be valid.
Scenario read_valid(const std::string& text);

}  // namespace skein::scenario::testing
