// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/cost_file.h"

#include "backend/core/data/csv_number.h"
#include "backend/core/data/csv_reader.h"
#include "backend/core/failure.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace teleta::cost {

namespace {

struct CostFileText {
    Q_DECLARE_TR_FUNCTIONS(CostFileText)
};

core::Unexpected badField(const core::CsvReader& reader, std::size_t column, std::string_view text,
                          const QString& expected) {
    return core::failed(core::ErrorKind::badInput,
                        CostFileText::tr("\"%1\" is not a value of the column %2")
                            .arg(QString::fromUtf8(text), QString::fromStdString(reader.header()[column])),
                        expected, reader.place(column));
}

} // namespace

void writeCosts(std::span<const LadderCost> ladders, core::CsvWriter& writer) {
    for (const LadderCost& ladder : ladders)
        for (const RungCost& rung : ladder.rungs) {
            writer.text(ladder.ladder);
            writer.text(rung.name);
            writer.text(rung.parameter);
            for (const double error : {rung.errorMean, rung.errorP95, rung.errorMax})
                writer.number(error);
            writer.text(ladder.errorUnit);
            writer.number(rung.timeMedian_s);
            writer.number(rung.timeP99_s);
            writer.integer(static_cast<long long>(rung.samples));
            writer.text(rung.pareto ? "yes" : "no");
            writer.endRow();
        }
}

core::Expected<void> writeCostFile(std::span<const LadderCost> ladders, const std::string& path) {
    TELETA_TRY(core::CsvWriter writer, core::CsvWriter::create(path, kCostColumns));
    writeCosts(ladders, writer);
    return writer.finish();
}

core::Expected<std::vector<LadderCost>> readCostFile(const std::string& path) {
    TELETA_TRY(core::CsvReader reader, core::CsvReader::open(path));
    TELETA_TRY(const std::vector<std::size_t> columns, reader.columns(kCostColumns));
    std::vector<LadderCost> ladders;
    std::vector<std::string_view> fields;
    for (;;) {
        TELETA_TRY(const bool more, reader.nextText(fields));
        if (!more)
            return ladders;
        const auto field = [&](std::size_t i) { return fields[columns[i]]; };
        std::array<double, kCostColumns.size()> numbers{};
        for (const std::size_t i : {3U, 4U, 5U, 7U, 8U, 9U}) {
            const std::optional<double> number = core::numberOrNA(field(i));
            if (!number || (!std::isnan(*number) && *number < 0.0))
                return badField(reader, columns[i], field(i),
                                CostFileText::tr("a number that is not negative, or NA"));
            numbers[i] = *number;
        }
        if (field(10) != "yes" && field(10) != "no")
            return badField(reader, columns[10], field(10), CostFileText::tr("yes or no"));
        constexpr double kMostSamples = 1e9;
        if (std::isnan(numbers[9]) || numbers[9] > kMostSamples)
            return badField(reader, columns[9], field(9), CostFileText::tr("a number of samples"));
        auto ladder = std::ranges::find(ladders, field(0), &LadderCost::ladder);
        if (ladder == ladders.end()) {
            ladders.push_back({std::string(field(0)), std::string(field(6)), {}});
            ladder = ladders.end() - 1;
        }
        ladder->rungs.push_back({.name = std::string(field(1)),
                                 .parameter = std::string(field(2)),
                                 .errorMean = numbers[3],
                                 .errorP95 = numbers[4],
                                 .errorMax = numbers[5],
                                 .timeMedian_s = numbers[7],
                                 .timeP99_s = numbers[8],
                                 .samples = static_cast<std::size_t>(numbers[9]),
                                 .spread = std::numeric_limits<double>::quiet_NaN(),
                                 .pareto = field(10) == "yes"});
    }
}

} // namespace teleta::cost
