// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/recording_arguments.h"

#include "backend/core/failure.h"
#include "backend/frames/frame_request.h"

#include <QCoreApplication>

namespace teleta::console {

namespace {

struct RecordingArgumentsText {
    Q_DECLARE_TR_FUNCTIONS(RecordingArgumentsText)
};

} // namespace

core::Expected<app::CsvRequest> completeRecording(const RecordingArguments& recording) {
    auto guessed = app::guessCsv(recording.path.toStdString());
    if (!guessed)
        return guessed;
    app::CsvRequest& request = *guessed;
    request.layout.rows = recording.rows.value_or(request.layout.rows);
    request.layout.columns = recording.columns.value_or(request.layout.columns);
    request.layout.setPitch_m(recording.pitch_m.value_or(request.layout.pitchX_m));
    if (recording.tarePath)
        request.tarePath = recording.tarePath->toStdString();
    if (recording.unit)
        request.loadUnit = recording.unit->toStdString();
    request.gain = recording.gain.value_or(request.gain);
    request.threshold_N = recording.threshold_N.value_or(request.threshold_N);
    request.rate_Hz = recording.rate_Hz.value_or(request.rate_Hz);
    request.inverted = recording.inverted;
    if (!recording.threshold_N && !frames::usualThreshold(request.loadUnit))
        return core::failed(
            core::ErrorKind::badInput,
            RecordingArgumentsText::tr("the loads are in %1, a unit without a usual threshold")
                .arg(QString::fromStdString(request.loadUnit)),
            RecordingArgumentsText::tr("--threshold, from how many %1 a taxel is in contact")
                .arg(QString::fromStdString(request.loadUnit)),
            {request.path});
    return guessed;
}

} // namespace teleta::console
