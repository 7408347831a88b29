// SPDX-License-Identifier: Apache-2.0
// The GraphML of the CSTNU Tool (`.stnu`): reading.
#include "graphml.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "link_tables.hpp"
#include "readers.hpp"
#include "seconds_text.hpp"
#include "xml_document.hpp"

namespace skein::temporal {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

/// What stands in <data> children, by what their keys mean.
using Data = std::map<std::string, std::string, std::less<>>;

/// An edge of a contingent pair before its mate is found.
struct HalfLink {
  NodeIndex source = 0;
  NodeIndex target = 0;
  std::optional<Ticks> value;
  std::optional<Ticks> lower_case;  ///< LC(target): the shortest duration
  std::optional<Ticks> upper_case;  ///< UC(source): minus the longest one
  Place place;
};

class GraphmlReader {
 public:
  explicit GraphmlReader(Problems& problems)
      : problems_(problems),
        nodes_("node", problems),
        links_(nodes_, problems, LinkRules::kOthers) {}

  Stnu read(const XmlElement& root) {
    if (root.name != "graphml") {
      problems_.add(place_of(root), "the root element is " + in_quotes(root.name), "<graphml>");
      return {};
    }
    for (const XmlElement& child : root.children) {
      if (child.name == "key") read_key(child);
    }
    const XmlElement* graph = nullptr;
    for (const XmlElement& child : root.children) {
      if (child.name == "graph" && graph != nullptr)
        problems_.add(place_of(child), "a second graph");
      if (child.name == "graph") graph = &child;
      if (child.name != "graph" && child.name != "key") unknown(child, {"key", "graph"});
    }
    if (graph == nullptr) {
      problems_.add(place_of(root), "no graph", "an element <graph>");
      return {};
    }
    return read_graph(*graph);
  }

 private:
  void unknown(const XmlElement& element, const std::vector<std::string>& known) {
    if (element.name == "desc") return;
    problems_.add_unknown(place_of(element), "element", element.name, known);
  }

  const std::string* required(const XmlElement& element, std::string_view attribute) {
    const std::string* value = element.attribute(attribute);
    if (value == nullptr) {
      problems_.add(place_of(element),
                    "<" + element.name + "> without the attribute " + in_quotes(attribute));
    }
    return value;
  }

  // What a key means is its attr.name, or its id where there is none, as the CSTNU Tool writes it.
  // A key is one of graphs, of nodes, of edges or of all of these: each may have the same id.
  void read_key(const XmlElement& key) {
    const std::string* id = required(key, "id");
    if (id == nullptr) return;
    const std::string* name = key.attribute("attr.name");
    const std::string* domain = key.attribute("for");
    const KeyId key_id{domain == nullptr ? kAllDomains : *domain, *id};
    if (!meaning_of_.emplace(key_id, name == nullptr ? *id : *name).second) {
      problems_.add(place_of(key),
                    "key " + in_quotes(*id) + " is there twice for the same elements");
    }
    for (const XmlElement& child : key.children) {
      if (child.name != "default") unknown(child, {"default"});
    }
  }

  const std::string& meaning_of(const std::string& domain, const std::string& id) const {
    for (const std::string& one : {domain, std::string(kAllDomains)}) {
      const auto found = meaning_of_.find({one, id});
      if (found != meaning_of_.end()) return found->second;
    }
    return id;
  }

  Data data_of(const XmlElement& element) {
    Data data;
    for (const XmlElement& child : element.children) {
      if (child.name != "data") continue;
      const std::string* key = required(child, "key");
      if (key == nullptr) continue;
      const std::string& name = meaning_of(element.name, *key);
      if (!data.emplace(name, trimmed(child.text)).second) {
        problems_.add(place_of(child), "data " + in_quotes(name) + " is there twice");
      }
    }
    return data;
  }

  Stnu read_graph(const XmlElement& graph) {
    const std::string* direction = graph.attribute("edgedefault");
    if (direction != nullptr && *direction != "directed") {
      problems_.add(place_of(graph), "edgedefault is " + in_quotes(*direction), "'directed'");
    }
    const Data data = data_of(graph);
    const auto type = data.find("NetworkType");
    if (type != data.end() && type->second != "STNU" && type->second != "STN") {
      problems_.add(place_of(graph), "the network is of type " + in_quotes(type->second),
                    "STN or STNU");
    }
    for (const XmlElement& child : graph.children) {
      if (child.name == "node") read_node(child);
    }
    for (const XmlElement& child : graph.children) {
      if (child.name == "edge") read_edge(child);
      if (child.name != "node" && child.name != "edge" && child.name != "data") {
        unknown(child, {"node", "edge", "data"});
      }
    }
    return assemble();
  }

  void read_node(const XmlElement& node) {
    const std::string* id = required(node, "id");
    if (id == nullptr) return;
    const std::string problem = name_problem(*id);
    if (!problem.empty()) return problems_.add(place_of(node), problem);
    nodes_.add(*id, place_of(node));
    const Data data = data_of(node);
    for (const char* conditional : {"Obs", "Label"}) {
      const auto found = data.find(conditional);
      if (found == data.end() || found->second.empty() || found->second == "⊡") continue;
      problems_.add(place_of(node),
                    std::string("a node with ") + conditional + " " + in_quotes(found->second) +
                        ": the network is conditional",
                    "an STN or STNU");
    }
  }

  void read_edge(const XmlElement& edge) {
    const std::string* source_name = required(edge, "source");
    const std::string* target_name = required(edge, "target");
    if (source_name == nullptr || target_name == nullptr) return;
    const std::optional<NodeIndex> source = nodes_.find(*source_name, place_of(edge));
    const std::optional<NodeIndex> target = nodes_.find(*target_name, place_of(edge));
    if (!source || !target) return;
    const Data data = data_of(edge);
    const auto found = data.find("Type");
    const std::string type = found == data.end() ? "normal" : found->second;
    const bool ordinary = std::find(kOrdinary.begin(), kOrdinary.end(), type) != kOrdinary.end();
    if (!ordinary && type != "contingent") {
      std::vector<std::string> known(kOrdinary.begin(), kOrdinary.end());
      known.emplace_back("contingent");
      return problems_.add_unknown(place_of(edge), "type of edge", type, known);
    }
    HalfLink half{*source, *target, value_of(data, place_of(edge)), {}, {}, place_of(edge)};
    if (!read_labels(data, type == "contingent", half)) return;
    if (type == "contingent") return add_half(half);
    add_ordinary(half, type);
  }

  void add_ordinary(const HalfLink& half, const std::string& type) {
    const bool labelled = half.lower_case || half.upper_case;
    if (labelled && type != "derived") {
      return problems_.add(half.place, "a labelled value outside a contingent link");
    }
    if (half.value == kInfinite || (labelled && !half.value)) return;
    if (!half.value) return problems_.add(half.place, "an edge without a value");
    edges_.push_back({half.source, half.target, *half.value, half.place});
  }

  std::optional<Ticks> value_of(const Data& data, const Place& place) {
    const auto found = data.find("Value");
    if (found == data.end() || found->second.empty()) return std::nullopt;
    return number(found->second, place);
  }

  std::optional<Ticks> number(std::string_view text, const Place& place) {
    for (const std::string_view infinite : {"∞", "+∞", "inf", "+inf"}) {
      if (text == infinite) return kInfinite;
    }
    const Result<Ticks, BadSeconds> ticks = seconds_from(text, BelowNanosecond::kRound);
    if (ticks) return *ticks;
    add_bad_seconds(problems_, place, text, ticks.error());
    return kInfinite;  // a value was there; that it is wrong has been said
  }

  // "LC(C):3" or "UC(C):-10", under either of the names that the key has had.
  bool read_labels(const Data& data, bool contingent, HalfLink& half) {
    for (const char* key : {"LabeledValue", "LabeledValues"}) {
      const auto found = data.find(key);
      if (found == data.end() || found->second.empty()) continue;
      const std::string_view text = found->second;
      const std::size_t end = text.rfind("):");
      const bool lower = text.starts_with("LC(");
      if ((!lower && !text.starts_with("UC(")) || end == std::string_view::npos) {
        problems_.add(half.place, in_quotes(text) + " is not a labelled value",
                      "LC(node):number or UC(node):number");
        return false;
      }
      const std::optional<NodeIndex> node = nodes_.find(text.substr(3, end - 3), half.place);
      if (!node) return false;
      if (contingent && *node != (lower ? half.target : half.source)) {
        problems_.add(half.place, in_quotes(text) + " does not name the end of its link");
        return false;
      }
      (lower ? half.lower_case : half.upper_case) =
          number(trimmed(text.substr(end + 2)), half.place);
    }
    return true;
  }

  void add_half(const HalfLink& half) {
    const auto mate = halves_.find({half.target, half.source});
    if (mate != halves_.end()) {
      const HalfLink other = mate->second;
      halves_.erase(mate);
      return add_contingent(half, other);
    }
    if (!halves_.emplace(std::pair(half.source, half.target), half).second) {
      problems_.add(half.place, "the contingent edge is there twice");
    }
  }

  // The edge from the activation to the end has the positive value, or the lower-case one.
  void add_contingent(const HalfLink& a, const HalfLink& b) {
    const auto leaves = [](const HalfLink& half) {
      return half.lower_case.has_value() || (half.value && *half.value > 0 && !half.upper_case);
    };
    if (leaves(a) == leaves(b)) {
      return problems_.add(a.place,
                           "a contingent link without a positive shortest and longest "
                           "duration",
                           "one edge with a positive value, its opposite with a negative one");
    }
    const HalfLink& out = leaves(a) ? a : b;
    const HalfLink& back = leaves(a) ? b : a;
    const auto opposite = [](const std::optional<Ticks>& value) {
      return value && *value != kInfinite ? std::optional(-*value) : std::nullopt;
    };
    const std::optional<Ticks> shortest = one_of(out.lower_case, opposite(back.value), a.place);
    const std::optional<Ticks> longest = one_of(opposite(back.upper_case), out.value, a.place);
    if (!shortest || !longest) return;
    links_.add(ContingentLink{out.source, out.target, *shortest, *longest}, a.place);
  }

  // A bound may be written in two ways, and then must be the same.
  std::optional<Ticks> one_of(const std::optional<Ticks>& labelled,
                              const std::optional<Ticks>& plain, const Place& place) {
    if (!labelled && !plain) problems_.add(place, "a contingent link that lacks a bound");
    if (labelled && plain && *labelled != *plain) {
      problems_.add(place, "a contingent link whose value and labelled value differ");
    }
    return labelled ? labelled : plain;
  }

  Stnu assemble() {
    for (const auto& [ends, half] : halves_) {
      problems_.add(half.place, "a contingent edge without its opposite",
                    "a contingent edge from " + in_quotes(nodes_.names()[half.target]) + " to " +
                        in_quotes(nodes_.names()[half.source]));
    }
    Stnu network{nodes_.names(), 0, arcs_from(edges_, nodes_, problems_), links_.take_contingent()};
    append_fixed(network.arcs, links_.take_arcs());
    choose_origin(network, kGraphmlOrigin);
    if (std::any_of(network.contingent.begin(), network.contingent.end(),
                    [&](const auto& link) { return link.contingent == network.origin; })) {
      problems_.add({}, "a contingent link ends in the origin 'Z'");
    }
    return network;
  }

  static constexpr std::array<std::string_view, 5> kOrdinary{"normal", "requirement", "constraint",
                                                             "derived", "internal"};

  Problems& problems_;
  using KeyId = std::pair<std::string, std::string>;  ///< what it is for, id
  static constexpr const char* kAllDomains = "all";

  std::map<KeyId, std::string> meaning_of_;
  NameTable nodes_;
  LinkTable links_;
  std::vector<Edge> edges_;
  std::map<std::pair<NodeIndex, NodeIndex>, HalfLink> halves_;
};

}  // namespace

Stnu read_graphml(std::string_view text, Problems& problems, XmlEncoding encoding) {
  const std::optional<XmlElement> root = parse_xml(text, problems, encoding);
  return root ? GraphmlReader(problems).read(*root) : Stnu{};
}

}  // namespace skein::temporal
