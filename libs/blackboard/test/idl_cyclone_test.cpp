// SPDX-License-Identifier: Apache-2.0
// The wire structs against what idlc makes of idl/*.idl: same fields from our bytes, same bytes
// back.
#include <cyclone/event.h>
#include <cyclone/state.h>
#include <cyclone/stream.h>
#include <dds/ddsi/ddsi_cdrstream.h>
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "skein/blackboard/cdr.hpp"
#include "testing/random_sample.hpp"

namespace skein::blackboard {
namespace {

using testing::random_value;
using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t kXcdr1 = 1;
constexpr std::size_t kEncapsulation = 4;

/// Compares a wire struct with its C image.
class SameFields {
 public:
  template <class T, class C>
  void operator()(const char* name, const T& value, const C& image) {
    EXPECT_TRUE(same(value, image)) << name;
  }

 private:
  template <class T, class C>
  bool same(const T& value, const C& image) {
    if constexpr (wire::kIsRecord<T>) {
      visit_pairs(*this, value, image);
      return true;
    } else if constexpr (wire::WireEnum<T>) {
      return static_cast<std::uint32_t>(value) == static_cast<std::uint32_t>(image);
    } else {
      return value == image;
    }
  }
  bool same(const std::string& value, const char* const& image) { return value == image; }
  template <class T, class C>
  bool same(const std::vector<T>& values, const C& image) {
    if (values.size() != image._length) return false;
    bool all = true;
    for (std::size_t i = 0; i < values.size(); ++i) all = all && same(values[i], image._buffer[i]);
    return all;
  }
  bool same(const std::vector<std::string>& values, const dds_sequence_string& image) {
    if (values.size() != image._length) return false;
    bool all = true;
    for (std::size_t i = 0; i < values.size(); ++i) all = all && values[i] == image._buffer[i];
    return all;
  }
};

template <class C, class T>
void expect_conformance(const dds_topic_descriptor_t& descriptor) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const T value = random_value<T>(random);
    const wire::Sample sample = value;
    Bytes bytes = in_cdr(sample);
    const auto size = static_cast<std::uint32_t>(bytes.size() - kEncapsulation);
    C image{};
    dds_istream_t in;
    dds_istream_init(&in, size, bytes.data() + kEncapsulation, kXcdr1);
    dds_ostream_t out;
    dds_ostream_init(&out, 0, kXcdr1);

    dds_stream_read(&in, reinterpret_cast<char*>(&image), descriptor.m_ops);
    dds_stream_write(&out, reinterpret_cast<const char*>(&image), descriptor.m_ops);

    SameFields same_fields;
    visit_pairs(same_fields, value, image);
    ASSERT_EQ(out.m_index, size);
    EXPECT_EQ(std::memcmp(out.m_buffer, bytes.data() + kEncapsulation, size), 0);
    dds_ostream_fini(&out);
    dds_stream_free_sample(&image, descriptor.m_ops);
  }
  EXPECT_STREQ(descriptor.m_typename,
               ("skein::idl::" + std::string(wire::slot_name(wire::slot_of(T{})))).c_str());
  EXPECT_EQ(descriptor.m_nkeys, 3U);
}

#define SKEIN_CONFORMANCE_TEST(T) \
  TEST(IdlConformance, T) { expect_conformance<skein_idl_##T, wire::T>(skein_idl_##T##_desc); }

SKEIN_FOR_EACH_SLOT(SKEIN_CONFORMANCE_TEST)

}  // namespace
}  // namespace skein::blackboard
