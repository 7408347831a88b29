// SPDX-License-Identifier: Apache-2.0
// The picture around the map: title, scale, north, legend.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing.hpp"
#include "palette.hpp"

namespace skein::cartography {
namespace {

constexpr double kTitle = 17, kLine = 15, kLegendRow = 18;
constexpr double kBarWidth = 160, kBarHeight = 10;

constexpr const char* kDefinitions = R"svg(<defs>
<pattern id="closed" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
<rect width="7" height="7" fill="#b3202c" fill-opacity="0.10"/>
<path d="M0 0V7" stroke="#b3202c" stroke-width="1.6" stroke-opacity="0.55"/></pattern>
<clipPath id="frame"><rect width="{w}" height="{h}"/></clipPath>
</defs>
)svg";

/// 1, 2 or 5 times a power of ten, at most a quarter of the width.
double scale_length(double width) {
  const double power = std::pow(10, std::floor(std::log10(width / 4)));
  double length = power;
  for (const double factor : {2.0, 5.0})
    if (factor * power <= width / 4) length = factor * power;
  return length;
}

std::string scale_bar(const Scale& scale) {
  const double metres = scale_length(scale.frame().east - scale.frame().west);
  const double wide = scale.pixels(metres), x = 12, y = scale.height() - 14;
  const std::string words =
      metres >= 1000 ? fmt::format("{:g} km", metres / 1000) : fmt::format("{:g} m", metres);
  return fmt::format(
             R"(<path d="M{0} {1}v6h{2}v-6" fill="none" stroke="#ffffff" stroke-width="4" stroke-opacity="0.8"/>)"
             R"(<path d="M{0} {1}v6h{2}v-6" fill="none" stroke="#202020" stroke-width="1.4"/>)"
             "\n",
             px(x), px(y), px(wide)) +
         text({x + wide / 2, y}, words, {.anchor = "middle", .halo = true});
}

std::string north_arrow(double width) {
  return fmt::format(
             R"(<path d="M{0} 12l6 18l-6 -4l-6 4z" fill="#202020" stroke="#ffffff" stroke-width="1"/>)"
             "\n",
             px(width - 18)) +
         text({width - 18, 42}, "N", {.anchor = "middle", .bold = true, .halo = true});
}

std::string heat_bar(const HeatScale& heat, const Spot& at) {
  std::string out;
  constexpr int kSteps = 32;
  for (int i = 0; i < kSteps; ++i)
    out += fmt::format(R"(<rect x="{}" y="{}" width="{}" height="{}" fill="{}"/>)",
                       px(at.x + i * kBarWidth / kSteps), px(at.y), px(kBarWidth / kSteps + 0.3),
                       px(kBarHeight), hex(heat_tint((i + 0.5) / kSteps)));
  out += '\n';
  out += text({at.x - 6, at.y + 9}, fmt::format("{:g}", heat.low), {.anchor = "end"});
  out += text({at.x + kBarWidth + 6, at.y + 9}, fmt::format("{:g}", heat.high), {});
  return out + text({at.x + kBarWidth + 48, at.y + 9}, heat.title, {});
}

/// Between the margins of the picture.
double page_width(const Map::Drawing& drawing) { return std::max(drawing.scale.width(), 620.0); }

std::string legend_of(const Map::Drawing& drawing, double top) {
  std::string out;
  double y = top;
  for (const HeatScale& heat : drawing.heats) {
    out += heat_bar(heat, {50, y});
    y += kLegendRow;
  }
  double x = 0;
  for (const LegendLine& line : drawing.legend) {
    const double wide = 34 + width_of(line.words, 11);
    if (x > 0 && x + wide > page_width(drawing)) {
      x = 0;
      y += kLegendRow;
    }
    out += fmt::format(R"(<path d="M{} {}h18" stroke="{}" stroke-width="3.5"/>)", px(x), px(y + 5),
                       line.colour) +
           text({x + 23, y + 9}, line.words, {});
    x += wide;
  }
  return out;
}

double legend_height(const Map::Drawing& drawing) {
  double rows = static_cast<double>(drawing.heats.size());
  double x = 0;
  for (const LegendLine& line : drawing.legend) {
    const double wide = 34 + width_of(line.words, 11);
    if (x == 0) rows += 1;
    if (x > 0 && x + wide > page_width(drawing)) {
      x = 0;
      rows += 1;
    }
    x += wide;
  }
  return rows * kLegendRow;
}

/// Coordinates along the southern and the western border, those of the west inside the map.
std::string coordinates(const Scale& scale) {
  const Frame& frame = scale.frame();
  const auto lines = [](double low, double high) {
    std::vector<double> at;
    const double step = tick_step(high - low, 8);
    for (double k = std::ceil(low / step); k * step <= high; ++k) at.push_back(k * step + 0.0);
    return at;
  };
  const auto mark = [](const Spot& from, const char* way) {
    return fmt::format(R"(<path d="M{} {}{}" stroke="#606060" stroke-width="1"/>)"
                       "\n",
                       px(from.x), px(from.y), way);
  };
  std::string out;
  for (const double x : lines(frame.west, frame.east)) {
    const Spot at = scale(world::Vector2(x, frame.south));
    out += mark(at, "v5") +
           text({at.x, at.y + 14}, fmt::format("{:g}", x), {.size = 9, .anchor = "middle"});
  }
  for (const double y : lines(frame.south, frame.north)) {
    const Spot at = scale(world::Vector2(frame.west, y));
    if (at.y < 8 || at.y > scale.height() - 26) continue;  // beside the scale bar
    out += mark(at, "h-5") + text({3, at.y + 3}, fmt::format("{:g}", y), {.size = 9, .halo = true});
  }
  return out;
}

std::string words_of_ground(const Relief& relief) {
  if (is_level(relief)) return fmt::format("level ground at {:.0f} m", relief.low);
  return fmt::format("contour lines every {:g} m, ground from {:.0f} to {:.0f} m",
                     contour_interval(relief), relief.low, relief.high);
}

std::string group(double x, double y, const std::string& inside, const char* more = "") {
  return fmt::format("<g transform=\"translate({} {})\"{}>\n{}</g>\n", px(x), px(y), more, inside);
}

std::string map_part(const Map::Drawing& drawing) {
  const Scale& scale = drawing.scale;
  return "<g clip-path=\"url(#frame)\">\n" + drawing.layers + "</g>\n" +
         placed(drawing.labels, scale.width(), scale.height()) + scale_bar(scale) +
         north_arrow(scale.width()) +
         fmt::format(
             R"(<rect width="{}" height="{}" fill="none" stroke="#606060" stroke-width="1"/>)"
             "\n",
             px(scale.width()), px(scale.height())) +
         coordinates(scale);
}

std::string definitions(const Scale& scale) {
  std::string out = kDefinitions;
  out.replace(out.find("{w}"), 3, px(scale.width()));
  return out.replace(out.find("{h}"), 3, px(scale.height()));
}

}  // namespace

std::string Map::finish(const std::string& title, const std::vector<std::string>& lines) const {
  const Drawing& d = *drawing_;
  std::string body = text({kMargin, kMargin + kTitle}, title, {.size = kTitle, .bold = true});
  double y = kMargin + kTitle + 6;
  for (const std::string& line : lines) {
    if (line.empty()) continue;
    y += kLine;
    body += text({kMargin, y}, line, {.size = 12, .colour = "#505050"});
  }
  y += 12;
  body += group(kMargin, y, map_part(d));
  y += d.scale.height() + 26;
  for (const std::string& profile : d.profiles) {
    body += group(kMargin, y, profile);
    y += kProfileHeight + 12;
  }
  body += group(kMargin, y, legend_of(d, 4));
  y += legend_height(d);
  body += text({kMargin, y + 16}, words_of_ground(d.relief) + "; x east, y north, z up [m]",
               {.size = 10, .colour = "#707070"});
  const double width = page_width(d) + 2 * kMargin, height = y + 16 + kMargin;
  return fmt::format(
             R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 0 {0} {1}" font-family="DejaVu Sans, Helvetica, Arial, sans-serif">)"
             "\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
             px(width), px(height)) +
         definitions(d.scale) + body + "</svg>\n";
}

}  // namespace skein::cartography
