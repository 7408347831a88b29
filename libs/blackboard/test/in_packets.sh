#!/usr/bin/env bash
# The laws of large and long events over an interface that carries 1,500 bytes in a packet, in a network namespace of its own; then: no
# datagram was cut up. Skipped (77) where no namespace can be made.  in_packets.sh TEST-PROGRAM
set -u
user=(); [ "$(id -u)" = 0 ] || user=(--map-root-user)
unshare "${user[@]}" --net true 2>/dev/null || { echo "SKIPPED: network namespaces cannot be made here"; exit 77; }
exec unshare "${user[@]}" --net bash -euc '
ip link set lo up mtu 1500 multicast on
"$0" --gtest_filter="BlackboardLaws.ALargeEventGoesThroughWhole:*Long*"
cut=$(awk "/^Ip:/ { if (!n) for (i = 1; i <= NF; ++i) if (\$i == \"FragCreates\") n = i; line = \$n } END { print line }" /proc/net/snmp)
echo "pieces of datagrams: $cut"
[ "$cut" = 0 ]
' "$1"
