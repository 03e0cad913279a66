// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/trial.h"

#include <QString>

#include <optional>

namespace teleta::study {

/// A whole page: title, the mode's banner unless it is a run, and the body, which is HTML inside <main>. It
/// needs no other file, is well-formed XML, and fits light and dark screens and paper. Thread: any.
[[nodiscard]] QString reportPage(const QString& title, std::optional<Mode> mode, const QString& body);

} // namespace teleta::study
