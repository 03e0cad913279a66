// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/dds/discovery.h"

#include "devices/dds/dds_error.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <dds/dds.h>
#include <functional>
#include <tuple>
#include <utility>

namespace teleta::dds {

namespace {

struct DiscoveryText {
    Q_DECLARE_TR_FUNCTIONS(DdsDiscovery)
};

constexpr std::size_t kMostEnds = 4096;

Guid guidOf(const dds_guid_t& guid) {
    Guid result{};
    std::ranges::copy(guid.v, result.begin());
    return result;
}

ros::QosProfile profileOf(const dds_qos_t* qos) {
    ros::QosProfile profile;
    dds_reliability_kind_t reliability = DDS_RELIABILITY_BEST_EFFORT;
    dds_durability_kind_t durability = DDS_DURABILITY_VOLATILE;
    dds_duration_t blocking_ns = 0;
    if (dds_qget_reliability(qos, &reliability, &blocking_ns) && reliability == DDS_RELIABILITY_RELIABLE)
        profile.reliability = ros::Reliability::reliable;
    if (dds_qget_durability(qos, &durability) && durability != DDS_DURABILITY_VOLATILE)
        profile.durability = ros::Durability::transientLocal;
    return profile;
}

/// Hands over what is alive of a topic of the middleware itself, and leaves it there.
void readAlive(std::int32_t reader, const std::function<void(const void*)>& take) {
    std::vector<void*> samples(kMostEnds, nullptr);
    std::vector<dds_sample_info_t> infos(kMostEnds);
    const dds_return_t count =
        dds_read_mask(reader, samples.data(), infos.data(), kMostEnds, kMostEnds,
                      DDS_ANY_SAMPLE_STATE | DDS_ANY_VIEW_STATE | DDS_ALIVE_INSTANCE_STATE);
    for (dds_return_t i = 0; i < count; ++i) {
        if (infos[static_cast<std::size_t>(i)].valid_data)
            take(samples[static_cast<std::size_t>(i)]);
    }
    if (count > 0)
        (void)dds_return_loan(reader, samples.data(), count);
}

} // namespace

Discovery::Discovery(std::shared_ptr<const Participant> participant)
    : m_participant(std::move(participant)) {
}

Discovery::Discovery(Discovery&& other) noexcept
    : m_participant(std::move(other.m_participant))
    , m_programs(std::exchange(other.m_programs, 0))
    , m_writers(std::exchange(other.m_writers, 0))
    , m_readers(std::exchange(other.m_readers, 0)) {
}

Discovery::~Discovery() {
    for (const std::int32_t reader : {m_programs, m_writers, m_readers}) {
        if (reader > 0)
            (void)dds_delete(reader);
    }
}

core::Expected<Discovery> Discovery::open(std::shared_ptr<const Participant> participant) {
    Discovery discovery(std::move(participant));
    const std::int32_t parent = discovery.m_participant->entity();
    for (const auto& [member, topic] :
         {std::pair{&Discovery::m_programs, DDS_BUILTIN_TOPIC_DCPSPARTICIPANT},
          std::pair{&Discovery::m_writers, DDS_BUILTIN_TOPIC_DCPSPUBLICATION},
          std::pair{&Discovery::m_readers, DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION}}) {
        discovery.*member = dds_create_reader(parent, topic, nullptr, nullptr);
        if (discovery.*member < 0)
            return ddsFailure(DiscoveryText::tr("other programs of the domain cannot be found"),
                              discovery.*member);
    }
    return discovery;
}

std::vector<FoundEnd> Discovery::ends() const {
    std::vector<FoundEnd> found;
    for (const bool writes : {true, false}) {
        readAlive(writes ? m_writers : m_readers, [&](const void* sample) {
            const auto& end = *static_cast<const dds_builtintopic_endpoint_t*>(sample);
            const Guid program = guidOf(end.participant_key);
            found.push_back({guidOf(end.key), program, end.topic_name, end.type_name, profileOf(end.qos),
                             writes, program == m_participant->guid()});
        });
    }
    std::ranges::sort(found, {},
                      [](const FoundEnd& end) { return std::tie(end.ddsTopic, end.writes, end.guid); });
    return found;
}

std::vector<FoundEnd> Discovery::endsOf(std::string_view ddsTopic) const {
    std::vector<FoundEnd> found = ends();
    std::erase_if(found, [&](const FoundEnd& end) { return end.ddsTopic != ddsTopic; });
    return found;
}

std::size_t Discovery::otherPrograms() const {
    std::size_t count = 0;
    readAlive(m_programs, [&](const void* sample) {
        const auto& program = *static_cast<const dds_builtintopic_participant_t*>(sample);
        count += guidOf(program.key) == m_participant->guid() ? 0 : 1;
    });
    return count;
}

} // namespace teleta::dds
