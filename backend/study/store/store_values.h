// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QMetaType>
#include <QString>
#include <QVariant>

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>

namespace teleta::study {

/// Values as the tables of a study have them: times in UTC as text, what is missing as NULL of its type.
inline QString timeText(const QDateTime& time) {
    return time.toUTC().toString(Qt::ISODateWithMs);
}

inline QDateTime timeOf(const QString& text) {
    return QDateTime::fromString(text, Qt::ISODateWithMs).toUTC();
}

inline QVariant number(std::size_t value) {
    return static_cast<qlonglong>(value);
}

template <typename Value>
QVariant orNull(const std::optional<Value>& value) {
    if constexpr (std::is_same_v<Value, double>)
        return value ? QVariant(*value) : QVariant(QMetaType(QMetaType::Double));
    else
        return value ? number(*value) : QVariant(QMetaType(QMetaType::LongLong));
}

inline QVariant orNull(const std::string& text) {
    return text.empty() ? QVariant(QMetaType(QMetaType::QString)) : QVariant(QString::fromStdString(text));
}

inline std::optional<double> optionalNumber(const QVariant& value) {
    return value.isNull() ? std::nullopt : std::optional(value.toDouble());
}

inline std::size_t count(const QVariant& value) {
    return static_cast<std::size_t>(value.toLongLong());
}

} // namespace teleta::study
