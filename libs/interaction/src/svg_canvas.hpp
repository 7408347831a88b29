// SPDX-License-Identifier: Apache-2.0
// Boxes, lines and words of a picture.
#pragma once

#include <string>
#include <string_view>

namespace skein::interaction {

struct TextStyle {
  double size = 12;  ///< [px]
  const char* colour = "#1f2933";
  const char* anchor = "start";
  bool bold = false;
};

struct BoxStyle {
  const char* fill = "white";
  const char* stroke = "#52606d";
  double width = 1;
  double radius = 4;
  const char* dash = "";
};

/// Collects elements; all lengths in pixels, y downwards.
class SvgCanvas {
 public:
  /// How wide a text will be, about.
  static double width_of(std::string_view text, double size);

  void box(double x, double y, double width, double height, const BoxStyle& style);
  void text(double x, double y, std::string_view text, const TextStyle& style = {});
  struct End {
    double x = 0, y = 0;
    double edge = 0;  ///< up to here, in x, it runs level
    double bend = 0;  ///< and this far beyond, more or less
  };
  /// A line with a head at each end.
  void arrow(const End& from, const End& to);
  /// The whole picture.
  std::string finish(double width, double height) const;

 private:
  std::string body_;
};

}  // namespace skein::interaction
