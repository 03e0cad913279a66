// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/trial.h"

#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::study {

/// How much attention something needs.
enum class Tone { calm, good, attention, alarm };

/// A condition of a run.
struct CheckLine {
    QString name;
    bool passed = false;
    QString finding;
    QString remedy; ///< empty when passed
    friend bool operator==(const CheckLine&, const CheckLine&) = default;
};

/// A finished trial.
struct OutcomeLine {
    QString trial; ///< "test 12"
    QString presented;
    QString answered; ///< a dash: none
    QString outcome;
    Tone tone = Tone::calm;
    std::optional<double> responseTime_s;
    friend bool operator==(const OutcomeLine&, const OutcomeLine&) = default;
};

/// What the session panel shows.
struct SessionScene {
    QString title;    ///< participant and task
    QString subtitle; ///< place in the plan
    Mode mode = Mode::run;
    QString next; ///< the next step, on the large button
    bool nextEnabled = false;
    QString state; ///< what happens now, or why nothing happens
    Tone tone = Tone::calm;
    std::vector<CheckLine> checks; ///< before a run
    QString phase;
    std::size_t done = 0;              ///< of the phase
    std::size_t total = 0;             ///< of the phase; 0: no bar
    std::vector<OutcomeLine> outcomes; ///< newest first
    QString device;
    Tone deviceTone = Tone::calm;
    QString saved; ///< where the results were saved
    bool canPause = false;
    bool canAbort = false;
    bool canNote = false;
    bool canSkip = false;          ///< a questionnaire
    std::size_t questionnaire = 0; ///< number of the one that is asked
    QString skipConsequence;       ///< whether it is asked again
    bool needsNoise = false;
    bool noiseConfirmed = false;
    bool noisePlaying = false;
    QString noiseText;
    friend bool operator==(const SessionScene&, const SessionScene&) = default;
};

} // namespace teleta::study
