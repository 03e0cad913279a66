// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/signal/signals_mime.h"

#include <QDataStream>
#include <QIODevice>
#include <QMimeData>
#include <QStringList>

namespace teleta::signal {

namespace {

constexpr char kType[] = "application/x-teleta-signals";
constexpr qsizetype kParts = 3; // source, stream, column

} // namespace

std::unique_ptr<QMimeData> mimeOf(const std::vector<SignalId>& signalIds) {
    QStringList parts;
    for (const SignalId& id : signalIds)
        for (const std::string* part : {&id.source, &id.stream, &id.column})
            parts << QString::fromStdString(*part);
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream << parts;
    auto mime = std::make_unique<QMimeData>();
    mime->setData(QLatin1String(kType), bytes);
    return mime;
}

std::vector<SignalId> signalsOf(const QMimeData& mime) {
    QStringList parts;
    QDataStream stream(mime.data(QLatin1String(kType)));
    stream >> parts;
    std::vector<SignalId> ids;
    for (qsizetype i = 0; i + kParts <= parts.size(); i += kParts)
        ids.push_back({parts[i].toStdString(), parts[i + 1].toStdString(), parts[i + 2].toStdString()});
    return ids;
}

} // namespace teleta::signal
