// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/shape_recogniser.h"
#include "tests/backend/contour/random_contours.h"
#include "tests/benchmarks/coverage_rows.h"

#include <algorithm>
#include <string>

namespace teleta::benchmarks {

/// A row for each tenth of the confidence. covered: the answer is right; flagged: more than one shape comes
/// into question. Random contours, eight times as many as asked for a row, fall into the rows as they come.
void shapeRows(int cases, const TakeRow& take) {
    constexpr int kBins = 10;
    std::vector<CoverageRow> rows;
    for (int bin = 0; bin < kBins; ++bin)
        rows.emplace_back("shape", "confidence 0." + std::to_string(bin) + " to " +
                                       (bin + 1 < kBins ? "0." + std::to_string(bin + 1) : "1"));
    contour::RandomContours random(8001);
    for (int i = 0; i < 8 * cases; ++i) {
        const contour::RandomContour contour = random.next();
        const auto seen = contour::recogniseShape(contour.points_m);
        const int bin = std::min(kBins - 1, static_cast<int>(kBins * seen->confidence));
        rows[static_cast<std::size_t>(bin)].add(seen->shape == contour.truth, seen->candidates().size() == 1,
                                                std::nullopt);
    }
    for (const CoverageRow& row : rows)
        take(row);
}

} // namespace teleta::benchmarks
