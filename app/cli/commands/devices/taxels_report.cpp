// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/devices/taxels_report.h"

#include <QCoreApplication>
#include <QString>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

namespace teleta::cli {

namespace {

struct TaxelsReportText {
    Q_DECLARE_TR_FUNCTIONS(TaxelsReportText)
};

constexpr std::size_t kBytesInLine = 16;
constexpr std::size_t kWidestGrid = 32;

std::string hexOf(std::uint8_t byte) {
    std::array<char, 4> text{};
    std::snprintf(text.data(), text.size(), "%02X", static_cast<unsigned>(byte));
    return text.data();
}

std::string bytesText(const taxels::TaxelsProbe& probe) {
    std::set<std::uint64_t> begins;
    for (const auto& frame : probe.frames)
        begins.insert(frame.begin);
    std::string text;
    for (std::size_t line = 0; line < probe.bytes.size(); line += kBytesInLine) {
        std::array<char, 24> place{};
        std::snprintf(place.data(), place.size(), "%06zx ", line);
        std::string bytes = place.data();
        std::string letters;
        for (std::size_t i = line; i < std::min(line + kBytesInLine, probe.bytes.size()); ++i) {
            const std::uint8_t byte = probe.bytes[i];
            bytes += (begins.contains(i) ? '>' : ' ') + hexOf(byte);
            letters += byte >= 0x20 && byte < 0x7F ? static_cast<char>(byte) : '.';
        }
        bytes.resize(std::max(bytes.size(), std::size_t{7 + 3 * kBytesInLine}), ' ');
        text += bytes + "  " + letters + '\n';
    }
    return text;
}

QString numberText(float value) {
    const QString number = std::isnan(value) ? QStringLiteral(".") : forPeople(static_cast<double>(value));
    return number.rightJustified(10);
}

/// A line a taxel: its number, place in mm, and what it tells.
std::string placesText(const TaxelsReport& report) {
    constexpr double kMillimetres = 1e3;
    const auto components = static_cast<std::size_t>(report.layout.components());
    std::string text;
    for (std::size_t taxel = 0; taxel < report.layout.taxels(); ++taxel) {
        QString line = QString::number(taxel).rightJustified(5) +
                       forPeople(kMillimetres * report.layout.x_m(taxel)).rightJustified(10) +
                       forPeople(kMillimetres * report.layout.y_m(taxel)).rightJustified(10);
        for (std::size_t k = 0; k < components; ++k)
            line += numberText(report.probe.first[taxel * components + k]);
        if (!report.layout.isAbsent(taxel))
            text += line.toStdString() + '\n';
    }
    return text;
}

std::string gridText(const TaxelsReport& report) {
    const auto columns = static_cast<std::size_t>(report.layout.grid().columns);
    std::string text;
    for (std::size_t row = static_cast<std::size_t>(report.layout.grid().rows); row-- > 0;) {
        for (std::size_t column = 0; column < std::min(columns, kWidestGrid); ++column)
            text += numberText(report.probe.first[row * columns + column]).toStdString();
        text += columns > kWidestGrid ? " ...\n" : "\n";
    }
    return text;
}

} // namespace

void addFields(const TaxelsReport& report, Fields& fields) {
    const auto& counted = report.probe.counters;
    const auto add = [&](const QString& name, std::uint64_t count) {
        fields.emplace_back(name, QString::number(count));
    };
    add(TaxelsReportText::tr("Frames found"), counted.frames);
    add(TaxelsReportText::tr("Bytes of frames"), counted.frameBytes);
    add(TaxelsReportText::tr("Bytes outside frames"), counted.droppedBytes);
    add(TaxelsReportText::tr("Wrong checksums"), counted.badChecksums);
    add(TaxelsReportText::tr("Wrong lengths"), counted.badSizes);
    add(TaxelsReportText::tr("Wrong closing bytes"), counted.badEnds);
    add(TaxelsReportText::tr("Unreadable values"), counted.badValues);
    add(TaxelsReportText::tr("Frames of another length"), counted.otherFrames);
    if (report.probe.binaryMessages > 0)
        add(TaxelsReportText::tr("Binary messages, which are left out"), report.probe.binaryMessages);
}

std::string textOf(const TaxelsReport& report) {
    std::string text;
    if (!report.probe.bytes.empty())
        text = '\n' + TaxelsReportText::tr("Bytes (> begins a frame)").toStdString() + '\n' +
               bytesText(report.probe);
    const bool isGridOfLoads = report.layout.isGrid() && !report.layout.isVector();
    if (!report.probe.first.empty() && !isGridOfLoads)
        text += '\n' +
                (report.layout.isVector()
                     ? TaxelsReportText::tr("First frame: taxel, x and y in mm, and its x, y and z in %1")
                     : TaxelsReportText::tr("First frame: taxel, x and y in mm, and its load in %1"))
                    .arg(QString::fromStdString(report.unit))
                    .toStdString() +
                '\n' + placesText(report);
    if (!report.probe.first.empty() && isGridOfLoads)
        text += '\n' +
                TaxelsReportText::tr("First frame in %1, the last row first")
                    .arg(QString::fromStdString(report.unit))
                    .toStdString() +
                '\n' + gridText(report);
    return text;
}

nlohmann::ordered_json toJson(const TaxelsReport& report) {
    const taxels::TaxelsProbe& probe = report.probe;
    std::string hex;
    for (const std::uint8_t byte : probe.bytes)
        hex += hexOf(byte);
    nlohmann::ordered_json places = nlohmann::ordered_json::array();
    for (const auto& frame : probe.frames)
        if (frame.begin < probe.bytes.size())
            places.push_back({{"begin", frame.begin}, {"bytes", frame.bytes}});
    nlohmann::ordered_json values = nlohmann::ordered_json::array();
    for (const float value : probe.first)
        values.push_back(std::isnan(value) ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(value));
    return {{"rows", report.layout.grid().rows},
            {"columns", report.layout.grid().columns},
            {"components", report.layout.components()},
            {"unit", report.unit},
            {"frames", probe.counters.frames},
            {"frame_bytes", probe.counters.frameBytes},
            {"dropped_bytes", probe.counters.droppedBytes},
            {"wrong_checksums", probe.counters.badChecksums},
            {"wrong_lengths", probe.counters.badSizes},
            {"wrong_ends", probe.counters.badEnds},
            {"unreadable_values", probe.counters.badValues},
            {"other_frames", probe.counters.otherFrames},
            {"binary_messages", probe.binaryMessages},
            {"bytes_hex", hex},
            {"frames_found", std::move(places)},
            {"first_frame", std::move(values)}};
}

} // namespace teleta::cli
