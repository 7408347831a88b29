// SPDX-License-Identifier: Apache-2.0
// Samples go into a file and come out as they were.
#include "recorder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/blackboard/cdr.hpp"

namespace skein::spy_tool {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

Taken taken(const wire::Sample& sample, const std::string& partition, std::uint64_t heard) {
  std::string bytes(blackboard::encoded_size(sample), '\0');
  blackboard::encode(sample, {reinterpret_cast<std::uint8_t*>(bytes.data()), bytes.size()});
  return {wire::slot_of(sample), partition, heard, heard - 1, bytes};
}

wire::MissionState phase(const std::string& name) {
  wire::MissionState state;
  state.phase = name;
  return state;
}

std::vector<Taken> some() {
  return {taken(phase("a"), "world", 10),
          taken(wire::Telemetry{}, "radio/marvin>ground", 20),
          taken(phase("b"), "world", 30),
          {wire::Slot::kTaskEvent, "radio/marvin>ground", 40, 39, "malformed"}};
}

std::string recorded(const std::vector<Taken>& samples, bool with_json) {
  std::string file;
  Recorder recorder(with_json, [&](std::string_view bytes) { file.append(bytes); });
  for (const Taken& one : samples) recorder.take(one);
  recorder.close();
  return file;
}

TEST(Recorder, KeepsBytesPartitionsAndTimesAlsoOfWhatIsMalformed) {
  for (const bool with_json : {false, true}) {
    std::vector<Taken> back;
    samples_of(recorded(some(), with_json), [&](Taken one) { back.push_back(std::move(one)); });

    EXPECT_EQ(back, some());
  }
}

TEST(Recorder, NamesTopicsSchemasAndEncodings) {
  const auto contents = mcap::scan(recorded(some(), false), [](const auto&, const auto&) {});

  std::vector<std::string> topics, schemas;
  for (const auto& [id, channel] : contents.channels) {
    topics.push_back(channel.topic);
    EXPECT_EQ(channel.encoding, "cdr");
  }
  for (const auto& [id, schema] : contents.schemas) {
    schemas.push_back(schema.name);
    EXPECT_EQ(schema.encoding, "omgidl");
    EXPECT_THAT(schema.data, HasSubstr("struct SampleHeader"));
  }
  EXPECT_THAT(topics, Contains("world/MissionState"));
  EXPECT_THAT(topics, Contains("radio/marvin>ground/Telemetry"));
  EXPECT_THAT(schemas, Contains("skein::idl::MissionState"));
}

TEST(Recorder, WithJsonHasEachWellFormedSampleOnceMore) {
  std::size_t json = 0;
  mcap::scan(recorded(some(), true),
             [&](const mcap::Channel& channel, const mcap::Message& message) {
               if (channel.encoding != "json") return;
               ++json;
               EXPECT_THAT(std::string(message.data), HasSubstr("\"slot\":"));
             });

  EXPECT_EQ(json, 3U);
}

TEST(SamplesOf, AFileOfSomebodyElseAreNone) {
  std::string file;
  mcap::Writer writer({}, [&](std::string_view bytes) { file.append(bytes); });
  const auto channel =
      writer.add(mcap::Channel{0, "/x", "cdr", {{"slot", "NoSlot"}, {"partition", ""}}});
  writer.write(channel, 1, "abc");
  writer.write(writer.add(mcap::Channel{0, "/y", "json"}), 1, "{}");
  writer.close();

  const auto contents = samples_of(file, [](Taken) { FAIL(); });

  EXPECT_TRUE(contents.complete);
}

}  // namespace
}  // namespace skein::spy_tool
