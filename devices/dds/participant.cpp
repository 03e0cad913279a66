// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/dds/participant.h"

#include "backend/core/failure.h"
#include "backend/core/threads/urgent_thread.h"
#include "devices/dds/dds_error.h"
#include "devices/dds/dds_qos.h"
#include "devices/dds/log_lines.h"

#include <QCoreApplication>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <dds/dds.h>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace teleta::dds {

namespace {

struct ParticipantText {
    Q_DECLARE_TR_FUNCTIONS(DdsParticipant)
};

/// Opens a domain with this configuration unless it is open with it already.
core::Expected<void> openDomain(const DomainConfig& config) {
    static std::mutex mutex;
    static std::map<int, DomainConfig> open;
    const std::scoped_lock lock(mutex);
    if (const auto found = open.find(config.domain); found != open.end()) {
        if (found->second == config)
            return {};
        return core::refused(ParticipantText::tr("domain %1 is open with another interface or other peers")
                                 .arg(config.domain));
    }
    limitLog();
    std::string told;
    const auto create = [&](std::optional<int> priority) {
        const CollectedLog log;
        const dds_entity_t domain = dds_create_domain(static_cast<dds_domainid_t>(config.domain),
                                                      configurationOf(config, priority).c_str());
        told = log.text();
        return domain;
    };
    const std::optional<int> priority = core::libraryThreadPriority();
    dds_entity_t domain = create(priority);
    if (domain < 0 && priority)
        domain = create(std::nullopt);
    if (domain < 0) {
        const QString reason =
            told.empty() ? QString::fromLatin1(dds_strretcode(domain)) : QString::fromStdString(told);
        return core::failed(
            core::ErrorKind::unavailable,
            ParticipantText::tr("domain %1 of DDS cannot be opened: %2").arg(config.domain).arg(reason),
            config.interface.empty()
                ? QString()
                : ParticipantText::tr("\"%1\" to be the name or the address of a network interface")
                      .arg(QString::fromStdString(config.interface)));
    }
    open.emplace(config.domain, config);
    return {};
}

/// Where this program has, or had, a secured participant.
class SecuredDomains {
public:
    [[nodiscard]] core::Expected<void> enter(int domain, const std::string& rights) {
        const std::scoped_lock lock(m_mutex);
        Entry& entry = m_entries.try_emplace(domain, Entry{rights}).first->second;
        if (entry.isIn)
            return core::refused(
                ParticipantText::tr("this program has joined domain %1 with keys already").arg(domain),
                ParticipantText::tr("once: the permissions of the first would apply to all"));
        if (entry.rights != rights)
            return core::refused(
                ParticipantText::tr("this program joined domain %1 with other permissions before")
                    .arg(domain),
                ParticipantText::tr("the same ones until the program is started again"));
        entry.isIn = true;
        return {};
    }
    void leave(int domain) {
        const std::scoped_lock lock(m_mutex);
        m_entries[domain].isIn = false;
    }

private:
    struct Entry {
        std::string rights; ///< signedRights()
        bool isIn = false;
    };
    std::mutex m_mutex;
    std::map<int, Entry> m_entries;
};

SecuredDomains& securedDomains() {
    static SecuredDomains domains;
    return domains;
}

} // namespace

Participant::Participant(std::int32_t entity, DomainConfig config, bool secured)
    : m_entity(entity)
    , m_config(std::move(config))
    , m_secured(secured) {
    dds_guid_t guid{};
    (void)dds_get_guid(entity, &guid);
    std::ranges::copy(guid.v, m_guid.begin());
}

core::Expected<std::shared_ptr<const Participant>>
Participant::open(const DomainConfig& config, std::string_view userData,
                  const std::optional<Security>& security) {
    if (!security)
        return join(config, userData, security);
    TELETA_CHECK(checkSecurity(*security));
    TELETA_TRY(const std::string rights, signedRights(*security));
    TELETA_CHECK(securedDomains().enter(config.domain, rights));
    auto joined = join(config, userData, security);
    if (!joined)
        securedDomains().leave(config.domain);
    return joined;
}

core::Expected<std::shared_ptr<const Participant>>
Participant::join(const DomainConfig& config, std::string_view userData,
                  const std::optional<Security>& security) {
    TELETA_CHECK(openDomain(config));
    forgetRefusals(config.domain);
    const CollectedLog log;
    const Qos qos(dds_create_qos());
    if (!userData.empty())
        dds_qset_userdata(qos.get(), userData.data(), userData.size());
    if (security) {
        for (const auto& [name, value] : propertiesOf(*security))
            dds_qset_prop(qos.get(), name.c_str(), value.c_str());
    }
    const dds_entity_t entity =
        dds_create_participant(static_cast<dds_domainid_t>(config.domain), qos.get(), nullptr);
    if (entity < 0) {
        if (security && !log.text().empty())
            return core::refused(
                ParticipantText::tr("domain %1 of DDS cannot be joined with the keys in %2: %3")
                    .arg(config.domain)
                    .arg(QString::fromStdString(security->folder), securityReason(log.text())));
        if (!log.text().empty())
            return core::failed(core::ErrorKind::unavailable,
                                ParticipantText::tr("domain %1 of DDS cannot be joined: %2")
                                    .arg(config.domain)
                                    .arg(QString::fromStdString(log.text())));
        return ddsFailure(ParticipantText::tr("domain %1 of DDS cannot be joined").arg(config.domain),
                          entity);
    }
    return std::shared_ptr<const Participant>(new Participant(entity, config, security.has_value()));
}

Refusals Participant::refusals() const {
    const RefusalLines lines = refusalLines(m_config.domain);
    if (lines.count == 0)
        return {};
    return {lines.count, ParticipantText::tr("a program is kept out of domain %1: %2")
                             .arg(m_config.domain)
                             .arg(securityReason(lines.last))
                             .toStdString()};
}

Participant::~Participant() {
    struct End {
        std::mutex mutex;
        std::condition_variable condition;
        bool reached = false;
    };
    const auto end = std::make_shared<End>();
    std::thread([end, entity = m_entity] {
        (void)dds_delete(entity);
        const std::scoped_lock lock(end->mutex);
        end->reached = true;
        end->condition.notify_all();
    }).detach();
    std::unique_lock lock(end->mutex);
    const bool ended =
        end->condition.wait_for(lock, std::chrono::nanoseconds(kLongestEnd_ns), [&] { return end->reached; });
    if (m_secured && ended)
        securedDomains().leave(m_config.domain);
}

} // namespace teleta::dds
