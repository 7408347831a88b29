// SPDX-License-Identifier: Apache-2.0
#include "request_body.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limits.hpp"

namespace skein::console {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(RequestBody, SaysWhoAsksForWhat) {
  const auto request = request_of(R"({"who":"eva","number":3,"actions":[{"take":"marvin"}]})");
  ASSERT_TRUE(request.has_value());
  EXPECT_EQ(request->who, "eva");
  EXPECT_EQ(request->number, 3U);
  EXPECT_EQ(request->request, R"([{"take":"marvin"}])");
}

TEST(RequestBody, IsRefusedWithEveryProblem) {
  const auto request = request_of(R"({"number":-1,"actions":{}})");
  ASSERT_FALSE(request.has_value());
  EXPECT_THAT(request.error(),
              ElementsAre(HasSubstr("who:"), HasSubstr("number:"), HasSubstr("actions:")));
}

TEST(RequestBody, ThatIsNestedTooDeeplyIsRefusedWhateverTheStack) {
  std::string actions(kRequestBytes / 2 - 40, '[');
  actions.append(actions.size(), ']');
  const auto request = request_of(R"({"who":"eva","number":3,"actions":)" + actions + "}");
  ASSERT_FALSE(request.has_value());
  EXPECT_THAT(request.error(), ElementsAre("nested too deeply"));
}

TEST(RequestBody, ThatIsNestedTooDeeplyBehindAQuoteInATextIsRefused) {
  const auto request = request_of(R"({"why":"\"","who":"eva","number":3,"actions":)" +
                                  std::string(100, '[') + std::string(100, ']') + "}");
  ASSERT_FALSE(request.has_value());
  EXPECT_THAT(request.error(), ElementsAre("nested too deeply"));
}

TEST(RequestBody, BracketsInTextsAreNoNesting) {
  const std::string action = R"("\")" + std::string(100, '{') + '"';
  const auto request = request_of(R"({"who":"eva","number":3,"actions":[)" + action + "]}");
  ASSERT_TRUE(request.has_value()) << request.error().front();
  EXPECT_EQ(request->request, "[" + action + "]");
}

}  // namespace
}  // namespace skein::console
