// SPDX-License-Identifier: Apache-2.0
// Messages counted, and written for people.
#include "skein/temporal/message.hpp"

#include <algorithm>
#include <string>

#include "skein/foundation/overloaded.hpp"

namespace skein::temporal {
namespace {

std::string bound_text(Bound bound) { return bound == Bound::kLower ? "LB" : "UB"; }

std::string ticks_text(Ticks value) {
  if (value == kInfinite) return "+inf";
  if (value == kMinusInfinite) return "-inf";
  return std::to_string(value);
}

std::string text_of(const ArcUpdates& m) {
  std::string text = "UPDATE(";
  for (const ArcUpdate& a : m.arcs) {
    if (&a != &m.arcs.front()) text += "; ";
    text +=
        "arc " + std::to_string(a.arc) + " [" + ticks_text(a.min) + ", " + ticks_text(a.max) + "]";
  }
  return text + ")";
}

std::string text_of(const NodeUpdates& m) {
  std::string text = "UPDATE(";
  for (const BoundChange& b : m.bounds) {
    if (&b != &m.bounds.front()) text += "; ";
    text += std::to_string(b.node) + ", " + bound_text(b.bound) + " " + ticks_text(b.value);
  }
  return text + ")";
}

std::string text_of(const Update& m) {
  std::string text = "UPDATE(" + std::to_string(m.node) + ", " + bound_text(m.bound) + " " +
                     (m.anchored ? "" : "floating ") + ticks_text(m.value) + ", trail";
  for (const NodeIndex node : m.trail) text += " " + std::to_string(node);
  return text + ")";
}

template <class RelaxOrRelaxed>
std::string job_text(const char* name, const RelaxOrRelaxed& m) {
  return name + ("(" + std::to_string(m.node)) + ", " + bound_text(m.bound) + ", job " +
         std::to_string(m.job) + ")";
}

std::string text_of(const MacroUpdates& m) {
  std::string text = "MACRO(";
  for (const MacroConstraint& c : m.constraints) {
    text +=
        std::to_string(c.from) + "->" + std::to_string(c.to) + " >= " + ticks_text(c.min) + "; ";
  }
  return text + (m.consistent ? "consistent)" : "inconsistent)");
}

}  // namespace

bool is_data(const Content& content) {
  return !std::holds_alternative<Consistency>(content) && !std::holds_alternative<Hello>(content);
}

std::size_t unit_count(const Content& content) {
  return std::visit(
      Overloaded{
          [](const ArcUpdates& m) { return m.arcs.size(); },
          [](const NodeUpdates& m) { return m.bounds.size(); },
          [](const MacroUpdates& m) { return std::max<std::size_t>(1, m.constraints.size()); },
          [](const auto&) -> std::size_t { return 1; },
      },
      content);
}

std::string to_text(const Content& content) {
  return std::visit(Overloaded{
                        [](const Relax& m) { return job_text("RELAX", m); },
                        [](const Relaxed& m) { return job_text("RELAXED", m); },
                        [](const Consistency& m) {
                          return std::string("CONSISTENCY(") + (m.consistent ? "true" : "false") +
                                 ", " + std::to_string(m.last_id) + ")";
                        },
                        [](const Hello&) { return std::string("HELLO"); },
                        [](const auto& m) { return text_of(m); },
                    },
                    content);
}

}  // namespace skein::temporal
