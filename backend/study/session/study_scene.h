// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/protocol/protocol.h"
#include "backend/study/session/simulated_participant.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::study {

/// A scene that is no tactile world but a study: simulated participants with a bracelet. What is not listed
/// among its effects is not simulated: who is not confused answers right, who has no reaction time answers
/// when the stimulus ends, a bracelet without effects does at once what it is told.
struct StudyScene {
    std::string name;
    std::string description;
    double duration_s = 0.0;   ///< simulated; the rehearsal ends earlier when all sessions are done
    double frameRate_Hz = 0.0; ///< of the bracelet
    Protocol protocol;
    std::size_t participants = 1;

    bool confusion = false;       ///< as the paper's participants: paperMatrix(), else assumedMatrix()
    std::optional<double> lapses; ///< probability of no answer
    struct ReactionTime {
        double median_s = 0.0;
        double logSpread = 0.0;
    };
    std::optional<ReactionTime> reactionTime;
    struct MotorLag {
        double rise_s = 0.0; ///< from rest to 90 % of a speed
        double fall_s = 0.0; ///< from a speed to 10 % of it
    };
    std::optional<MotorLag> motorLag;
    std::optional<double> deadZone;      ///< share of the full drive below which a motor stands
    std::optional<double> droppedFrames; ///< share of the frames that do not arrive

    struct Effect {
        std::string name;
        std::string why; ///< what the scene would lose without it
    };
    std::vector<Effect> effects; ///< in the order of the file

    /// The same scene without one of its effects; one that it does not list changes nothing.
    [[nodiscard]] StudyScene without(const std::string& effect) const;

    /// As the effects say. Thread: any.
    [[nodiscard]] SimulatedParticipant participantFor(const StudyTask& task,
                                                      const std::string& condition) const;
};

/// Whether a scene file is one of a study: it has a table [study]. What cannot be read is none.
[[nodiscard]] bool isStudyScene(std::string_view text);

/// Reads such a scene. file: the name that errors show; a protocol is looked for beside it, "paper" is the
/// paper's. Error: badInput with line and column; what readProtocol() reports. Thread: any.
[[nodiscard]] core::Expected<StudyScene> parseStudyScene(std::string_view text, const std::string& file);

} // namespace teleta::study
