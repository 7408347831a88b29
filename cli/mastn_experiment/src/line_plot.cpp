// SPDX-License-Identifier: Apache-2.0
#include "skein/mastn_experiment/line_plot.hpp"
#include "skein/foundation/markup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numeric>

namespace skein::temporal {

namespace {

// The page and the area of the curves [px].
constexpr double kWidth = 760;
constexpr double kHeight = 460;
constexpr double kLeft = 70;
constexpr double kRight = 560;
constexpr double kTop = 70;
constexpr double kBottom = 396;
constexpr double kLegend = 584;

// The palette of Okabe and Ito, which the colour-blind can tell apart.
struct Look {
  const char* colour;
  const char* dash;
};
constexpr std::array<Look, 6> kLooks = {{{"#D55E00", ""},
                                         {"#0072B2", ""},
                                         {"#009E73", ""},
                                         {"#CC79A7", "7 3"},
                                         {"#000000", "2 3"},
                                         {"#E69F00", "9 3 2 3"}}};

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value);
  std::string trimmed = text.data();
  trimmed.erase(trimmed.find_last_not_of('0') + 1);
  if (trimmed.back() == '.') trimmed.pop_back();
  return trimmed == "-0" ? "0" : trimmed;
}

bool is_drawable(const PlotPoint& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.spread);
}

// The least of 1, 2 and 5 times a power of ten that cuts `range` into at most six.
double round_step(double range) {
  const double least = range / 6;
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10 * power;
}

/// From 0 to `end`, drawn between two places on the page.
struct Axis {
  double end;
  double first;  // [px]
  double last;   // [px]
  std::vector<double> ticks;

  double place(double value) const { return first + (last - first) * value / end; }
};

Axis make_axis(double greatest, double first, double last, std::vector<double> ticks) {
  if (greatest <= 0) greatest = 1;
  if (!ticks.empty()) return {std::max(greatest, ticks.back()) * 1.04, first, last, ticks};
  const double step = round_step(greatest);
  const double steps = std::ceil(greatest / step - 1e-9);
  for (int tick = 0; tick <= static_cast<int>(steps); ++tick) ticks.push_back(tick * step);
  return {steps * step, first, last, std::move(ticks)};
}

class Picture {
 public:
  explicit Picture(const LinePlot& plot) : plot_(plot) {
    double greatest_x = 0;
    double greatest_y = 0;
    for (const PlotSeries& series : plot.series) {
      for (const PlotPoint& point : series.points) {
        if (!is_drawable(point)) continue;
        greatest_x = std::max(greatest_x, point.x);
        greatest_y = std::max(greatest_y, point.y + point.spread);
      }
    }
    x_ = make_axis(greatest_x, kLeft, kRight, plot.x_ticks);
    y_ = make_axis(greatest_y, kBottom, kTop, {});
  }

  std::string draw() {
    out_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(kWidth) + "\" height=\"" +
           number(kHeight) + "\" viewBox=\"0 0 " + number(kWidth) + " " + number(kHeight) +
           "\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"13\">\n"
           "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    text(kLeft, 28, plot_.title, "font-size=\"16\" font-weight=\"bold\"");
    text(kLeft, 48, plot_.subtitle, "font-size=\"12\" fill=\"#555555\"");
    draw_axes();
    for (std::size_t series = 0; series < plot_.series.size(); ++series) draw_series(series);
    draw_legend();
    return out_ + "</svg>\n";
  }

 private:
  void text(double x, double y, const std::string& what, const std::string& attributes) {
    out_ += "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" " + attributes + ">" +
            escaped_markup(what) + "</text>\n";
  }

  void line(double x1, double y1, double x2, double y2, const std::string& attributes) {
    out_ += "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) +
            "\" y2=\"" + number(y2) + "\" " + attributes + "/>\n";
  }

  void draw_axes() {
    for (const double tick : y_.ticks) {
      const double y = y_.place(tick);
      if (tick > 0) line(kLeft, y, kRight, y, "stroke=\"#dddddd\"");
      text(kLeft - 8, y + 4.5, number(tick), "text-anchor=\"end\"");
    }
    for (const double tick : x_.ticks) {
      const double x = x_.place(tick);
      line(x, kBottom, x, kBottom + 5, "stroke=\"#000000\"");
      text(x, kBottom + 20, number(tick), "text-anchor=\"middle\"");
    }
    line(kLeft, kBottom, kRight, kBottom, "stroke=\"#000000\"");
    line(kLeft, kTop, kLeft, kBottom, "stroke=\"#000000\"");
    text((kLeft + kRight) / 2, kBottom + 44, plot_.x_label, "text-anchor=\"middle\"");
    const double middle = (kTop + kBottom) / 2;
    text(22, middle, plot_.y_label,
         "text-anchor=\"middle\" transform=\"rotate(-90 22 " + number(middle) + ")\"");
  }

  static std::string stroke(std::size_t series) {
    const Look& look = kLooks[series % kLooks.size()];
    const std::string dash = look.dash;
    return std::string("stroke=\"") + look.colour + "\" stroke-width=\"2\" fill=\"none\"" +
           (dash.empty() ? "" : " stroke-dasharray=\"" + dash + "\"");
  }

  void draw_series(std::size_t index) {
    std::string path;
    std::string marks;
    std::swap(out_, marks);
    for (const PlotPoint& point : plot_.series[index].points) {
      if (!is_drawable(point)) continue;
      const double x = x_.place(point.x);
      path += (path.empty() ? "" : " ") + number(x) + "," + number(y_.place(point.y));
      if (point.spread > 0) draw_spread(index, point);
      draw_mark(index, x, y_.place(point.y));
    }
    std::swap(out_, marks);
    out_ += "<polyline points=\"" + path + "\" " + stroke(index) + "/>\n" + marks;
  }

  void draw_spread(std::size_t series, const PlotPoint& point) {
    const double x = x_.place(point.x);
    const double high = y_.place(point.y + point.spread);
    const double low = y_.place(std::max(0.0, point.y - point.spread));
    const std::string thin =
        std::string("stroke=\"") + kLooks[series % kLooks.size()].colour + "\" opacity=\"0.6\"";
    line(x, low, x, high, thin);
    line(x - 4, low, x + 4, low, thin);
    line(x - 4, high, x + 4, high, thin);
  }

  // A different shape for each of the first four series.
  void draw_mark(std::size_t series, double x, double y) {
    const std::string fill =
        std::string(" fill=\"") + kLooks[series % kLooks.size()].colour + "\"/>\n";
    const std::string ring = " stroke=\"" + std::string(kLooks.front().colour) +
                             "\" stroke-width=\"2\" fill=\"#ffffff\"/>\n";
    const std::string px = number(x);
    const std::string py = number(y);
    switch (series % 4) {
      case 0:  // the first is a ring, so that another mark on the same place shows inside
        out_ += "<circle cx=\"" + px + "\" cy=\"" + py + "\" r=\"" + (series == 0 ? "7" : "3.5") +
                "\"" + (series == 0 ? ring : fill);
        break;
      case 1:
        out_ += "<rect x=\"" + number(x - 4) + "\" y=\"" + number(y - 4) +
                "\" width=\"8\" height=\"8\"" + fill;
        break;
      case 2:
        polygon({{x, y - 5.5}, {x + 5, y + 4}, {x - 5, y + 4}}, fill);
        break;
      default:
        polygon({{x, y - 5.5}, {x + 5.5, y}, {x, y + 5.5}, {x - 5.5, y}}, fill);
    }
  }

  void polygon(const std::vector<std::pair<double, double>>& corners, const std::string& fill) {
    out_ += "<polygon points=\"";
    for (const auto& [x, y] : corners) out_ += number(x) + "," + number(y) + " ";
    out_ += "\"" + fill;
  }

  double last_value(std::size_t series) const {
    const auto& points = plot_.series[series].points;
    const auto last = std::find_if(points.rbegin(), points.rend(), is_drawable);
    return last == points.rend() ? 0 : last->y;
  }

  void draw_legend() {
    std::vector<std::size_t> order(plot_.series.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
      return last_value(a) > last_value(b);
    });
    double y = kTop + 12;
    for (const std::size_t series : order) {
      out_ += "<polyline points=\"" + number(kLegend) + "," + number(y) + " " +
              number(kLegend + 34) + "," + number(y) + "\" " + stroke(series) + "/>\n";
      draw_mark(series, kLegend + 17, y);
      text(kLegend + 42, y + 4.5, plot_.series[series].name, "fill=\"#000000\"");
      y += 24;
    }
  }

  const LinePlot& plot_;
  Axis x_{};
  Axis y_{};
  std::string out_;
};

}  // namespace

std::string to_svg(const LinePlot& plot) { return Picture(plot).draw(); }

}  // namespace skein::temporal
