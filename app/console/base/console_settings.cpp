// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/base/console_settings.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

#include <array>
#include <cmath>
#include <utility>

namespace teleta::console {

namespace {

constexpr char kDockLayouts[] = "layout/named";
constexpr char kPlotLayouts[] = "plot/layouts";

/// Group of a recording: its path, hashed because QSettings keys cannot hold slashes.
QString recordingGroup(const QString& path) {
    const QByteArray hash =
        QCryptographicHash::hash(QFileInfo(path).absoluteFilePath().toUtf8(), QCryptographicHash::Sha1);
    return QStringLiteral("recordings/") + QString::fromLatin1(hash.toHex().left(16)) + QLatin1Char('/');
}

QString frameGroup(const std::string& family) {
    const QByteArray hash =
        QCryptographicHash::hash(QByteArray::fromStdString(family), QCryptographicHash::Sha1);
    return QStringLiteral("frames/") + QString::fromLatin1(hash.toHex().left(16)) + QLatin1Char('/');
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
    // Many recordings do not push out the one scene.
    const bool isRecording = app::isPlayable(absolute);
    int ofItsKind = 0;
    files.removeIf([&](const QString& file) {
        return app::isPlayable(file) == isRecording && ++ofItsKind > ConsoleSettings::kRecentFiles;
    });
    return files;
}

constexpr std::array<std::pair<AtStart, const char*>, 3> kAtStart{
    {{AtStart::offer, "offer"}, {AtStart::open, "open"}, {AtStart::nothing, "nothing"}}};

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

QStringList ConsoleSettings::recentStudies() const {
    return list(QStringLiteral("study/recent"));
}

void ConsoleSettings::addRecentStudy(const QString& folder) {
    addToList(QStringLiteral("study/recent"), folder);
}

void ConsoleSettings::clearRecent() {
    for (const char* key : {"recent", "patterns/recent", "study/recent"})
        set(QLatin1String(key), QStringList());
}

AtStart ConsoleSettings::atStart() const {
    const QString word = text(QStringLiteral("session/at_start"), {});
    for (const auto& [choice, known] : kAtStart)
        if (word == QLatin1String(known))
            return choice;
    return AtStart::offer;
}

void ConsoleSettings::setAtStart(AtStart choice) {
    for (const auto& [known, word] : kAtStart)
        if (known == choice)
            set(QStringLiteral("session/at_start"), QLatin1String(word));
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

std::optional<app::CsvRequest> ConsoleSettings::recording(const QString& path) const {
    const QString group = recordingGroup(path);
    if (!m_settings || !m_settings->contains(group + QStringLiteral("rows")))
        return std::nullopt;
    const auto value = [&](const char* key) { return m_settings->value(group + QLatin1String(key)); };
    app::CsvRequest request;
    request.path = path.toStdString();
    request.layout.rows = value("rows").toInt();
    request.layout.columns = value("columns").toInt();
    request.layout.setPitch_m(value("pitch_m").toDouble());
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
                        request.layout.pitchX_m > 0.0 && request.gain > 0.0 && request.threshold_N > 0.0 &&
                        request.rate_Hz >= 0.0;
    return usable ? std::optional(request) : std::nullopt;
}

void ConsoleSettings::setRecording(const app::CsvRequest& request) {
    const QString group = recordingGroup(QString::fromStdString(request.path));
    set(group + QStringLiteral("rows"), request.layout.rows);
    set(group + QStringLiteral("columns"), request.layout.columns);
    set(group + QStringLiteral("pitch_m"), request.layout.pitchX_m);
    set(group + QStringLiteral("tare"), QString::fromStdString(request.tarePath));
    set(group + QStringLiteral("gains"), QString::fromStdString(request.gainsPath));
    set(group + QStringLiteral("inverted"), request.inverted);
    set(group + QStringLiteral("gain"), request.gain);
    set(group + QStringLiteral("threshold"), request.threshold_N);
    set(group + QStringLiteral("rate_Hz"), request.rate_Hz);
    set(group + QStringLiteral("unit"), QString::fromStdString(request.loadUnit));
}

std::optional<frames::FrameRequest> ConsoleSettings::frameRequest(const std::string& family) const {
    const QString group = frameGroup(family);
    if (family.empty() || !m_settings || !m_settings->contains(group + QStringLiteral("axis")))
        return std::nullopt;
    const auto value = [&](const char* key) { return m_settings->value(group + QLatin1String(key)); };
    const auto side = [&](const char* key) {
        const int number = value(key).toInt();
        return number > 0 && number <= core::ArrayLayout::kMaximumSide ? std::optional(number) : std::nullopt;
    };
    const auto positive = [&](const char* key) {
        const double number = value(key).toDouble();
        return number > 0.0 && std::isfinite(number) ? std::optional(number) : std::nullopt;
    };
    const int axis = value("axis").toInt();
    frames::FrameRequest request;
    request.array = value("array").toString().toStdString();
    if (axis >= 0 && axis <= static_cast<int>(frames::FrameAxis::last))
        request.axis = static_cast<frames::FrameAxis>(axis);
    request.rows = side("rows");
    request.columns = side("columns");
    request.pitch_m = positive("pitch_m");
    request.rate_Hz = positive("rate_Hz");
    request.taxelColumns = frames::columnRangesOf(value("taxels").toString().toStdString())
                               .value_or(std::vector<frames::ColumnRange>());
    request.timeColumn = value("time").toString().toStdString();
    request.timeUnit = value("time_unit").toString().toStdString();
    request.threshold = positive("threshold");
    request.knownPath = value("layout").toString().toStdString();
    return request;
}

void ConsoleSettings::setFrameRequest(const std::string& family, const frames::FrameRequest& request) {
    if (family.empty())
        return;
    const QString group = frameGroup(family);
    set(group + QStringLiteral("array"), QString::fromStdString(request.array));
    set(group + QStringLiteral("axis"), static_cast<int>(request.axis));
    set(group + QStringLiteral("rows"), request.rows.value_or(0));
    set(group + QStringLiteral("columns"), request.columns.value_or(0));
    set(group + QStringLiteral("pitch_m"), request.pitch_m.value_or(0.0));
    set(group + QStringLiteral("rate_Hz"), request.rate_Hz.value_or(0.0));
    set(group + QStringLiteral("taxels"), QString::fromStdString(frames::textOf(request.taxelColumns)));
    set(group + QStringLiteral("time"), QString::fromStdString(request.timeColumn));
    set(group + QStringLiteral("time_unit"), QString::fromStdString(request.timeUnit));
    set(group + QStringLiteral("threshold"), request.threshold.value_or(0.0));
    set(group + QStringLiteral("layout"), QString::fromStdString(request.knownPath));
}

QString ConsoleSettings::text(const QString& key, const QString& fallback) const {
    return m_settings ? m_settings->value(key, fallback).toString() : fallback;
}

QByteArray ConsoleSettings::bytes(const QString& key) const {
    return m_settings ? m_settings->value(key).toByteArray() : QByteArray();
}

bool ConsoleSettings::flag(const QString& key, bool fallback) const {
    return m_settings ? m_settings->value(key, fallback).toBool() : fallback;
}

QMap<QString, QByteArray> ConsoleSettings::namedLayouts() const {
    return named(QLatin1String(kDockLayouts));
}

void ConsoleSettings::setNamedLayout(const QString& name, const QByteArray& layout) {
    setNamed(QLatin1String(kDockLayouts), name, layout);
}

QMap<QString, QByteArray> ConsoleSettings::plotLayouts() const {
    return named(QLatin1String(kPlotLayouts));
}

void ConsoleSettings::setPlotLayout(const QString& name, const QByteArray& layout) {
    setNamed(QLatin1String(kPlotLayouts), name, layout);
}

QMap<QString, QByteArray> ConsoleSettings::named(const QString& key) const {
    QMap<QString, QByteArray> layouts;
    if (!m_settings)
        return layouts;
    const QVariantMap stored = m_settings->value(key).toMap();
    for (auto layout = stored.begin(); layout != stored.end(); ++layout)
        layouts.insert(layout.key(), layout.value().toByteArray());
    return layouts;
}

void ConsoleSettings::setNamed(const QString& key, const QString& name, const QByteArray& layout) {
    if (!m_settings)
        return;
    // Another console may have saved one.
    m_settings->sync();
    QVariantMap stored = m_settings->value(key).toMap();
    if (layout.isEmpty())
        stored.remove(name);
    else
        stored.insert(name, layout);
    set(key, stored);
    m_settings->sync();
}

void ConsoleSettings::set(const QString& key, const QVariant& value) {
    if (m_settings)
        m_settings->setValue(key, value);
}

} // namespace teleta::console
