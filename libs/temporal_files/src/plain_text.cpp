// SPDX-License-Identifier: Apache-2.0
// The plain text of the CSTNU Tool (`.plainStnu`).
#include <algorithm>
#include <array>
#include <cctype>

#include "link_tables.hpp"
#include "readers.hpp"
#include "seconds_text.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::temporal {

namespace {

constexpr const char* kOrigin = "Z";

enum class Section { kNone, kKind, kNodeCount, kEdgeCount, kLinkCount, kNodes, kEdges, kLinks };

// In the order of `Section`, lower case.
constexpr std::array<std::string_view, 7> kHeaders{
    "kind of network",  "num time-points", "num ordinary edges", "num contingent links",
    "time-point names", "ordinary edges",  "contingent links"};

/// A word of a line; quotes removed.
struct Word {
  std::string_view text;
  Place place;
};

std::string header_of(std::string_view line) {
  std::string header;
  for (const char c : line.substr(1)) {
    header += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  const std::size_t begin = header.find_first_not_of(" \t\r");
  if (begin == std::string::npos) return "";
  return header.substr(begin, header.find_last_not_of(" \t\r:") + 1 - begin);
}

class PlainReader {
 public:
  explicit PlainReader(Problems& problems)
      : problems_(problems),
        nodes_("node", problems),
        links_(nodes_, problems, LinkRules::kOthers) {}

  Stnu read(std::string_view text) {
    while (!text.empty() && !problems_.full()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      ++line_;
      read_line(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    return assemble();
  }

 private:
  Place place(std::size_t column = 0) const { return {line_, static_cast<int>(column) + 1, ""}; }

  void read_line(std::string_view line) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return;
    if (line[begin] == '#') return read_header(line.substr(begin));
    const std::optional<std::vector<Word>> words = words_of(line);
    if (words) read_data(*words);
  }

  // Other lines with '#' are comments, unless they look like a header with an error.
  void read_header(std::string_view line) {
    const std::string header = header_of(line);
    const auto* found = std::find(kHeaders.begin(), kHeaders.end(), header);
    if (found != kHeaders.end()) {
      section_ = static_cast<Section>(found - kHeaders.begin() + 1);
      any_header_ = true;
      return;
    }
    if (header.size() > 40) return;
    const std::string nearest = nearest_name(header, {kHeaders.begin(), kHeaders.end()});
    if (nearest.empty()) return;
    problems_.add(place(), "unknown section " + in_quotes(header), "", nearest);
    section_ = Section::kNone;
    any_header_ = true;
  }

  std::optional<std::vector<Word>> words_of(std::string_view line) {
    std::vector<Word> words;
    std::size_t at = line.find_first_not_of(" \t\r");
    while (at != std::string_view::npos) {
      const bool quoted = line[at] == '\'';
      const std::size_t begin = quoted ? at + 1 : at;
      const std::size_t end = quoted ? line.find('\'', begin)
                                     : std::min(line.find_first_of(" \t\r", begin), line.size());
      if (end == std::string_view::npos) {
        problems_.add(place(at), "a quote that does not end");
        return std::nullopt;
      }
      words.push_back({line.substr(begin, end - begin), place(at)});
      at = line.find_first_not_of(" \t\r", quoted ? end + 1 : end);
    }
    return words;
  }

  void read_data(const std::vector<Word>& words) {
    switch (section_) {
      case Section::kNone:
        if (any_header_) return;  // the lines of a section whose header was wrong
        any_header_ = true;       // said once
        return problems_.add(place(), "no format that is known begins like this",
                             "JSON, GraphML, or plain text with \"# Time-Point Names\"");
      case Section::kKind:
        return read_kind(words);
      case Section::kNodeCount:
        return read_count(words, node_count_);
      case Section::kEdgeCount:
        return read_count(words, edge_count_);
      case Section::kLinkCount:
        return read_count(words, link_count_);
      case Section::kNodes:
        for (const Word& word : words) read_node(word);
        return;
      case Section::kEdges:
        return read_edge(words);
      case Section::kLinks:
        return read_link(words);
    }
  }

  void read_kind(const std::vector<Word>& words) {
    if (words.size() == 1 && (words[0].text == "STN" || words[0].text == "STNU")) return;
    problems_.add(words[0].place, "the network is of kind " + in_quotes(words[0].text),
                  "STN or STNU");
  }

  struct Count {
    std::size_t value = 0;
    Place place;
  };

  void read_count(const std::vector<Word>& words, std::optional<Count>& count) {
    const std::string_view text = words[0].text;
    const bool whole = words.size() == 1 && text.size() <= 9 && !text.empty() &&
                       text.find_first_not_of("0123456789") == std::string_view::npos;
    if (!whole) return problems_.add(words[0].place, in_quotes(text) + " is not a count");
    count = Count{std::stoul(std::string(text)), words[0].place};
  }

  void check_count(const std::optional<Count>& count, std::size_t found, const char* what) {
    if (!count || count->value == found) return;
    problems_.add(count->place, std::to_string(count->value) + " " + what + " announced, " +
                                    std::to_string(found) + " found");
  }

  void read_node(const Word& word) {
    const std::string problem = name_problem(word.text);
    if (!problem.empty()) return problems_.add(word.place, problem);
    nodes_.add(std::string(word.text), word.place);
  }

  std::optional<Ticks> number(const Word& word) {
    const Result<Ticks, BadSeconds> ticks = seconds_from(word.text, BelowNanosecond::kRound);
    if (ticks) return *ticks;
    add_bad_seconds(problems_, word.place, word.text, ticks.error());
    return std::nullopt;
  }

  void read_edge(const std::vector<Word>& words) {
    ++edges_read_;
    if (words.size() != 3) {
      return problems_.add(words[0].place, std::to_string(words.size()) + " words",
                           "'source' weight 'target'");
    }
    const std::optional<NodeIndex> source = nodes_.find(words[0].text, words[0].place);
    const std::optional<Ticks> weight = number(words[1]);
    const std::optional<NodeIndex> target = nodes_.find(words[2].text, words[2].place);
    if (source && weight && target) edges_.push_back({*source, *target, *weight, words[0].place});
  }

  void read_link(const std::vector<Word>& words) {
    ++links_read_;
    if (words.size() != 4) {
      return problems_.add(words[0].place, std::to_string(words.size()) + " words",
                           "'activation' min max 'contingent'");
    }
    const std::optional<NodeIndex> from = nodes_.find(words[0].text, words[0].place);
    const std::optional<Ticks> min = number(words[1]);
    const std::optional<Ticks> max = number(words[2]);
    const std::optional<NodeIndex> to = nodes_.find(words[3].text, words[3].place);
    if (!from || !min || !max || !to) return;
    if (nodes_.names()[*to] == kOrigin) links_.set_origin(*to);
    links_.add(ContingentLink{*from, *to, *min, *max}, words[0].place);
  }

  Stnu assemble() {
    if (!any_header_) problems_.add({}, "nothing to read", "a network");
    check_count(node_count_, nodes_.names().size(), "time-points");
    check_count(edge_count_, edges_read_, "ordinary edges");
    check_count(link_count_, links_read_, "contingent links");
    Stnu network{nodes_.names(), 0, arcs_from(edges_, nodes_, problems_), links_.take_contingent()};
    append_fixed(network.arcs, links_.take_arcs());
    choose_origin(network, kOrigin);
    return network;
  }

  Problems& problems_;
  NameTable nodes_;
  LinkTable links_;
  std::vector<Edge> edges_;
  Section section_ = Section::kNone;
  bool any_header_ = false;
  int line_ = 0;
  std::optional<Count> node_count_, edge_count_, link_count_;
  std::size_t edges_read_ = 0;
  std::size_t links_read_ = 0;
};

}  // namespace

Stnu read_plain(std::string_view text, Problems& problems) {
  return PlainReader(problems).read(text);
}

Result<std::string, Failure> write_plain(const Stnu& network) {
  Result<std::vector<std::string>, Failure> names = names_with_origin(network, kOrigin);
  if (!names) return tl::unexpected(names.error());
  std::string nodes;
  for (std::string& name : *names) {
    if (name.find('\'') != std::string::npos) {
      return failure("the name " + in_quotes(name) + " has a quote");
    }
    name = "'" + name + "'";
    nodes += (nodes.empty() ? "" : " ") + name;
  }
  const std::vector<Edge> all = edges_from(network.arcs);
  std::string edges;
  for (const Edge& edge : all) {
    edges += (*names)[edge.source] + " " + seconds_text(edge.weight) + " " + (*names)[edge.target] +
             "\n";
  }
  std::string links;
  for (const ContingentLink& link : network.contingent) {
    links += (*names)[link.activation] + " " + seconds_text(link.min) + " " +
             seconds_text(link.max) + " " + (*names)[link.contingent] + "\n";
  }
  return "# KIND OF NETWORK\nSTNU\n# Num Time-Points\n" + std::to_string(names->size()) +
         "\n# Num Ordinary Edges\n" + std::to_string(all.size()) + "\n# Num Contingent Links\n" +
         std::to_string(network.contingent.size()) + "\n# Time-Point Names\n" + nodes +
         "\n# Ordinary Edges\n" + edges + "# Contingent Links\n" + links;
}

}  // namespace skein::temporal
