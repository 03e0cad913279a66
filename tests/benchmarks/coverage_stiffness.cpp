// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/stiffness/coverage_of_touches.h"
#include "tests/benchmarks/coverage_rows.h"

namespace teleta::benchmarks {

void stiffnessRows(int cases, const TakeRow& take) {
    for (const stiffness::test::DisturbanceName& row : stiffness::test::kDisturbances)
        take(stiffness::test::coverageOf(row, cases, 1));
}

} // namespace teleta::benchmarks
