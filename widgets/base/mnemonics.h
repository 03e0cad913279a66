// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace teleta::base {

/// A name as the text of a button or an action: an & in it is shown and underlines no letter. Thread: any
/// (pure).
[[nodiscard]] inline QString withoutMnemonic(QString name) {
    return name.replace(QLatin1Char('&'), QLatin1String("&&"));
}

} // namespace teleta::base
