// SPDX-License-Identifier: Apache-2.0
// Edits of text. Each is made where the layout says that it belongs; whether the text then says
// what it should is looked at after, so that no case that is not thought of here goes wrong unseen.
#include "skein/yaml_edit/edit.hpp"

#include <algorithm>

#include "layout.hpp"
#include "skein/config/parse.hpp"
#include "write.hpp"

namespace skein::yaml_edit {

namespace {

using config::Value;

constexpr const char* kByHand = "this cannot be changed here without changing more: edit the text";

std::size_t line_begin(std::string_view text, std::size_t at) {
  const std::size_t end = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  return end == std::string_view::npos ? 0 : end + 1;
}
/// Behind the end of the line, or the end of the text.
std::size_t line_end(std::string_view text, std::size_t at) {
  const std::size_t end = text.find('\n', at);
  return end == std::string_view::npos ? text.size() : end + 1;
}
bool has_comment(std::string_view piece) { return piece.find('#') != std::string_view::npos; }

/// The text under way, for one edit.
class Editor {
 public:
  explicit Editor(std::string_view text) : text_(text) {}

  Result<std::string, Failure> make(const Edit& edit) {
    auto top = layout_of(text_);
    if (!top) return tl::unexpected(top.error());
    top_ = std::move(*top);
    const bool made = std::visit([this](const auto& one) { return change(one); }, edit);
    if (!made) return failure(kByHand);
    return std::move(text_);
  }

 private:
  const Place* at(const Path& path) const { return find(top_, path, path.size()); }
  const Place* around(const Path& path) const {
    return path.empty() ? nullptr : find(top_, path, path.size() - 1);
  }
  static std::size_t index_in(const Place& parent, const Step& step) {
    if (const auto* index = std::get_if<std::size_t>(&step)) return *index;
    const auto& key = std::get<std::string>(step);
    return static_cast<std::size_t>(std::find(parent.names.begin(), parent.names.end(), key) -
                                    parent.names.begin());
  }
  void replace(Span span, const std::string& with) {
    text_.replace(span.begin, span.end - span.begin, with);
  }
  std::string_view piece(Span span) const {
    return std::string_view(text_).substr(span.begin, span.end - span.begin);
  }
  bool in_flow(const Path& path) const {
    for (std::size_t depth = 0; depth < path.size(); ++depth) {
      if (find(top_, path, depth)->flow) return true;
    }
    return false;
  }

  // ---- set ----

  bool change(const Set& edit) {
    const Place* place = at(edit.path);
    if (place == nullptr || place->shared) return false;
    if (edit.path.empty()) {
      replace(place->span, edit.value.kind == Value::Kind::kMap && !edit.value.entries.empty()
                               ? block_text(edit.value, place->column)
                               : flow_text(edit.value));
      return true;
    }
    return put(*place, *around(edit.path), index_in(*around(edit.path), edit.path.back()),
               edit.value, in_flow(edit.path));
  }

  /// The value of an entry or an item becomes another.
  bool put(const Place& old, const Place& parent, std::size_t index, const Value& value,
           bool inside_flow) {
    const std::size_t name_end =
        parent.kind == Place::Kind::kMap ? parent.keys[index].end : std::size_t{0};
    const bool on_own_lines = old.is_block() && parent.kind == Place::Kind::kMap;
    const bool is_absent = old.span.begin == old.span.end && old.kind == Place::Kind::kScalar;
    Span span = old.span;
    if (is_absent || on_own_lines) {
      if (parent.kind != Place::Kind::kMap) return false;
      const std::size_t colon = text_.find(':', name_end);
      if (colon == std::string::npos) return false;
      span = {colon + 1, is_absent ? colon + 1 : old.span.end};
    }
    const std::size_t column = span.begin - line_begin(text_, span.begin);
    if (inside_flow || is_short(value, column)) {
      if (!inside_flow || !has_comment(piece(span))) return put_short(span, old, value);
      return false;
    }
    if (parent.kind == Place::Kind::kMap) return put_long(span, parent.column + 2, value);
    replace(span, block_text(value, column));
    return true;
  }

  /// A comment behind the key stays there.
  bool put_short(Span span, const Place& old, const Value& value) {
    const bool behind_colon = span.begin != old.span.begin;
    if (!behind_colon) {
      if (has_comment(piece(span)) && !old.is_block() && old.kind != Place::Kind::kScalar)
        return false;
      replace(span, flow_text(value));
      return true;
    }
    const std::size_t rest = std::min(text_.find('\n', span.begin), span.end);
    const std::string comment = text_.substr(span.begin, rest - span.begin);
    replace(span, " " + flow_text(value) + (has_comment(comment) ? comment : ""));
    return true;
  }

  bool put_long(Span span, std::size_t column, const Value& value) {
    if (has_comment(piece(span)) && text_[span.begin] != '\n' && text_[span.begin] != ' ')
      return false;
    const std::size_t end = text_.find('\n', span.begin);
    std::string comment;
    if (end < span.end) {  // lines of its own: what stands behind the key stays
      comment = text_.substr(span.begin, end - span.begin);
    } else {
      while (span.begin > 0 && text_[span.begin - 1] == ' ') --span.begin;
    }
    replace(span, comment + "\n" + std::string(column, ' ') + block_text(value, column));
    return true;
  }

  // ---- insert ----

  bool change(const Insert& edit) {
    const Place* parent = at(edit.into);
    if (parent == nullptr || parent->shared || parent->kind == Place::Kind::kScalar) return false;
    if (parent->is_block()) return insert_lines(*parent, edit, new_lines(*parent, edit));
    if (insert_in_line(*parent, edit)) return true;
    return rewrite(edit.into, edit);
  }

  std::string new_lines(const Place& parent, const Insert& edit) const {
    const std::string indent(parent.column, ' ');
    Value one;
    one.kind = edit.key.empty() ? Value::Kind::kSequence : Value::Kind::kMap;
    if (edit.key.empty()) {
      one.items.push_back(edit.value);
    } else {
      one.entries.push_back({edit.key, edit.value});
    }
    return indent + block_text(one, parent.column) + "\n";
  }

  /// Before what is at the index now, or behind the last.
  bool insert_lines(const Place& parent, const Insert& edit, const std::string& lines) {
    std::size_t index = std::min(edit.index, parent.nodes.size());
    if (index == 0 && parent.kind == Place::Kind::kMap && !begins_line(parent.span.begin))
      index = 1;
    if (index < parent.nodes.size()) {
      const std::size_t from = own_lines(parent, index).begin;
      if (!begins_line(head(parent, index))) return false;
      text_.insert(from, lines);
      return true;
    }
    const std::size_t end = line_end(text_, parent.span.end);
    if (end == text_.size() && text_.back() != '\n') {
      text_ += "\n" + lines.substr(0, lines.size() - 1);
    } else {
      text_.insert(end, lines);
    }
    return true;
  }

  /// In the line of a collection, as far as one would write it so.
  bool insert_in_line(const Place& parent, const Insert& edit) {
    if (has_comment(piece(parent.span))) return false;
    const bool may_be_long = !in_flow(edit.into) && !edit.into.empty();
    if (may_be_long && !stays_short(parent, edit)) return false;
    std::string one = flow_text(edit.value);
    if (!edit.key.empty()) one = scalar_text(edit.key, false) + ": " + one;
    if (parent.nodes.empty()) {
      text_.insert(parent.span.end - 1, one);
    } else if (edit.index < parent.nodes.size()) {
      text_.insert(head(parent, edit.index), one + ", ");
    } else {
      text_.insert(parent.nodes.back().span.end, ", " + one);
    }
    return true;
  }

  bool stays_short(const Place& parent, const Insert& edit) const {
    const auto document = config::parse_yaml(text_, "");
    const auto result = document ? applied(*document, edit) : Result<Value, Failure>(Value());
    if (!result) return true;
    return is_short(value_at(*result, edit.into),
                    parent.span.begin - line_begin(text_, parent.span.begin));
  }

  static const Value& value_at(const Value& top, const Path& path) {
    const Value* value = &top;
    for (const Step& step : path) {
      const auto* key = std::get_if<std::string>(&step);
      value = key != nullptr ? value->find(*key) : &value->items[std::get<std::size_t>(step)];
    }
    return *value;
  }

  /// A collection in one line that is to have more than fits there.
  bool rewrite(const Path& path, const Edit& edit) {
    if (path.empty() || has_comment(piece(at(path)->span))) return false;
    const auto document = config::parse_yaml(text_, "");
    if (!document) return false;
    const auto result = applied(*document, edit);
    if (!result) return false;
    return change(Set{path, value_at(*result, path)});
  }

  // ---- remove ----

  bool change(const Remove& edit) {
    const Place* parent = around(edit.path);
    if (parent == nullptr || at(edit.path) == nullptr || parent->shared) return false;
    if (parent->nodes.size() == 1) return empty(edit.path);
    const std::size_t index = index_in(*parent, edit.path.back());
    return parent->flow ? remove_in_line(*parent, index) : remove_lines(*parent, index);
  }

  /// The last one goes: what was around it says that it is empty.
  bool empty(Path path) {
    path.pop_back();
    const Place& place = *at(path);
    Value nothing;
    nothing.kind = place.kind == Place::Kind::kList ? Value::Kind::kSequence : Value::Kind::kMap;
    if (place.flow && !has_comment(piece(place.span))) {
      replace(place.span, flow_text(nothing));
      return true;
    }
    return change(Set{path, nothing});
  }

  bool remove_in_line(const Place& parent, std::size_t index) {
    const bool is_last = index + 1 == parent.nodes.size();
    const Span gone = is_last ? Span{parent.nodes[index - 1].span.end, parent.nodes[index].span.end}
                              : Span{head(parent, index), head(parent, index + 1)};
    if (has_comment(piece(gone))) return false;
    replace(gone, "");
    return true;
  }

  bool remove_lines(const Place& parent, std::size_t index) {
    if (begins_line(head(parent, index))) {
      replace(own_lines(parent, index), "");
      return true;
    }
    // The first of what begins behind a dash: the second takes its place.
    if (index != 0) return false;
    const Span gone{head(parent, 0), head(parent, 1)};
    if (has_comment(piece(gone))) return false;
    replace(gone, "");
    return true;
  }

  // ---- rename, move ----

  bool change(const Rename& edit) {
    const Place* parent = around(edit.path);
    if (parent == nullptr || parent->kind != Place::Kind::kMap) return false;
    replace(parent->keys[index_in(*parent, edit.path.back())], scalar_text(edit.key, false));
    return true;
  }

  bool change(const Move& edit) {
    const Place* parent = around(edit.path);
    const Place* into = at(edit.into);
    const Place* item = at(edit.path);
    if (item == nullptr || into == nullptr || into->kind != Place::Kind::kList) return false;
    const bool as_lines = parent->is_block() && into->is_block() && parent->nodes.size() > 1 &&
                          begins_line(head(*parent, std::get<std::size_t>(edit.path.back())));
    return as_lines ? move_lines(edit, *parent) : move_value(edit);
  }

  bool move_lines(const Move& edit, const Place& parent) {
    const Span own = own_lines(parent, std::get<std::size_t>(edit.path.back()));
    std::string lines(piece(own));
    if (lines.empty() || lines.back() != '\n') lines += '\n';
    const std::size_t from = parent.column;
    replace(own, "");
    auto top = layout_of(text_);
    if (!top) return false;
    top_ = std::move(*top);
    const Path into = path_without(edit.into, edit.path);
    const Place* list = at(into);
    if (list == nullptr || !list->is_block()) return false;
    Insert insert;
    insert.into = into;
    insert.index = edit.index;
    return insert_lines(*list, insert, moved(lines, from, list->column));
  }

  static std::string moved(const std::string& lines, std::size_t from, std::size_t to) {
    std::string result;
    for (std::size_t at = 0; at < lines.size();) {
      const std::size_t end = line_end(lines, at);
      std::string line = lines.substr(at, end - at);
      const std::size_t blank = std::min(line.find_first_not_of(' '), line.size());
      if (line != "\n" && to > from) line.insert(0, to - from, ' ');
      if (line != "\n" && to < from) line.erase(0, std::min(blank, from - to));
      result += line;
      at = end;
    }
    return result;
  }

  bool move_value(const Move& edit) {
    const auto document = config::parse_yaml(text_, "");
    if (!document || has_comment(piece(at(edit.path)->span))) return false;
    const Value value = value_at(*document, edit.path);
    if (!change(Remove{edit.path})) return false;
    auto top = layout_of(text_);
    if (!top) return false;
    top_ = std::move(*top);
    return change(Insert{path_without(edit.into, edit.path), edit.index, "", value});
  }

  // ---- lines ----

  /// Where an entry begins: with its key; an item of a block list: with its dash.
  std::size_t head(const Place& parent, std::size_t index) const {
    if (parent.kind == Place::Kind::kMap) return parent.keys[index].begin;
    const Place& item = parent.nodes[index];
    if (parent.flow) return item.span.begin;
    const std::size_t after = index == 0 ? parent.span.begin : parent.nodes[index - 1].span.end;
    for (std::size_t line = line_begin(text_, item.span.begin);;) {
      const std::size_t dash = line + parent.column;
      if (dash < text_.size() && dash >= after && text_[dash] == '-') return dash;
      if (line == 0 || line < after) return item.span.begin;
      line = line_begin(text_, line - 1);
    }
  }

  bool begins_line(std::size_t at) const {
    return text_.find_first_not_of(' ', line_begin(text_, at)) == at;
  }

  /// From the comments right above, that stand as far to the right, to the end of its last line.
  Span own_lines(const Place& parent, std::size_t index) const {
    std::size_t begin = line_begin(text_, head(parent, index));
    // Those at the head of a file are not of its first entry.
    const std::size_t after =
        index > 0 ? line_end(text_, parent.nodes[index - 1].span.end) : std::size_t{0};
    while ((index > 0 || parent.column > 0) && begin > after) {
      const std::size_t above = line_begin(text_, begin - 1);
      const std::size_t first = text_.find_first_not_of(' ', above);
      if (first != above + parent.column || text_[first] != '#') break;
      begin = above;
    }
    const std::size_t end = std::max(parent.nodes[index].span.end, head(parent, index));
    return {begin, line_end(text_, end)};
  }

  std::string text_;
  Place top_;
};

}  // namespace

Result<std::string, Failure> edited(std::string_view text, const Edit& edit) {
  const auto before = config::parse_yaml(text, "");
  if (!before) return failure("the text is no YAML: mend it first");
  const auto wanted = applied(*before, edit);
  if (!wanted) return tl::unexpected(wanted.error());
  auto result = Editor(text).make(edit);
  if (!result) return tl::unexpected(result.error());
  const auto after = config::parse_yaml(*result, "");
  if (!after || !says_same(*after, *wanted)) return failure(kByHand);
  return result;
}

Result<std::string, Failure> edited(std::string_view text, const std::vector<Edit>& edits) {
  std::string result(text);
  for (const Edit& edit : edits) {
    auto next = edited(result, edit);
    if (!next) return tl::unexpected(next.error());
    result = std::move(*next);
  }
  return result;
}

}  // namespace skein::yaml_edit
