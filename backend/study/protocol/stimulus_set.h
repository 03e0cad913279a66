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

/// Id of the tactile pattern that is the stimulus for a pattern under a condition: "task.letter.condition".
[[nodiscard]] std::string stimulusId(const StudyTask& task, const StudyPattern& pattern,
                                     const std::string& condition);

/// Id of the tactile pattern of a task with levels: "task.stimulus".
[[nodiscard]] std::string levelStimulusId(const StudyTask& task);

/// A custom pattern of a study, as the study keeps it.
struct OwnStimulus {
    std::string id;   ///< stimulusId() or levelStimulusId()
    std::string file; ///< from which it came, without its folder; or the id of a built-in pattern
    std::string json; ///< patternToJson()
};

/// Reads the pattern files that a protocol names, in any supported format; ids of built-in patterns stand for
/// these. Error: refused for a relative path, or a stimulus that does not fit its levels; what loadPattern()
/// reports. Thread: any but the GUI's (I/O).
[[nodiscard]] core::Expected<std::vector<OwnStimulus>> readOwnStimuli(const Protocol& protocol);

/// SHA-256, in hexadecimal, of the ids and patterns (custom or built-in) of all stimuli of a protocol: it
/// changes whenever anything that participants feel changes. Thread: any.
[[nodiscard]] std::string stimulusSetSha256(const Protocol& protocol,
                                            const std::vector<OwnStimulus>& own = {});

/// Ids of a protocol's stimuli that have neither a built-in pattern nor a file. Thread: any.
[[nodiscard]] std::vector<std::string> missingStimuli(const Protocol& protocol);

/// The stimuli of a study: built-in patterns, and the study's copies of custom ones. Copies share the
/// patterns. Thread: any (immutable).
class StimulusSet {
public:
    StimulusSet() = default;

    /// place: for errors. Error: badInput when one of `own` is not a pattern.
    [[nodiscard]] static core::Expected<StimulusSet>
    of(const Protocol& protocol, std::vector<OwnStimulus> own, const std::string& place);

    /// Null: none. Valid as long as any copy of the set.
    [[nodiscard]] const pattern::Pattern* find(const std::string& id) const;
    /// Null: not a custom one.
    [[nodiscard]] const OwnStimulus* findOwn(const std::string& id) const;
    /// Ids of stimuli without a pattern.
    [[nodiscard]] const std::vector<std::string>& missing() const { return m_missing; }
    [[nodiscard]] const std::string& sha256() const { return m_sha256; }

private:
    std::map<std::string, std::shared_ptr<const pattern::Pattern>> m_patterns;
    std::vector<OwnStimulus> m_own;
    std::vector<std::string> m_missing;
    std::string m_sha256;
};

} // namespace teleta::study
