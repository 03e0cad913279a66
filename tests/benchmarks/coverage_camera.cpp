// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/vision/foreign_coverage.h"
#include "tests/benchmarks/coverage_rows.h"

namespace teleta::benchmarks {

namespace {

using namespace vision;

/// Counts where a camera locates one point of the tube along its axis; widths in mm.
void count(CoverageRow& row, const ForeignCamera& truth, const Calibration& calibration, double angle_rad,
           double z_m) {
    const auto point = located(truth, withoutNoise(calibration.camera), angle_rad, z_m);
    if (!point)
        return row.add(false, calibration.isReliable(), std::nullopt);
    row.add(std::abs(point->error_m.x()) <= kNormal95 * point->deviation_m.x(), calibration.isReliable(),
            2e3 * kNormal95 * point->deviation_m.x());
}

void rowsOf(const std::string& name, ForeignLens lens, const ForeignPairs& how, int cases,
            const TakeRow& take) {
    ForeignLottery lottery(1);
    CoverageRow whole("camera", name);
    CoverageRow far("camera", name + ", far end");
    for (int i = 0; i < cases; ++i) {
        const ForeignCamera truth = lottery.camera(lens);
        const auto calibration = calibrate(lottery.pairs(truth, how), {}, CalibrationMethod::robust);
        const auto angle = [&] { return lottery.uniform(0.0, 2.0 * std::numbers::pi); };
        const auto anywhere = std::pair(angle(), lottery.uniform(0.02, 0.1));
        const auto atTheEnd = std::pair(angle(), lottery.uniform(0.075, 0.1));
        if (calibration) {
            count(whole, truth, *calibration, anywhere.first, anywhere.second);
            count(far, truth, *calibration, atTheEnd.first, atTheEnd.second);
        } else {
            whole.addRefused();
            far.addRefused();
        }
    }
    take(whole);
    take(far);
}

} // namespace

void cameraRows(int cases, const TakeRow& take) {
    struct Disturbance {
        std::string name;
        ForeignPairs pairs;
    };
    const Disturbance disturbances[] = {{"250 holes", {}},
                                        {"four nearest rings", {.nearest_m = 0.036}},
                                        {"hole factor 0.97 forgotten", {.holeFactor = 0.97}},
                                        {"u and v swapped", {.swapped = true}}};
    for (const Disturbance& disturbance : disturbances) {
        for (const ForeignLens lens : kForeignLenses)
            rowsOf(std::string(nameOf(lens)) + ", " + disturbance.name, lens, disturbance.pairs, cases, take);
    }
}

} // namespace teleta::benchmarks
