// SPDX-License-Identifier: BSD-3-Clause
#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <memory>
#include <thread>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "core/wire/writer.h"
#include "monitor/front/doctor/checks.h"

namespace galilean::front {
namespace {

bool has_interface(unsigned flags) {
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) return false;
  const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> all(first, freeifaddrs);
  for (const ifaddrs* one = first; one; one = one->ifa_next)
    if ((one->ifa_flags & flags) == flags && one->ifa_addr && one->ifa_addr->sa_family == AF_INET)
      return true;
  return false;
}

/// Returns whether a message that this process sends through Cyclone comes back to it within 2 s.
bool arrives(wire::Participant& participant) {
  const std::string topic = "rt/galilean_doctor_" + std::to_string(getpid());
  wire::Reader reader(participant, topic, msg::Command::kRosType);
  wire::Writer<msg::Command> writer(participant, topic);
  bool arrived = false;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(2);
  while (!arrived && std::chrono::steady_clock::now() < deadline) {
    if (writer.readers() > 0 && !writer.write({})) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    reader.take([&](const wire::Received&) { arrived = true; });
  }
  return arrived;
}

}  // namespace

Check check_port(int port) {
  const std::string what = "port " + std::to_string(port);
  const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int reuse = 1;
  setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &reuse, sizeof reuse);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const bool free =
      bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  const int problem = errno;
  close(listener);
  if (free) return {what, true, "free for the page"};
  return {what, false, std::strerror(problem),
          "a monitor may run already; if none does, choose another port by --port or --listen"};
}

Check check_loopback() {
  if (has_interface(IFF_UP | IFF_LOOPBACK))
    return {"loopback", true, "programs on this machine can hear one another"};
  return {"loopback", false, "no loopback interface is up", "ip link set lo up"};
}

Check check_multicast() {
  if (has_interface(IFF_UP | IFF_MULTICAST))
    return {"multicast", true, "robots on other machines are found by themselves"};
  return {
      "multicast", true,
      "no interface has it; programs on this machine find one another without it; for robots on "
      "other machines set GALILEAN_PEERS to their addresses"};
}

Check check_dds(int domain) try {
  const auto participant = wire::Participant::join("doctor", domain);
  if (!participant)
    return {"DDS", false, participant.error().message, "see docs/WIRE.md, 'Finding one another'"};
  if (arrives(*participant.value())) return {"DDS", true, "joined, and a message came through"};
  return {"DDS", false, "joined, but no message came through within 2 s",
          "check CYCLONEDDS_URI and the firewall"};
} catch (const std::exception& error) {
  return {"DDS", false, error.what(), "check CYCLONEDDS_URI"};
}

}  // namespace galilean::front
