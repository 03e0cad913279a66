// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QDateTime>

#include <optional>
#include <string>
#include <vector>

namespace teleta::study {

/// Who is behind a pseudonym.
struct KeyEntry {
    std::string pseudonym; ///< the participant's name in the study
    std::string name;      ///< of the person
    std::string note;      ///< how to reach the person, for example; may be empty
    QDateTime time;        ///< UTC of the entry
};

/// The key of a study: a CSV file participant_id,name,note,time_utc, the only place that knows who the
/// participants are. It lies apart from the study, whose folder is copied and published, and only its owner
/// can read it. Every change rewrites the file at once. Thread: one; several programs may change the same
/// file.
class PseudonymKey {
public:
    /// Reads the file; one that is not there yet is empty. Error: refused when it lies in the study's folder;
    /// badInput, ioFailed.
    [[nodiscard]] static core::Expected<PseudonymKey> open(const std::string& path,
                                                           const std::string& studyFolder);

    [[nodiscard]] const std::vector<KeyEntry>& entries() const { return m_entries; }
    [[nodiscard]] std::optional<KeyEntry> find(const std::string& pseudonym) const;

    /// Error: refused when the pseudonym is there, or another program changes the file just now; ioFailed.
    [[nodiscard]] core::Expected<void> add(const KeyEntry& entry);
    /// False: it was not there. Error: as add().
    [[nodiscard]] core::Expected<bool> remove(const std::string& pseudonym);

private:
    explicit PseudonymKey(std::string path)
        : m_path(std::move(path)) {}
    [[nodiscard]] core::Expected<void> read();
    [[nodiscard]] core::Expected<void> write() const;

    std::string m_path;
    std::vector<KeyEntry> m_entries;
};

/// A pseudonym at random that is not among the taken ones: P and five letters or digits that are not mistaken
/// for others. Thread: any.
[[nodiscard]] std::string randomPseudonym(const std::vector<std::string>& taken);

} // namespace teleta::study
