// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/ros/qos_profile.h"
#include "devices/dds/participant.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::dds {

/// A reader or a writer of some program in the domain.
struct FoundEnd {
    Guid guid{};
    Guid program{};
    std::string ddsTopic;
    std::string ddsType;
    ros::QosProfile profile; ///< longestBlocking_s is not told
    bool writes = false;
    bool own = false; ///< of this participant

    [[nodiscard]] bool operator==(const FoundEnd&) const = default;
};

/// Who is in the domain, as their programs tell it by themselves. Thread: one.
class Discovery {
public:
    /// Failure: as Participant::open().
    [[nodiscard]] static core::Expected<Discovery> open(std::shared_ptr<const Participant> participant);
    Discovery(Discovery&&) noexcept;
    Discovery& operator=(Discovery&&) = delete;
    Discovery(const Discovery&) = delete;
    Discovery& operator=(const Discovery&) = delete;
    ~Discovery();

    /// Ends that are there now, own ones too, in the order of topics.
    [[nodiscard]] std::vector<FoundEnd> ends() const;
    /// The same of one topic.
    [[nodiscard]] std::vector<FoundEnd> endsOf(std::string_view ddsTopic) const;

    /// Other programs that are there now, whether or not they have topics.
    [[nodiscard]] std::size_t otherPrograms() const;

private:
    explicit Discovery(std::shared_ptr<const Participant> participant);

    std::shared_ptr<const Participant> m_participant;
    std::int32_t m_programs = 0;
    std::int32_t m_writers = 0;
    std::int32_t m_readers = 0;
};

} // namespace teleta::dds
