// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace teleta::console {

/// What a sweep that comes with the program is called and asks, in the language. Thread: any (pure).
struct SweepText {
    QString topic;
    QString title;
    QString about;
};

/// name: as app::sweepNames() has it. One that is not known has its name as title.
[[nodiscard]] SweepText sweepText(const QString& name);

} // namespace teleta::console
