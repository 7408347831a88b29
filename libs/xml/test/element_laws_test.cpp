// SPDX-License-Identifier: Apache-2.0
// Trees drawn at random, written by a writer of the test's own and read back.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "skein/foundation/markup.hpp"
#include "skein/foundation/random.hpp"
#include "skein/xml/element.hpp"

namespace skein::xml {
namespace {

std::string any_name(Random& random) {
  static const std::vector<std::string> kNames = {"a", "wpt", "gx:Track", "x-y", "é", "_1"};
  return kNames[random.below(kNames.size())];
}

std::string any_text(Random& random) {
  static const std::vector<std::string> kParts = {"<", ">", "&", "\"", "'",
                                                  " ", "ã", "🚁", "x",  "]]>"};
  std::string text;
  for (std::uint64_t i = random.below(5); i > 0; --i) text += kParts[random.below(kParts.size())];
  return text;
}

Element any_element(Random& random, int depth) {
  Element element;
  element.name = any_name(random);
  std::set<std::string> taken;
  for (std::uint64_t i = random.below(3); i > 0; --i) {
    const std::string name = any_name(random);
    if (taken.insert(name).second) element.attributes.emplace_back(name, any_text(random));
  }
  element.text = any_text(random);
  for (std::uint64_t i = depth > 0 ? random.below(4) : 0; i > 0; --i)
    element.children.push_back(any_element(random, depth - 1));
  return element;
}

/// Writes it, each tag in a line of its own after what stands before, and notes where it stands.
class Scribe {
 public:
  std::string text;

  void write(Element& element) {
    element.line = line_;
    element.column = static_cast<int>(text.size() - line_begin_) + 1;
    text += "<" + element.name;
    for (const auto& [name, value] : element.attributes)
      text += " " + name + "='" + escaped_markup(value) + "'";
    text += ">" + escaped_markup(element.text);
    for (Element& child : element.children) {
      text += "<!--\n-->";
      ++line_;
      line_begin_ = text.size() - 3;
      write(child);
    }
    text += "</" + element.name + ">";
  }

 private:
  int line_ = 1;
  std::size_t line_begin_ = 0;
};

void expect_same(const Element& read, const Element& meant) {
  EXPECT_EQ(read.name, meant.name);
  EXPECT_EQ(read.text, meant.text);
  EXPECT_EQ(read.attributes, meant.attributes);
  EXPECT_EQ(read.line, meant.line) << meant.name;
  EXPECT_EQ(read.column, meant.column) << meant.name;
  ASSERT_EQ(read.children.size(), meant.children.size());
  for (std::size_t i = 0; i < meant.children.size(); ++i)
    expect_same(read.children[i], meant.children[i]);
}

TEST(ElementLaws, ATreeIsReadBackAsItWasWrittenAndWhereItStands) {
  Random random(31);
  for (int trial = 0; trial < 300; ++trial) {
    Element meant = any_element(random, 4);
    Scribe scribe;
    scribe.write(meant);

    const auto read = parse(scribe.text, "f.xml", Encoding::kUtf8);

    ASSERT_TRUE(read.has_value()) << to_text(read.error()) << "\n" << scribe.text;
    expect_same(*read, meant);
  }
}

TEST(ElementLaws, NoPartOfATextIsATree) {
  Random random(32);
  for (int trial = 0; trial < 20; ++trial) {
    Element meant = any_element(random, 2);
    Scribe scribe;
    scribe.write(meant);
    for (std::size_t size = 0; size < scribe.text.size(); ++size) {
      const auto read = parse(scribe.text.substr(0, size), "f.xml", Encoding::kUtf8);
      ASSERT_FALSE(read.has_value()) << scribe.text.substr(0, size);
      EXPECT_EQ(read.error().file, "f.xml");
      EXPECT_EQ(read.error().message.rfind("not XML: ", 0), 0U) << read.error().message;
    }
  }
}

std::size_t count_of(const Element& element) {
  std::size_t count = 1;
  for (const Element& child : element.children) count += count_of(child);
  return count;
}
std::size_t depth_of(const Element& element) {
  std::size_t deepest = 0;
  for (const Element& child : element.children) deepest = std::max(deepest, depth_of(child));
  return deepest + 1;
}

TEST(ElementLaws, ExactlyWhatIsWithinTheLimitsIsRead) {
  Random random(33);
  for (int trial = 0; trial < 200; ++trial) {
    Element meant = any_element(random, 3);
    Scribe scribe;
    scribe.write(meant);
    const std::size_t count = count_of(meant), depth = depth_of(meant);
    const auto fits = [&](Limits limits) {
      return parse(scribe.text, "", Encoding::kUtf8, limits).has_value();
    };

    EXPECT_TRUE(fits({depth, count}));
    EXPECT_FALSE(fits({depth - 1, count}));
    EXPECT_FALSE(fits({depth, count - 1}));
  }
}

struct NoXml {
  const char* text;
  const char* told;
};

TEST(Element, EachThingThatIsNoXmlIsToldWithItsPlace) {
  const std::vector<NoXml> all = {
      {"", "f.xml:1:1: not XML: no element found"},
      {"text", "f.xml:1:1: not XML: syntax error"},
      {"<a/>\n<b/>", "f.xml:2:1: not XML: junk after document element"},
      {"<a\n x='1'\n x='2'/>", "f.xml:3:2: not XML: duplicate attribute"},
      {"<a>&none;</a>", "f.xml:1:4: not XML: undefined entity"},
      {"<a x=1/>", "f.xml:1:6: not XML: not well-formed (invalid token)"},
      {"<a>\n\x01</a>", "f.xml:2:1: not XML: not well-formed (invalid token)"},
      {"<a>\xff</a>", "f.xml:1:4: not XML: not well-formed (invalid token)"},
      {"<!DOCTYPE a><a/>", "f.xml:1:12: a document type declaration; expected none"},
  };
  for (const NoXml& one : all) {
    const auto read = parse(one.text, "f.xml");
    ASSERT_FALSE(read.has_value()) << one.text;
    EXPECT_EQ(to_text(read.error()), one.told) << one.text;
  }
}

TEST(Element, TextOfCdataIsTextAndAttributesAreFoundByName) {
  const auto read = parse("<a b='1' c='2'><![CDATA[x < y]]> &amp; z</a>", "f.xml");

  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->text, "x < y & z");
  EXPECT_EQ(*read->attribute("c"), "2");
}

}  // namespace
}  // namespace skein::xml
