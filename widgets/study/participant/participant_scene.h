// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/trial.h"
#include "widgets/study/participant/pattern_diagram.h"

#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::studyview {

/// One of the answers between which a participant chooses.
struct AnswerChoice {
    QString letter;
    QString name;
    PatternDiagram diagram;
};

/// What the participant's window shows.
struct ParticipantScene {
    enum class State {
        waiting,   ///< for the experimenter: nothing runs
        ready,     ///< Space begins the next trial
        starting,  ///< asked for, the stimulus has not begun
        stimulus,  ///< it is felt
        answering, ///< it is over
        feedback,  ///< the right answer is shown; Space goes on
        resting,   ///< Space goes on once restLeft_s is over
        paused,
        stopped, ///< STOP, or a device that is lost
        finished,
        questionnaire, ///< in place of the answers, a questionnaire is filled in
    };

    State state = State::waiting;
    QString title = {}; ///< the task
    study::Phase phase = study::Phase::practice;
    study::Mode mode = study::Mode::run;
    std::size_t trial = 0;  ///< from 1, of the phase
    std::size_t trials = 0; ///< of the phase
    bool answersOpen = false;
    bool diagrams = false; ///< pictures on the buttons
    bool canReplay = false;
    std::optional<std::size_t> answered = {};  ///< the last answer, in feedback and after it
    std::optional<std::size_t> presented = {}; ///< the right answer; in feedback only
    int restLeft_s = 0;
    bool questionnaireLocked = false;  ///< its answers are being or have to be kept, or are a program's
    QString questionnaireProblem = {}; ///< why they could not be kept

    friend bool operator==(const ParticipantScene&, const ParticipantScene&) = default;
};

} // namespace teleta::studyview
