// SPDX-License-Identifier: Apache-2.0
// Our own format, and what all formats share.
#include "skein/temporal_files/network_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnostics_text.hpp"

namespace skein::temporal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kSmall = R"({
  "nodes": ["v0", "a", "b"],
  "arcs": [
    {"from": "v0", "to": "a", "min": 0, "max": 12.5},
    {"from": "a", "to": "b", "min": null, "max": null}
  ],
  "contingent": [
    {"from": "a", "to": "b", "min": 1, "max": 2.000000001}
  ]
})";

std::string errors(std::string_view text) { return errors_of(read_network(text)); }

// A network with this in its arrays "arcs" and "contingent".
std::string with(const std::string& arcs, const std::string& contingent = "") {
  return R"({"nodes":["v0","a","b"],"arcs":[)" + arcs + R"(],"contingent":[)" + contingent + "]}";
}

std::string link(const std::string& from, const std::string& to, const std::string& min,
                 const std::string& max) {
  return R"({"from":")" + from + R"(","to":")" + to + R"(","min":)" + min + R"(,"max":)" + max +
         "}";
}

TEST(ReadNetwork, TakesAnEmptyListOfAgentsForANetworkOfNobody) {
  const auto own = read_network(
      R"({"agents":[],"nodes":["v0","a"],"arcs":[{"from":"v0","to":"a","min":1,"max":2}]})");
  const auto mastn = read_network(R"({"agents":[],"nodes":[],"arcs":[]})");

  ASSERT_EQ(errors_of(own), "");
  EXPECT_EQ(own->format, Format::kJson);
  EXPECT_EQ(own->network.arcs.size(), 1U);
  ASSERT_EQ(errors_of(mastn), "");
  EXPECT_EQ(mastn->format, Format::kMastn);
}

TEST(ReadNetwork, ReadsOurOwnFormat) {
  const Result<ReadNetwork, Diagnostics> read = read_network(kSmall);

  ASSERT_TRUE(read) << to_text(read.error());
  EXPECT_EQ(read->format, Format::kJson);
  EXPECT_THAT(read->network.nodes, ElementsAre("v0", "a", "b"));
  EXPECT_EQ(read->network.origin, 0U);
  EXPECT_THAT(read->network.arcs, ElementsAre(Arc{0, 1, 0, 12'500'000'000}, Arc{1, 2}));
  EXPECT_THAT(read->network.contingent,
              ElementsAre(ContingentLink{1, 2, 1'000'000'000, 2'000'000'001}));
}

TEST(ReadNetwork, TakesTheOriginThatIsNamed) {
  const auto read = read_network(R"({"origin":"z","nodes":["a","z"],"arcs":[]})");

  ASSERT_TRUE(read) << to_text(read.error());
  EXPECT_EQ(read->network.origin, 1U);
}

TEST(ReadNetwork, MakesAContingentLinkOfOneDurationARequirement) {
  const auto read = read_network(with("", link("a", "b", "3", "3")));

  ASSERT_TRUE(read) << to_text(read.error());
  EXPECT_TRUE(read->network.contingent.empty());
  EXPECT_THAT(read->network.arcs, ElementsAre(Arc{1, 2, 3'000'000'000, 3'000'000'000}));
}

TEST(ReadNetwork, SaysWhereAnErrorIsAndWhatWasExpected) {
  const auto read = read_network(
      "{\n \"nodes\": [\"v0\", \"alpha\"],\n \"arcs\": [\n  {\"from\": "
      "\"alhpa\", \"to\": \"v0\", \"min\": 0, \"max\": \"x\"}]}",
      "plan.json");

  ASSERT_FALSE(read);
  ASSERT_EQ(read.error().size(), 2U);
  const Diagnostic& name = read.error().all()[0];
  EXPECT_EQ(to_text(name),
            "plan.json:4:12: arcs[0].from: unknown node 'alhpa'; did you mean 'alpha'?");
  const Diagnostic& number = read.error().all()[1];
  EXPECT_EQ(to_text(number),
            "plan.json:4:50: arcs[0].max: this is a string; expected a number of "
            "seconds, or null for no bound");
}

TEST(ReadNetwork, NamesEachErrorOfALink) {
  EXPECT_THAT(errors(with(link("a", "c", "0", "1"))), HasSubstr("unknown node 'c'"));
  EXPECT_THAT(errors(with(link("a", "a", "0", "1"))), HasSubstr("from 'a' to itself"));
  EXPECT_THAT(errors(with(link("a", "b", "2", "1"))), HasSubstr("min 2 is greater than max 1"));
  EXPECT_THAT(errors(with(link("a", "b", "0", "1") + "," + link("a", "b", "0", "9"))),
              HasSubstr("the arc from 'a' to 'b' is there twice"));
  EXPECT_THAT(errors(with(link("a", "b", "0", "1e10"))), HasSubstr("'1e10' overflows"));
  EXPECT_THAT(errors(with(link("a", "b", "0", "1e-10"))), HasSubstr("finer than a nanosecond"));
  EXPECT_THAT(errors(with(link("a", "b", "0", "1e999"))), HasSubstr("a number out of range"));
  EXPECT_THAT(errors(with(link("a", "b", "0", "NaN"))), HasSubstr("'NaN' is not a number"));
  EXPECT_THAT(errors(with(link("a", "b", "0", "\"NaN\""))), HasSubstr("this is a string"));
}

TEST(ReadNetwork, NamesEachErrorOfAContingentLink) {
  EXPECT_THAT(errors(with("", link("a", "b", "0", "1"))), HasSubstr("min 0 is not positive"));
  EXPECT_THAT(errors(with("", link("a", "b", "-1", "1"))), HasSubstr("min -1 is not positive"));
  EXPECT_THAT(errors(with("", link("a", "b", "null", "1"))), HasSubstr("min -inf is not positive"));
  EXPECT_THAT(errors(with("", link("a", "b", "1", "null"))), HasSubstr("max is infinite"));
  EXPECT_THAT(errors(with("", link("a", "b", "2", "1"))), HasSubstr("greater than max"));
  EXPECT_THAT(errors(with("", link("a", "v0", "1", "2"))), HasSubstr("ends in the origin 'v0'"));
  EXPECT_THAT(errors(with("", link("a", "b", "1", "2") + "," + link("v0", "b", "1", "2"))),
              HasSubstr("a second contingent link ends in 'b'"));
}

TEST(ReadNetwork, AcceptsArcsBothWays) {
  EXPECT_EQ(errors(with(link("a", "b", "0", "1") + "," + link("b", "a", "0", "1"))), "");
}

TEST(ReadNetwork, NamesEachErrorOfTheDocument) {
  EXPECT_THAT(errors(R"({"nodes":["v0"]})"), HasSubstr("missing key 'arcs'"));
  EXPECT_THAT(errors(R"({"nodes":["a"],"arcs":[]})"), HasSubstr("no origin"));
  EXPECT_THAT(errors(R"({"nodes":["v0","v0"],"arcs":[]})"), HasSubstr("'v0' is there twice"));
  EXPECT_THAT(errors(R"({"nodes":["v0",""],"arcs":[]})"), HasSubstr("nodes[1]: an empty name"));
  EXPECT_THAT(errors(R"({"nodes":["v0","a\u0007"],"arcs":[]})"), HasSubstr("control characters"));
  EXPECT_THAT(errors(R"({"nodes":["v0"],"arcs":{}})"), HasSubstr("arcs: this is an object"));
  EXPECT_THAT(errors(R"({"nodes":["v0"],"arcs":[],"contigent":[]})"),
              HasSubstr("unknown key 'contigent'; did you mean 'contingent'?"));
  EXPECT_THAT(errors(R"({"nodes":["v0"],"nodes":["v0"],"arcs":[]})"),
              HasSubstr("1:17: key 'nodes' comes twice"));
  EXPECT_THAT(errors("[]"), HasSubstr("this is an array; expected an object"));
  EXPECT_THAT(errors(R"({"nodes":[)"), HasSubstr("the text ends too early"));
  EXPECT_THAT(errors("{\"nodes\":[\"v0\"],\n\"arcs\":[],}"),
              StartsWith("line 2:11: not JSON at '}'"));
  EXPECT_THAT(errors("{\"nodes\": [" + std::string(30, '[') + "]}"), HasSubstr("nested more than"));
}

TEST(ReadNetwork, ReportsAllErrorsUpToABound) {
  std::string arcs = link("x", "y", "0", "1");
  for (int i = 0; i < 200; ++i) arcs += "," + link("x", "y", "0", "1");

  const auto read = read_network(with(arcs));

  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().size(), 101U);
  EXPECT_EQ(read.error().all().back().message, "more errors, not shown");
}

TEST(ReadNetwork, NamesWhatIsNoNetworkAtAll) {
  EXPECT_THAT(errors(""), HasSubstr("nothing to read; expected a network"));
  EXPECT_THAT(errors("hello\nworld"), HasSubstr("no format that is known begins like this"));
  EXPECT_THAT(errors(std::string(kLongestText + 1, ' ')), HasSubstr("longer than 67108864 bytes"));
}

TEST(ReadNetwork, TakesAByteOrderMark) {
  EXPECT_EQ(errors("\xEF\xBB\xBF" + std::string(kSmall)), "");
}

TEST(ReadNetwork, ShowsNoControlCharactersInItsErrors) {
  const std::string text = errors(R"({"nodes":["v0"],"arcs":[{"from":"\u001b[31m"}]})");

  EXPECT_THAT(text, HasSubstr("?[31m"));
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
}

TEST(FormatNames, AreThoseThatAreRead) {
  for (const std::string& name : format_names()) {
    ASSERT_TRUE(format_named(name)) << name;
    EXPECT_EQ(name_of(*format_named(name)), name);
  }
  EXPECT_EQ(format_named("xml"), std::nullopt);
}

TEST(WriteNetwork, FailsWhereTheFormatCannotHoldTheNetwork) {
  const Stnu two_origins{{"v0", "Z", "it's"}, 0, {}, {}};

  EXPECT_EQ(write_network(two_origins, Format::kGraphml).error().why,
            "the format calls the origin 'Z', and another node has that name");
  EXPECT_EQ(write_network({{"it's", "Z"}, 1, {}, {}}, Format::kPlain).error().why,
            "the name 'it's' has a quote");
  EXPECT_FALSE(write_network(two_origins, Format::kMastn));
  EXPECT_TRUE(write_network(two_origins, Format::kJson));
}

TEST(WithoutUncertainty, AppendsTheContingentLinksAsArcs) {
  const Stn stn = without_uncertainty({{"v0", "a"}, 0, {{0, 1, 0, 9}}, {{0, 1, 1, 2}}});

  EXPECT_THAT(stn.arcs, ElementsAre(Arc{0, 1, 0, 9}, Arc{0, 1, 1, 2}));
}

}  // namespace
}  // namespace skein::temporal
