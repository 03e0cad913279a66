// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/motor_recording.h"

#include "backend/core/data/csv_reader.h"
#include "backend/core/failure.h"
#include "backend/motors/speed_from_signal.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace teleta::motors {

namespace {

struct RecordingText {
    Q_DECLARE_TR_FUNCTIONS(MotorRecording)
};

core::Unexpected bad(const QString& message, const QString& expected, core::SourcePlace where) {
    return core::failed(core::ErrorKind::badInput, message, expected, std::move(where));
}

core::Expected<void> checkSample(double time_s, double before_s, double drive, const core::SourcePlace& time,
                                 const core::SourcePlace& commanded) {
    if (!(time_s > before_s))
        return bad(RecordingText::tr("the time does not rise"),
                   RecordingText::tr("a time above %1 s").arg(before_s), time);
    if (!(drive >= 0.0 && drive <= 1.0))
        return bad(RecordingText::tr("the commanded drive is %1").arg(drive),
                   RecordingText::tr("a share of the full drive, 0 to 1"), commanded);
    return {};
}

} // namespace

core::Expected<MotorRecording> readMotorRecording(const std::string& path) {
    TELETA_TRY(auto reader, core::CsvReader::open(path));
    const auto& header = reader.header();
    const bool isSpeed = std::ranges::find(header, "speed_hz") != header.end();
    if (!isSpeed && std::ranges::find(header, "signal") == header.end())
        return bad(RecordingText::tr("there is neither a column \"speed_hz\" nor \"signal\""),
                   QStringLiteral("time_s,commanded,speed_hz | time_s,commanded,signal"), reader.place(0));
    const std::array<std::string_view, 3> names{"time_s", "commanded", isSpeed ? "speed_hz" : "signal"};
    TELETA_TRY(const auto columns, reader.columns(names));
    MotorRecording recording;
    std::vector<double> row;
    for (;;) {
        TELETA_TRY(const auto more, reader.next(row));
        if (!more)
            break;
        const double before_s = recording.time_s.empty() ? -HUGE_VAL : recording.time_s.back();
        const double time_s = row[columns[0]];
        const double drive = row[columns[1]];
        TELETA_CHECK(
            checkSample(time_s, before_s, drive, reader.place(columns[0]), reader.place(columns[1])));
        recording.time_s.push_back(time_s);
        recording.drive.push_back(drive);
        recording.speed_Hz.push_back(row[columns[2]]);
    }
    if (isSpeed)
        return recording;
    auto speeds = speedFromSignal(recording.time_s, recording.drive, recording.speed_Hz);
    if (!speeds && speeds.error().where.file.empty())
        speeds.error().where.file = path;
    return speeds;
}

core::Expected<void> checkMotorRecording(const MotorRecording& recording) {
    if (recording.drive.size() != recording.size() || recording.speed_Hz.size() != recording.size() ||
        (!recording.unknown.empty() && recording.unknown.size() != recording.size()))
        return bad(RecordingText::tr("the numbers of times, drives and speeds differ"), {}, {});
    for (std::size_t i = 0; i < recording.size(); ++i) {
        const core::SourcePlace where{{}, static_cast<long long>(i) + 1, 0};
        if (!std::isfinite(recording.time_s[i]) || !std::isfinite(recording.speed_Hz[i]))
            return bad(RecordingText::tr("sample %1 is not a finite number").arg(i + 1), {}, where);
        const double before_s = i == 0 ? -HUGE_VAL : recording.time_s[i - 1];
        TELETA_CHECK(checkSample(recording.time_s[i], before_s, recording.drive[i], where, where));
    }
    return {};
}

} // namespace teleta::motors
