// SPDX-License-Identifier: Apache-2.0
#include "skein/config/parse.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>

namespace skein::config {

namespace {

constexpr std::size_t kMaximumBytes = std::size_t{16} << 20;
constexpr int kMaximumDepth = 64;
constexpr int kMaximumValues = 1'000'000;

// Copies a yaml-cpp tree into ours; aliases are expanded, so the number of values is counted.
class Converter {
 public:
  explicit Converter(const std::string& file) : file_(file) {}

  Value convert(const YAML::Node& node, const std::string& path, int depth) {
    Value value;
    const YAML::Mark mark = node.Mark();
    value.line = mark.line + 1;
    value.column = mark.column + 1;
    if (++values_ > kMaximumValues || depth > kMaximumDepth) {
      if (!too_much_) report(value, path, "the document is nested too deeply or too large");
      too_much_ = true;
      return value;
    }
    if (node.IsScalar()) return scalar(node, std::move(value));
    if (node.IsSequence()) return sequence(node, std::move(value), path, depth);
    if (node.IsMap()) return map(node, std::move(value), path, depth);
    return value;
  }

  Diagnostics diagnostics;

 private:
  static Value scalar(const YAML::Node& node, Value value) {
    value.kind = Value::Kind::kScalar;
    value.scalar = node.Scalar();
    value.quoted = node.Tag() == "!";
    return value;
  }

  Value sequence(const YAML::Node& node, Value value, const std::string& path, int depth) {
    value.kind = Value::Kind::kSequence;
    for (std::size_t i = 0; i < node.size() && !too_much_; ++i) {
      value.items.push_back(convert(node[i], path + "[" + std::to_string(i) + "]", depth + 1));
    }
    return value;
  }

  Value map(const YAML::Node& node, Value value, const std::string& path, int depth) {
    value.kind = Value::Kind::kMap;
    std::set<std::string> seen;
    for (const auto& entry : node) {
      if (too_much_) break;
      Value at;
      at.line = entry.first.Mark().line + 1;
      at.column = entry.first.Mark().column + 1;
      if (!entry.first.IsScalar()) {
        report(at, path, "a key that is not a plain name");
        continue;
      }
      const std::string key = entry.first.Scalar();
      const std::string below = path.empty() ? key : path + "." + key;
      if (!seen.insert(key).second) report(at, below, "key '" + key + "' given twice");
      value.entries.push_back({key, convert(entry.second, below, depth + 1)});
    }
    return value;
  }

  void report(const Value& at, const std::string& path, std::string message) {
    diagnostics.add({file_, at.line, at.column, path, std::move(message), "", ""});
  }

  const std::string& file_;
  int values_ = 0;
  bool too_much_ = false;
};

tl::unexpected<Diagnostics> one_error(const std::string& file, int line, int column,
                                      std::string message, std::string expected = "") {
  Diagnostics diagnostics;
  diagnostics.add({file, line, column, "", std::move(message), std::move(expected), ""});
  return tl::unexpected<Diagnostics>(std::move(diagnostics));
}

/// What the parser's words for a file that does not hang together come to; empty: nothing better.
std::string wanted(const std::string& words) {
  if (words == "end of map not found" || words == "end of sequence not found")
    return "this line to begin as far to the right as those of its kind above it, with spaces (no "
           "tabs)";
  if (words == "illegal tab when looking for indentation") return "spaces";
  if (words == "illegal map value") return "quotes around a text with ': ' in it";
  return "";
}

/// Takes note of where the last document began, and the last text in quotes.
class Notes final : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& at) override { mark = at; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark& at, const std::string& tag, YAML::anchor_t,
                const std::string&) override {
    if (tag == "!") quoted = at;
  }
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}

  YAML::Mark mark;
  std::optional<YAML::Mark> quoted;
};

/// Whether the text in quotes that begins at this position has an end. yaml-cpp (0.7) takes the end
/// of the file for one, and all that was to follow for text.
bool is_closed(const std::string& text, std::size_t begin) {
  const char quote = begin < text.size() ? text[begin] : ' ';
  if (quote != '\'' && quote != '"') return true;  // not where the mark says
  for (std::size_t i = begin + 1; i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (text[i] == quote) {
      if (quote == '"' || i + 1 == text.size() || text[i + 1] != quote) return true;
      ++i;  // two of them are one within the text
    }
  }
  return false;
}

/// A second document, or anything else after the first; quotes without end. Not by YAML::LoadAll,
/// which (in 0.7) never comes back from what follows a closed map or list: {a: 1}}.
std::optional<Diagnostics> misread(const std::string& text, const std::string& file) {
  std::istringstream in(text);
  YAML::Parser parser(in);
  Notes notes;
  if (!parser.HandleNextDocument(notes)) return std::nullopt;
  if (notes.quoted && !is_closed(text, static_cast<std::size_t>(notes.quoted->pos))) {
    return one_error(file, notes.quoted->line + 1, notes.quoted->column + 1,
                     "a quote that nothing closes")
        .value();
  }
  if (!parser.HandleNextDocument(notes)) return std::nullopt;
  return one_error(file, notes.mark.line + 1, 1, "a second document; expected one").value();
}

}  // namespace

Result<Value, Diagnostics> parse_yaml(std::string_view text, const std::string& file) {
  if (text.size() > kMaximumBytes) return one_error(file, 0, 0, "larger than 16 MiB");
  try {
    const std::string whole(text);
    if (auto problems = misread(whole, file))
      return tl::unexpected<Diagnostics>(std::move(*problems));
    const YAML::Node document = YAML::Load(whole);
    if (!document.IsDefined() || document.IsNull()) {
      return one_error(file, 1, 1, "the file is empty");
    }
    Converter converter(file);
    Value value = converter.convert(document, "", 0);
    if (!converter.diagnostics.empty()) {
      return tl::unexpected<Diagnostics>(std::move(converter.diagnostics));
    }
    return value;
  } catch (const YAML::Exception& e) {
    return one_error(file, e.mark.line + 1, e.mark.column + 1, "not YAML: " + e.msg, wanted(e.msg));
  } catch (const std::exception& e) {
    return one_error(file, 0, 0, std::string("not YAML: ") + e.what());
  }
}

Result<Value, Diagnostics> parse_yaml_file(const std::string& path) {
  std::error_code error;
  std::ifstream in(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path, error) || !in) {
    return one_error(path, 0, 0, "cannot be read");
  }
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  return parse_yaml(text, path);
}

}  // namespace skein::config
