// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/base/console_settings.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

namespace teleta::console {

namespace {

/// Group of a recording: its path, hashed because QSettings keys cannot hold slashes.
QString recordingGroup(const QString& path) {
    const QByteArray hash =
        QCryptographicHash::hash(QFileInfo(path).absoluteFilePath().toUtf8(), QCryptographicHash::Sha1);
    return QStringLiteral("recordings/") + QString::fromLatin1(hash.toHex().left(16)) + QLatin1Char('/');
}

/// Before QSettings writes what it could read over it. The copy; empty: there is none.
QString keepCopy(const QString& damaged) {
    const QString copy = damaged + QStringLiteral(".damaged");
    QFile::remove(copy);
    return QFile::copy(damaged, copy) ? copy : QString();
}

QStringList withNewest(QStringList files, const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    files.removeAll(absolute);
    files.prepend(absolute);
    while (files.size() > ConsoleSettings::kRecentFiles)
        files.removeLast();
    return files;
}

} // namespace

ConsoleSettings::ConsoleSettings(bool fresh) {
    if (fresh)
        return;
    m_settings = std::make_unique<QSettings>(QSettings::IniFormat, QSettings::UserScope,
                                             QStringLiteral("teleta"), QStringLiteral("console"));
    m_keptFile = m_settings->fileName();
    const int version = m_settings->value(QStringLiteral("version"), 0).toInt();
    if (version > kVersion) {
        // Written by a newer program: leave its file as it is and remember nothing.
        m_settings.reset();
        m_found = Found::newer;
        return;
    }
    if (m_settings->status() == QSettings::FormatError) {
        m_found = Found::damaged;
        m_keptFile = keepCopy(m_keptFile);
    }
    m_settings->setValue(QStringLiteral("version"), kVersion);
    m_settings->sync();
    if (m_found == Found::usable && m_settings->status() == QSettings::AccessError)
        m_found = Found::unwritable;
}

QStringList ConsoleSettings::recentFiles() const {
    return list(QStringLiteral("recent"));
}

void ConsoleSettings::addRecentFile(const QString& path) {
    addToList(QStringLiteral("recent"), path);
}

QStringList ConsoleSettings::recentPatterns() const {
    return list(QStringLiteral("patterns/recent"));
}

void ConsoleSettings::addRecentPattern(const QString& path) {
    addToList(QStringLiteral("patterns/recent"), path);
}

QStringList ConsoleSettings::list(const QString& key) const {
    return m_settings ? m_settings->value(key).toStringList() : QStringList();
}

void ConsoleSettings::addToList(const QString& key, const QString& path) {
    if (!m_settings)
        return;
    // Another console may have added one, and is to find this one.
    m_settings->sync();
    set(key, withNewest(list(key), path));
    m_settings->sync();
}

QStringList ConsoleSettings::deviceFiles() const {
    return list(QStringLiteral("devices"));
}

void ConsoleSettings::addDeviceFile(const QString& path) {
    addToList(QStringLiteral("devices"), path);
}

std::optional<CsvRequest> ConsoleSettings::recording(const QString& path) const {
    const QString group = recordingGroup(path);
    if (!m_settings || !m_settings->contains(group + QStringLiteral("rows")))
        return std::nullopt;
    const auto value = [&](const char* key) { return m_settings->value(group + QLatin1String(key)); };
    CsvRequest request;
    request.path = path.toStdString();
    request.layout.rows = value("rows").toInt();
    request.layout.columns = value("columns").toInt();
    request.layout.pitch_m = value("pitch_m").toDouble();
    request.tarePath = value("tare").toString().toStdString();
    request.gainsPath = value("gains").toString().toStdString();
    request.inverted = value("inverted").toBool();
    request.gain = value("gain").toDouble();
    request.threshold_N = value("threshold").toDouble();
    request.rate_Hz = value("rate_Hz").toDouble();
    request.loadUnit = value("unit").toString().toStdString();
    const bool usable = request.layout.rows > 0 && request.layout.rows <= core::ArrayLayout::kMaximumSide &&
                        request.layout.columns > 0 &&
                        request.layout.columns <= core::ArrayLayout::kMaximumSide &&
                        request.layout.pitch_m > 0.0 && request.gain > 0.0 && request.threshold_N > 0.0 &&
                        request.rate_Hz >= 0.0;
    return usable ? std::optional(request) : std::nullopt;
}

void ConsoleSettings::setRecording(const CsvRequest& request) {
    const QString group = recordingGroup(QString::fromStdString(request.path));
    set(group + QStringLiteral("rows"), request.layout.rows);
    set(group + QStringLiteral("columns"), request.layout.columns);
    set(group + QStringLiteral("pitch_m"), request.layout.pitch_m);
    set(group + QStringLiteral("tare"), QString::fromStdString(request.tarePath));
    set(group + QStringLiteral("gains"), QString::fromStdString(request.gainsPath));
    set(group + QStringLiteral("inverted"), request.inverted);
    set(group + QStringLiteral("gain"), request.gain);
    set(group + QStringLiteral("threshold"), request.threshold_N);
    set(group + QStringLiteral("rate_Hz"), request.rate_Hz);
    set(group + QStringLiteral("unit"), QString::fromStdString(request.loadUnit));
}

QString ConsoleSettings::text(const QString& key, const QString& fallback) const {
    return m_settings ? m_settings->value(key, fallback).toString() : fallback;
}

QByteArray ConsoleSettings::bytes(const QString& key) const {
    return m_settings ? m_settings->value(key).toByteArray() : QByteArray();
}

void ConsoleSettings::set(const QString& key, const QVariant& value) {
    if (m_settings)
        m_settings->setValue(key, value);
}

} // namespace teleta::console
