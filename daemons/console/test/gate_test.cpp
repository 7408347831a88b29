// SPDX-License-Identifier: Apache-2.0
#include "gate.hpp"

#include <gtest/gtest.h>

namespace skein::console {
namespace {

Asked get(const std::string& host = "127.0.0.1:8080", const std::string& path = "/api/events") {
  Asked asked;
  asked.method = "GET";
  asked.host = host;
  asked.path = path;
  return asked;
}

Asked post(const std::string& path = "/api/request") {
  Asked asked = get("127.0.0.1:8080", path);
  asked.method = "POST";
  asked.origin = "http://127.0.0.1:8080";
  asked.content_type = "application/json";
  asked.content_length = 10;
  return asked;
}

const Gate kOpen(8080, {"station.lan"}, "");
const Gate kClosed(8080, {}, "sesame");

TEST(Gate, LetsTheMachineItselfInByAddressAndName) {
  for (const char* host :
       {"127.0.0.1:8080", "localhost:8080", "10.0.0.1:8080", "station.lan:8080"}) {
    EXPECT_TRUE(kOpen.judge(get(host)).passes()) << host;
  }
}

TEST(Gate, RefusesAHostThatIsAnothersName) {
  for (const char* host : {"evil.example:8080", "localhost", "127.0.0.1:80", "", ":8080",
                           "127.0.0.1.evil.example:8080", "localhost:8080:8080"}) {
    EXPECT_EQ(kOpen.judge(get(host)).status, 421U) << host;
    EXPECT_EQ(kOpen.judge(get(host, "/")).status, 421U) << "static files too: " << host;
  }
}

TEST(Gate, RefusesPagesFromElsewhere) {
  Asked asked = post();
  for (const char* origin :
       {"http://evil.example", "null", "https://127.0.0.1:8080", "http://127.0.0.1:8081"}) {
    asked.origin = origin;
    EXPECT_EQ(kOpen.judge(asked).status, 403U) << origin;
  }
}

TEST(Gate, TakesOnlyJsonOfAKnownAndModestLength) {
  EXPECT_TRUE(kOpen.judge(post()).passes());
  Asked form = post();
  form.content_type = "text/plain";
  EXPECT_EQ(kOpen.judge(form).status, 415U);
  Asked chunked = post();
  chunked.chunked = true;
  EXPECT_EQ(kOpen.judge(chunked).status, 411U);
  Asked huge = post();
  huge.content_length = 300'000'000;
  EXPECT_EQ(kOpen.judge(huge).status, 413U);
  Asked put = post();
  put.method = "PUT";
  EXPECT_EQ(kOpen.judge(put).status, 405U);
}

TEST(Gate, ModelsMayBeLongerThanRequests) {
  Asked asked = post();
  asked.content_length = 500'000;
  asked.path = "/api/designer/look";
  EXPECT_TRUE(kOpen.judge(asked).passes());
  asked.content_length = 1'100'000;
  EXPECT_EQ(kOpen.judge(asked).status, 413U);
}

TEST(Gate, ARequestFromNoPageShowsThatItIsNoForm) {
  Asked asked = post();
  asked.origin.clear();
  EXPECT_EQ(kOpen.judge(asked).status, 403U);
  asked.authorization = "Bearer shell";
  EXPECT_TRUE(kOpen.judge(asked).passes());
}

TEST(Gate, WithATokenNothingButFilesAndTheExchangeGoesWithout) {
  EXPECT_EQ(kClosed.judge(get()).status, 401U);
  EXPECT_EQ(kClosed.judge(post()).status, 401U);
  EXPECT_TRUE(kClosed.judge(get("127.0.0.1:8080", "/app.js")).passes());
  EXPECT_TRUE(kClosed.judge(post("/api/session")).passes());
}

TEST(Gate, TakesTheTokenByCookieOrAsBearer) {
  Asked asked = get();
  asked.cookie = "skein-80=no; skein-8080=sesame";
  EXPECT_TRUE(kClosed.judge(asked).passes());
  asked.cookie = "skein-8080=sesam; xskein-8080=sesame";
  EXPECT_FALSE(kClosed.judge(asked).passes());
  asked.cookie.clear();
  asked.authorization = "Bearer sesame";
  EXPECT_TRUE(kClosed.judge(asked).passes());
  asked.authorization = "Bearer ";
  EXPECT_FALSE(kClosed.judge(asked).passes());
}

}  // namespace
}  // namespace skein::console
