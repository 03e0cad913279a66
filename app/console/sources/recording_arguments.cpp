// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/recording_arguments.h"

namespace teleta::console {

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
    return guessed;
}

} // namespace teleta::console
