// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/ros/messages.h"
#include "backend/ros/qos_profile.h"
#include "devices/dds/participant.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace teleta::dds {

/// What is known of a sample besides its message.
struct SampleInfo {
    std::int64_t sent_ns = 0; ///< of the clock of the computer that sent it, since 1970
    std::uint64_t writer = 0; ///< the same for all samples of a writer
};

/// A reader or a writer of a topic. Thread: any.
class Endpoint {
public:
    Endpoint(Endpoint&& other) noexcept;
    Endpoint& operator=(Endpoint&&) = delete;
    Endpoint(const Endpoint&) = delete;
    Endpoint& operator=(const Endpoint&) = delete;
    ~Endpoint();

    [[nodiscard]] std::int32_t entity() const { return m_entity; }
    /// What names it in the domain.
    [[nodiscard]] Guid guid() const;
    /// How many ends of other programs, and of this one, are connected to it.
    [[nodiscard]] std::size_t matched() const;
    /// Why the last end that wanted other qualities is not connected; nothing: there was none.
    [[nodiscard]] std::optional<ros::QosMismatch> incompatible() const;

protected:
    Endpoint(std::shared_ptr<const Participant> participant, std::int32_t entity, bool reads);

    std::shared_ptr<const Participant> m_participant;
    std::int32_t m_entity;
    bool m_reads;
};

/// Reads a topic whose type is known when it is opened. Thread: take() from one.
class AnyReader : public Endpoint {
public:
    /// ddsTopic: with its prefix (ros::ddsTopicOf()). Failure: unavailable, another type has this topic in
    /// this program; refused, the permissions of a secured participant do not allow it.
    [[nodiscard]] static core::Expected<AnyReader> open(std::shared_ptr<const Participant> participant,
                                                        const std::string& ddsTopic,
                                                        const dds_topic_descriptor_t& type,
                                                        const ros::QosProfile& profile);

    /// Hands over all samples that have come since the last call, in their order; returns how many. The
    /// message is valid during the call.
    std::size_t takeAny(const std::function<void(const void* message, const SampleInfo&)>& take);

private:
    using Endpoint::Endpoint;
};

template <typename Message>
class Reader : public AnyReader {
public:
    [[nodiscard]] static core::Expected<Reader> open(std::shared_ptr<const Participant> participant,
                                                     const std::string& ddsTopic,
                                                     const ros::QosProfile& profile) {
        TELETA_TRY(AnyReader reader,
                   AnyReader::open(std::move(participant), ddsTopic, ros::descriptorOf<Message>(), profile));
        return Reader(std::move(reader));
    }

    template <typename Take>
    std::size_t take(const Take& take) {
        return takeAny([&take](const void* message, const SampleInfo& info) {
            take(*static_cast<const Message*>(message), info);
        });
    }

private:
    explicit Reader(AnyReader&& reader)
        : AnyReader(std::move(reader)) {}
};

class AnyWriter : public Endpoint {
public:
    /// As AnyReader::open().
    [[nodiscard]] static core::Expected<AnyWriter> open(std::shared_ptr<const Participant> participant,
                                                        const std::string& ddsTopic,
                                                        const dds_topic_descriptor_t& type,
                                                        const ros::QosProfile& profile);

    /// False: not sent within the time of the profile, or at all. Every text of the message is set.
    [[nodiscard]] bool writeAny(const void* message);

private:
    using Endpoint::Endpoint;
};

template <typename Message>
class Writer : public AnyWriter {
public:
    [[nodiscard]] static core::Expected<Writer> open(std::shared_ptr<const Participant> participant,
                                                     const std::string& ddsTopic,
                                                     const ros::QosProfile& profile) {
        TELETA_TRY(AnyWriter writer,
                   AnyWriter::open(std::move(participant), ddsTopic, ros::descriptorOf<Message>(), profile));
        return Writer(std::move(writer));
    }

    /// As writeAny().
    [[nodiscard]] bool write(const Message& message) { return writeAny(&message); }

private:
    explicit Writer(AnyWriter&& writer)
        : AnyWriter(std::move(writer)) {}
};

} // namespace teleta::dds
