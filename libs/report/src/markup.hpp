// SPDX-License-Identifier: Apache-2.0
// Writes HTML and SVG that is well-formed and escaped by construction.
#pragma once

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "text.hpp"

namespace skein::report {

/// A name and its value; numbers are written with two decimals at most.
struct Attribute {
  template <std::convertible_to<std::string_view> Text>
  Attribute(std::string_view n, const Text& v) : name(n), value(std::string_view(v)) {}
  Attribute(std::string_view n, double v) : name(n), value(short_number(v, 2)) {}
  Attribute(std::string_view n, int v) : name(n), value(std::to_string(v)) {}
  Attribute(std::string_view n, std::size_t v) : name(n), value(std::to_string(v)) {}

  std::string_view name;
  std::string value;
};

using Attributes = std::initializer_list<Attribute>;

/// A document under construction. Every open() has its close(); text and values are escaped.
class Markup {
 public:
  Markup& open(std::string_view element, Attributes attributes = {});
  Markup& close();
  /// An element without content: `<rect …/>`, `<br/>`.
  Markup& leaf(std::string_view element, Attributes attributes = {});
  /// An element with only text in it.
  Markup& element(std::string_view element, Attributes attributes, std::string_view text);
  Markup& text(std::string_view text);
  /// The tool tip of the open SVG element.
  Markup& title(std::string_view text) { return element("title", {}, text); }
  /// Inserts finished markup unescaped.
  Markup& raw(std::string_view piece);
  Markup& line_break();

  /// The document; every element must be closed.
  std::string take();

 private:
  void start(std::string_view element, Attributes attributes);

  std::string out_;
  std::vector<std::string> open_;
};

/// "M1 2L3 4…" from points with x and y.
template <class Points>
std::string path_data(const Points& points, int decimals = 1) {
  std::string data;
  for (const auto& p : points) {
    data += data.empty() ? 'M' : 'L';
    data += short_number(p.x, decimals);
    data += ' ';
    data += short_number(p.y, decimals);
  }
  return data;
}

}  // namespace skein::report
