#include "tools/ros/dds/dds_domain.hpp"

#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <dds/dds.h>
#include <fmt/format.h>

namespace castaway::testbed {
namespace {

/// Errors of the library, which it says while it opens a domain.
std::string& said() {
  static std::string text;
  return text;
}

void hear(void*, const dds_log_data_t* data) {
  if ((data->priority & (DDS_LC_ERROR | DDS_LC_FATAL)) == 0) return;
  said() = data->message;
  std::erase(said(), '\n');
}

/// On this machine alone, participants find each other by the address 127.0.0.1, without multicast,
/// as those of ROS 2 do (ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST).
constexpr const char* kLocalDiscovery =
    "<ParticipantIndex>auto</ParticipantIndex>"
    "<MaxAutoParticipantIndex>32</MaxAutoParticipantIndex>"
    "<SPDPInterval>1s</SPDPInterval>"  // So long may a node wait that comes later.
    R"(<Peers><Peer address="127.0.0.1"/></Peers>)";

/// Without hashes of keys, Fast DDS does not understand who has gone.
std::string xml_of(const std::string& interfaces, bool local) {
  return fmt::format(R"(<CycloneDDS><Domain id="any"><General><Interfaces>{}</Interfaces>)"
                     "<AllowMulticast>{}</AllowMulticast></General><Discovery>{}</Discovery>"
                     "<Internal><GenerateKeyhash>true</GenerateKeyhash></Internal></Domain>"
                     "</CycloneDDS>",
                     interfaces, local ? "false" : "default", local ? kLocalDiscovery : "");
}

/// Configurations, of which the first is taken that works. Nodes on this machine state the address
/// of its network interface, or 127.0.0.1: packets to either go by the loopback device.
std::vector<std::string> configurations(const DdsNetwork& network) {
  const std::string any = R"(<NetworkInterface autodetermine="true"/>)";
  const std::string loopback = R"(<NetworkInterface address="127.0.0.1"/>)";
  if (network.interface == "loopback") {
    return {xml_of(any + loopback, true), xml_of(loopback, true)};  // There may be no network.
  }
  if (network.interface == "any") return {xml_of(any, false)};
  return {xml_of(fmt::format(R"(<NetworkInterface name="{}"/>)", network.interface), false)};
}

/// Names of interfaces need no quoting in XML.
void check(const DdsNetwork& network) {
  if (network.domain < 0 || network.domain > 232) {
    throw std::runtime_error(fmt::format("domain {} is not within 0 to 232", network.domain));
  }
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '.' || c == '_' || c == '-' || c == '@' || c == ':';
  };
  if (network.interface.empty() || !std::ranges::all_of(network.interface, is_plain)) {
    throw std::runtime_error("'" + network.interface + "' is no network interface");
  }
}

std::int32_t open_domain(const DdsNetwork& network) {
  check(network);
  said().clear();
  dds_set_log_sink(hear, nullptr);
  dds_set_trace_sink(hear, nullptr);
  dds_entity_t domain = DDS_RETCODE_ERROR;
  for (const std::string& xml : configurations(network)) {
    if (domain > 0) break;
    domain = dds_create_domain(static_cast<dds_domainid_t>(network.domain), xml.c_str());
  }
  if (domain < 0 && !said().empty()) {
    throw std::runtime_error(fmt::format("cannot open domain {} on interface '{}': {}",
                                         network.domain, network.interface, said()));
  }
  return domain;
}

/// CycloneDDS receives from all interfaces, whichever it sends on: those sockets of this process
/// that are bound to any address get the loopback device.
void bind_to_loopback() {
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    const int file = std::atoi(entry.path().filename().c_str());
    int kind = 0;
    socklen_t size = sizeof(kind);
    sockaddr_in address{};
    socklen_t length = sizeof(address);
    if (getsockopt(file, SOL_SOCKET, SO_TYPE, &kind, &size) != 0 || kind != SOCK_DGRAM) continue;
    if (getsockname(file, reinterpret_cast<sockaddr*>(&address), &length) != 0) continue;
    if (address.sin_family != AF_INET || address.sin_addr.s_addr != htonl(INADDR_ANY)) continue;
    if (setsockopt(file, SOL_SOCKET, SO_BINDTODEVICE, "lo", 3) == 0) continue;
    throw std::runtime_error(std::string("cannot listen on the loopback interface alone: ") +
                             std::strerror(errno));
  }
}

}  // namespace

DdsDomain::DdsDomain(const DdsNetwork& network)
    : network_(network),
      domain_(open_domain(network), fmt::format("open domain {}", network.domain)) {
  if (network.interface == "loopback") bind_to_loopback();
}

std::shared_ptr<DdsDomain> DdsDomain::join(const DdsNetwork& network) {
  static std::map<int, std::weak_ptr<DdsDomain>> domains;
  std::weak_ptr<DdsDomain>& known = domains[network.domain];
  std::shared_ptr<DdsDomain> domain = known.lock();
  if (!domain) known = domain = std::make_shared<DdsDomain>(network);
  if (domain->network().interface == network.interface) return domain;
  throw std::runtime_error(fmt::format("domain {} is open on interface '{}', not on '{}'",
                                       network.domain, domain->network().interface,
                                       network.interface));
}

}  // namespace castaway::testbed
