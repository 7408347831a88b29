// SPDX-License-Identifier: Apache-2.0
#include "automaton_picture.hpp"

#include <algorithm>

#include "skein/interaction/describe.hpp"

namespace skein::interaction {

namespace {

// In pixels.
constexpr double kPadding = 10;
constexpr double kGap = 7;
constexpr double kTitle = 12;
constexpr double kSmall = 10.5;
constexpr double kLine = 15;
constexpr double kLeaf = 24;
constexpr double kChip = 15;

constexpr const char* kPre = "#0b6e4f";
constexpr const char* kExit = "#b3261e";
constexpr const char* kLocal = "#5b4b8a";
constexpr const char* kUnknownScm = "#7b8794";

std::string parameters_text(const config::Value& value) {
  std::string text;
  for (const config::Entry& one : value.entries) {
    const bool plain = one.value.kind == config::Value::Kind::kScalar;
    text += (text.empty() ? "" : ", ") + one.key + ": " + (plain ? one.value.scalar : "…");
  }
  return text;
}

double chips_width(const Block& block) {
  double width = 0;
  for (const std::string& scm : block.scms) width += SvgCanvas::width_of(scm, kSmall) + 16;
  return width;
}

}  // namespace

AutomatonPicture::AutomatonPicture(const Automaton& automaton,
                                   const std::map<std::string, const char*>& colours)
    : automaton_(automaton), colours_(colours), boxes_(automaton.size()) {
  measure(0);
}

std::string AutomatonPicture::title_of(const Componel& componel) const {
  if (const Task* task = componel.task()) {
    return componel.id + "  " + task->type + "(" + parameters_text(task->parameters) + ")";
  }
  if (const CoordinationAction* action = componel.action()) {
    return componel.id + "  ⇄ " + action->modality;
  }
  const Block& block = *componel.block();
  const std::string kind = block.type == BlockType::kLoop ? "  ↻ loop" : "  plan";
  const bool ends_more = block.end == EndMode::kImmediate && &componel != &automaton_[0];
  return componel.id + kind + (ends_more ? ", ends what is around it" : "");
}

std::vector<AutomatonPicture::Line> AutomatonPicture::lines_of(ComponelIndex index) const {
  const Block& block = *automaton_[index].block();
  std::vector<Line> lines;
  const auto add = [&](const std::string& first, const std::vector<std::string>& all,
                       const char* colour) {
    for (const std::string& one : all) {
      lines.push_back({(&one == &all.front() ? first : "   ") + one, {kSmall, colour}});
    }
  };
  add("▶ when ", describe(block.precondition, automaton_), kPre);
  add("■ until ", describe(block.exit, automaton_), kExit);
  for (const LocalParameter& one : block.locals) {
    lines.push_back({one.name + " := " + one.initialiser, {kSmall, kLocal}});
  }
  return lines;
}

void AutomatonPicture::measure(ComponelIndex index) {
  Box& box = boxes_[index];
  const Componel& componel = automaton_[index];
  box.width = SvgCanvas::width_of(title_of(componel), kTitle) + 2 * kPadding;
  box.height = kLeaf;
  const Block* block = componel.block();
  if (block == nullptr) return;
  box.width += chips_width(*block) + 10;
  box.height = kPadding + kLine;
  for (const Line& line : lines_of(index)) {
    box.width = std::max(box.width, SvgCanvas::width_of(line.text, kSmall) + 2 * kPadding);
    box.height += kLine;
  }
  for (const ComponelIndex below : block->content) {
    measure(below);
    box.width = std::max(box.width, boxes_[below].width + 2 * kPadding);
    box.height += kGap + boxes_[below].height;
  }
  box.height += kPadding;
}

// Blocks are as wide as what is around them, so that their borders stand in line.
void AutomatonPicture::place(ComponelIndex index, double x, double y, double width) {
  Box& box = boxes_[index];
  box.x = x;
  box.y = y;
  const Block* block = automaton_[index].block();
  if (block == nullptr) return;
  box.width = width;
  double at = y + kPadding + kLine + kLine * static_cast<double>(lines_of(index).size());
  for (const ComponelIndex below : block->content) {
    at += kGap;
    place(below, x + kPadding, at, width - 2 * kPadding);
    at += boxes_[below].height;
  }
}

void AutomatonPicture::draw(SvgCanvas& canvas, double x, double y) {
  place(0, x, y, boxes_[0].width);
  for (ComponelIndex i = 0; i < automaton_.size(); ++i) {
    if (automaton_[i].block() != nullptr) {
      draw_block(canvas, i);
    } else {
      draw_leaf(canvas, i);
    }
  }
}

void AutomatonPicture::draw_block(SvgCanvas& canvas, ComponelIndex index) const {
  const Box& box = boxes_[index];
  const Block& block = *automaton_[index].block();
  std::size_t depth = 0;
  for (ComponelIndex up = index; up != 0; up = automaton_[up].parent) ++depth;
  const bool loop = block.type == BlockType::kLoop;
  canvas.box(box.x, box.y, box.width, box.height,
             {depth % 2 == 0 ? "#f5f7fa" : "#ffffff", loop ? "#1c64a8" : "#52606d",
              loop ? 2.0 : 1.0, 5, ""});
  double y = box.y + kPadding + kTitle - 2;
  canvas.text(box.x + kPadding, y, title_of(automaton_[index]), {kTitle, "#1f2933", "start", true});
  double right = box.x + box.width - kPadding;
  for (auto scm = block.scms.rbegin(); scm != block.scms.rend(); ++scm) {
    const double width = SvgCanvas::width_of(*scm, kSmall) + 12;
    const auto colour = colours_.find(*scm);
    canvas.box(right - width, y - 11, width, kChip,
               {colour == colours_.end() ? kUnknownScm : colour->second, "none", 0, 7, ""});
    canvas.text(right - width / 2, y, *scm, {kSmall, "white", "middle", true});
    right -= width + 4;
  }
  for (const Line& line : lines_of(index)) {
    y += kLine;
    canvas.text(box.x + kPadding, y, line.text, line.style);
  }
}

void AutomatonPicture::draw_leaf(SvgCanvas& canvas, ComponelIndex index) const {
  const Box& box = boxes_[index];
  const bool task = automaton_[index].task() != nullptr;
  canvas.box(
      box.x, box.y, box.width, box.height,
      {task ? "#e3f0fb" : "#fdebd8", task ? "#7fb2e0" : "#c2570c", 1, task ? 4.0 : 12.0, ""});
  canvas.text(box.x + kPadding, box.y + 16, title_of(automaton_[index]), {kTitle});
}

}  // namespace skein::interaction
