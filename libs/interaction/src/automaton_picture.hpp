// SPDX-License-Identifier: Apache-2.0
// Draws one automaton as nested boxes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "skein/interaction/automaton.hpp"
#include "svg_canvas.hpp"

namespace skein::interaction {

class AutomatonPicture {
 public:
  /// `colours` of SCMs by their ids; both must outlive the picture.
  AutomatonPicture(const Automaton& automaton, const std::map<std::string, const char*>& colours);

  double width() const { return boxes_[0].width; }
  double height() const { return boxes_[0].height; }
  void draw(SvgCanvas& canvas, double x, double y);

  struct Box {
    double x = 0, y = 0, width = 0, height = 0;
  };
  /// Where a componel was drawn.
  const Box& box(ComponelIndex index) const { return boxes_[index]; }

 private:
  struct Line {
    std::string text;
    TextStyle style;
  };
  std::vector<Line> lines_of(ComponelIndex index) const;
  std::string title_of(const Componel& componel) const;
  void measure(ComponelIndex index);
  void place(ComponelIndex index, double x, double y, double width);
  void draw_block(SvgCanvas& canvas, ComponelIndex index) const;
  void draw_leaf(SvgCanvas& canvas, ComponelIndex index) const;

  const Automaton& automaton_;
  const std::map<std::string, const char*>& colours_;
  std::vector<Box> boxes_;
};

}  // namespace skein::interaction
