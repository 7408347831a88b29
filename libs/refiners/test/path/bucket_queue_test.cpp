// SPDX-License-Identifier: Apache-2.0
#include "path/bucket_queue.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <vector>

#include "skein/foundation/random.hpp"

namespace skein::refiners {
namespace {

TEST(BucketQueue, GivesTheLastPutInFirstAmongEquals) {
  BucketQueue queue(10);
  queue.push(3, 1);
  queue.push(3, 2);
  queue.push(2, 3);

  EXPECT_EQ(queue.pop(), 3U);
  EXPECT_EQ(queue.priority(), 2);
  EXPECT_EQ(queue.pop(), 2U);
  EXPECT_EQ(queue.pop(), 1U);
  EXPECT_TRUE(queue.empty());
}

RC_GTEST_PROP(BucketQueueProperty, GivesThemAsASortedStackWould, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const auto span = static_cast<std::int64_t>(1 + random.below(random.chance(0.5) ? 5 : 3000));
  BucketQueue queue(span);
  std::map<std::int64_t, std::vector<std::uint64_t>> model;
  const auto start = static_cast<std::int64_t>(random.below(1U << 20U));
  queue.start_at(start);
  std::int64_t now = start;
  std::uint64_t next = 0;

  for (int i = 0; i < 12'000; ++i) {
    if (model.empty() || random.chance(i < 9000 ? 0.6 : 0.3)) {
      const auto above =
          static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(span) + 1));
      queue.push(now + above, next);
      model[now + above].push_back(next++);
      continue;
    }
    const auto least = model.begin();
    RC_ASSERT(queue.pop() == least->second.back());
    RC_ASSERT(queue.priority() == least->first);
    now = least->first;
    least->second.pop_back();
    if (least->second.empty()) model.erase(least);
  }
  RC_ASSERT(queue.empty() == model.empty());
}

}  // namespace
}  // namespace skein::refiners
