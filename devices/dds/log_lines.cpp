// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/dds/log_lines.h"

#include "backend/core/steady_time.h"

#include <dds/dds.h>
#include <iostream>
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

/// Each message about nodes is read as that of either distribution, see ros::nodesOf().
bool isExpected(std::string_view line) {
    return line.find("deserialization ros_discovery_info/") != std::string_view::npos;
}

void takeLine(void* /*unused*/, const dds_log_data_t* data) {
    const std::string_view line =
        trimmed(std::string_view(data->message, data->size > 0 ? data->size - 1 : 0));
    if (collected != nullptr) {
        if (collected->size() < kMostCollected)
            collected->append(collected->empty() ? "" : "; ").append(line);
        return;
    }
    if (isExpected(line))
        return;
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

CollectedLog::CollectedLog() {
    collected = &m_text;
}

CollectedLog::~CollectedLog() {
    collected = nullptr;
}

} // namespace teleta::dds
