// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::dds {

/// Highest number of a domain whose ports exist.
inline constexpr int kHighestDomain = 232;

/// Programs of one computer that are looked for in a domain. Each has a port of its own, from 7410 + 250 *
/// domain on in steps of 2.
inline constexpr int kProgramsPerComputer = 32;

/// Where other programs of DDS are. Discovery uses no multicast: it looks on this computer and at the peers.
struct DomainConfig {
    int domain = 0;                 ///< 0 .. kHighestDomain
    std::string interface;          ///< name or address; empty: the first that is not loopback
    std::vector<std::string> peers; ///< names or addresses of computers

    [[nodiscard]] bool operator==(const DomainConfig&) const = default;
};

/// Whether it names the interface within this computer. Thread: any (pure).
[[nodiscard]] bool isLoopback(std::string_view interface);

/// The configuration of Cyclone DDS, as XML. priority: real-time priority of the threads that receive and
/// send, which the user must be allowed; empty: they are ordinary ones. Thread: any (pure). Source: Cyclone
/// DDS 0.10, options.md.
[[nodiscard]] std::string configurationOf(const DomainConfig& config, std::optional<int> priority = {});

/// The domain that the environment variable ROS_DOMAIN_ID names, 0 without it. Failure: badInput, it names
/// none. Thread: any, while nobody changes the environment.
[[nodiscard]] core::Expected<int> defaultDomain();

} // namespace teleta::dds
