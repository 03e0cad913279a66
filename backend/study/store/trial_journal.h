// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/protocol/trial.h"

#include <QDateTime>

#include <string>
#include <vector>

namespace teleta::study {

/// A trial that the server does not have yet.
struct PendingTrial {
    long long sessionKey = 0;
    std::string sessionId;
    TrialResult result;
    QDateTime time; ///< UTC of its end
};

/// Trials of one session that are waiting for their server, in a file pending-KEY.jsonl in the study's
/// folder, one JSON object per line, so that they outlive the program. Thread: one; every process has its own
/// files.
class TrialJournal {
public:
    TrialJournal(const std::string& folder, long long sessionKey);

    /// Safe on the disk when it returns. Error: ioFailed.
    [[nodiscard]] core::Expected<void> append(const PendingTrial& trial) const;
    /// A last line that was cut off by a crash was never reported as safe and is ignored. Error: ioFailed,
    /// badInput with the line for any other damage.
    [[nodiscard]] core::Expected<std::vector<PendingTrial>> read() const;
    /// To be called when the server has all of it.
    [[nodiscard]] core::Expected<void> remove() const;

    [[nodiscard]] const std::string& path() const { return m_path; }

    /// Keys of the sessions with a file in a folder.
    [[nodiscard]] static std::vector<long long> sessionsIn(const std::string& folder);

private:
    std::string m_path;
};

} // namespace teleta::study
