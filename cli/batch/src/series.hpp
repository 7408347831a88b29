// SPDX-License-Identifier: Apache-2.0
// Statistics over runs that differ only in their seeds.
#pragma once

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

#include "row.hpp"

namespace skein::batch_tool {

struct Series {
  std::string scenario;
  Combination combination;
  std::size_t runs = 0, passed = 0, lawless = 0;
  struct Share {
    std::string name;
    std::size_t met = 0, judged = 0;
  };
  std::vector<Share> expectations;
  /// Figures of each measure, in the order of the seeds; of runs in which it could be measured.
  std::vector<std::pair<std::string, std::vector<double>>> measures;
  std::vector<Row> bad;  ///< runs that did not pass, or violated a law

  std::string label() const;  ///< "confirmed, radio.loss=0.1"
};

/// The series in the order of the rows; interrupted runs are ignored.
std::vector<Series> series_of(const std::vector<Row>& rows);

/// Tables for people; of runs that did not pass the first `examples`.
void print(std::ostream& out, const std::vector<Series>& all, std::size_t examples);

/// One JSON document with the same figures.
std::string summary_json(const std::vector<Series>& all);

/// An SVG document: each measure of all series (report::distributions_svg).
std::string summary_svg(const std::vector<Series>& all);

}  // namespace skein::batch_tool
