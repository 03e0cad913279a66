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

/// A scene that describes a study: simulated participants with a bracelet. Only listed effects are simulated:
/// without confusion answers are right, without a reaction time they come when the stimulus ends, and a
/// bracelet without effects follows its commands at once.
struct StudyScene {
    std::string name;
    std::string description;
    double duration_s = 0.0;   ///< simulated; the rehearsal ends earlier when all sessions are done
    double frameRate_Hz = 0.0; ///< of the bracelet
    std::string protocolPath;  ///< as the file names it
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
    std::optional<double> deadZone;      ///< share of the full drive below which a motor does not turn
    std::optional<double> droppedFrames; ///< share of frames that are lost

    struct Effect {
        std::string name;
        std::string why; ///< what the scene would lose without it
    };
    std::vector<Effect> effects; ///< in the order of the file

    void describeKeys(core::Keys& keys);

    /// The same scene without one of its effects; unlisted effects change nothing.
    [[nodiscard]] StudyScene without(const std::string& effect) const;

    /// According to the effects. Thread: any.
    [[nodiscard]] SimulatedParticipant participantFor(const StudyTask& task,
                                                      const std::string& condition) const;
};

/// Whether a scene file describes a study, that is, has a table [study]; false for unreadable text.
[[nodiscard]] bool isStudyScene(std::string_view text);

/// Reads such a scene. file: name for errors, and base of the protocol's path; "paper" is the paper's
/// protocol. Error: badInput with line and column; what readProtocol() reports. Thread: any.
[[nodiscard]] core::Expected<StudyScene> parseStudyScene(std::string_view text, const std::string& file);

} // namespace teleta::study
