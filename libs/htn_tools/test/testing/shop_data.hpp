// SPDX-License-Identifier: Apache-2.0
// The shared problems with SHOP3's results (../shared/data/shop), read in place. The folder can be
// given by the environment variable SKEIN_SHARED_DATA (the folder that holds `shop`).
#pragma once

#include <filesystem>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skein/htn/definitions.hpp"
#include "skein/htn_tools/given_plan.hpp"

namespace skein::htn::shop_data {

/// A row of reference.csv.
struct Row {
  std::string domain;
  std::string problem;
  std::string which;  ///< "first", "all/opt=t", "first/opt=37"
  std::string steps;  ///< a number, "none" or "error"
  double cost = 0;    ///< of the first plan returned
  std::size_t plans = 0;
};

/// How GoogleTest prints a row.
void PrintTo(const Row& row, std::ostream* out);

std::filesystem::path folder();
/// Empty where the data is absent.
std::vector<Row> rows();

/// What the files of a row define; the domain meant is the first.
struct Loaded {
  TermStore store;
  Definitions definitions;
  Diagnostics errors;
  Diagnostics warnings;
  const ProblemDefinition* problem = nullptr;  ///< by its name, else by that of its file
};
std::unique_ptr<Loaded> load(const std::string& domain, const std::string& problem);

/// The archive of plans, unpacked for the life of the object.
class Archive {
 public:
  Archive();
  ~Archive();
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;
  /// The first plan SHOP3 returned; none if the archive has none.
  std::optional<GivenPlan> plan(const std::string& domain, const std::string& problem,
                                const std::string& which, TermStore& store) const;

 private:
  std::filesystem::path path_;
};

}  // namespace skein::htn::shop_data
