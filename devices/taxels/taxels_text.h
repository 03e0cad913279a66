// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/keys/keys.h"

#include <QCoreApplication>
#include <QString>

#include <string_view>

namespace teleta::taxels {

/// What described arrays say to people, in one context of the translations.
struct TaxelsText {
    Q_DECLARE_TR_FUNCTIONS(TaxelsText)
};

/// Says that the value of a key does not go with the others.
inline void refuse(core::Keys& keys, std::string_view key, const QString& message, const QString& expected) {
    keys.refuse(key, message.toStdString(), expected.toStdString());
}

} // namespace teleta::taxels
