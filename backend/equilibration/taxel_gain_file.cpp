// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/equilibration/taxel_gain_file.h"

#include "backend/core/data/csv_number.h"
#include "backend/core/data/csv_reader.h"
#include "backend/core/data/csv_writer.h"
#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace teleta::equilibration {

namespace {

struct GainFileText {
    Q_DECLARE_TR_FUNCTIONS(TaxelGainFile)
};

constexpr std::size_t kNeeded = 4; ///< of the columns; the others may be missing
constexpr double kLeast = 1e-3;
constexpr double kMost = 1e3;
constexpr double kNA = std::numeric_limits<double>::quiet_NaN();

/// Reads a table of gains row by row.
class GainTable {
public:
    GainTable(core::CsvReader csv, const core::ArrayLayout& layout)
        : m_csv(std::move(csv))
        , m_seen(layout.taxels(), false) {
        m_gains.layout = layout;
        m_gains.taxels.resize(layout.taxels());
    }

    [[nodiscard]] core::Expected<TaxelGains> read() {
        TELETA_TRY(const auto columns, m_csv.columns(std::span(kTaxelGainColumns).first<kNeeded>()));
        std::copy(columns.begin(), columns.end(), m_columns.begin());
        m_error = optional("gain_se");
        m_state = optional("state");
        std::vector<std::string_view> fields;
        for (;;) {
            TELETA_TRY(const auto any, m_csv.nextText(fields));
            if (!any)
                break;
            TELETA_CHECK(takeRow(fields));
        }
        for (std::size_t taxel = 0; taxel < m_seen.size(); ++taxel) {
            if (!m_seen[taxel])
                return core::failed(core::ErrorKind::badInput,
                                    GainFileText::tr("taxel %1 is missing").arg(taxel),
                                    GainFileText::tr("the taxels 0 to %1").arg(m_seen.size() - 1),
                                    {m_csv.path(), m_csv.nextLine(), 1});
        }
        return std::move(m_gains);
    }

private:
    /// Index of an optional column; the number of columns when it is missing.
    [[nodiscard]] std::size_t optional(std::string_view name) const {
        const std::vector<std::string>& header = m_csv.header();
        return static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
    }

    [[nodiscard]] core::Unexpected bad(std::size_t column, const QString& message,
                                       const QString& expected) const {
        return core::failed(core::ErrorKind::badInput, message, expected, m_csv.place(column));
    }

    [[nodiscard]] core::Expected<std::size_t> index(std::span<const std::string_view> fields,
                                                    std::size_t which, std::size_t count) const {
        const std::string_view text = fields[m_columns[which]];
        std::size_t value = 0;
        const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (code != std::errc() || end != text.data() + text.size() || value >= count)
            return bad(m_columns[which],
                       GainFileText::tr("the %1 is \"%2\"", "a column of a table")
                           .arg(QString::fromUtf8(kTaxelGainColumns[which].data(),
                                                  static_cast<qsizetype>(kTaxelGainColumns[which].size())),
                                QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())).left(40)),
                       GainFileText::tr("a whole number from 0 to %1").arg(count - 1));
        return value;
    }

    [[nodiscard]] core::Expected<void> takeRow(std::span<const std::string_view> fields) {
        const core::ArrayLayout& layout = m_gains.layout;
        TELETA_TRY(const auto taxel, index(fields, 0, layout.taxels()));
        TELETA_TRY(const auto row, index(fields, 1, static_cast<std::size_t>(layout.rows)));
        TELETA_TRY(const auto column, index(fields, 2, static_cast<std::size_t>(layout.columns)));
        const std::size_t expected = row * static_cast<std::size_t>(layout.columns) + column;
        if (taxel != expected)
            return bad(
                m_columns[0],
                GainFileText::tr("taxel %1 is listed in row %2, column %3").arg(taxel).arg(row).arg(column),
                GainFileText::tr("%1, in an array of %2 rows x %3 columns")
                    .arg(expected)
                    .arg(layout.rows)
                    .arg(layout.columns));
        if (m_seen[taxel])
            return bad(m_columns[0], GainFileText::tr("taxel %1 is listed twice").arg(taxel),
                       GainFileText::tr("each taxel once"));
        m_seen[taxel] = true;

        const std::size_t gainColumn = m_columns[3];
        const std::optional<double> gain = core::numberOrNA(fields[gainColumn]);
        if (!gain || (!std::isnan(*gain) && !(*gain >= kLeast && *gain <= kMost)))
            return bad(gainColumn, GainFileText::tr("the gain is not a number or out of range"),
                       GainFileText::tr("a number from %1 to %2, or NA").arg(kLeast).arg(kMost));
        TaxelGain& taken = m_gains.taxels[taxel];
        taken.gain = *gain;
        taken.state = std::isnan(*gain) ? TaxelState::dead : TaxelState::good;
        taken.error = std::isnan(*gain) ? kNA : 0.0;
        if (m_error < fields.size()) {
            const std::optional<double> error = core::numberOrNA(fields[m_error]);
            if (!error || (!std::isnan(*error) && *error < 0.0))
                return bad(m_error, GainFileText::tr("the standard error is not a number or out of range"),
                           GainFileText::tr("a number of at least 0, or NA"));
            if (taken.isGood() && !std::isnan(*error))
                taken.error = *error;
        }
        if (m_state < fields.size()) {
            const std::optional<TaxelState> state = taxelState(fields[m_state]);
            if (fields[m_state] != "NA" && (!state || (*state == TaxelState::good) != taken.isGood()))
                return bad(m_state, GainFileText::tr("the state does not fit the gain"),
                           taken.isGood() ? QStringLiteral("good")
                                          : QStringLiteral("dead, weak, strong, stuck"));
            if (state)
                taken.state = *state;
        }
        return {};
    }

    core::CsvReader m_csv;
    TaxelGains m_gains;
    std::vector<bool> m_seen;
    std::array<std::size_t, kNeeded> m_columns{};
    std::size_t m_error = 0;
    std::size_t m_state = 0;
};

} // namespace

core::Expected<TaxelGains> readTaxelGains(const std::string& path, const core::ArrayLayout& layout) {
    TELETA_TRY(auto csv, core::CsvReader::open(path));
    return GainTable(std::move(csv), layout).read();
}

core::Expected<void> writeTaxelGains(const TaxelGains& gains, const std::string& path) {
    TELETA_CHECK(core::makeFolder(QFileInfo(QString::fromStdString(path)).absolutePath().toStdString()));
    TELETA_TRY(auto csv, core::CsvWriter::create(path, kTaxelGainColumns));
    writeTaxelGainRows(gains, csv);
    return csv.finish();
}

} // namespace teleta::equilibration
