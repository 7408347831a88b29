// SPDX-License-Identifier: Apache-2.0
// What was written is read back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "recorded.hpp"

namespace skein::mcap {
namespace {

using ::testing::IsEmpty;

RC_GTEST_PROP(RoundTrip, GivesEveryMessageInOrderByEveryCompression, ()) {
  const auto messages = *rc::gen::container<std::vector<Told>>(any_message());
  const std::string file =
      written(messages, *any_compression(), *rc::gen::inRange<std::size_t>(1, 600));

  const Read back = read(file);

  RC_ASSERT(back.messages == messages);
  RC_ASSERT(back.contents.messages == messages.size());
  RC_ASSERT(back.contents.complete);
  RC_ASSERT(back.contents.problems.empty());
}

TEST(RoundTrip, GivesSchemasChannelsAndMetadata) {
  std::string file;
  Writer writer({"skein 0.1", "x", Compression::kLz4, 1000},
                [&](std::string_view bytes) { file.append(bytes); });
  const Schema schema{"foxglove.Log", "jsonschema", "{\"type\":\"object\"}"};
  const Channel channel{writer.add(schema), "/log", "json", {{"k", "v"}, {"", "empty"}}};
  const ChannelId id = writer.add(channel);
  writer.metadata("run", {{"seed", "7"}});
  writer.write(id, 5, "{}");
  writer.close();

  const Read back = read(file);

  EXPECT_EQ(back.contents.library, "skein 0.1");
  EXPECT_EQ(back.contents.profile, "x");
  EXPECT_EQ(back.contents.schemas.at(1), schema);
  EXPECT_EQ(back.contents.channels.at(id), channel);
  EXPECT_EQ(back.contents.metadata.at("run").at("seed"), "7");
}

TEST(RoundTrip, OfNothingIsAWholeFile) {
  const Read back = read(written({}, Compression::kZstd));

  EXPECT_TRUE(back.contents.complete);
  EXPECT_THAT(back.contents.problems, IsEmpty());
}

// 0x00 in magic and lengths, in data, in names: nothing ends at a zero.
TEST(RoundTrip, KeepsZeroBytes) {
  const std::vector<Told> messages{{std::string("a\0b", 3), 1, 2, std::string(70, '\0')}};

  EXPECT_EQ(read(written(messages, Compression::kNone)).messages, messages);
}

}  // namespace
}  // namespace skein::mcap
