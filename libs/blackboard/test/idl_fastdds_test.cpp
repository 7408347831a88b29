// SPDX-License-Identifier: Apache-2.0
// The wire structs against what fastddsgen makes of idl/*.idl: same bytes, same fields, same keys.
#include <fastdds/eventPubSubTypes.h>
#include <fastdds/statePubSubTypes.h>
#include <fastdds/streamPubSubTypes.h>
#include <gtest/gtest.h>

#include <type_traits>

#include <vector>

#include "adapters/fastdds/sample_type.hpp"
#include "skein/blackboard/cdr.hpp"
#include "testing/random_sample.hpp"

namespace skein::blackboard {
namespace {

using eprosima::fastrtps::rtps::InstanceHandle_t;
using eprosima::fastrtps::rtps::SerializedPayload_t;
using testing::random_value;
using Bytes = std::vector<std::uint8_t>;

/// Copies a wire struct into its generated class.
class ToGenerated {
 public:
  template <class T, class G>
  void operator()(const char*, const T& value, G& generated) {
    copy(value, generated);
  }

 private:
  template <class T, class G>
  void copy(const T& value, G& generated) {
    if constexpr (wire::kIsRecord<T>) {
      visit_pairs(*this, value, generated);
    } else if constexpr (wire::WireEnum<T>) {
      generated = static_cast<G>(value);
    } else {
      generated = value;
    }
  }
  template <class T, class G>
  void copy(const std::vector<T>& values, std::vector<G>& generated) {
    generated.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) copy(values[i], generated[i]);
  }
};

template <class Type, class T>
Bytes generated_bytes(const T& value) {
  typename Type::type generated;
  ToGenerated to_generated;
  visit_pairs(to_generated, value, generated);
  Type type;
  SerializedPayload_t payload(type.getSerializedSizeProvider(&generated)());
  EXPECT_TRUE(type.serialize(&generated, &payload));
  return {payload.data, payload.data + payload.length};
}

template <class Type, class T>
void expect_same_key(const T& value) {
  typename Type::type generated;
  ToGenerated to_generated;
  visit_pairs(to_generated, value, generated);
  const wire::Sample sample = value;
  fastdds::Cargo cargo;
  cargo.outgoing = &sample;
  fastdds::SampleType ours(wire::slot_of(sample));
  Type theirs;
  for (const bool force_md5 : {false, true}) {
    InstanceHandle_t our_key;
    InstanceHandle_t their_key;

    ASSERT_TRUE(ours.getKey(&cargo, &our_key, force_md5));
    ASSERT_TRUE(theirs.getKey(&generated, &their_key, force_md5));

    EXPECT_EQ(our_key, their_key);
  }
  EXPECT_STREQ(ours.getName(), theirs.getName());
}

template <class Type, class T>
void expect_conformance() {
  if constexpr (std::is_same_v<T, wire::TeamMessage>) {
    GTEST_SKIP() << "what fastddsgen makes of sequences nested five deep counts its greatest size "
                    "for hours; Cyclone's image of it is compared";
  }
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const T value = random_value<T>(random);
    const wire::Sample sample = value;
    const Bytes ours = in_cdr(sample);

    ASSERT_EQ(ours, (generated_bytes<Type>(value))) << wire::to_text(sample);
  }
  expect_same_key<Type>(random_value<T>(random));
}

#define SKEIN_CONFORMANCE_TEST(T) \
  TEST(IdlConformance, T) { expect_conformance<idl::T##PubSubType, wire::T>(); }

SKEIN_FOR_EACH_SLOT(SKEIN_CONFORMANCE_TEST)

}  // namespace
}  // namespace skein::blackboard
