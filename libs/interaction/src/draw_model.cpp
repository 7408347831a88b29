// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/draw_model.hpp"

#include <algorithm>
#include <array>
#include <deque>

#include "automaton_picture.hpp"
#include "skein/interaction/describe.hpp"

namespace skein::interaction {

namespace {

// In pixels.
constexpr double kMargin = 24;
constexpr double kColumnGap = 150;
constexpr double kLine = 17;
constexpr double kNote = 11;

constexpr std::array kColours{"#1b7f79", "#8e3b8a", "#b7791f", "#2f5fb3", "#a83a3a", "#4d7c0f"};
constexpr const char* kQuiet = "#52606d";

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& one : words) text += (text.empty() ? "" : ", ") + one;
  return text;
}

std::string parameters_text(const Parameters& parameters) {
  std::vector<std::string> words;
  for (const Parameter& one : parameters) {
    words.push_back(one.name + ": " + std::string(to_text(one.type)));
  }
  return joined(words);
}

/// One variant: its roles beside each other.
class VariantPicture {
 public:
  VariantPicture(const Library& library, const Variant& variant)
      : library_(library), variant_(variant) {
    const auto& scms = variant.table.scms;
    for (std::size_t i = 0; i < scms.size(); ++i) {
      colours_[scms[i].id] = kColours[i % kColours.size()];
    }
    for (const std::string& name : variant.roles) {
      automata_.push_back(automaton_in(library, variant, name));
      pictures_.emplace_back(automata_.back(), colours_);
    }
  }

  /// Draws from y on; the new y.
  double draw(SvgCanvas& canvas, const std::string& task, double y) {
    y = text(canvas, kMargin, y + 6, task + ", variant " + variant_.name,
             {17, "#1f2933", "start", true});
    y = text(canvas, kMargin, y, parameters_text(variant_.parameters), {kNote, kQuiet});
    double x = kMargin;
    double lowest = y;
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
      lowest = std::max(lowest, draw_role(canvas, i, x, y + 14));
      x += column_width(i) + kColumnGap;
    }
    width_ = std::max(width_, x - kColumnGap + 130);
    draw_correspondences(canvas);
    return draw_scms(canvas, lowest + 22) + kMargin;
  }
  double width() const { return width_; }

 private:
  double text(SvgCanvas& canvas, double x, double y, const std::string& words,
              const TextStyle& style) {
    y += style.size + 4;
    canvas.text(x, y, words, style);
    width_ = std::max(width_, x + SvgCanvas::width_of(words, style.size) + kMargin);
    return y;
  }

  std::string role_title(std::size_t i) const {
    return variant_.roles[i] + " × " + to_text(variant_.table.arities.at(variant_.roles[i]));
  }
  std::string needs_text(std::size_t i) const {
    std::vector<std::string> words;
    for (const Requirement& one : library_.roles.at(variant_.roles[i]).requirements) {
      words.push_back(describe(one));
    }
    return "needs " + (words.empty() ? "nothing" : joined(words));
  }
  std::string bindings_text(std::size_t i) const {
    std::vector<std::string> words;
    const auto found = variant_.table.parameters.find(variant_.roles[i]);
    if (found == variant_.table.parameters.end()) return "";
    for (const auto& [own, given] : found->second) words.push_back(own + " = " + given);
    return joined(words);
  }
  double column_width(std::size_t i) const {
    return std::max({pictures_[i].width(), SvgCanvas::width_of(role_title(i), 14),
                     SvgCanvas::width_of(needs_text(i), kNote),
                     SvgCanvas::width_of(bindings_text(i), kNote)});
  }

  double draw_role(SvgCanvas& canvas, std::size_t i, double x, double y) {
    y = text(canvas, x, y, role_title(i), {14, "#1f2933", "start", true});
    y = text(canvas, x, y, needs_text(i), {kNote, kQuiet});
    y = text(canvas, x, y, bindings_text(i), {kNote, kQuiet});
    pictures_[i].draw(canvas, x, y + 10);
    return y + 10 + pictures_[i].height();
  }

  // --- correspondences: both sides of one are one arrow
  // ---------------------------------------------

  void draw_correspondences(SvgCanvas& canvas) {
    std::vector<const Correspondence*> drawn;
    for (const Correspondence& one : variant_.table.correspondences) {
      const auto is_its_answer = [&](const Correspondence* other) {
        return other->role == one.target_role && other->action == one.target_action &&
               other->target_role == one.role && other->target_action == one.action;
      };
      if (std::any_of(drawn.begin(), drawn.end(), is_its_answer)) continue;
      drawn.push_back(&one);
      draw_correspondence(canvas, one);
    }
  }

  void draw_correspondence(SvgCanvas& canvas, const Correspondence& one) {
    std::size_t from = column_of(one.role);
    std::size_t to = column_of(one.target_role);
    const AutomatonPicture::Box* a = &box_of(from, one.action);
    const AutomatonPicture::Box* b = &box_of(to, one.target_action);
    if (from == to) return draw_within(canvas, *a, from, one);
    std::string left = who(one.role, number_asked(one.target_role, one.target_action, one.role));
    std::string right = who(one.target_role, one.number);
    if (from > to) {
      std::swap(a, b);
      std::swap(from, to);
      std::swap(left, right);
    }
    const double x1 = a->x + a->width, y1 = a->y + a->height / 2;
    const double x2 = b->x, y2 = b->y + b->height / 2;
    const double edge = pictures_[from].box(0).x + pictures_[from].width();
    const double other_edge = pictures_[to].box(0).x;
    canvas.arrow({x1, y1, edge, 80}, {x2, y2, other_edge, -80});
    const bool descends = y2 > y1;  // who takes part stands on the other side of the line
    canvas.text(edge + 8, y1 + (descends ? -6 : 14), left, {kNote, "#c2570c"});
    canvas.text(other_edge - 8, y2 + (descends ? 14 : -6), right, {kNote, "#c2570c", "end"});
  }

  // Among those who hold the same role: out at the right and back.
  void draw_within(SvgCanvas& canvas, const AutomatonPicture::Box& box, std::size_t column,
                   const Correspondence& one) {
    const double edge = pictures_[column].box(0).x + pictures_[column].width();
    const auto& other = box_of(column, one.target_action);
    const double y = box.y + box.height / 2 - 5;
    canvas.arrow({box.x + box.width, y, edge, 34},
                 {other.x + other.width, other.y + other.height / 2 + 5, edge, 34});
    canvas.text(edge + 32, y + 9, who(one.role, one.number), {kNote, "#c2570c"});
  }

  std::optional<int> number_asked(const std::string& role, const std::string& action,
                                  const std::string& of) const {
    for (const Correspondence& one : variant_.table.correspondences) {
      if (one.role == role && one.action == action && one.target_role == of) return one.number;
    }
    return std::nullopt;
  }
  static std::string who(const std::string& role, std::optional<int> number) {
    return (number ? std::to_string(*number) : std::string("all")) + " " + role;
  }
  std::size_t column_of(const std::string& role) const {
    return static_cast<std::size_t>(std::find(variant_.roles.begin(), variant_.roles.end(), role) -
                                    variant_.roles.begin());
  }
  const AutomatonPicture::Box& box_of(std::size_t column, const std::string& id) const {
    return pictures_[column].box(*automata_[column].find(id));
  }

  // --- SCMs
  // ------------------------------------------------------------------------------------------

  double draw_scms(SvgCanvas& canvas, double y) {
    for (const ScmInstance& one : variant_.table.scms) {
      const double width = SvgCanvas::width_of(one.id, kNote) + 14;
      canvas.box(kMargin, y, width, 16, {colours_.at(one.id), "none", 0, 8, ""});
      canvas.text(kMargin + width / 2, y + 12, one.id, {kNote, "white", "middle", true});
      const std::string words = one.scm + ": " + joined(describe(library_.scms.at(one.scm), one));
      text(canvas, kMargin + std::max(width, 70.0) + 10, y - 3, words, {kNote});
      y += kLine + 4;
    }
    return y;
  }

  const Library& library_;
  const Variant& variant_;
  std::map<std::string, const char*> colours_;
  std::deque<Automaton> automata_;  // their pictures refer to them
  std::vector<AutomatonPicture> pictures_;
  double width_ = 0;
};

}  // namespace

std::string draw_svg(const Automaton& automaton, const std::string& title) {
  const std::map<std::string, const char*> none;
  AutomatonPicture picture(automaton, none);
  SvgCanvas canvas;
  canvas.text(kMargin, kMargin + 10, title, {16, "#1f2933", "start", true});
  picture.draw(canvas, kMargin, kMargin + 28);
  const double width = std::max(picture.width(), SvgCanvas::width_of(title, 16));
  return canvas.finish(width + 2 * kMargin, picture.height() + 2 * kMargin + 28);
}

std::string draw_svg(const Library& library) {
  SvgCanvas canvas;
  double y = kMargin / 2;
  double width = 0;
  for (const auto& [task, model] : library.models) {
    for (const Variant& variant : model.variants) {
      VariantPicture picture(library, variant);
      y = picture.draw(canvas, task, y);
      width = std::max(width, picture.width());
    }
  }
  if (library.models.empty()) {
    const std::map<std::string, const char*> none;
    for (const auto& [name, role] : library.roles) {
      AutomatonPicture picture(role.automaton, none);
      canvas.text(kMargin, y + 18, name, {16, "#1f2933", "start", true});
      picture.draw(canvas, kMargin, y + 32);
      y += picture.height() + 32 + kMargin;
      width = std::max(width, picture.width() + 2 * kMargin);
    }
  }
  return canvas.finish(width, y + kMargin / 2);
}

}  // namespace skein::interaction
