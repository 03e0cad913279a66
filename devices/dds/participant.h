// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/dds/domain_config.h"
#include "devices/dds/security.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace teleta::dds {

/// Names a program, reader or writer in a domain.
using Guid = std::array<std::uint8_t, 16>;

/// Programs that security keeps out of a domain.
struct Refusals {
    std::uint64_t count = 0; ///< of reports; a program that is kept out tries again each second
    std::string reason;      ///< of the last one, translated; empty before the first

    [[nodiscard]] bool operator==(const Refusals&) const = default;
};

/// This program in a domain of DDS. Readers, writers and discovery live below it and keep it alive. The
/// domain stays open until the program ends, so that traffic comes back with an interface that was lost.
/// Thread: any.
class Participant {
public:
    /// The configuration is the one given; CYCLONEDDS_URI is ignored. Failure: unavailable, with what the
    /// middleware says of the interface; refused, the program uses this domain in another way already.
    /// userData: what other programs are told of this one. security: without it nothing is encrypted, and
    /// programs with it stay out of reach. Failure then also: as checkSecurity(); refused, the program has a
    /// secured participant in this domain already, or had one with other permissions: the middleware would
    /// apply the first ones.
    [[nodiscard]] static core::Expected<std::shared_ptr<const Participant>>
    open(const DomainConfig& config, std::string_view userData = {},
         const std::optional<Security>& security = {});
    /// Leaves the domain on a thread of its own and waits kLongestEnd_ns for that: it may never happen where
    /// an interface has lost its address. What hangs then hangs until the program ends.
    ~Participant();
    Participant(const Participant&) = delete;
    Participant& operator=(const Participant&) = delete;

    static constexpr std::int64_t kLongestEnd_ns = 2'000'000'000;

    [[nodiscard]] std::int32_t entity() const { return m_entity; }
    [[nodiscard]] const Guid& guid() const { return m_guid; }
    [[nodiscard]] const DomainConfig& config() const { return m_config; }
    /// Since it was opened. Of two programs with keys that do not accept each other, it may be the other one
    /// that tells. A program without keys is kept out silently.
    [[nodiscard]] Refusals refusals() const;

private:
    Participant(std::int32_t entity, DomainConfig config, bool secured);
    [[nodiscard]] static core::Expected<std::shared_ptr<const Participant>>
    join(const DomainConfig& config, std::string_view userData, const std::optional<Security>& security);

    std::int32_t m_entity;
    DomainConfig m_config;
    bool m_secured;
    Guid m_guid{};
};

} // namespace teleta::dds
