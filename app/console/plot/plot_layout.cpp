// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/plot/plot_layout.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace teleta::console {

namespace {

constexpr int kPlotLayoutVersion = 1;

} // namespace

QByteArray toJson(const PlotLayout& layout) {
    QJsonArray plotted;
    for (const PlottedSignal& each : layout.plotted)
        plotted.append(QJsonObject{{"source", QString::fromStdString(each.id.source)},
                                   {"stream", QString::fromStdString(each.id.stream)},
                                   {"column", QString::fromStdString(each.id.column)},
                                   {"derivative", each.derivative},
                                   {"spectrum", each.spectrum}});
    return QJsonDocument(QJsonObject{{"version", kPlotLayoutVersion},
                                     {"span_s", layout.span_s},
                                     {"density", layout.density},
                                     {"clock", layout.clock},
                                     {"signals", plotted}})
        .toJson(QJsonDocument::Compact);
}

std::optional<PlotLayout> plotLayoutOf(const QByteArray& json) {
    const QJsonObject object = QJsonDocument::fromJson(json).object();
    const double span_s = object["span_s"].toDouble();
    if (object["version"].toInt() != kPlotLayoutVersion || !(span_s > 0.0))
        return std::nullopt;
    PlotLayout layout{{}, span_s, object["density"].toBool(), object["clock"].toBool()};
    for (const QJsonValue& value : object["signals"].toArray()) {
        const QJsonObject each = value.toObject();
        layout.plotted.push_back(
            {{each["source"].toString().toStdString(), each["stream"].toString().toStdString(),
              each["column"].toString().toStdString()},
             each["derivative"].toBool(),
             each["spectrum"].toBool()});
    }
    return layout;
}

} // namespace teleta::console
