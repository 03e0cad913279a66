// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::core {

/// While one of these exists, files and folders that the program makes are for their owner alone (0600,
/// 0700), whatever the umask of the person: for data of participants. A file that replaces another one keeps
/// that one's permissions, so what was opened to others on purpose stays open. The umask is that of the whole
/// process; files that other threads make meanwhile are private, too. Thread: any.
class PrivateFiles {
public:
    PrivateFiles();
    ~PrivateFiles();
    PrivateFiles(const PrivateFiles&) = delete;
    PrivateFiles& operator=(const PrivateFiles&) = delete;
};

} // namespace teleta::core
