// SPDX-License-Identifier: Apache-2.0
#include "source_addresses.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

namespace skein::blackboard::rtps {
namespace {

/// What others announce takes no more memory than this.
constexpr std::size_t kMostAnswers = 1024;
constexpr std::uint16_t kAnyPort = 9;  // nothing is sent

/// A socket that is connected has the source that its datagrams would have.
std::optional<Address> ask_the_system(Address destination) {
  const int file = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (file < 0) return std::nullopt;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(kAnyPort);
  address.sin_addr.s_addr = htonl(destination);
  socklen_t size = sizeof address;
  auto* const generic = reinterpret_cast<sockaddr*>(&address);
  const bool found = connect(file, generic, size) == 0 && getsockname(file, generic, &size) == 0;
  close(file);
  if (!found) return std::nullopt;
  return ntohl(address.sin_addr.s_addr);
}

}  // namespace

std::string to_text(Address address) {
  in_addr in{htonl(address)};
  std::array<char, INET_ADDRSTRLEN> text{};
  return inet_ntop(AF_INET, &in, text.data(), text.size());
}

std::optional<Address> parse_ipv4(const std::string& text) {
  in_addr in{};
  if (inet_pton(AF_INET, text.c_str(), &in) != 1) return std::nullopt;
  return ntohl(in.s_addr);
}

SourceAddresses::SourceAddresses(std::vector<Address> own, Ask ask)
    : own_(std::move(own)), ask_(std::move(ask)) {}

SourceAddresses::SourceAddresses(std::vector<Address> own)
    : SourceAddresses(std::move(own), ask_the_system) {}

bool SourceAddresses::is_for(Address source, Address destination, Clock::time_point now) {
  auto found = answers_.find(destination);
  if (found == answers_.end() || now - found->second.asked >= kAskedAgain) {
    if (answers_.size() >= kMostAnswers) answers_.clear();
    found = answers_.insert_or_assign(destination, Answer{source_for(destination), now}).first;
  }
  return !found->second.source || *found->second.source == source;
}

std::optional<Address> SourceAddresses::source_for(Address destination) const {
  const auto source = ask_(destination);
  const bool is_own = source && std::ranges::find(own_, *source) != own_.end();
  return is_own ? source : std::nullopt;
}

}  // namespace skein::blackboard::rtps
