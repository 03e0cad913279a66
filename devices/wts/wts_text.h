// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace teleta::wts {

/// What the device says to people, in one context of the translations.
struct WtsText {
    Q_DECLARE_TR_FUNCTIONS(WtsText)
};

} // namespace teleta::wts
