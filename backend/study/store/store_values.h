// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/trial.h"

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

inline QVariant sqlValue(std::size_t value) {
    return static_cast<qlonglong>(value);
}
inline QVariant sqlValue(double value) {
    return value;
}
inline QVariant sqlValue(Phase phase) {
    return QString::fromLatin1(toString(phase));
}
inline QVariant sqlValue(Outcome outcome) {
    return QString::fromLatin1(toString(outcome));
}
inline QVariant sqlValue(const QDateTime& time) {
    return timeText(time);
}
/// An empty text is NULL.
inline QVariant sqlValue(const std::string& text) {
    return text.empty() ? QVariant(QMetaType(QMetaType::QString)) : QVariant(QString::fromStdString(text));
}
template <typename Value>
QVariant sqlValue(const std::optional<Value>& value) {
    const auto type = std::is_same_v<Value, double> ? QMetaType::Double : QMetaType::LongLong;
    return value ? sqlValue(*value) : QVariant(QMetaType(type));
}

inline std::string stringOf(const QVariant& value) {
    return value.toString().toStdString();
}
inline std::size_t count(const QVariant& value) {
    return static_cast<std::size_t>(value.toLongLong());
}

/// The inverse of sqlValue().
inline void readInto(const QVariant& value, std::size_t& number) {
    number = count(value);
}
inline void readInto(const QVariant& value, double& number) {
    number = value.toDouble();
}
inline void readInto(const QVariant& value, Phase& phase) {
    phase = phaseOf(stringOf(value)).value_or(Phase::test);
}
inline void readInto(const QVariant& value, Outcome& outcome) {
    outcome = outcomeOf(stringOf(value)).value_or(Outcome::aborted);
}
inline void readInto(const QVariant& value, QDateTime& time) {
    time = timeOf(value.toString());
}
inline void readInto(const QVariant& value, std::string& words) {
    words = stringOf(value);
}
template <typename Value>
void readInto(const QVariant& value, std::optional<Value>& known) {
    if (!value.isNull())
        readInto(value, known.emplace());
}

} // namespace teleta::study
