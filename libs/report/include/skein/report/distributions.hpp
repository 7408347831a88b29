// SPDX-License-Identifier: Apache-2.0
// How figures of many runs are spread: numbers, and a picture of them.
#pragma once

#include <string>
#include <vector>

namespace skein::report {

/// Of a list of figures. Quantiles are interpolated linearly between neighbours in rank (Hyndman
/// and Fan 1996, definition 7).
struct Spread {
  std::size_t count = 0;  ///< the others say nothing when it is 0
  double mean = 0;
  double deviation = 0;  ///< standard deviation of the sample (n - 1); 0 of one figure
  double minimum = 0, lower_quartile = 0, median = 0, upper_quartile = 0, p95 = 0, maximum = 0;
};

/// Precondition: all finite. Cost: a sort.
Spread spread_of(std::vector<double> values);

/// The figures of one series.
struct DistributionRow {
  std::string label;
  std::vector<double> values;
};

/// One figure, of several series over one axis.
struct DistributionPanel {
  std::string name, unit;
  std::vector<DistributionRow> rows;
};

/// An SVG document: for each panel an axis and for each of its rows a box from quartile to quartile
/// with the median, the mean as a rhombus, and every figure as a dot. The same input gives the same
/// bytes. Colours: Okabe and Ito 2008.
std::string distributions_svg(const std::string& title,
                              const std::vector<DistributionPanel>& panels);

}  // namespace skein::report
