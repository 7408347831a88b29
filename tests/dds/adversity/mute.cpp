// SPDX-License-Identifier: Apache-2.0
// What a process sends by UDP: preloaded (LD_PRELOAD), and nothing without these variables,
//   ADVERSITY_MUTE "0,6"     it takes for sent, and does not send, what goes to the ports of the
//   DDS
//                            participants of these numbers, whatever their domain. What goes to
//                            everybody by multicast goes.
//   ADVERSITY_HANDSHAKE "1"  it stops itself (SIGSTOP) before its first message of a handshake of
//                            DDS Security, so that who heard of it waits for that in vain.
#include <arpa/inet.h>
#include <dlfcn.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/types.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>

namespace {

// Of RTPS: domain d starts at port 7400 + 250 d, its participant p has two from 10 + 2 p after.
constexpr int kFirst = 7400, kOfDomain = 250, kOfParticipants = 10;

std::set<int> numbers_of_variable() {
  std::set<int> numbers;
  const char* const given = std::getenv("ADVERSITY_MUTE");
  if (given == nullptr) return numbers;
  std::istringstream words(given);
  for (std::string word; std::getline(words, word, ',');) numbers.insert(std::stoi(word));
  return numbers;
}

bool is_unheard(const void* address, socklen_t size) {
  static const std::set<int> numbers = numbers_of_variable();
  if (numbers.empty() || address == nullptr || size < sizeof(sockaddr_in)) return false;
  const auto* to = static_cast<const sockaddr_in*>(address);
  const int port = ntohs(to->sin_port);
  if (to->sin_family != AF_INET || port < kFirst) return false;
  const int of_domain = (port - kFirst) % kOfDomain;
  return of_domain >= kOfParticipants && numbers.count((of_domain - kOfParticipants) / 2) > 0;
}

/// Who writes the messages of handshakes: BuiltinParticipantStatelessMessageWriter of RTPS.
constexpr std::array<std::byte, 4> kHandshakes{std::byte{0}, std::byte{2}, std::byte{1},
                                               std::byte{0xc3}};

bool is_of_handshake(const void* bytes, std::size_t size) {
  const auto* const first = static_cast<const std::byte*>(bytes);
  const auto* const last = first + size;
  return std::search(first, last, kHandshakes.begin(), kHandshakes.end()) != last;
}

void stop_before_handshake(const void* bytes, std::size_t size) {
  static const bool wanted = std::getenv("ADVERSITY_HANDSHAKE") != nullptr;
  static std::atomic<bool> stopped{false};
  if (wanted && is_of_handshake(bytes, size) && !stopped.exchange(true)) raise(SIGSTOP);
}

}  // namespace

extern "C" ssize_t sendmsg(int socket, const msghdr* message, int flags) {
  using Function = ssize_t (*)(int, const msghdr*, int);
  static const auto real = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "sendmsg"));  // NOLINT
  for (std::size_t i = 0; i < message->msg_iovlen; ++i)
    stop_before_handshake(message->msg_iov[i].iov_base, message->msg_iov[i].iov_len);
  if (!is_unheard(message->msg_name, message->msg_namelen)) return real(socket, message, flags);
  std::size_t size = 0;
  for (std::size_t i = 0; i < message->msg_iovlen; ++i) size += message->msg_iov[i].iov_len;
  return static_cast<ssize_t>(size);
}

extern "C" ssize_t sendto(int socket, const void* bytes, size_t size, int flags, const sockaddr* to,
                          socklen_t length) {
  using Function = ssize_t (*)(int, const void*, size_t, int, const sockaddr*, socklen_t);
  static const auto real = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "sendto"));  // NOLINT
  stop_before_handshake(bytes, size);
  if (is_unheard(to, length)) return static_cast<ssize_t>(size);
  return real(socket, bytes, size, flags, to, length);
}
