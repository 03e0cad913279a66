// SPDX-License-Identifier: GPL-3.0-or-later
// How often the intervals of the estimators hold the truth, as CSV: coverage_benchmark [CASES], 500 a row
// unless told otherwise. covered: the interval, or the bound, holds the truth; flagged: the answer says that
// it is not reliable; refused: there is none; honest: any of the three. median_width: of the intervals, over
// the truth. Of a recognised shape, covered: it is right; flagged: others come into question too; its rows
// are tenths of its confidence. Every row has a generator of its own, which uses no code of the estimator.
#include "tests/benchmarks/coverage_rows.h"

#include <charconv>
#include <cstdio>
#include <cstring>

int main(int argc, char** argv) {
    using namespace teleta::benchmarks;
    int cases = 500;
    if (argc > 1) {
        const char* end = argv[1] + std::strlen(argv[1]);
        if (argc > 2 || std::from_chars(argv[1], end, cases).ptr != end || cases < 1) {
            std::fprintf(stderr, "usage: coverage_benchmark [CASES]\n");
            return 2;
        }
    }
    std::printf("estimator,disturbance,cases,covered,flagged,refused,honest,median_width\n");
    for (const auto rowsOf : {stiffnessRows, transferRows, motorRows, cameraRows, shapeRows}) {
        rowsOf(cases, [](const CoverageRow& row) {
            std::printf("%s,\"%s\",%d,%d,%d,%d,%d,", row.estimator().c_str(), row.disturbance().c_str(),
                        row.cases(), row.covered(), row.flagged(), row.refused(), row.honest());
            if (const auto width = row.medianWidth())
                std::printf("%.4g\n", *width);
            else
                std::printf("NA\n");
            std::fflush(stdout);
        });
    }
    return 0;
}
