// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/store/study_store.h"

#include <string>

namespace teleta::study {

/// A study on a server has its exports and waiting trials in a folder, where server-study.json says whose
/// they are: two studies in one folder would overwrite each other. A study is known by its time and seed, so
/// that it may be reached under several addresses.

/// Error: refused when the folder has a study of its own or that of another server; badInput when the mark is
/// damaged; ioFailed. A folder that is not there, or has no mark, is free. Thread: any.
[[nodiscard]] core::Expected<void> checkFolderOwner(const std::string& folder, const StudyHead& head);

/// Checks it, makes it and leaves the mark. shownName: the server, for people. Error: the same.
[[nodiscard]] core::Expected<void> ownFolder(const std::string& folder, const StudyHead& head,
                                             const std::string& shownName);

} // namespace teleta::study
