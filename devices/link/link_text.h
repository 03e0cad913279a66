// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace teleta::link {

/// What links say to people, in one context of the translations.
struct LinkText {
    Q_DECLARE_TR_FUNCTIONS(LinkText)
};

} // namespace teleta::link
