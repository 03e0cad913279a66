// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/study/store/study_store.h"

#include <string>

namespace teleta::study {

/// A study on a server keeps its exports and pending trials in a local folder; server-study.json in it names
/// the owner, because two studies in one folder would overwrite each other. A study is identified by its time
/// of creation and seed, since it may be reached under several addresses.

/// Error: refused when the folder contains a local study or belongs to another one; badInput when the file is
/// damaged; ioFailed. A missing folder, or one without the file, is free. Thread: any.
[[nodiscard]] core::Expected<void> checkFolderOwner(const std::string& folder, const StudyHead& head);

/// Checks the folder, creates it and writes the file. shownName: the server, for people. Error: the same.
[[nodiscard]] core::Expected<void> ownFolder(const std::string& folder, const StudyHead& head,
                                             const std::string& shownName);

} // namespace teleta::study
