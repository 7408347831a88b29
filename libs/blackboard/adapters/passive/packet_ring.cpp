// SPDX-License-Identifier: Apache-2.0
#include "packet_ring.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <linux/filter.h>
#include <linux/if_ether.h>
#include <linux/if_packet.h>
#include <net/if.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>

namespace skein::blackboard::passive {
namespace {

constexpr unsigned kBlock = 1U << 20U, kBlocks = 16, kFrame = 2048;
/// A block that is not full is shown after so many milliseconds.
constexpr unsigned kShownAfter = 100;
constexpr std::size_t kUdpHeader = 8;

struct Interface {
  int index = 0;
  bool loopback = false;
};

std::optional<Interface> interface_of(const std::string& address) {
  ifaddrs* all = nullptr;
  if (getifaddrs(&all) != 0) return std::nullopt;
  const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> owner(all, &freeifaddrs);
  for (const ifaddrs* one = all; one != nullptr; one = one->ifa_next) {
    if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET) continue;
    sockaddr_in in{};
    std::memcpy(&in, one->ifa_addr, sizeof in);
    std::array<char, INET_ADDRSTRLEN> text{};
    inet_ntop(AF_INET, &in.sin_addr, text.data(), text.size());
    if (address == text.data())
      return Interface{static_cast<int>(if_nametoindex(one->ifa_name)),
                       (one->ifa_flags & IFF_LOOPBACK) != 0};
  }
  return std::nullopt;
}

/// UDP to these ports, whole. Over the loopback each packet passes twice: once as it comes.
std::array<sock_filter, 12> filter_of(bool loopback, unsigned first_port, unsigned last_port) {
  constexpr std::uint32_t kWay = static_cast<std::uint32_t>(SKF_AD_OFF + SKF_AD_PKTTYPE);
  constexpr std::uint32_t kNoWay = 255, kProtocolAt = 9, kFragmentAt = 6, kFragmented = 0x3fff;
  return {{{BPF_LD | BPF_B | BPF_ABS, 0, 0, kWay},
           {BPF_JMP | BPF_JEQ | BPF_K, 9, 0, loopback ? std::uint32_t{PACKET_OUTGOING} : kNoWay},
           {BPF_LD | BPF_B | BPF_ABS, 0, 0, kProtocolAt},
           {BPF_JMP | BPF_JEQ | BPF_K, 0, 7, IPPROTO_UDP},
           {BPF_LD | BPF_H | BPF_ABS, 0, 0, kFragmentAt},
           {BPF_JMP | BPF_JSET | BPF_K, 5, 0, kFragmented},
           {BPF_LDX | BPF_B | BPF_MSH, 0, 0, 0},
           {BPF_LD | BPF_H | BPF_IND, 0, 0, 2},
           {BPF_JMP | BPF_JGE | BPF_K, 0, 2, first_port},
           {BPF_JMP | BPF_JGT | BPF_K, 1, 0, last_port},
           {BPF_RET | BPF_K, 0, 0, 0xffff},
           {BPF_RET | BPF_K, 0, 0, 0}}};
}

Failure refused(const std::string& what) {
  const std::string why = std::strerror(errno);
  const bool rights = errno == EPERM || errno == EACCES;
  return Failure{what + ": " + why +
                 (rights ? "; to look at what passes an interface takes CAP_NET_RAW" : "")};
}

template <class Value>
bool set(int socket, int option, const Value& value) {
  return setsockopt(socket, SOL_PACKET, option, &value, sizeof value) == 0;
}

}  // namespace

struct PacketRing::Impl {
  explicit Impl(int opened) : socket(opened) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    if (ring != nullptr) munmap(ring, std::size_t{kBlock} * kBlocks);
    close(socket);
  }
  std::uint8_t* block() const { return ring + std::size_t{kBlock} * next; }

  int socket;
  std::uint8_t* ring = nullptr;
  unsigned next = 0;
  std::uint64_t lost = 0;
};

Result<PacketRing, Failure> PacketRing::open(const std::string& address, unsigned first_port,
                                             unsigned last_port) {
  const auto interface = interface_of(address);
  if (!interface) return failure("no interface here has the address " + address);
  const int opened = socket(AF_PACKET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (opened < 0) return tl::unexpected(refused("looking at " + address));
  auto impl = std::make_unique<Impl>(opened);
  auto filter = filter_of(interface->loopback, first_port, last_port);
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  tpacket_req3 shape{};
  shape.tp_block_size = kBlock;
  shape.tp_block_nr = kBlocks;
  shape.tp_frame_size = kFrame;
  shape.tp_frame_nr = kBlock / kFrame * kBlocks;
  shape.tp_retire_blk_tov = kShownAfter;
  sockaddr_ll where{};
  where.sll_family = AF_PACKET;
  where.sll_protocol = htons(ETH_P_IP);
  where.sll_ifindex = interface->index;
  const bool shaped =
      setsockopt(opened, SOL_SOCKET, SO_ATTACH_FILTER, &program, sizeof program) == 0 &&
      set(opened, PACKET_VERSION, int{TPACKET_V3}) && set(opened, PACKET_RX_RING, shape);
  if (!shaped) return tl::unexpected(refused("looking at " + address));
  void* const ring =
      mmap(nullptr, std::size_t{kBlock} * kBlocks, PROT_READ | PROT_WRITE, MAP_SHARED, opened, 0);
  if (ring == MAP_FAILED) return tl::unexpected(refused("looking at " + address));
  impl->ring = static_cast<std::uint8_t*>(ring);
  if (bind(opened, reinterpret_cast<const sockaddr*>(&where), sizeof where) != 0)
    return tl::unexpected(refused("looking at " + address));
  return PacketRing(std::move(impl));
}

PacketRing::PacketRing(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PacketRing::PacketRing(PacketRing&&) noexcept = default;
PacketRing& PacketRing::operator=(PacketRing&&) noexcept = default;
PacketRing::~PacketRing() = default;

void PacketRing::take(const Use& use) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  for (unsigned looked = 0; looked < kBlocks; ++looked) {
    auto& header = reinterpret_cast<tpacket_block_desc*>(impl_->block())->hdr.bh1;
    if ((__atomic_load_n(&header.block_status, __ATOMIC_ACQUIRE) & TP_STATUS_USER) == 0) return;
    const std::uint8_t* at = impl_->block() + header.offset_to_first_pkt;
    for (std::uint32_t i = 0; i < header.num_pkts; ++i) {
      tpacket3_hdr packet{};
      std::memcpy(&packet, at, sizeof packet);
      const std::span<const std::uint8_t> ip(at + packet.tp_net, packet.tp_snaplen);
      const std::size_t before = ip.empty() ? 0 : (ip[0] & 0xfU) * 4U + kUdpHeader;
      if (ip.size() > before)
        use(ip.subspan(before), std::int64_t{packet.tp_sec} * kSecond + packet.tp_nsec);
      at += packet.tp_next_offset;
    }
    __atomic_store_n(&header.block_status, std::uint32_t{TP_STATUS_KERNEL}, __ATOMIC_RELEASE);
    impl_->next = (impl_->next + 1) % kBlocks;
  }
}

std::uint64_t PacketRing::lost() {
  tpacket_stats_v3 counts{};  // since the last time it was asked for
  socklen_t size = sizeof counts;
  if (getsockopt(impl_->socket, SOL_PACKET, PACKET_STATISTICS, &counts, &size) == 0)
    impl_->lost += counts.tp_drops;
  return impl_->lost;
}

}  // namespace skein::blackboard::passive
