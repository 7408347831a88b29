// SPDX-License-Identifier: Apache-2.0
#include "skein/xml/element.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::xml {
namespace {

using ::testing::HasSubstr;

TEST(Element, HasItsAttributesItsTextAndItsPlace) {
  const auto root = parse("<a>\n  <b id='7'>one<c/>two</b>\n</a>", "f.xml");

  ASSERT_TRUE(root);
  EXPECT_EQ(root->name, "a");
  ASSERT_EQ(root->children.size(), 1U);
  const Element& b = root->children[0];
  EXPECT_EQ(b.text, "onetwo");
  ASSERT_NE(b.attribute("id"), nullptr);
  EXPECT_EQ(*b.attribute("id"), "7");
  EXPECT_EQ(b.attribute("name"), nullptr);
  EXPECT_EQ(b.line, 2);
  EXPECT_EQ(b.column, 3);
  EXPECT_EQ(b.children[0].name, "c");
}

TEST(Element, KeepsThePrefixOfAName) {
  const auto root = parse("<kml xmlns:gx='urn:x'><gx:Track/></kml>", "f.xml");

  ASSERT_TRUE(root);
  EXPECT_EQ(root->children[0].name, "gx:Track");
}

TEST(Element, WhatIsNotWellFormedIsToldWhereItStands) {
  const auto root = parse("<a>\n<b></a>", "f.xml");

  ASSERT_FALSE(root);
  EXPECT_EQ(to_text(root.error()), "f.xml:2:6: not XML: mismatched tag");
}

TEST(Element, ADocumentTypeIsRefusedBeforeItsEntitiesAreRead) {
  const auto root = parse("<!DOCTYPE a [<!ENTITY e 'eeee'>]><a>&e;&e;</a>", "f.xml");

  ASSERT_FALSE(root);
  EXPECT_THAT(root.error().message, HasSubstr("a document type declaration"));
}

TEST(Element, NestingIsBounded) {
  const Limits limits{3, 100};

  EXPECT_TRUE(parse("<a><b><c/></b></a>", "", Encoding::kDeclared, limits));
  const auto deeper = parse("<a><b><c><d/></c></b></a>", "", Encoding::kDeclared, limits);
  ASSERT_FALSE(deeper);
  EXPECT_EQ(deeper.error().message, "nested more than 3 deep");
  EXPECT_EQ(deeper.error().column, 10);
}

TEST(Element, AHundredThousandOpenTagsAreRefusedAndNotFollowed) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "<a>";

  const auto root = parse(text, "f.xml");

  ASSERT_FALSE(root);
  EXPECT_EQ(root.error().message, "nested more than 16 deep");
}

TEST(Element, TheNumberOfElementsIsBounded) {
  const auto root = parse("<a><b/><b/><b/></a>", "", Encoding::kDeclared, {16, 3});

  ASSERT_FALSE(root);
  EXPECT_EQ(root.error().message, "more than 3 elements");
}

TEST(Element, AnEncodingThatIsDeclaredCountsUnlessUtf8IsSaid) {
  const std::string latin = "<?xml version='1.0' encoding='ISO-8859-1'?><a>\xe9</a>";
  const std::string utf8 = "<?xml version='1.0' encoding='ISO-8859-1'?><a>\xc3\xa9</a>";

  EXPECT_EQ(parse(latin, "")->text, "\xc3\xa9");
  EXPECT_EQ(parse(utf8, "", Encoding::kUtf8)->text, "\xc3\xa9");
}

}  // namespace
}  // namespace skein::xml
