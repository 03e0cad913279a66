// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/store/trial_journal.h"

#include "backend/core/data/input_file.h"
#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"
#include "backend/study/store/trial_fields.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QString>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <unistd.h>

namespace teleta::study {

namespace {

using nlohmann::ordered_json;

struct JournalText {
    Q_DECLARE_TR_FUNCTIONS(StudyStore)
};

template <typename Value>
ordered_json jsonOf(const Value& value) {
    return value;
}
ordered_json jsonOf(Phase phase) {
    return toString(phase);
}
ordered_json jsonOf(Outcome outcome) {
    return toString(outcome);
}
ordered_json jsonOf(const QDateTime& time) {
    return time.toUTC().toString(Qt::ISODateWithMs).toStdString();
}
template <typename Value>
ordered_json jsonOf(const std::optional<Value>& value) {
    return value ? ordered_json(*value) : ordered_json(nullptr);
}

template <typename Value>
void readInto(const ordered_json& json, Value& value) {
    json.get_to(value);
}
/// A count: not negative, no fraction.
void readInto(const ordered_json& json, std::size_t& count) {
    if (!json.is_number_unsigned())
        throw std::out_of_range("not a count");
    json.get_to(count);
}
void readInto(const ordered_json& json, Phase& phase) {
    phase = phaseOf(json.get<std::string>()).value();
}
void readInto(const ordered_json& json, Outcome& outcome) {
    outcome = outcomeOf(json.get<std::string>()).value();
}
void readInto(const ordered_json& json, QDateTime& time) {
    time = QDateTime::fromString(QString::fromStdString(json), Qt::ISODateWithMs).toUTC();
}
template <typename Value>
void readInto(const ordered_json& json, std::optional<Value>& value) {
    if (!json.is_null())
        readInto(json, value.emplace());
}

ordered_json toJson(const PendingTrial& trial) {
    ordered_json json{{"session_key", trial.sessionKey}, {"session_id", trial.sessionId}};
    forEachField(trial, [&](const char* name, const auto& field) { json[name] = jsonOf(field); });
    return json;
}

bool isNewer(std::string_view field) {
    constexpr std::array<std::string_view, 7> kNewer{
        "track", "level", "target", "trigger_ms", "recording", "recording_s", "device_latency_spread_ms"};
    return std::ranges::find(kNewer, field) != kNewer.end();
}

PendingTrial fromJson(const ordered_json& json) {
    PendingTrial trial;
    if (!json.at("session_key").is_number_integer())
        throw std::out_of_range("not a key");
    trial.sessionKey = json.at("session_key");
    trial.sessionId = json.at("session_id");
    forEachField(trial, [&](const char* name, auto& field) {
        // Journals of older programs do not have the fields at the end.
        if (json.contains(name) || !isNewer(name))
            readInto(json.at(name), field);
    });
    return trial;
}

core::Unexpected journalFailed(const QString& message, const std::string& path) {
    return core::failed(core::ErrorKind::ioFailed, message, {}, {path});
}

} // namespace

TrialJournal::TrialJournal(const std::string& folder, long long sessionKey)
    : m_path(QDir(QString::fromStdString(folder))
                 .filePath(QStringLiteral("pending-%1.jsonl").arg(sessionKey))
                 .toStdString()) {
}

core::Expected<void> TrialJournal::append(const PendingTrial& trial) const {
    QFile file(QString::fromStdString(m_path));
    const QByteArray line = QByteArray::fromStdString(toJson(trial).dump() + '\n');
    const qint64 before_B = file.size();
    // Unbuffered: buffered data would be written after the truncation that follows a failed write.
    const bool done = file.open(QIODevice::WriteOnly | QIODevice::Append | QIODevice::Unbuffered,
                                QFileDevice::ReadOwner | QFileDevice::WriteOwner) &&
                      file.write(line) == line.size() && fsync(file.handle()) == 0;
    if (done && core::syncFolder(QFileInfo(file).path().toStdString()))
        return {};
    const QString reason = file.errorString();
    if (file.isOpen())
        (void)file.resize(before_B); // half a line would spoil the next one
    return journalFailed(JournalText::tr("cannot write the file: %1").arg(reason), m_path);
}

core::Expected<std::vector<PendingTrial>> TrialJournal::read() const {
    QFile file(QString::fromStdString(m_path));
    std::vector<PendingTrial> trials;
    if (!file.exists())
        return trials;
    TELETA_CHECK(core::requireFile(m_path));
    if (!file.open(QIODevice::ReadOnly))
        return journalFailed(JournalText::tr("cannot read the file: %1").arg(file.errorString()), m_path);
    for (long long number = 1; !file.atEnd(); ++number) {
        const std::string line = file.readLine().toStdString();
        try {
            trials.push_back(fromJson(ordered_json::parse(line)));
        } catch (const std::exception&) {
            if (file.atEnd() && line.back() != '\n')
                break;
            return core::failed(core::ErrorKind::badInput, JournalText::tr("this is not a trial"),
                                JournalText::tr("a stored trial"), {m_path, number, 0});
        }
    }
    return trials;
}

core::Expected<void> TrialJournal::remove() const {
    QFile file(QString::fromStdString(m_path));
    if (file.exists() && !file.remove())
        return journalFailed(JournalText::tr("cannot remove the file: %1").arg(file.errorString()), m_path);
    return {};
}

std::vector<long long> TrialJournal::sessionsIn(const std::string& folder) {
    std::vector<long long> keys;
    const QStringList names = QDir(QString::fromStdString(folder))
                                  .entryList({QStringLiteral("pending-*.jsonl")}, QDir::Files, QDir::Name);
    for (const QString& name : names) {
        bool isNumber = false;
        const long long key = name.mid(8, name.size() - 14).toLongLong(&isNumber);
        if (isNumber)
            keys.push_back(key);
    }
    return keys;
}

} // namespace teleta::study
