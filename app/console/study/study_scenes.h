// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/study/study_controller.h"
#include "widgets/study/participant/participant_scene.h"
#include "widgets/study/results/confusion_picture.h"
#include "widgets/study/session_panel.h"
#include "widgets/study/study_panel.h"

#include <optional>
#include <utility>
#include <vector>

namespace teleta::console {

/// Action of the large button.
enum class NextStep {
    none,
    enrol,    ///< the first participant
    begin,    ///< the chosen session
    rehearse, ///< all simulated sessions
    stopRehearsal,
    goOn,         ///< after a hold
    retry,        ///< to save the last trial, or the last answers
    fillIn,       ///< a questionnaire, in the participant's window
    leaveSession, ///< to the participant's next one
    showResults,
};

/// What the views of a study show. Thread: GUI.
class StudyScenes {
    Q_DECLARE_TR_FUNCTIONS(StudyScenes)

public:
    [[nodiscard]] static study::PanelScene study(const StudyController& controller);
    /// Of one that is not open. running: participant and session.
    [[nodiscard]] static study::PanelScene study(const StudyOverview& overview,
                                                 const std::optional<std::pair<int, int>>& running = {});
    [[nodiscard]] static study::SessionScene session(const StudyController& controller);
    [[nodiscard]] static study::ParticipantScene participant(const StudyController& controller);
    [[nodiscard]] static study::ConfusionContent matrix(const StudyController& controller);
    /// The answers of the chosen session, with pictures of the patterns.
    [[nodiscard]] static std::vector<study::AnswerChoice> choices(const StudyController& controller);
    [[nodiscard]] static NextStep nextStep(const StudyController& controller);
    /// "Object shape, static".
    [[nodiscard]] static QString sessionName(const study::Protocol& protocol,
                                             const study::PlannedSession& plan);

private:
    static void describeRunning(const StudyController& controller, study::SessionScene& scene);
    static void describeQuestionnaire(const StudyController& controller, study::SessionScene& scene);
    [[nodiscard]] static QString skipConsequence(study::QuestionnaireTime when);
    static void describeIdle(const StudyController& controller, study::SessionScene& scene);
    [[nodiscard]] static QString protocolText(const study::StudyHead& head);
};

} // namespace teleta::console
