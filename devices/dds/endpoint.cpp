// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/dds/endpoint.h"

#include "backend/core/failure.h"
#include "devices/dds/dds_error.h"
#include "devices/dds/dds_qos.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <dds/dds.h>
#include <utility>

namespace teleta::dds {

namespace {

struct DdsEndpoint {
    Q_DECLARE_TR_FUNCTIONS(DdsEndpoint)
};

Qos qosOf(const ros::QosProfile& profile, bool reads) {
    Qos qos(dds_create_qos());
    const auto duration = [](double time_s) { return static_cast<dds_duration_t>(time_s * 1e9); };
    const bool latched = profile.durability == ros::Durability::transientLocal;
    dds_qset_reliability(qos.get(),
                         profile.reliability == ros::Reliability::reliable ? DDS_RELIABILITY_RELIABLE
                                                                           : DDS_RELIABILITY_BEST_EFFORT,
                         duration(profile.longestBlocking_s));
    dds_qset_durability(qos.get(), latched ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
    dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, profile.depth);
    if (latched)
        dds_qset_durability_service(qos.get(), 0, DDS_HISTORY_KEEP_LAST, profile.depth, DDS_LENGTH_UNLIMITED,
                                    DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
    if (!reads && profile.deadline_s > 0.0)
        dds_qset_deadline(qos.get(), duration(profile.deadline_s));
    if (!reads && profile.livelinessLease_s > 0.0)
        dds_qset_liveliness(qos.get(), DDS_LIVELINESS_AUTOMATIC, duration(profile.livelinessLease_s));
    // Readers would see each exit of a writer as the end of the data.
    dds_qset_writer_data_lifecycle(qos.get(), false);
    return qos;
}

core::Unexpected notPermitted(const QString& ddsTopic, bool reads) {
    return core::refused((reads ? DdsEndpoint::tr("the permissions do not allow reading topic %1")
                                : DdsEndpoint::tr("the permissions do not allow writing topic %1"))
                             .arg(ddsTopic));
}

core::Expected<std::int32_t> openEnd(const Participant& participant, const std::string& ddsTopic,
                                     const dds_topic_descriptor_t& type, const ros::QosProfile& profile,
                                     bool reads) {
    const dds_entity_t topic =
        dds_create_topic(participant.entity(), &type, ddsTopic.c_str(), nullptr, nullptr);
    const QString name = QString::fromStdString(ddsTopic);
    // It is refused only where it may neither be read nor written.
    if (topic == DDS_RETCODE_NOT_ALLOWED_BY_SECURITY)
        return notPermitted(name, reads);
    if (topic < 0)
        return ddsFailure(DdsEndpoint::tr("topic %1 cannot be opened").arg(name), topic);
    const Qos qos = qosOf(profile, reads);
    const dds_entity_t entity = reads ? dds_create_reader(participant.entity(), topic, qos.get(), nullptr)
                                      : dds_create_writer(participant.entity(), topic, qos.get(), nullptr);
    // The end keeps its topic.
    (void)dds_delete(topic);
    if (entity == DDS_RETCODE_NOT_ALLOWED_BY_SECURITY)
        return notPermitted(name, reads);
    if (entity < 0)
        return ddsFailure((reads ? DdsEndpoint::tr("topic %1 cannot be read")
                                 : DdsEndpoint::tr("topic %1 cannot be written"))
                              .arg(name),
                          entity);
    if (reads)
        (void)dds_set_status_mask(entity, DDS_DATA_AVAILABLE_STATUS);
    return entity;
}

} // namespace

Endpoint::Endpoint(std::shared_ptr<const Participant> participant, std::int32_t entity, bool reads)
    : m_participant(std::move(participant))
    , m_entity(entity)
    , m_reads(reads) {
}

Endpoint::Endpoint(Endpoint&& other) noexcept
    : m_participant(std::move(other.m_participant))
    , m_entity(std::exchange(other.m_entity, 0))
    , m_reads(other.m_reads) {
}

Endpoint::~Endpoint() {
    if (m_entity > 0)
        (void)dds_delete(m_entity);
}

Guid Endpoint::guid() const {
    dds_guid_t own{};
    (void)dds_get_guid(m_entity, &own);
    Guid guid{};
    std::ranges::copy(own.v, guid.begin());
    return guid;
}

std::size_t Endpoint::matched() const {
    const dds_return_t count = m_reads ? dds_get_matched_publications(m_entity, nullptr, 0)
                                       : dds_get_matched_subscriptions(m_entity, nullptr, 0);
    return count > 0 ? static_cast<std::size_t>(count) : 0;
}

std::optional<ros::QosMismatch> Endpoint::incompatible() const {
    std::uint32_t total = 0;
    std::uint32_t policy = 0;
    if (m_reads) {
        dds_requested_incompatible_qos_status_t status{};
        (void)dds_get_requested_incompatible_qos_status(m_entity, &status);
        total = status.total_count;
        policy = status.last_policy_id;
    } else {
        dds_offered_incompatible_qos_status_t status{};
        (void)dds_get_offered_incompatible_qos_status(m_entity, &status);
        total = status.total_count;
        policy = status.last_policy_id;
    }
    if (total == 0)
        return std::nullopt;
    if (policy == DDS_RELIABILITY_QOS_POLICY_ID)
        return ros::QosMismatch::reliability;
    if (policy == DDS_DURABILITY_QOS_POLICY_ID)
        return ros::QosMismatch::durability;
    return ros::QosMismatch::other;
}

core::Expected<AnyReader> AnyReader::open(std::shared_ptr<const Participant> participant,
                                          const std::string& ddsTopic, const dds_topic_descriptor_t& type,
                                          const ros::QosProfile& profile) {
    TELETA_TRY(const std::int32_t entity, openEnd(*participant, ddsTopic, type, profile, true));
    return AnyReader(std::move(participant), entity, true);
}

std::size_t AnyReader::takeAny(const std::function<void(const void*, const SampleInfo&)>& take) {
    constexpr std::size_t kAtOnce = 16;
    std::size_t taken = 0;
    for (;;) {
        std::array<void*, kAtOnce> samples{};
        std::array<dds_sample_info_t, kAtOnce> infos{};
        const dds_return_t count = dds_take(m_entity, samples.data(), infos.data(), kAtOnce, kAtOnce);
        if (count <= 0)
            return taken;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            if (!infos[i].valid_data)
                continue;
            take(samples[i], {infos[i].source_timestamp, infos[i].publication_handle});
            ++taken;
        }
        (void)dds_return_loan(m_entity, samples.data(), count);
    }
}

core::Expected<AnyWriter> AnyWriter::open(std::shared_ptr<const Participant> participant,
                                          const std::string& ddsTopic, const dds_topic_descriptor_t& type,
                                          const ros::QosProfile& profile) {
    TELETA_TRY(const std::int32_t entity, openEnd(*participant, ddsTopic, type, profile, false));
    return AnyWriter(std::move(participant), entity, false);
}

bool AnyWriter::writeAny(const void* message) {
    return dds_write(m_entity, message) >= 0;
}

} // namespace teleta::dds
