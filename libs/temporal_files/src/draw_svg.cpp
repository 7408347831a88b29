// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "drawn_links.hpp"
#include "layered_layout.hpp"
#include "picture_strips.hpp"
#include "readers.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/foundation/markup.hpp"

namespace skein::temporal {

namespace {

constexpr std::size_t kMostBends = 60'000;
// All in pixels.
constexpr double kMargin = 24;
constexpr double kTitleHeight = 34;
constexpr double kLegendHeight = 40;
constexpr double kNarrowest = 460;  // for the legend
constexpr double kTitleSize = 16;
constexpr double kNameSize = 14;
constexpr double kDateSize = 10.5;
constexpr double kLabelSize = 11.5;
constexpr double kCharacter = 0.57;  // mean width of a character by its size
constexpr double kArrow = 8;
constexpr double kWidestStrip = 1600;  // of a picture that is folded
constexpr double kStripGap = 46;       // with the number of the strip
constexpr double kStripMargin = 4;     // above and below, for the thickness of lines

double text_width(std::string_view text, double size) {
  const auto characters = std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  });
  return kCharacter * size * static_cast<double>(characters);
}

std::string px(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", value);
  return text.data();
}

std::string at(double x, double y) { return px(x) + "," + px(y); }

struct TextStyle {
  double size = kNameSize;
  const char* colour = kInk;
  const char* anchor = "middle";
  const char* more = "";
};

class SvgPicture {
 public:
  SvgPicture(const Stnu& network, const DrawingOptions& options)
      : network_(network),
        options_(options),
        links_(drawn_links(network, options.conflict)),
        nodes_(drawn_nodes(network, links_)) {
    for (const DrawnLink& link : links_) {
      if (link.from == link.to) loops_ += loop_text(link);
    }
    std::erase_if(links_, [](const DrawnLink& link) { return link.from == link.to; });
  }

  Result<std::string, Failure> draw() {
    const std::optional<Layout> layout = lay_out(boxes(), edges(), kMostBends);
    if (!layout) return failure("too many long links to be told apart; try --dot and Graphviz");
    const std::vector<Strip> strips = strips_of(*layout, kWidestStrip);
    if (strips.size() > 1) return draw_folded(*layout, strips);
    const double width =
        std::max({layout->width, text_width(options_.title, kTitleSize), kNarrowest});
    top_ = kMargin + (options_.title.empty() ? 0 : kTitleHeight);
    left_ = kMargin + (width - layout->width) / 2;
    const double height = top_ + layout->height + kLegendHeight + kMargin;
    start(width + 2 * kMargin, height);
    title();
    draw_content(*layout);
    legend(height - kMargin);
    return svg_ + "</svg>\n";
  }

 private:
  // The whole once, shown strip by strip below each other.
  std::string draw_folded(const Layout& layout, const std::vector<Strip>& strips) {
    draw_content(layout);
    const std::string plan = std::exchange(svg_, "");
    double width = std::max(text_width(options_.title, kTitleSize), kNarrowest);
    for (const Strip& strip : strips) width = std::max(width, strip.width());
    const double row = layout.height + 2 * kStripMargin + kStripGap;
    double y = kMargin + (options_.title.empty() ? 0 : kTitleHeight);
    const double height = y + row * static_cast<double>(strips.size()) + kLegendHeight;
    start(width + 2 * kMargin, height);
    title();
    svg_ += "<defs><g id=\"plan\">\n" + plan + "</g></defs>\n";
    for (std::size_t i = 0; i < strips.size(); ++i, y += row) {
      text(kMargin, y + kLabelSize,
           std::to_string(i + 1) + " of " + std::to_string(strips.size()) +
               (i + 1 < strips.size() ? ", continued below" : ""),
           {kLabelSize, kQuietInk, "start", ""});
      show_strip(strips[i], y + 2 * kLabelSize, layout.height + 2 * kStripMargin);
    }
    legend(height - kMargin);
    return svg_ + "</svg>\n";
  }

  void show_strip(const Strip& strip, double y, double height) {
    const std::string size = " width=\"" + px(strip.width()) + "\" height=\"" + px(height) + "\"";
    svg_ += "<svg x=\"" + px(kMargin) + "\" y=\"" + px(y) + "\"" + size + " viewBox=\"" +
            px(strip.begin) + " " + px(-kStripMargin) + " " + px(strip.width()) + " " + px(height) +
            "\"><use xlink:href=\"#plan\"/></svg>\n";
    for (const double x : {kMargin, kMargin + strip.width()}) {
      svg_ += "<path d=\"M" + at(x, y) + " v" + px(height) + "\" stroke=\"" + kQuietInk +
              "\" stroke-width=\"0.6\" stroke-dasharray=\"2 4\"/>\n";
    }
  }

  void title() {
    text(kMargin, kMargin + kTitleSize, options_.title,
         {kTitleSize, kInk, "start", " font-weight=\"600\""});
  }

  void draw_content(const Layout& layout) {
    draw_links(layout);
    for (NodeIndex i = 0; i < nodes_.size(); ++i) draw_node(i, layout.nodes[place_of(i)]);
  }

  // A link from a node to itself has no place in layers: it is said below the picture.
  std::string loop_text(const DrawnLink& link) const {
    return "; not drawn: " + network_.nodes[link.from] + " to itself, " +
           bounds_text(link.min, link.max);
  }

  // The layout begins with its node 0: the origin and the first node change places.
  NodeIndex place_of(NodeIndex node) const {
    if (node == network_.origin) return 0;
    return node == 0 ? network_.origin : node;
  }

  std::vector<LayoutBox> boxes() const {
    const bool dated = !options_.windows.empty();
    std::vector<LayoutBox> all;
    for (NodeIndex place = 0; place < nodes_.size(); ++place) {
      const NodeIndex node = place_of(place);
      double width = text_width(network_.nodes[node], kNameSize);
      if (dated) {
        width = std::max(width, text_width(window_text(options_.windows[node]), kDateSize));
      }
      all.push_back({std::max(width + 20, 44.0), dated ? 42.0 : 30.0});
    }
    return all;
  }

  std::vector<LayoutEdge> edges() const {
    std::vector<LayoutEdge> all;
    for (const DrawnLink& link : links_) {
      const double width = text_width(bounds_text(link.min, link.max), kLabelSize) + 6;
      LayoutEdge edge{place_of(link.from), place_of(link.to), {width, 2 * kLabelSize + 6}};
      if (link.is_backwards()) std::swap(edge.from, edge.to);
      all.push_back(edge);
    }
    return all;
  }

  void start(double width, double height) {
    svg_ =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"" +
        px(width) + "\" height=\"" + px(height) + "\" viewBox=\"0 0 " + px(width) + " " +
        px(height) +
        "\" font-family=\"Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  }

  void text(double x, double y, std::string_view words, const TextStyle& style) {
    if (words.empty()) return;
    svg_ += "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" font-size=\"" + px(style.size) +
            "\" fill=\"" + style.colour + "\" text-anchor=\"" + style.anchor + "\"" + style.more +
            ">" + escaped_markup(words) + "</text>\n";
  }

  // What is in the conflict lies on top, and labels above all lines.
  void draw_links(const Layout& layout) {
    for (const bool red : {false, true}) {
      for (std::size_t i = 0; i < links_.size(); ++i) {
        if (links_[i].in_conflict == red) draw_line(links_[i], layout.edges[i]);
      }
    }
    for (std::size_t i = 0; i < links_.size(); ++i) draw_label(links_[i], layout.edges[i]);
  }

  void draw_line(const DrawnLink& link, const RoutedEdge& route) {
    std::vector<Station> stations = route.stations;
    // The arrow is at `to`; of a link laid out the other way round that is the first station.
    if (link.is_backwards()) std::reverse(stations.begin(), stations.end());
    if (link.is_backwards()) {
      for (Station& one : stations) std::swap(one.x_in, one.x_out);
    }
    const Station tip = stations.back();
    const double before = stations[stations.size() - 2].x_out;
    const double direction = before < tip.x_in ? 1 : -1;
    stations.back().x_in -= direction * (kArrow - 1);
    const std::string width = link.in_conflict ? "2.4" : "1.3";
    svg_ += "<path d=\"" + path(stations) + "\" fill=\"none\" stroke=\"" + link.colour() +
            "\" stroke-width=\"" + width + "\"" +
            (link.contingent ? " stroke-dasharray=\"7 4\"" : "") + "/>\n";
    const double x = left_ + tip.x_in;
    const double y = top_ + tip.y;
    const double half = link.in_conflict ? 4.2 : 3.2;
    svg_ += "<path d=\"M" + at(x, y) + " L" + at(x - direction * kArrow, y - half) + " L" +
            at(x - direction * kArrow, y + half) + " Z\" fill=\"" + link.colour() + "\"/>\n";
  }

  std::string path(const std::vector<Station>& stations) const {
    std::string d = "M" + at(left_ + stations.front().x_out, top_ + stations.front().y);
    for (std::size_t i = 1; i < stations.size(); ++i) {
      const Station& a = stations[i - 1];
      const Station& b = stations[i];
      const double middle = left_ + (a.x_out + b.x_in) / 2;
      d += " C" + at(middle, top_ + a.y) + " " + at(middle, top_ + b.y) + " " +
           at(left_ + b.x_in, top_ + b.y);
      if (b.x_in != b.x_out && i + 1 < stations.size()) {
        d += " L" + at(left_ + b.x_out, top_ + b.y);
      }
    }
    return d;
  }

  void draw_label(const DrawnLink& link, const RoutedEdge& route) {
    const Station& station = route.stations[route.label];
    text(left_ + (station.x_in + station.x_out) / 2, top_ + station.y - 4,
         bounds_text(link.min, link.max),
         {kLabelSize, link.colour(), "middle",
          link.in_conflict
              ? " font-weight=\"600\" stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\""
              : " stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\""});
  }

  void draw_node(NodeIndex node, const Station& place) {
    const DrawnNode& drawn = nodes_[node];
    const bool dated = !options_.windows.empty();
    const double height = dated ? 42 : 30;
    const char* line = drawn.contingent ? kContingentInk : kRequirementInk;
    const char* fill = drawn.contingent ? "#fff6e2" : "#f4f7f9";
    const bool origin = node == network_.origin;
    svg_ += "<rect x=\"" + px(left_ + place.x_in) + "\" y=\"" + px(top_ + place.y - height / 2) +
            "\" width=\"" + px(place.x_out - place.x_in) + "\" height=\"" + px(height) +
            "\" rx=\"" + (drawn.contingent ? px(height / 2) : "6") + "\" fill=\"" +
            (origin ? "#dde5ea" : fill) + "\" stroke=\"" +
            (drawn.in_conflict ? kConflictInk : line) + "\" stroke-width=\"" +
            (drawn.in_conflict ? "2.2" : "1.3") + "\"" +
            (drawn.contingent ? " stroke-dasharray=\"7 4\"" : "") + "/>\n";
    const double x = left_ + (place.x_in + place.x_out) / 2;
    const double y = top_ + place.y;
    text(x, dated ? y - 1.5 : y + 5, network_.nodes[node],
         {kNameSize, kInk, "middle", origin ? " font-weight=\"600\"" : ""});
    if (dated) {
      text(x, y + 13, window_text(options_.windows[node]), {kDateSize, kQuietInk, "middle", ""});
    }
  }

  void legend(double y) {
    double x = kMargin;
    const auto sample = [&](const char* colour, const char* dash, const char* words) {
      svg_ += "<path d=\"M" + at(x, y - 4) + " h30\" stroke=\"" + colour +
              "\" stroke-width=\"1.8\"" + dash + "/>\n";
      text(x + 37, y, words, {kLabelSize, kQuietInk, "start", ""});
      x += 37 + text_width(words, kLabelSize) + 22;
    };
    sample(kRequirementInk, "", "requirement");
    if (!network_.contingent.empty()) {
      sample(kContingentInk, " stroke-dasharray=\"7 4\"", "contingent");
    }
    if (!options_.conflict.empty()) sample(kConflictInk, "", "conflict");
    text(x, y, (options_.windows.empty() ? "seconds" : "seconds; earliest … latest date") + loops_,
         {kLabelSize, kQuietInk, "start", ""});
  }

  const Stnu& network_;
  const DrawingOptions& options_;
  std::vector<DrawnLink> links_;
  std::vector<DrawnNode> nodes_;
  std::string loops_;  ///< links from a node to itself
  std::string svg_;
  double top_ = 0;
  double left_ = 0;
};

}  // namespace

std::optional<Failure> too_large_to_draw(const Stnu& network) {
  if (network.nodes.size() <= kMostDrawnNodes) return std::nullopt;
  return Failure{std::to_string(network.nodes.size()) + " nodes are too many for a picture (" +
                 std::to_string(kMostDrawnNodes) + " at most); try --dot and Graphviz"};
}

Result<std::string, Failure> draw_svg(const Stnu& network, const DrawingOptions& options) {
  SKEIN_EXPECTS(options.windows.empty() || options.windows.size() == network.nodes.size());
  if (std::optional<Failure> why = too_large_to_draw(network)) return tl::unexpected(*why);
  return SvgPicture(network, options).draw();
}

}  // namespace skein::temporal
