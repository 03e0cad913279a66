// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"

#include "app/cli/base/options.h"
#include "app/cli/base/standard_streams.h"
#include "backend/core/number_text.h"
#include "backend/core/steady_time.h"

#include <QCoreApplication>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace teleta::cli {

namespace {

constexpr int kTableDigits = 4;
constexpr std::size_t kTableWidth = 11; // "-1.234e-05" and a blank
constexpr std::int64_t kFlushInterval_ns = 100'000'000;

struct OutputText {
    Q_DECLARE_TR_FUNCTIONS(OutputText)
};

/// Text as a JSON string; bytes that are not UTF-8 are replaced.
std::string jsonString(std::string_view text) {
    return nlohmann::json(std::string(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace

ExitCode exitCode(const core::Error& error) {
    const bool isOfInput = error.kind == core::ErrorKind::badInput || error.kind == core::ErrorKind::notFound;
    return isOfInput ? kBadInput : kWorkFailed;
}

void printError(const core::Error& error) {
    std::fprintf(stderr, "teleta: %s\n", core::describe(error).c_str());
}

void warn(const QString& text) {
    std::fprintf(stderr, "teleta: %s\n", text.toUtf8().constData());
}

void declareJson(CLI::App& app, bool& json) {
    addFlag(app, "-j,--json", json, OutputText::tr("Print one JSON document on standard output"));
}

void declareOut(CLI::App& app, std::string& outPath) {
    addOption(app, "-o,--out", outPath,
              OutputText::tr("Write the CSV to this file, which appears when it is complete"), "FILE");
}

QString forPeople(double value, int digits) {
    const core::NumberText text(value, digits);
    return QString::fromLatin1(text.view().data(), static_cast<qsizetype>(text.view().size()));
}

nlohmann::ordered_json orNull(const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json textOrNull(const std::string& text) {
    return text.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(text);
}

core::Expected<void> printText(std::string_view text) {
    core::OutputFile output = core::OutputFile::standardOutput();
    output.write(text);
    return output.finish();
}

core::Expected<void> printDocument(const nlohmann::ordered_json& document) {
    return printText(document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

core::Expected<void> printFields(const Fields& fields) {
    qsizetype width = 0;
    for (const auto& [label, value] : fields)
        width = std::max(width, label.size());
    std::string text;
    for (const auto& [label, value] : fields)
        text += (label.leftJustified(width + 2) + value + QLatin1Char('\n')).toStdString();
    if (!standardOutputIsFile())
        return printText(text);
    std::fputs(text.c_str(), stderr);
    return {};
}

RowOutput::RowOutput(std::span<const std::string_view> columns)
    : m_columns(columns.begin(), columns.end()) {
}

core::Expected<RowOutput> RowOutput::open(std::span<const std::string_view> columns,
                                          const RowOptions& options) {
    RowOutput rows(columns);
    rows.m_json = options.json;
    rows.m_table = !options.json && options.outPath.empty() && isatty(STDOUT_FILENO) != 0;
    if (!options.outPath.empty()) {
        TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(options.outPath, columns));
        rows.m_csv = std::move(csv);
    } else if (!options.json && !rows.m_table) {
        rows.m_csv.emplace(core::OutputFile::standardOutput(), columns);
    }
    if (rows.m_json || rows.m_table)
        rows.m_text = core::OutputFile::standardOutput();
    if (rows.m_json)
        rows.m_text->write("[");
    if (rows.m_table) {
        for (const std::string_view column : columns)
            rows.cell(column);
        rows.endRow();
    }
    return rows;
}

void RowOutput::number(double value) {
    number(std::isnan(value) ? std::nullopt : std::optional(value));
}

void RowOutput::number(const std::optional<double>& value) {
    if (m_csv)
        m_csv->number(value);
    if (m_json)
        jsonValue(value && std::isfinite(*value) ? core::NumberText(*value).view() : "null");
    if (m_table)
        cell(value ? core::NumberText(*value, kTableDigits).view() : "NA");
}

void RowOutput::integer(long long value) {
    if (m_csv)
        m_csv->integer(value);
    if (m_json)
        jsonValue(core::NumberText(value).view());
    if (m_table)
        cell(core::NumberText(value).view());
}

void RowOutput::text(std::string_view value) {
    if (m_csv)
        m_csv->text(value);
    if (m_json)
        jsonValue(jsonString(value));
    if (m_table)
        cell(value);
}

void RowOutput::jsonValue(std::string_view value) {
    if (m_field == 0)
        m_text->write(m_firstRow ? "\n{" : ",\n{");
    else
        m_text->write(",");
    m_text->write("\"");
    m_text->write(m_columns[m_field++]);
    m_text->write("\":");
    m_text->write(value);
}

/// Right-aligned to the width of its column.
void RowOutput::cell(std::string_view value) {
    const std::size_t width = std::max(kTableWidth, m_columns[m_field++].size() + 1);
    m_text->write(std::string(width - std::min(width - 1, value.size()), ' '));
    m_text->write(value);
}

void RowOutput::endRow() {
    if (m_csv)
        m_csv->endRow();
    if (m_json)
        m_text->write("}");
    if (m_table)
        m_text->write("\n");
    m_firstRow = false;
    m_field = 0;
}

bool RowOutput::failed() const {
    return (m_csv && m_csv->failed()) || (m_text && m_text->failed());
}

void RowOutput::flushIfDue() {
    const std::int64_t now_ns = core::steadyNow_ns();
    if (now_ns < m_nextFlush_ns)
        return;
    m_nextFlush_ns = now_ns + kFlushInterval_ns;
    flush();
}

void RowOutput::flush() {
    if (m_csv)
        m_csv->flush();
    if (m_text)
        m_text->flush();
}

core::Expected<void> RowOutput::finish() {
    core::Expected<void> done;
    if (m_csv)
        done = m_csv->finish();
    if (m_text) {
        if (m_json)
            m_text->write(m_firstRow ? "]\n" : "\n]\n");
        const core::Expected<void> finished = m_text->finish();
        if (done)
            done = finished;
    }
    return done;
}

} // namespace teleta::cli
