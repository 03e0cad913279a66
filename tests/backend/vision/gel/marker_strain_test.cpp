// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/marker_strain.h"

#include <gtest/gtest.h>

namespace teleta::vision {
namespace {

/// A square grid that moves by d = (1, 2) mm + G x.
struct Sheet {
    explicit Sheet(const Eigen::Matrix2d& gradient) {
        std::vector<Eigen::Vector2d> places;
        for (int i = 0; i < 25; ++i) {
            places.emplace_back(0.002 * (i % 5), 0.002 * (i / 5)); // NOLINT(bugprone-integer-division)
            markers.push_back({.rest_m = places.back()});
            motions.push_back(
                {.found = true, .displacement_m = Eigen::Vector2d(0.001, 0.002) + gradient * places.back()});
        }
        neighbours = markerNeighbours(places);
    }
    std::vector<GelMarker> markers;
    std::vector<GelMotion> motions;
    std::vector<std::vector<std::size_t>> neighbours;
    std::vector<MarkerStrain> strains;
};

} // namespace

TEST(MarkerStrain, isThatOfAnAffineMotionAtEachMarker) {
    Eigen::Matrix2d gradient;
    gradient << 0.05, -0.03, 0.01, 0.02;
    Sheet sheet(gradient);
    markerStrains(sheet.markers, sheet.motions, sheet.neighbours, sheet.strains);
    for (const MarkerStrain& strain : sheet.strains) {
        ASSERT_TRUE(strain.known);
        EXPECT_NEAR(strain.divergence, 0.07, 1e-12);
        EXPECT_NEAR(strain.curl, 0.04, 1e-12);
        EXPECT_NEAR(strain.shear, std::hypot(0.03, -0.02), 1e-12);
    }
}

TEST(MarkerStrain, isUnknownWithoutPlacesThatSpanAPlane) {
    Sheet sheet(Eigen::Matrix2d::Zero());
    for (std::size_t i = 0; i < 25; ++i)
        sheet.motions[i].found = i < 5; // one row
    sheet.motions[20].found = true;     // one alone
    markerStrains(sheet.markers, sheet.motions, sheet.neighbours, sheet.strains);
    for (const MarkerStrain& strain : sheet.strains)
        EXPECT_FALSE(strain.known);
}

} // namespace teleta::vision
