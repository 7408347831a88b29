// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal_files/network_text.hpp"

#include <algorithm>

#include "readers.hpp"
#include "text_encoding.hpp"

namespace skein::temporal {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

enum class Syntax { kJson, kXml, kPlain };

Syntax syntax_of(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  const char first = begin == std::string_view::npos ? '\0' : text[begin];
  if (first == '{' || first == '[') return Syntax::kJson;
  return first == '<' ? Syntax::kXml : Syntax::kPlain;
}

/// UTF-8 without what may stand before it.
class Text {
 public:
  /// Not there, and a problem, when it is too long or wrongly encoded.
  Text(std::string_view given, Problems& problems) : text_(given) {
    there_ = given.size() <= kLongestText;
    if (!there_) problems.add({}, "longer than " + std::to_string(kLongestText) + " bytes");
    if (there_ && is_utf16(given)) convert(given, problems);
    if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
  }
  Text(const Text&) = delete;
  Text& operator=(const Text&) = delete;

  bool there() const { return there_; }
  std::string_view utf8() const { return text_; }
  /// An XML declaration then names the encoding that the text had before.
  XmlEncoding xml_encoding() const {
    return converted_.empty() ? XmlEncoding::kDeclared : XmlEncoding::kUtf8;
  }

 private:
  void convert(std::string_view given, Problems& problems) {
    std::optional<std::string> converted = utf8_from_utf16(given, problems);
    there_ = converted.has_value();
    if (there_) converted_ = std::move(*converted);
    text_ = converted_;
  }

  std::string converted_;
  std::string_view text_;
  bool there_ = true;
};

// A network of nobody's nodes is one of ours: {"agents": [], "nodes": ["v0", …], …}.
bool has_agents(const JsonNode& root) {
  if (!root.has("agents")) return false;
  const auto first_of = [](const JsonNode& list) -> const JsonValue* {
    const std::vector<JsonValue>& items = list.value().items;
    return items.empty() ? nullptr : &items.front();
  };
  const std::optional<JsonNode> nodes = root.find("nodes");
  const JsonValue* node = nodes ? first_of(*nodes) : nullptr;
  return first_of(*root.find("agents")) != nullptr || node == nullptr ||
         node->kind != JsonKind::kString;
}

ReadNetwork read_json(std::string_view text, Problems& problems) {
  const std::optional<JsonValue> value = parse_json(text, problems);
  if (!value) return {};
  const JsonNode root(*value, "", problems);
  if (!root.is_object()) return {};
  if (root.has("constraints")) return {read_heatlab(root, problems), Format::kHeatlab};
  if (has_agents(root)) {
    return {without_agents(read_mastn_json(root, problems)), Format::kMastn};
  }
  return {read_own_json(root, problems), Format::kJson};
}

ReadNetwork read_any(const Text& text, Problems& problems) {
  switch (syntax_of(text.utf8())) {
    case Syntax::kJson:
      return read_json(text.utf8(), problems);
    case Syntax::kXml:
      return {read_graphml(text.utf8(), problems, text.xml_encoding()), Format::kGraphml};
    case Syntax::kPlain:
      break;
  }
  return {read_plain(text.utf8(), problems), Format::kPlain};
}

}  // namespace

const std::vector<std::string>& format_names() {
  static const std::vector<std::string> names{"json", "heatlab", "graphml", "plain", "mastn"};
  return names;
}

std::string_view name_of(Format format) { return format_names()[static_cast<std::size_t>(format)]; }

std::optional<Format> format_named(std::string_view name) {
  const std::vector<std::string>& names = format_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Format>(found - names.begin());
}

Result<ReadNetwork, Diagnostics> read_network(std::string_view text, const std::string& file) {
  Problems problems(file);
  ReadNetwork read;
  const Text all(text, problems);
  if (all.there()) read = read_any(all, problems);
  if (!problems.none()) return tl::unexpected(problems.take());
  read.warnings = problems.take_warnings();
  return read;
}

namespace {

// Only files of others have links from a node to itself.
std::optional<Failure> loop_failure(const Stnu& network) {
  for (const Arc& arc : network.arcs) {
    if (arc.from != arc.to) continue;
    return Failure{"it has a link from " + in_quotes(network.nodes[arc.from]) + " to itself"};
  }
  return std::nullopt;
}

}  // namespace

Result<std::string, Failure> write_network(const Stnu& network, Format format) {
  switch (format) {
    case Format::kJson:
      if (const std::optional<Failure> loop = loop_failure(network)) return tl::unexpected(*loop);
      return write_own_json(network);
    case Format::kHeatlab:
      return write_heatlab(network);
    case Format::kGraphml:
      return write_graphml(network);
    case Format::kPlain:
      return write_plain(network);
    case Format::kMastn:
      break;
  }
  return failure("nobody knows whose nodes they are");
}

Result<Mastn, Diagnostics> read_mastn(std::string_view text, const std::string& file) {
  Problems problems(file);
  Mastn network;
  const Text all(text, problems);
  const std::optional<JsonValue> value =
      all.there() ? parse_json(all.utf8(), problems) : std::nullopt;
  if (value) network = read_mastn_json(JsonNode(*value, "", problems), problems);
  if (!problems.none()) return tl::unexpected(problems.take());
  return network;
}

Stn without_uncertainty(const Stnu& network) {
  Stn stn{network.nodes, network.origin, network.arcs};
  for (const ContingentLink& link : network.contingent) {
    stn.arcs.push_back({link.activation, link.contingent, link.min, link.max});
  }
  return stn;
}

Result<std::vector<std::string>, Failure> names_with_origin(const Stnu& network,
                                                            const std::string& origin) {
  std::vector<std::string> names = network.nodes;
  const auto taken = std::find(names.begin(), names.end(), origin);
  if (taken != names.end() && taken - names.begin() != static_cast<long>(network.origin)) {
    return failure("the format calls the origin " + in_quotes(origin) +
                   ", and another node has that name");
  }
  names[network.origin] = origin;
  return names;
}

}  // namespace skein::temporal
