// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal/network_text.hpp"

#include <algorithm>

#include "readers.hpp"

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

// The text without what may stand before it; nothing, and a problem, when it is too long.
std::optional<std::string_view> bounded(std::string_view text, Problems& problems) {
  if (text.size() > kLongestText) {
    problems.add({}, "longer than " + std::to_string(kLongestText) + " bytes");
    return std::nullopt;
  }
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return text;
}

ReadNetwork read_json(std::string_view text, Problems& problems) {
  const std::optional<JsonValue> value = parse_json(text, problems);
  if (!value) return {};
  const JsonNode root(*value, "", problems);
  if (!root.is_object()) return {};
  if (root.has("constraints")) return {read_heatlab(root, problems), Format::kHeatlab};
  if (root.has("agents")) {
    return {without_agents(read_mastn_json(root, problems)), Format::kMastn};
  }
  return {read_own_json(root, problems), Format::kJson};
}

ReadNetwork read_any(std::string_view text, Problems& problems) {
  switch (syntax_of(text)) {
    case Syntax::kJson:
      return read_json(text, problems);
    case Syntax::kXml:
      return {read_graphml(text, problems), Format::kGraphml};
    case Syntax::kPlain:
      break;
  }
  return {read_plain(text, problems), Format::kPlain};
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
  if (const std::optional<std::string_view> all = bounded(text, problems)) {
    read = read_any(*all, problems);
  }
  if (!problems.none()) return tl::unexpected(problems.take());
  return read;
}

Result<std::string, Failure> write_network(const Stnu& network, Format format) {
  switch (format) {
    case Format::kJson:
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
  const std::optional<std::string_view> all = bounded(text, problems);
  const std::optional<JsonValue> value = all ? parse_json(*all, problems) : std::nullopt;
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
