// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/dds/log_lines.h"

#include "backend/core/steady_time.h"

#include <algorithm>
#include <charconv>
#include <dds/dds.h>
#include <iostream>
#include <map>
#include <mutex>

namespace teleta::dds {

namespace {

constexpr std::int64_t kBetweenLines_ns = 1'000'000'000;
constexpr std::size_t kMostCollected = 2000;

thread_local std::string* collected = nullptr;

std::string_view trimmed(std::string_view line) {
    while (!line.empty() && (line.back() == '\n' || line.back() == ' '))
        line.remove_suffix(1);
    return line;
}

/// Each message about nodes is read as that of either distribution, see ros::nodesOf(). Programs with keys
/// are not let in before this one has joined; a moment later they are.
bool isExpected(std::string_view line) {
    return line.find("deserialization ros_discovery_info/") != std::string_view::npos ||
           line.starts_with("Remote secure participant");
}

/// The domain of a line, from its header "1795803779.122432 [95]    fsm: ": Cyclone DDS 0.10 does not set
/// domid.
std::optional<int> domainOf(const dds_log_data_t& data) {
    const std::string_view header(data.message - data.hdrsize, data.hdrsize);
    const std::size_t begin = header.find('[');
    int domain = 0;
    if (begin == std::string_view::npos ||
        std::from_chars(header.data() + begin + 1, header.data() + header.size(), domain).ec != std::errc())
        return std::nullopt;
    return domain;
}

/// Whether security keeps another program out of the domain.
bool isRefusal(std::string_view line) {
    constexpr std::string_view kBegins[] = {"Validate remote identity failed",
                                            "Begin handshake request failed",
                                            "Begin handshake reply failed",
                                            "Process handshake failed",
                                            "Getting shared secret failed",
                                            "Could not authenticate_peer_credential_token",
                                            "Could not get remote",
                                            "Plugin does not allow remote participant"};
    return std::ranges::any_of(kBegins, [line](std::string_view begin) { return line.starts_with(begin); });
}

class RefusalCount {
public:
    void add(int domain, std::string_view line) {
        const std::scoped_lock lock(m_mutex);
        RefusalLines& lines = m_lines[domain];
        ++lines.count;
        lines.last = line;
    }
    [[nodiscard]] RefusalLines of(int domain) {
        const std::scoped_lock lock(m_mutex);
        return m_lines[domain];
    }
    void forget(int domain) {
        const std::scoped_lock lock(m_mutex);
        m_lines.erase(domain);
    }

private:
    std::mutex m_mutex;
    std::map<int, RefusalLines> m_lines;
};

RefusalCount& refusals() {
    // Never destroyed: threads of open domains report until the program has ended.
    static RefusalCount* const refusals = new RefusalCount;
    return *refusals;
}

void takeLine(void* /*unused*/, const dds_log_data_t* data) {
    const std::string_view line = trimmed(std::string_view(data->message, data->size));
    if (collected != nullptr) {
        if (collected->size() < kMostCollected)
            collected->append(collected->empty() ? "" : "; ").append(line);
        return;
    }
    if (isExpected(line))
        return;
    if (const std::optional<int> domain = domainOf(*data); domain && isRefusal(line))
        refusals().add(*domain, line);
    static std::mutex mutex;
    static LogLimit limit;
    const std::scoped_lock lock(mutex);
    if (const auto printed = limit.pass(line, core::steadyNow_ns()))
        std::cerr << "DDS: " + *printed + "\n";
}

} // namespace

std::optional<std::string> LogLimit::pass(std::string_view line, std::int64_t now_ns) {
    if (m_last_ns && now_ns - *m_last_ns < kBetweenLines_ns) {
        ++m_keptBack;
        return std::nullopt;
    }
    m_last_ns = now_ns;
    std::string text(line);
    if (m_keptBack > 0)
        text += " (+" + std::to_string(m_keptBack) + ")";
    m_keptBack = 0;
    return text;
}

void limitLog() {
    dds_set_log_sink(takeLine, nullptr);
}

RefusalLines refusalLines(int domain) {
    return refusals().of(domain);
}

void forgetRefusals(int domain) {
    refusals().forget(domain);
}

CollectedLog::CollectedLog() {
    collected = &m_text;
}

CollectedLog::~CollectedLog() {
    collected = nullptr;
}

} // namespace teleta::dds
