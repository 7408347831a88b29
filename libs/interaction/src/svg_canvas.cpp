// SPDX-License-Identifier: Apache-2.0
#include "svg_canvas.hpp"
#include "skein/foundation/markup.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace skein::interaction {

namespace {

constexpr double kCharacter = 0.56;  // mean width of a character by its size

std::string px(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", value);
  return text.data();
}

std::string attribute(const char* name, double value) {
  return std::string(" ") + name + "=\"" + px(value) + "\"";
}

}  // namespace

double SvgCanvas::width_of(std::string_view text, double size) {
  const auto characters = std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  });
  return kCharacter * size * static_cast<double>(characters);
}

void SvgCanvas::box(double x, double y, double width, double height, const BoxStyle& style) {
  body_ += "<rect" + attribute("x", x) + attribute("y", y) + attribute("width", width) +
           attribute("height", height) + attribute("rx", style.radius) + " fill=\"" + style.fill +
           "\" stroke=\"" + style.stroke + "\"" + attribute("stroke-width", style.width);
  if (*style.dash != '\0') body_ += std::string(" stroke-dasharray=\"") + style.dash + "\"";
  body_ += "/>\n";
}

void SvgCanvas::text(double x, double y, std::string_view text, const TextStyle& style) {
  body_ += "<text" + attribute("x", x) + attribute("y", y) + attribute("font-size", style.size) +
           " fill=\"" + style.colour + "\" text-anchor=\"" + style.anchor + "\"" +
           (style.bold ? " font-weight=\"bold\"" : "") + ">" + escaped_markup(text) + "</text>\n";
}

void SvgCanvas::arrow(const End& from, const End& to) {
  const auto at = [](double x, double y) { return px(x) + "," + px(y) + " "; };
  body_ += "<path d=\"M" + at(from.x, from.y) + "L" + at(from.edge, from.y) + "C" +
           at(from.edge + from.bend, from.y) + at(to.edge + to.bend, to.y) + at(to.edge, to.y) +
           "L" + at(to.x, to.y) +
           "\" fill=\"none\" stroke=\"#c2570c\" stroke-width=\"1.8\" marker-start=\"url(#head)\" "
           "marker-end=\"url(#head)\"/>\n";
}

std::string SvgCanvas::finish(double width, double height) const {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", width) +
         attribute("height", height) + " viewBox=\"0 0 " + px(width) + " " + px(height) +
         "\" font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\">\n"
         "<defs><marker id=\"head\" viewBox=\"0 0 8 8\" refX=\"7\" refY=\"4\" markerWidth=\"6\" "
         "markerHeight=\"6\" orient=\"auto-start-reverse\"><path d=\"M0,0 L8,4 L0,8 Z\" "
         "fill=\"#c2570c\"/></marker></defs>\n"
         "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n" +
         body_ + "</svg>\n";
}

}  // namespace skein::interaction
