// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/protocol.h"

#include <QString>

namespace teleta::console {

/// A protocol in words, as HTML: what a trial is, practice and test, tasks, questionnaires, what does not
/// count. Texts of the file are escaped. Thread: any (pure).
[[nodiscard]] QString protocolSummary(const study::Protocol& protocol);

} // namespace teleta::console
