// SPDX-License-Identifier: Apache-2.0
#include "show_diagnostics.hpp"

#include <nlohmann/json.hpp>
#include <ostream>

namespace skein::plan_tool {

namespace {

htn::Excerpt excerpt_of(const Diagnostic& diagnostic, const htn::Definitions& definitions) {
  for (const auto& document : definitions.documents) {
    if (document->file == diagnostic.file) return htn::excerpt(diagnostic, document->text);
  }
  return {};
}

// The word stands before the message, behind the place: to_text() would show its colours as text.
std::string to_text(const Diagnostic& diagnostic, const std::string& word) {
  Diagnostic place = diagnostic;
  place.message = place.expected = place.nearest = "";
  Diagnostic message = diagnostic;
  message.file = message.path = "";
  message.line = 0;
  return skein::to_text(place) + word + skein::to_text(message);
}

}  // namespace

void show(const Diagnostics& diagnostics, Severity severity, const htn::Definitions& definitions,
          const htn::TextStyle& style, std::ostream& err) {
  const bool error = severity == Severity::kError;
  const std::string_view colour = error ? style.bad : style.accent;
  const std::string word = style.mark(colour, error ? "error: " : "warning: ");
  std::string text;  // in one piece: standard error is not buffered
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    const htn::Excerpt excerpt = excerpt_of(diagnostic, definitions);
    text += to_text(diagnostic, word) + '\n';
    if (excerpt.line.empty()) continue;
    text += "  " + excerpt.line + "\n  " + style.mark(colour, excerpt.marks) + '\n';
  }
  err << text;
}

std::string to_json_line(const Diagnostics& errors) {
  nlohmann::ordered_json out;
  out["result"] = "error";
  out["why"] = errors.empty() ? "" : to_text(errors.all().front());
  out["errors"] = nlohmann::ordered_json::array();
  for (const Diagnostic& one : errors.all()) {
    nlohmann::ordered_json& made = out["errors"].emplace_back();
    if (!one.file.empty()) made["file"] = one.file;
    if (one.line > 0) made["line"] = one.line;
    if (one.column > 0) made["column"] = one.column;
    made["message"] = one.message;
    if (!one.expected.empty()) made["expected"] = one.expected;
    if (!one.nearest.empty()) made["nearest"] = one.nearest;
  }
  return out.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace skein::plan_tool
