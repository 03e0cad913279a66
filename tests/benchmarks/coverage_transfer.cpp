// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/study/answering_people.h"
#include "tests/benchmarks/coverage_rows.h"

namespace teleta::benchmarks {

void transferRows(int cases, const TakeRow& take) {
    using namespace study;
    std::mt19937_64 random(1);
    for (const Design& design : {Design{6, 5, 0.0}, Design{6, 5, 5.0}, Design{12, 5, 0.0}, Design{12, 5, 5.0},
                                 Design{24, 10, 0.0}, Design{24, 10, 5.0}, Design{3, 2, 0.0}}) {
        for (const PaperTable& table : kPaperTables) {
            const Shares shares = sharesOf(table);
            const double truth_bit = trueTransfer_bit(shares);
            CoverageRow row("information transfer", table.name + ", " + std::to_string(design.people) +
                                                        " people x " + std::to_string(design.presentations) +
                                                        (design.alike > 0.0 ? ", who differ" : ""));
            for (int i = 0; i < cases; ++i) {
                const auto transfer = studyTransfer(simulate(design, shares, random));
                if (!transfer) {
                    row.addRefused();
                    continue;
                }
                std::optional<double> width;
                if (transfer->interval)
                    width = (transfer->interval->high - transfer->interval->low) / truth_bit;
                row.add(holds(*transfer, truth_bit), true, width);
            }
            take(row);
        }
    }
}

} // namespace teleta::benchmarks
