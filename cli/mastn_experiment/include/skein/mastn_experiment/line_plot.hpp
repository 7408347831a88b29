// SPDX-License-Identifier: Apache-2.0
// Curves with spreads as a self-contained SVG picture, without a plotting program.
#pragma once

#include <string>
#include <vector>

namespace skein::temporal {

struct PlotPoint {
  double x = 0;
  double y = 0;
  double spread = 0;  ///< half the length of the error bar; 0: none
};

struct PlotSeries {
  std::string name;               ///< in the legend
  std::vector<PlotPoint> points;  ///< in the order of x
};

struct LinePlot {
  std::string title;
  std::string subtitle;  ///< what was measured and how, in a smaller type
  std::string x_label;
  std::string y_label;
  std::vector<double> x_ticks;     ///< empty: round numbers
  std::vector<PlotSeries> series;  ///< at most six are told apart by colour, mark and dash
};

/// Both axes are linear and start at 0. The legend lists the series in the order of their last
/// points, highest first, beside the curves. Not-finite points are left out. Texts are escaped.
std::string to_svg(const LinePlot& plot);

}  // namespace skein::temporal
