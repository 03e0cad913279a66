// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/store/trial_journal.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QString>

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <stdexcept>
#include <unistd.h>

namespace teleta::study {

namespace {

using nlohmann::ordered_json;

struct JournalText {
    Q_DECLARE_TR_FUNCTIONS(StudyStore)
};

template <typename Value>
ordered_json jsonOrNull(const std::optional<Value>& value) {
    return value ? ordered_json(*value) : ordered_json(nullptr);
}

/// A count: not negative, no fraction.
std::size_t countOf(const ordered_json& value) {
    if (!value.is_number_unsigned())
        throw std::out_of_range("not a count");
    return value.get<std::size_t>();
}

template <typename Value>
std::optional<Value> optionalOf(const ordered_json& value) {
    return value.is_null() ? std::nullopt : std::optional(value.get<Value>());
}

ordered_json toJson(const PendingTrial& trial) {
    const TrialResult& result = trial.result;
    return {{"session_key", trial.sessionKey},
            {"session_id", trial.sessionId},
            {"phase", toString(result.planned.phase)},
            {"trial", result.planned.trial},
            {"repetition", result.planned.repetition},
            {"attempt", result.planned.attempt},
            {"stimulus", result.planned.stimulus},
            {"trial_in_block", result.trialInBlock},
            {"response", jsonOrNull(result.response)},
            {"outcome", toString(result.outcome)},
            {"response_time_s", jsonOrNull(result.responseTime_s)},
            {"response_time_offset_s", jsonOrNull(result.responseTimeOffset_s)},
            {"response_device", result.responseDevice},
            {"response_key", result.responseKey},
            {"n_replays", result.replays},
            {"early_presses", result.earlyPresses},
            {"onset_s", result.onset_s},
            {"duration_s", result.duration_s},
            {"device_latency_ms", jsonOrNull(result.deviceLatency_ms)},
            {"device_faults", result.deviceFaults},
            {"frame_write_ms", jsonOrNull(result.frameWrite_ms)},
            {"frames_missed", jsonOrNull(result.framesMissed)},
            {"time_utc", trial.time.toUTC().toString(Qt::ISODateWithMs).toStdString()}};
}

PendingTrial fromJson(const ordered_json& json) {
    PendingTrial trial;
    TrialResult& result = trial.result;
    if (!json.at("session_key").is_number_integer())
        throw std::out_of_range("not a key");
    trial.sessionKey = json.at("session_key");
    trial.sessionId = json.at("session_id");
    result.planned = {phaseOf(json.at("phase")).value(), countOf(json.at("trial")),
                      countOf(json.at("repetition")), countOf(json.at("attempt")),
                      countOf(json.at("stimulus"))};
    result.trialInBlock = countOf(json.at("trial_in_block"));
    if (!json.at("response").is_null())
        result.response = countOf(json.at("response"));
    result.outcome = outcomeOf(json.at("outcome")).value();
    result.responseTime_s = optionalOf<double>(json.at("response_time_s"));
    result.responseTimeOffset_s = optionalOf<double>(json.at("response_time_offset_s"));
    result.responseDevice = json.at("response_device");
    result.responseKey = json.at("response_key");
    result.replays = countOf(json.at("n_replays"));
    result.earlyPresses = countOf(json.at("early_presses"));
    result.onset_s = json.at("onset_s");
    result.duration_s = json.at("duration_s");
    result.deviceLatency_ms = optionalOf<double>(json.at("device_latency_ms"));
    result.deviceFaults = countOf(json.at("device_faults"));
    result.frameWrite_ms = optionalOf<double>(json.at("frame_write_ms"));
    if (!json.at("frames_missed").is_null())
        result.framesMissed = countOf(json.at("frames_missed"));
    trial.time =
        QDateTime::fromString(QString::fromStdString(json.at("time_utc")), Qt::ISODateWithMs).toUTC();
    return trial;
}

core::Unexpected journalFailed(const QString& message, const std::string& path) {
    return core::Unexpected(core::Error{core::ErrorKind::ioFailed, message.toStdString(), {}, {path}});
}

/// Makes a directory entry as durable as its file.
bool syncFolder(const QString& folder) {
    const int descriptor = ::open(QFile::encodeName(folder).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const bool done = descriptor >= 0 && fsync(descriptor) == 0;
    if (descriptor >= 0)
        ::close(descriptor);
    return done;
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
    const bool done = file.open(QIODevice::WriteOnly | QIODevice::Append | QIODevice::Unbuffered) &&
                      file.write(line) == line.size() && fsync(file.handle()) == 0;
    if (done && syncFolder(QFileInfo(file).path()))
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
    if (!file.open(QIODevice::ReadOnly))
        return journalFailed(JournalText::tr("cannot read the file: %1").arg(file.errorString()), m_path);
    for (long long number = 1; !file.atEnd(); ++number) {
        const std::string line = file.readLine().toStdString();
        try {
            trials.push_back(fromJson(ordered_json::parse(line)));
        } catch (const std::exception&) {
            if (file.atEnd() && line.back() != '\n')
                break;
            return core::Unexpected(core::Error{core::ErrorKind::badInput,
                                                JournalText::tr("this is not a trial").toStdString(),
                                                JournalText::tr("a stored trial").toStdString(),
                                                {m_path, number, 0}});
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
