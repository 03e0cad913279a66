// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/simulation/camera/gel/gel_field.h"
#include "backend/vision/gel/gel_contacts.h"
#include "tests/backend/vision/gel/simulated_motion.h"

#include <gtest/gtest.h>

#include <iostream>
#include <numbers>
#include <utility>

namespace teleta::vision {
namespace {

using simulation::GelContact;
using simulation::SimulatedGel;
using test::FollowedGel;
using test::Places;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kScale_m = 1e-4; ///< a pixel, as in the sensor's file

/// Contacts of the simulated gel; the field's m are pixels.
class Watched {
public:
    explicit Watched(const SimulatedGel& gel)
        : followed(gel) {}
    const std::vector<GelContactState>& show(const std::vector<GelContact>& pressed) {
        Places places = followed.renderer().rest_px();
        for (Eigen::Vector2d& place : places) {
            Eigen::Vector2d moved_px = Eigen::Vector2d::Zero();
            for (const GelContact& contact : pressed)
                moved_px += contact.displacement_m(place);
            place += moved_px;
        }
        followed.follow(places);
        return contacts.next(followed.gel());
    }
    FollowedGel followed;
    GelContacts contacts;
};

} // namespace

TEST(GelContacts, aMarkerHasTheSkinOfItsCell) {
    for (const bool hexagonal : {false, true}) {
        SimulatedGel gel{.hexagonal = hexagonal, .pitch_px = 20.0, .diameter_px = 7.0};
        gel.rows = 11;
        gel.columns = 14;
        Watched watched(gel);
        ASSERT_TRUE(watched.followed.isMade());
        const auto& contacts =
            watched.show({{.centre_m = {160.0, 120.0}, .radius_m = 60.0, .spread_m = 4.0}});
        ASSERT_EQ(contacts.size(), 1U);
        // A square of 2 mm, or a hexagon with neighbours 2 mm away: sqrt(3) / 2 of it.
        const double cell_m2 = 4e-6 * (hexagonal ? std::numbers::sqrt3 / 2.0 : 1.0);
        EXPECT_NEAR(contacts[0].area_m2 / static_cast<double>(contacts[0].markers.size()), cell_m2,
                    0.01 * cell_m2)
            << hexagonal;
    }
}

TEST(GelContacts, findsTheCentreUnderBallsOf2To8Mm) {
    core::RandomStream random(7);
    std::vector<double> errors_mm;
    // A marker every 2 mm, as on the sensors that can be bought; pressed by 0.6 mm.
    SimulatedGel gel{.pitch_px = 20.0, .diameter_px = 7.0, .printError_px = 0.5};
    gel.rows = 11;
    gel.columns = 15;
    Watched watched(gel);
    ASSERT_TRUE(watched.followed.isMade());
    for (const double radius_mm : {2.0, 4.0, 6.0, 8.0}) {
        for (int i = 0; i < 10; ++i) {
            const double a_px = std::sqrt(radius_mm * 0.6) * 1e-3 / kScale_m;
            const GelContact ball{
                .centre_m = {110.0 + 100.0 * random.uniform(), 80.0 + 80.0 * random.uniform()},
                .radius_m = a_px,
                .spread_m = 2.0};
            const auto& contacts = watched.show({ball});
            ASSERT_FALSE(contacts.empty()) << radius_mm;
            errors_mm.push_back((contacts.front().centre_m - kScale_m * ball.centre_m).norm() * 1e3);
            (void)watched.show({});
        }
    }
    std::ranges::sort(errors_mm);
    double mean_mm = 0.0;
    for (const double error : errors_mm)
        mean_mm += error / static_cast<double>(errors_mm.size());
    std::cout << "centre: mean " << mean_mm << " mm, 95 % " << errors_mm[37] << " mm\n";
    EXPECT_LT(mean_mm, 0.3);
    EXPECT_LT(errors_mm[37], 0.6);
}

TEST(GelContacts, tellsTheDirectionOfShearAndTheTurn) {
    SimulatedGel gel;
    double worst_deg = 0.0, worstTurn_deg = 0.0;
    for (const double direction_deg : {0.0, 35.0, 120.0, 250.0}) {
        Watched watched(gel);
        ASSERT_TRUE(watched.followed.isMade());
        const double direction_rad = direction_deg * kDegree;
        const Eigen::Vector2d along(std::cos(direction_rad), std::sin(direction_rad));
        const auto& contacts = watched.show(
            {{.centre_m = {160.0, 120.0}, .radius_m = 50.0, .slip_m = 8.0 * along, .stick = 0.7}});
        ASSERT_EQ(contacts.size(), 1U);
        const Eigen::Vector2d shear = contacts.front().shearProxy_m;
        worst_deg = std::max(worst_deg, std::acos(std::min(1.0, shear.normalized().dot(along))) / kDegree);
    }
    for (const double turn_deg : {-8.0, -3.0, 3.0, 8.0}) {
        Watched watched(gel);
        Places places = watched.followed.renderer().rest_px();
        std::vector<GelContactState> contacts;
        for (int i = 1; i <= 16; ++i)
            contacts = watched.show(
                {{.centre_m = {160.0, 120.0}, .radius_m = 300.0, .turn_rad = turn_deg * kDegree * i / 16.0}});
        ASSERT_EQ(contacts.size(), 1U);
        // The whole gel turns, and half the curl of a turn is its sine.
        worstTurn_deg =
            std::max(worstTurn_deg, std::abs(std::asin(contacts.front().torsion_rad) / kDegree - turn_deg));
    }
    std::cout << "shear: " << worst_deg << " degrees, torsion " << worstTurn_deg << " degrees\n";
    EXPECT_LT(worst_deg, 3.0);
    EXPECT_LT(worstTurn_deg, 0.5);
}

TEST(GelContacts, normalProxyRisesWithThePressAndIsZeroWithoutContact) {
    Watched watched(SimulatedGel{});
    EXPECT_TRUE(watched.show({}).empty());
    double before_m2 = 0.0;
    for (const double spread_px : {2.0, 4.0, 6.0}) {
        const auto& contacts =
            watched.show({{.centre_m = {160.0, 120.0}, .radius_m = 50.0, .spread_m = spread_px}});
        ASSERT_EQ(contacts.size(), 1U);
        EXPECT_GT(contacts.front().normalProxy_m2, 1.3 * before_m2);
        EXPECT_EQ(contacts.front().id, 1);
        EXPECT_GE(contacts.front().outline.size(), 3U);
        before_m2 = contacts.front().normalProxy_m2;
    }
    EXPECT_TRUE(watched.show({}).empty());
}

TEST(GelContacts, keepsTwoContactsApart) {
    SimulatedGel gel{.pitch_px = 20.0, .diameter_px = 7.0};
    gel.rows = 11;
    gel.columns = 15;
    Watched watched(gel);
    for (int i = 1; i <= 5; ++i) {
        const auto& contacts = watched.show(
            {{.centre_m = {90.0, 120.0}, .radius_m = 25.0, .slip_m = {1.0 * i, 0.0}, .stick = 0.9},
             {.centre_m = {230.0, 120.0}, .radius_m = 25.0, .slip_m = {0.0, 0.9 * i}, .stick = 0.9}});
        if (i < 3)
            continue;
        ASSERT_EQ(contacts.size(), 2U) << i;
        EXPECT_NEAR(contacts[0].centre_m.x(), 90.0 * kScale_m, 1e-3);
        EXPECT_NEAR(contacts[1].centre_m.x(), 230.0 * kScale_m, 1e-3);
        EXPECT_NE(contacts[0].id, contacts[1].id);
    }
}

/// A ball of contact radius 80 px is pressed, then dragged on: the ring of slip grows inwards.
TEST(GelContacts, slipIndexFollowsTheRingOfSlip) {
    SimulatedGel gel{.pitch_px = 20.0, .diameter_px = 7.0};
    gel.rows = 11;
    gel.columns = 15;
    Watched watched(gel);
    GelContact ball{.centre_m = {160.0, 120.0}, .radius_m = 80.0};
    for (int i = 1; i <= 10; ++i) {
        ball.spread_m = 0.6 * i;
        (void)watched.show({ball});
    }
    const double whole_px = 12.0; // the way at which all slips
    double worst = 0.0, largest = 0.0, sum = 0.0;
    int count = 0;
    std::optional<double> incipient, slip;
    for (int i = 1; i <= 60; ++i) {
        // (c / a)^2 falls by as much as the ball moves.
        const double way = std::min(1.0, 0.02 * i);
        ball.stick = std::sqrt(1.0 - way);
        ball.slip_m = {whole_px, 0.0};
        const auto& contacts = watched.show({ball});
        ASSERT_FALSE(contacts.empty());
        ASSERT_TRUE(contacts.front().slipIndex);
        largest = std::max(largest, *contacts.front().slipIndex);
        const double off = std::abs(*contacts.front().slipIndex - way);
        sum += off;
        ++count;
        worst = std::max(worst, off);
        if (contacts.front().event == SlipEvent::incipientSlip && !incipient)
            incipient = way;
        if (contacts.front().event == SlipEvent::slip && !slip)
            slip = way;
    }
    EXPECT_GE(largest, 0.8);
    ASSERT_TRUE(incipient) << worst;
    ASSERT_TRUE(slip) << worst;
    std::cout << "slip index: mean " << sum / count << ", worst " << worst << ", incipient slip told at "
              << *incipient << ", slip at " << *slip << '\n';
    // With a marker every quarter of the radius a ring of the grid begins to slip at once: 0.1 is a mean.
    EXPECT_LT(sum / count, 0.1);
    EXPECT_LT(worst, 0.25);
    EXPECT_NEAR(*incipient, 0.3, 0.081);
    EXPECT_NEAR(*slip, 0.8, 0.081);
}

/// A ball of 40 mm with friction 0.5 on markers 2 mm apart, pressed until it touches with this radius, then
/// dragged until all slips.
TEST(GelContacts, slipIndexHoldsForSmallContacts) {
    struct Row {
        double radius_px;
        double mean; ///< of the error
    };
    // Counted markers told 0.30, 0.18 and 0.09 too little.
    for (const Row& row : {Row{60.0, 0.12}, Row{70.0, 0.1}, Row{80.0, 0.08}}) {
        double sum = 0.0;
        int count = 0;
        for (const double direction_deg : {20.0, 130.0, 275.0}) {
            SimulatedGel gel{.pitch_px = 20.0, .diameter_px = 7.0, .printError_px = 0.5};
            gel.rows = 11;
            gel.columns = 15;
            Watched watched(gel);
            const double depth_px = row.radius_px * row.radius_px / 400.0;
            GelContact ball{.centre_m = {155.0, 122.0}};
            for (int i = 1; i <= 20; ++i) {
                const double depthNow_px = depth_px * i / 20.0;
                ball.radius_m = std::sqrt(400.0 * depthNow_px);
                ball.spread_m = 0.1 * depthNow_px;
                (void)watched.show({ball});
            }
            const double whole_px = 0.5 * depth_px;
            const double direction_rad = direction_deg * kDegree;
            ball.slip_m = whole_px * Eigen::Vector2d(std::cos(direction_rad), std::sin(direction_rad));
            for (int i = 1; i <= 50; ++i) {
                const double share = 0.02 * i;
                ball.stick = std::sqrt(1.0 - share);
                const auto& contacts = watched.show({ball});
                ASSERT_FALSE(contacts.empty());
                ASSERT_TRUE(contacts.front().slipIndex) << row.radius_px << ' ' << share;
                sum += std::abs(*contacts.front().slipIndex - share);
                ++count;
            }
        }
        std::cout << "radius " << row.radius_px << " px: slip index off by " << sum / count << '\n';
        EXPECT_LT(sum / count, row.mean) << row.radius_px;
    }
}

/// Neither skin that spreads by 0.3 of the depth slips, nor a contact that turns by 9 degrees.
TEST(GelContacts, takesNoSpreadAndNoTurnForSlip) {
    SimulatedGel gel{.pitch_px = 20.0, .diameter_px = 7.0};
    gel.rows = 11;
    gel.columns = 15;
    Watched watched(gel);
    GelContact ball{.centre_m = {160.0, 120.0}};
    double largest = 0.0;
    const auto show = [&] {
        for (const GelContactState& contact : watched.show({ball})) {
            largest = std::max(largest, contact.slipIndex.value_or(0.0));
            EXPECT_EQ(contact.event, SlipEvent::none);
        }
    };
    for (int i = 1; i <= 25; ++i) {
        const double depth_px = 0.8 * i;
        ball.radius_m = std::sqrt(400.0 * depth_px);
        ball.spread_m = 0.3 * depth_px;
        show();
    }
    const double pressed = std::exchange(largest, 0.0);
    EXPECT_LT(pressed, 0.1);
    ball.spread_m = 0.1 * 20.0;
    show();
    for (int i = 1; i <= 30; ++i) {
        ball.turn_rad = 0.3 * i * kDegree;
        show();
    }
    std::cout << "largest slip index of a press " << pressed << ", of a turn " << largest << '\n';
    EXPECT_LT(largest, 0.1);
}

TEST(GelContacts, hasNoSlipWhileTheLoadChangesAndSticks) {
    SimulatedGel gel{.width_px = 200, .height_px = 180, .rows = 6, .columns = 7};
    Watched watched(gel);
    ASSERT_TRUE(watched.followed.isMade());
    int events = 0;
    double largest = 0.0;
    // 60 s at 25 frames a second.
    for (int i = 0; i < 1500; ++i) {
        const double load = 4.0 + 2.0 * std::sin(0.02 * i) + 0.5 * std::sin(0.11 * i);
        const double way = 0.08 + 0.07 * std::sin(0.035 * i);
        const GelContact ball{.centre_m = {100.0, 90.0},
                              .radius_m = 55.0,
                              .spread_m = load,
                              .slip_m = {14.0, 0.0},
                              .stick = std::sqrt(1.0 - way)};
        for (const GelContactState& contact : watched.show({ball})) {
            events += contact.event != SlipEvent::none ? 1 : 0;
            largest = std::max(largest, contact.slipIndex.value_or(0.0));
        }
    }
    std::cout << "largest slip index while all sticks but a rim: " << largest << '\n';
    EXPECT_EQ(events, 0);
}

} // namespace teleta::vision
