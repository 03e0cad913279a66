// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pattern/model/pattern.h"
#include "backend/study/protocol/protocol.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace teleta::study {

/// The tactile pattern that is felt as the stimulus of a pattern under a condition: "task.letter.condition".
[[nodiscard]] std::string stimulusId(const StudyTask& task, const StudyPattern& pattern,
                                     const std::string& condition);

/// A pattern of one's own that a study was made with, as the study keeps it.
struct OwnStimulus {
    std::string id;   ///< stimulusId()
    std::string file; ///< from which it came, without its folder
    std::string json; ///< patternToJson()
};

/// Reads the pattern files that a protocol names, in any format that is read. Error: refused for a path that
/// is not a whole one; what loadPattern() reports. Thread: any but the GUI's (I/O).
[[nodiscard]] core::Expected<std::vector<OwnStimulus>> readOwnStimuli(const Protocol& protocol);

/// SHA-256, in hexadecimal digits, of the ids of all stimuli of a protocol and of what is felt at each, the
/// own pattern or the built-in one: another value where anything that participants feel has changed.
/// Thread: any.
[[nodiscard]] std::string stimulusSetSha256(const Protocol& protocol,
                                            const std::vector<OwnStimulus>& own = {});

/// Ids of the stimuli of a protocol that have neither a built-in pattern nor a file. Thread: any.
[[nodiscard]] std::vector<std::string> missingStimuli(const Protocol& protocol);

/// What is felt in a study: built-in patterns, and the study's copies of one's own where the protocol names
/// files. Copies share the patterns. Thread: any (it does not change).
class StimulusSet {
public:
    StimulusSet() = default;

    /// place: for errors. Error: badInput when one of them is no pattern.
    [[nodiscard]] static core::Expected<StimulusSet>
    of(const Protocol& protocol, std::vector<OwnStimulus> own, const std::string& place);

    /// Null: there is none. Valid as long as any copy of the set.
    [[nodiscard]] const pattern::Pattern* find(const std::string& id) const;
    /// Null: it is not one's own.
    [[nodiscard]] const OwnStimulus* findOwn(const std::string& id) const;
    /// Ids of stimuli that nothing can be felt of.
    [[nodiscard]] const std::vector<std::string>& missing() const { return m_missing; }
    [[nodiscard]] const std::string& sha256() const { return m_sha256; }

private:
    std::map<std::string, std::shared_ptr<const pattern::Pattern>> m_patterns;
    std::vector<OwnStimulus> m_own;
    std::vector<std::string> m_missing;
    std::string m_sha256;
};

} // namespace teleta::study
