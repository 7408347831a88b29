// SPDX-License-Identifier: Apache-2.0
#include "layout.hpp"

#include <yaml.h>

#include <algorithm>

namespace skein::yaml_edit {

namespace {

constexpr int kDeepest = 64;

/// The events of libyaml, each with where it stands in bytes (libyaml counts characters).
class Events {
 public:
  explicit Events(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) bytes_.push_back(i);
    }
    bytes_.push_back(text.size());
    yaml_parser_initialize(&parser_);
    yaml_parser_set_encoding(&parser_, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&parser_, reinterpret_cast<const unsigned char*>(text.data()),
                                 text.size());
  }
  Events(const Events&) = delete;
  Events& operator=(const Events&) = delete;
  ~Events() {
    yaml_event_delete(&event_);
    yaml_parser_delete(&parser_);
  }

  /// False when the text is wrong.
  bool next() {
    yaml_event_delete(&event_);
    return yaml_parser_parse(&parser_, &event_) == 1;
  }
  const yaml_event_t& event() const { return event_; }
  Span span() const { return {byte(event_.start_mark), byte(event_.end_mark)}; }
  Failure problem() const {
    const std::string what = parser_.problem == nullptr ? "not YAML" : parser_.problem;
    return {"line " + std::to_string(parser_.problem_mark.line + 1) + ": " + what};
  }

 private:
  std::size_t byte(const yaml_mark_t& mark) const {
    return bytes_[std::min<std::size_t>(mark.index, bytes_.size() - 1)];
  }

  yaml_parser_t parser_{};
  yaml_event_t event_{};
  std::vector<std::size_t> bytes_;  ///< of each character
};

class Builder {
 public:
  explicit Builder(std::string_view text) : text_(text), events_(text) {}

  Result<Place, Failure> build() {
    Place top;
    while (events_.next()) {
      const yaml_event_type_t type = events_.event().type;
      if (type == YAML_STREAM_END_EVENT) return failure("there is no document");
      if (type == YAML_STREAM_START_EVENT || type == YAML_DOCUMENT_START_EVENT) continue;
      if (!take(top, 0)) break;
      return top;
    }
    return tl::unexpected(why_.why.empty() ? events_.problem() : why_);
  }

 private:
  /// The node that begins with the present event.
  bool take(Place& place, int depth) {
    const yaml_event_t& event = events_.event();
    place.span = events_.span();
    place.column = event.start_mark.column;
    if (depth > kDeepest) return refuse("nested too deeply");
    if (event.type == YAML_ALIAS_EVENT) return place.shared = true;
    if (event.type == YAML_SCALAR_EVENT) return take_scalar(place);
    if (event.type == YAML_SEQUENCE_START_EVENT) return take_list(place, depth);
    if (event.type == YAML_MAPPING_START_EVENT) return take_map(place, depth);
    return refuse("not a node");
  }

  bool take_scalar(Place& place) {
    const auto& scalar = events_.event().data.scalar;
    place.shared = scalar.anchor != nullptr || scalar.tag != nullptr;
    // That of a block scalar reaches to what follows it.
    while (place.span.end > place.span.begin && is_blank(text_[place.span.end - 1]))
      --place.span.end;
    return true;
  }

  bool take_list(Place& place, int depth) {
    const auto& list = events_.event().data.sequence_start;
    place.kind = Place::Kind::kList;
    place.flow = list.style == YAML_FLOW_SEQUENCE_STYLE;
    place.shared = list.anchor != nullptr || list.tag != nullptr;
    while (events_.next()) {
      if (events_.event().type == YAML_SEQUENCE_END_EVENT) return close(place);
      if (!take(place.nodes.emplace_back(), depth + 1)) return false;
    }
    return false;
  }

  bool take_map(Place& place, int depth) {
    const auto& map = events_.event().data.mapping_start;
    place.kind = Place::Kind::kMap;
    place.flow = map.style == YAML_FLOW_MAPPING_STYLE;
    place.shared = map.anchor != nullptr || map.tag != nullptr;
    while (events_.next()) {
      if (events_.event().type == YAML_MAPPING_END_EVENT) return close(place);
      if (events_.event().type != YAML_SCALAR_EVENT)
        return refuse("a key that is not a plain name");
      const auto& key = events_.event().data.scalar;
      place.names.emplace_back(reinterpret_cast<const char*>(key.value), key.length);
      place.keys.push_back(events_.span());
      if (!events_.next() || !take(place.nodes.emplace_back(), depth + 1)) return false;
    }
    return false;
  }

  bool close(Place& place) {
    place.span.end = place.flow ? events_.span().end : place.nodes.back().span.end;
    // A value that is absent may be said to stand far below.
    if (!place.flow && place.kind == Place::Kind::kMap) {
      place.span.end = std::max(place.keys.back().end, place.span.end);
    }
    return true;
  }

  bool refuse(const char* why) {
    why_ = {why};
    return false;
  }
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

  std::string_view text_;
  Events events_;
  Failure why_;
};

}  // namespace

Result<Place, Failure> layout_of(std::string_view text) { return Builder(text).build(); }

const Place* find(const Place& top, const Path& path, std::size_t depth) {
  const Place* place = &top;
  for (std::size_t i = 0; i < depth && place != nullptr; ++i) {
    std::size_t at = place->nodes.size();
    if (const auto* key = std::get_if<std::string>(&path[i])) {
      if (place->kind != Place::Kind::kMap) return nullptr;
      at = static_cast<std::size_t>(std::find(place->names.begin(), place->names.end(), *key) -
                                    place->names.begin());
    } else if (place->kind == Place::Kind::kList) {
      at = std::get<std::size_t>(path[i]);
    }
    place = at < place->nodes.size() ? &place->nodes[at] : nullptr;
  }
  return place;
}

}  // namespace skein::yaml_edit
