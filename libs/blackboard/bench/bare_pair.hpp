// SPDX-License-Identifier: Apache-2.0
// Request and reply over bare Fast DDS, with the types that fastddsgen generates.
#pragma once

#include <cstdint>
#include <memory>

namespace skein::blackboard::bench {

/// One writer and one reader, of the QoS of an event slot, and nothing else: no sessions, no
/// checks, no header. What comes is taken by a listener and handed to the waiting thread, as a
/// program does that works outside the threads of its middleware.
class BareSide {
 public:
  enum class Role : std::uint8_t { kAsks, kAnswers };
  BareSide(std::uint32_t domain, Role role);
  BareSide(const BareSide&) = delete;
  BareSide& operator=(const BareSide&) = delete;
  ~BareSide();

  /// Asks and waits for the answer; false if none comes within 5 s.
  bool ask(std::uint64_t command);
  /// Answers for ever.
  void serve();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::blackboard::bench
