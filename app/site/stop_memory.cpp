// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/site/stop_memory.h"

#include "backend/core/data/input_file.h"
#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"
#include "devices/site/site_topics.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QDir>
#include <QString>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace teleta::site_program {

namespace {

struct StopMemoryText {
    Q_DECLARE_TR_FUNCTIONS(StopMemoryText)
};

using nlohmann::json;

constexpr int kVersion = 1;
/// More than any site has consoles and programs of them.
constexpr std::size_t kMostBytes = 1U << 20U;

std::optional<std::pair<std::string, site::BootName>> consoleOf(const json& entry) {
    if (!entry.is_object() || !entry.contains("console") || !entry["console"].is_string() ||
        !entry.contains("program") || !entry["program"].is_string())
        return std::nullopt;
    auto name = entry["console"].get<std::string>();
    const auto program = entry["program"].get<std::string>();
    const QByteArray bytes = QByteArray::fromHex(QByteArray::fromStdString(program));
    site::BootName boot{};
    if (!site_link::isSiteName(name) || bytes.toHex().toStdString() != program ||
        bytes.size() != static_cast<qsizetype>(boot.size()))
        return std::nullopt;
    std::ranges::transform(bytes, boot.begin(), [](char byte) { return static_cast<std::uint8_t>(byte); });
    return std::pair(std::move(name), boot);
}

} // namespace

std::string stopText(const site::StopHolders& holders) {
    nlohmann::ordered_json consoles = nlohmann::ordered_json::array();
    for (const auto& [console, boot] : holders.consoles)
        consoles.push_back(
            {{"console", console},
             {"program",
              QByteArray(reinterpret_cast<const char*>(boot.data()), boot.size()).toHex().toStdString()}});
    return nlohmann::ordered_json{{"version", kVersion}, {"site", holders.site}, {"consoles", consoles}}.dump(
               2) +
           '\n';
}

core::Expected<site::StopHolders> parseStop(std::string_view text, const std::string& file) {
    const auto wrong = [&file] {
        return core::failed(core::ErrorKind::badInput,
                            StopMemoryText::tr("this does not tell who engages STOP"),
                            StopMemoryText::tr("version 1, site, consoles"), {file});
    };
    const json document = json::parse(text, nullptr, false);
    if (!document.is_object() || document.value("version", json()) != kVersion ||
        !document.contains("site") || !document["site"].is_boolean() || !document.contains("consoles") ||
        !document["consoles"].is_array())
        return wrong();
    site::StopHolders holders;
    holders.site = document["site"].get<bool>();
    for (const json& entry : document["consoles"]) {
        auto console = consoleOf(entry);
        if (!console)
            return wrong();
        holders.consoles.insert(std::move(*console));
    }
    return holders;
}

StopMemory::StopMemory(const std::string& folder, const std::string& site)
    : m_folder(folder)
    , m_path(QDir(QString::fromStdString(folder))
                 .filePath(QString::fromStdString(site) + QStringLiteral("-stop.json"))
                 .toStdString()) {
    const auto text = core::readFile(m_path, kMostBytes);
    core::Expected<site::StopHolders> known =
        text ? parseStop(*text, m_path) : core::Unexpected(text.error());
    if (!known && known.error().kind == core::ErrorKind::notFound)
        known = site::StopHolders();
    if (known)
        m_atStart = *known;
    m_atStart.site = m_atStart.site || !known;
    const core::Expected<void> written = write(m_atStart);
    if (!known || !written)
        m_problem = core::describe(known ? written.error() : known.error());
    if (!written) {
        // What cannot be kept may have been lost before, too.
        m_atStart.site = true;
        m_newest = m_atStart;
        m_trouble = core::describe(written.error());
    }
    m_thread = std::thread([this] { run(); });
}

StopMemory::~StopMemory() {
    {
        const std::scoped_lock lock(m_mutex);
        m_ends = true;
    }
    m_woken.notify_all();
    m_thread.join();
}

void StopMemory::keep(const site::StopHolders& holders) {
    {
        const std::scoped_lock lock(m_mutex);
        m_newest = holders;
    }
    m_woken.notify_all();
}

core::Expected<void> StopMemory::write(const site::StopHolders& holders) const {
    TELETA_CHECK(core::makeFolder(m_folder));
    return core::writeFile(m_path, stopText(holders));
}

std::string StopMemory::trouble() const {
    const std::scoped_lock lock(m_mutex);
    return m_trouble;
}

void StopMemory::run() {
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_woken.wait(lock, [this] { return m_ends || m_newest; });
        if (!m_newest)
            return;
        const site::StopHolders holders = *std::exchange(m_newest, std::nullopt);
        lock.unlock();
        const core::Expected<void> written = write(holders);
        lock.lock();
        m_trouble = written ? std::string() : core::describe(written.error());
        if (written)
            continue;
        if (m_ends)
            return;
        if (!m_newest)
            m_newest = holders;
        m_woken.wait_for(lock, kRetry, [this] { return m_ends; });
    }
}

std::string StopMemory::usualFolder() {
    // systemd names several with colons between.
    if (const QString state = qEnvironmentVariable("STATE_DIRECTORY").section(QLatin1Char(':'), 0, 0);
        !state.isEmpty())
        return state.toStdString();
    QString home = qEnvironmentVariable("XDG_STATE_HOME");
    if (!QDir::isAbsolutePath(home))
        home = QDir::home().filePath(QStringLiteral(".local/state"));
    return QDir(home).filePath(QStringLiteral("teleta-site")).toStdString();
}

} // namespace teleta::site_program
