// SPDX-License-Identifier: Apache-2.0
// Random edits of random texts: what they say after, and which lines are left alone. The texts are
// written here, with notes of which lines belong to what.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "skein/config/parse.hpp"
#include "skein/foundation/random.hpp"
#include "skein/yaml_edit/edit.hpp"

namespace skein::yaml_edit {
namespace {

using config::Value;

struct Lines {
  std::size_t first = 0, last = 0;  ///< with its key or dash
};

/// A text with comments, and the lines of each node in it.
class Draft {
 public:
  explicit Draft(Random& random) : random_(random) {
    comment(0);
    map(0, {}, 3, false);
    comment(0);
  }
  std::string text() const {
    std::string all;
    for (const std::string& line : lines_) all += line + "\n";
    return all;
  }
  const std::vector<std::string>& lines() const { return lines_; }
  std::map<std::string, std::pair<Path, Lines>> nodes;  ///< by their paths as text

 private:
  std::string word() {
    static const std::vector<std::string> kWords{"b1",    "t2",      "plan", "0.5", "member lost",
                                                 "\">\"", "'it''s'", "ä",    "R*",  "\"a: b, #c\""};
    return kWords[random_.below(kWords.size())];
  }
  void line(std::size_t column, const std::string& text) {
    const bool noted = random_.chance(0.15);
    lines_.push_back(std::string(column, ' ') + text + (noted ? "  # note" : ""));
  }
  void comment(std::size_t column) {
    if (random_.chance(0.25)) lines_.emplace_back();
    if (random_.chance(0.3))
      lines_.push_back(std::string(column, ' ') + "# comment " + std::to_string(lines_.size()));
  }

  std::string flow(const Path& path, int depth) {
    if (depth == 0 || random_.chance(0.4)) return word();
    std::string text;
    const bool list = random_.chance(0.5);
    for (std::uint64_t i = 0, n = random_.below(4); i < n; ++i) {
      Path below = path;
      const std::string key = "k" + std::to_string(i);
      list ? below.emplace_back(i) : below.emplace_back(key);
      note(below, {lines_.size(), lines_.size()});
      text += (i == 0 ? "" : ", ") + (list ? "" : key + ": ") + flow(below, depth - 1);
    }
    return list ? "[" + text + "]" : "{" + text + "}";
  }

  void value(std::size_t column, const std::string& head, const Path& path, int depth) {
    comment(column);
    const std::size_t first = lines_.size();
    const std::uint64_t kind = depth == 0 ? 0 : random_.below(3);
    if (kind == 0) {
      line(column, head + " " + flow(path, 2));
    } else if (head == "-") {
      kind == 1 ? map(column + 2, path, depth - 1, true) : line(column, "- " + word());
    } else {
      line(column, head);
      kind == 1 ? map(column + 2, path, depth - 1, false) : list(column + 2, path, depth - 1);
    }
    note(path, {first, lines_.size() - 1});
  }
  void map(std::size_t column, const Path& path, int depth, bool behind_dash) {
    for (std::uint64_t i = 0, n = 1 + random_.below(4); i < n; ++i) {
      Path below = path;
      const std::string key = "k" + std::to_string(i);
      below.emplace_back(key);
      if (behind_dash && i == 0) {
        note(below, {lines_.size(), lines_.size()});
        line(column - 2, "- " + key + ": " + flow(below, 1));
      } else {
        value(column, key + ":", below, depth);
      }
    }
  }
  void list(std::size_t column, const Path& path, int depth) {
    for (std::uint64_t i = 0, n = 1 + random_.below(4); i < n; ++i) {
      Path below = path;
      below.emplace_back(i);
      value(column, "-", below, depth);
    }
  }
  void note(const Path& path, Lines lines) { nodes[to_text(path)] = {path, lines}; }

  Random& random_;
  std::vector<std::string> lines_;
};

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

Value random_value(Random& random, int depth) {
  Value value;
  const std::uint64_t kind = depth == 0 ? 0 : random.below(3);
  if (kind == 0) {
    value.kind = Value::Kind::kScalar;
    value.scalar = random.chance(0.5) ? "new" : "a, \"b\": #c";
    return value;
  }
  value.kind = kind == 1 ? Value::Kind::kSequence : Value::Kind::kMap;
  for (std::uint64_t i = 0, n = random.below(4); i < n; ++i) {
    if (kind == 1) {
      value.items.push_back(random_value(random, depth - 1));
    } else {
      value.entries.push_back({"n" + std::to_string(i), random_value(random, depth - 1)});
    }
  }
  return value;
}

const Value& at(const Value& top, const Path& path) {
  const Value* value = &top;
  for (const Step& step : path) {
    const auto* key = std::get_if<std::string>(&step);
    value = key != nullptr ? value->find(*key) : &value->items[std::get<std::size_t>(step)];
  }
  return *value;
}

/// An edit and the lines that it is about: those of no others may change.
struct Drawn {
  Edit edit;
  Lines about;
  bool moves = false;
};

Drawn draw(Random& random, const Draft& draft, const Value& document) {
  const auto any = [&] {
    return std::next(draft.nodes.begin(),
                     static_cast<std::ptrdiff_t>(random.below(draft.nodes.size())))
        ->second;
  };
  const auto [path, lines] = any();
  const bool in_map = std::holds_alternative<std::string>(path.back());
  switch (random.below(5)) {
    case 0:
      return {Set{path, random_value(random, 3)}, lines};
    case 1:
      return {Remove{path}, lines};
    case 2:
      if (in_map) return {Rename{path, "renamed"}, {lines.first, lines.first}};
      return {Move{path, any().first, random.below(4)}, lines, true};
    case 3: {
      const bool map = at(document, path).kind == Value::Kind::kMap;
      return {Insert{path, random.below(5), map ? "inserted" : "", random_value(random, 3)}, lines};
    }
    default:
      if (in_map) return {Set{path, random_value(random, 1)}, lines};
      return {Move{path, Path(path.begin(), path.end() - 1), random.below(4)}, lines, true};
  }
}

/// Where the only one goes, what it was in says that it is empty.
Lines widened(const Draft& draft, const Value& document, const Path& path, Lines about) {
  const Path around(path.begin(), path.end() - 1);
  const Value& value = at(document, around);
  if (value.entries.size() > 1 &&
      std::holds_alternative<std::size_t>(around.empty() ? Step("") : around.back()) &&
      value.entries[0].key == std::get<std::string>(path.back())) {
    Path next = around;  // the second takes its place behind the dash
    next.emplace_back(value.entries[1].key);
    return {about.first, draft.nodes.at(to_text(next)).second.first};
  }
  if (value.items.size() + value.entries.size() > 1) return about;
  if (around.empty()) return {0, draft.lines().size()};
  return draft.nodes.at(to_text(around)).second;
}

bool is_comment_or_blank(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first == std::string::npos || line[first] == '#';
}

/// What must be there still, in its order. Comments right above may go with what they are above of.
std::vector<std::string> left_alone(const Draft& draft, Lines about) {
  std::size_t first = about.first;
  while (first > 0 && is_comment_or_blank(draft.lines()[first - 1])) --first;
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < draft.lines().size(); ++i) {
    if (i < first || i > about.last) lines.push_back(draft.lines()[i]);
  }
  return lines;
}

bool is_subsequence(const std::vector<std::string>& part, const std::vector<std::string>& whole) {
  auto at = whole.begin();
  for (const std::string& line : part) {
    at = std::find(at, whole.end(), line);
    if (at == whole.end()) return false;
    ++at;
  }
  return true;
}

RC_GTEST_PROP(EditLaw, TheTextSaysWhatItShouldAndOtherLinesAreLeftAlone, (std::uint32_t seed)) {
  Random random(seed);
  const Draft draft(random);
  const auto document = config::parse_yaml(draft.text(), "");
  RC_ASSERT(document.has_value());
  const Drawn drawn = draw(random, draft, *document);
  const auto wanted = applied(*document, drawn.edit);

  const auto result = edited(draft.text(), drawn.edit);

  RC_CLASSIFY(wanted.has_value() && result.has_value(), "made");
  RC_CLASSIFY(wanted.has_value() && !result.has_value(), "left to be made by hand");
  if (!wanted) {
    RC_ASSERT(!result.has_value());
    return;
  }
  if (!result) return;
  const auto read = config::parse_yaml(*result, "");
  RC_ASSERT(read.has_value());
  RC_ASSERT(says_same(*read, *wanted));
  Lines about = drawn.about;
  const auto* removed = std::get_if<Remove>(&drawn.edit);
  if (removed != nullptr) about = widened(draft, *document, removed->path, about);
  if (drawn.moves) {
    about = widened(draft, *document, std::get<Move>(drawn.edit).path,
                    about);  // a list in one line that gets the item changes its line, too
    const auto& into = draft.nodes.find(to_text(std::get<Move>(drawn.edit).into));
    if (into == draft.nodes.end()) return;
    about = {std::min(about.first, into->second.second.first),
             std::max(about.last, into->second.second.last)};
  }
  RC_ASSERT(is_subsequence(left_alone(draft, about), split(*result)));
}

// Otherwise the law above would say little.
TEST(EditLaw, MostEditsAreMade) {
  int made = 0, sensible = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Random random(seed);
    const Draft draft(random);
    const auto document = config::parse_yaml(draft.text(), "");
    ASSERT_TRUE(document.has_value()) << draft.text();
    const Drawn drawn = draw(random, draft, *document);
    if (!applied(*document, drawn.edit)) continue;
    ++sensible;
    made += edited(draft.text(), drawn.edit) ? 1 : 0;
  }

  EXPECT_GT(sensible, 150);
  EXPECT_GE(made * 100, sensible * 90) << made << " of " << sensible;
}

}  // namespace
}  // namespace skein::yaml_edit
