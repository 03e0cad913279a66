// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/site/control_arbiter.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

namespace teleta::site_program {

/// Who engages STOP, as the file of a StopMemory has it, and back. Error: badInput; anything but a whole file
/// of this kind. Thread: any (pure).
[[nodiscard]] std::string stopText(const site::StopHolders& holders);
[[nodiscard]] core::Expected<site::StopHolders> parseStop(std::string_view text, const std::string& file);

/// Keeps on disk who engages STOP, so that a site that is started anew, killed or crashed before, is still
/// stopped until STOP is withdrawn. A file that cannot be read, or not be written at the start, counts as
/// STOP of the site itself: nobody knows what it should have told. Who tells never waits for the disk: a
/// thread writes the newest, durably and as a whole, and tries again every kRetry until it could. Thread:
/// keep() and trouble() from any.
class StopMemory {
public:
    static constexpr std::chrono::seconds kRetry{1};

    /// The file is SITE-stop.json in this folder, which is made when it is not there.
    StopMemory(const std::string& folder, const std::string& site);
    /// Writes what was told last.
    ~StopMemory();
    StopMemory(const StopMemory&) = delete;
    StopMemory& operator=(const StopMemory&) = delete;

    /// Who engaged STOP when the program before ended.
    [[nodiscard]] const site::StopHolders& atStart() const { return m_atStart; }
    /// Why that is not known, so that STOP counts as engaged; empty: it is known.
    [[nodiscard]] const std::string& problem() const { return m_problem; }

    void keep(const site::StopHolders& holders);
    /// Why what was told last is not on disk; empty: it is, or is just being written.
    [[nodiscard]] std::string trouble() const;

    /// Where a site keeps it unless told otherwise: $STATE_DIRECTORY (of systemd), else
    /// $XDG_STATE_HOME/teleta-site, else ~/.local/state/teleta-site.
    [[nodiscard]] static std::string usualFolder();

private:
    void run();
    [[nodiscard]] core::Expected<void> write(const site::StopHolders& holders) const;

    std::string m_folder;
    std::string m_path;
    site::StopHolders m_atStart;
    std::string m_problem;

    mutable std::mutex m_mutex;
    std::condition_variable m_woken;
    std::optional<site::StopHolders>
        m_newest; ///< guarded by m_mutex, as the next two; nothing: it is written
    std::string m_trouble;
    bool m_ends = false;
    std::thread m_thread;
};

} // namespace teleta::site_program
