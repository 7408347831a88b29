// SPDX-License-Identifier: Apache-2.0
// The inputs from which the fuzzer of the wire types starts. Slots have moved since some were made:
// what was a TeamMessage was read as another type and refused at its first bytes.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "skein/blackboard/cdr.hpp"
#include "testing/random_sample.hpp"

namespace skein::blackboard {
namespace {

using testing::for_each_slot_type;
using testing::random_value;
using Bytes = std::vector<std::uint8_t>;

std::string file_of(wire::Slot slot) {
  return SKEIN_CORPUS "/" + std::string(wire::kSlotNames[static_cast<std::size_t>(slot)]);
}

Bytes content_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write(const wire::Sample& sample) {
  Bytes bytes = in_cdr(sample);
  bytes.insert(bytes.begin(), static_cast<std::uint8_t>(wire::slot_of(sample)));
  std::ofstream(file_of(wire::slot_of(sample)), std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

/// With elements in its lists, as its rows are what is easily read wrongly.
template <class T>
wire::Sample ample(Random& random) {
  wire::Sample most = random_value<T>(random);
  for (int i = 0; i < 40; ++i) {
    const wire::Sample other = random_value<T>(random);
    if (encoded_size(other) > encoded_size(most)) most = other;
  }
  return most;
}

TEST(FuzzCorpus, HasASampleOfEverySlotThatIsReadAsWhatItsNameSays) {
  Random random(1);
  for_each_slot_type([&]<class T>() {
    const wire::Sample ours = ample<T>(random);
    const wire::Slot slot = wire::slot_of(ours);
    if (std::getenv("SKEIN_WRITE_CORPUS") != nullptr) write(ours);  // after a change of idl/
    const Bytes bytes = content_of(file_of(slot));

    ASSERT_GT(bytes.size(), 1U) << file_of(slot) << " is not there";
    EXPECT_EQ(bytes[0], static_cast<std::uint8_t>(slot)) << file_of(slot);
    const auto decoded = decode(slot, std::span(bytes).subspan(1));
    const auto* sample = std::get_if<wire::Sample>(&decoded);
    ASSERT_NE(sample, nullptr) << file_of(slot);
    EXPECT_EQ(encoded_size(*sample), bytes.size() - 1) << file_of(slot);
  });
}

}  // namespace
}  // namespace skein::blackboard
