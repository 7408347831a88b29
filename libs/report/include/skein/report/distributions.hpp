// SPDX-License-Identifier: Apache-2.0
// Distributions of figures over many runs: statistics, and a box plot.
#pragma once

#include <string>
#include <vector>

namespace skein::report {

/// Statistics of a sample. Quantiles are interpolated linearly between neighbours in rank (Hyndman
/// and Fan 1996, definition 7).
struct Spread {
  std::size_t count = 0;  ///< the other fields have no meaning when it is 0
  double mean = 0;
  double deviation = 0;  ///< standard deviation of the sample (n - 1); 0 for a single value
  double minimum = 0, lower_quartile = 0, median = 0, upper_quartile = 0, p95 = 0, maximum = 0;
};

/// Precondition: all finite. Cost: a sort.
Spread spread_of(std::vector<double> values);

/// The figures of one series.
struct DistributionRow {
  std::string label;
  std::vector<double> values;
};

/// One quantity of several series, over a common axis.
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
