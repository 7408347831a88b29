// SPDX-License-Identifier: Apache-2.0
// Limits on the resources that browsers may use.
#pragma once

#include <cstddef>
#include <string_view>

namespace skein::console {

inline constexpr unsigned kConnections = 128;
inline constexpr unsigned kConnectionsOfOneAddress = 96;
inline constexpr unsigned kSecondsOfSilence = 30;  ///< of a connection that is not a stream
inline constexpr std::size_t kStreams = 32;
inline constexpr std::size_t kRequestBytes = 65'536;
inline constexpr std::string_view kAnnexPaths = "/api/designer/";
inline constexpr std::size_t kAnnexBytes = 1'048'576;  ///< of one request there: texts of models
/// Largest body of a request [byte].
constexpr std::size_t most_bytes(std::string_view path) {
  return path.starts_with(kAnnexPaths) ? kAnnexBytes : kRequestBytes;
}
inline constexpr std::size_t kRequestsWaiting = 64;    ///< for the daemon to take them
inline constexpr std::size_t kEvents = 4096;           ///< kept for who comes late
inline constexpr std::size_t kEventBytes = 4'194'304;  ///< of these
inline constexpr std::size_t kChunk = 65'536;          ///< [byte] written to a stream at once

}  // namespace skein::console
