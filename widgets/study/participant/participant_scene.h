// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/trial.h"
#include "widgets/study/participant/pattern_diagram.h"

#include <QString>

#include <cstddef>
#include <optional>

namespace teleta::study {

/// One of the participant's answers.
struct AnswerChoice {
    QString letter;
    QString name;
    PatternDiagram diagram = {};
    bool isPattern =
        true;         ///< false: one of the answers of a task with levels, of which only the name is shown
    QString key = {}; ///< letter of a key that means it too, "Y"; empty: only its digit
};

/// What the participant's window shows.
struct ParticipantScene {
    enum class State {
        waiting,   ///< for the experimenter
        ready,     ///< Space begins the next trial
        starting,  ///< requested, the stimulus has not begun
        stimulus,  ///< the stimulus is playing
        answering, ///< the stimulus is over
        feedback,  ///< the right answer is shown; Space continues
        resting,   ///< Space continues once restLeft_s is over
        paused,
        stopped, ///< STOP, or a lost device
        finished,
        ended,         ///< before all trials
        questionnaire, ///< a questionnaire replaces the answers
    };

    State state = State::waiting;
    QString title = {}; ///< the task
    Phase phase = Phase::practice;
    Mode mode = Mode::run;
    std::size_t trial = 0;  ///< from 1, of the phase
    std::size_t trials = 0; ///< of the phase
    bool answersOpen = false;
    bool diagrams = false; ///< pictures on the buttons
    bool canReplay = false;
    std::optional<std::size_t> answered = {};  ///< the last answer, in feedback and after it
    std::optional<std::size_t> presented = {}; ///< the right answer; in feedback only
    int restLeft_s = 0;
    QString question = {};             ///< of a task with levels; empty: which pattern it was
    std::size_t interval = 0;          ///< that is felt now, from 1; 0: none
    bool questionnaireLocked = false;  ///< its answers are being saved, could not be saved, or are simulated
    QString questionnaireProblem = {}; ///< why they could not be saved

    friend bool operator==(const ParticipantScene&, const ParticipantScene&) = default;
};

} // namespace teleta::study
