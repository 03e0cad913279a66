// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/site/site_log.h"

#include <QDateTime>

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <iostream>
#include <string>
#include <utility>

namespace teleta::site_program {

namespace {

constexpr std::array<const char*, 3> kSeverities{"note", "warning", "error"};

std::string lineOf(const site_link::SiteNews& news, bool json) {
    const std::string time = QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs).toStdString();
    if (!json)
        return time + "  " + (news.source.empty() ? "" : news.source + ": ") + news.message;
    const nlohmann::ordered_json line{{"time", time},
                                      {"severity", kSeverities[static_cast<std::size_t>(news.severity)]},
                                      {"source", news.source},
                                      {"code", news.code},
                                      {"message", news.message}};
    return line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

} // namespace

void SiteLog::write(const site_link::SiteNews& news) {
    std::string line = lineOf(news, m_json);
    const std::scoped_lock lock(m_mutex);
    m_lines.push_back(std::move(line));
    if (m_lines.size() > kMostLines) {
        m_lines.pop_front();
        ++m_lost;
    }
}

void SiteLog::flush() {
    std::deque<std::string> lines;
    std::uint64_t lost = 0;
    {
        const std::scoped_lock lock(m_mutex);
        lines.swap(m_lines);
        lost = std::exchange(m_lost, 0);
    }
    if (lost > 0)
        lines.push_front(lineOf({site_link::SiteNews::Severity::warning,
                                 {},
                                 "log_lost",
                                 std::to_string(lost) + " lines of the log were lost"},
                                m_json));
    std::ostream& out = m_json ? std::cout : std::cerr;
    for (const std::string& line : lines)
        out << line << '\n';
    out.flush();
}

} // namespace teleta::site_program
