// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/contact_tracker.h"
#include "tests/backend/contact/allocation_count.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

using namespace teleta::contact;

namespace {

using Places = std::vector<std::pair<double, double>>;

std::vector<int> assign(ContactTracker& tracker, const Places& places_mm, double time_s) {
    std::vector<Contact> contacts;
    for (const auto& [x_mm, y_mm] : places_mm)
        contacts.push_back({.x_m = 1e-3 * x_mm, .y_m = 1e-3 * y_mm});
    tracker.assign(contacts, time_s);
    std::vector<int> ids;
    for (const Contact& contact : contacts)
        ids.push_back(contact.id);
    return ids;
}

using Ids = std::vector<int>;

} // namespace

TEST(ContactTracker, identitiesCountFromOneInTheOrderOfTheContacts) {
    ContactTracker tracker;
    EXPECT_EQ(assign(tracker, {{0, 0}, {50, 0}, {0, 50}}, 0.0), (Ids{1, 2, 3}));
}

TEST(ContactTracker, aFrameWithoutContactsIsNoTrouble) {
    ContactTracker tracker;
    EXPECT_EQ(assign(tracker, {}, 0.0), Ids{});
    EXPECT_EQ(assign(tracker, {{0, 0}}, 0.005), Ids{1});
}

TEST(ContactTracker, identitiesFollowMotionBelowTheGateWhateverTheOrder) {
    ContactTracker tracker({.gate_m = 0.015});
    EXPECT_EQ(assign(tracker, {{0, 0}, {100, 0}}, 0.0), (Ids{1, 2}));
    for (int step = 1; step <= 20; ++step) {
        const double moved_mm = 14.0 * step;
        const Places places =
            step % 2 == 0 ? Places{{0, moved_mm}, {100, moved_mm}} : Places{{100, moved_mm}, {0, moved_mm}};
        EXPECT_EQ(assign(tracker, places, 0.005 * step), step % 2 == 0 ? (Ids{1, 2}) : (Ids{2, 1}));
    }
}

TEST(ContactTracker, motionBeyondTheGateMakesANewContact) {
    // Distances of 0.25 and more over 1/64 are exact.
    ContactTracker tracker({.gate_m = 0.25});
    std::vector<Contact> contact{{.x_m = 0.0}};
    tracker.assign(contact, 0.0);
    contact[0].x_m = 0.25;
    tracker.assign(contact, 0.01);
    EXPECT_EQ(contact[0].id, 1) << "the gate itself is not beyond it";
    contact[0].x_m = 0.5 + 1.0 / 64.0;
    tracker.assign(contact, 0.02);
    EXPECT_EQ(contact[0].id, 2);
}

TEST(ContactTracker, theGateIsACircle) {
    ContactTracker tracker({.gate_m = 0.015});
    EXPECT_EQ(assign(tracker, {{0, 0}}, 0.0), Ids{1});
    EXPECT_EQ(assign(tracker, {{11, 11}}, 0.01), Ids{2}) << "15.6 mm away";
    EXPECT_EQ(assign(tracker, {{21, 21}}, 0.02), Ids{2}) << "14.1 mm away";
}

TEST(ContactTracker, theAssignmentIsOptimalWhereTheNearestPairFirstIsWrong) {
    // Nearest first: 10 to 6 costs 4, which leaves 0 to 15 at 15: 19 in all. 0 to 6 and 10 to 15 cost 11.
    ContactTracker tracker({.gate_m = 0.020});
    EXPECT_EQ(assign(tracker, {{0, 0}, {10, 0}}, 0.0), (Ids{1, 2}));
    EXPECT_EQ(assign(tracker, {{6, 0}, {15, 0}}, 0.01), (Ids{1, 2}));
}

TEST(ContactTracker, aContactWithoutAPartnerCostsTheGate) {
    // Both pairs cost 9 + 9 = 18; the near pair and a new contact cost 1 + 15 = 16.
    ContactTracker tracker({.gate_m = 0.015});
    EXPECT_EQ(assign(tracker, {{0, 0}, {10, 0}}, 0.0), (Ids{1, 2}));
    EXPECT_EQ(assign(tracker, {{9, 0}, {19, 0}}, 0.01), (Ids{2, 3}));
}

TEST(ContactTracker, aContactThatIsGoneComesBackUnderItsIdentityWithinTheMemory) {
    ContactTracker tracker({.memory_s = 0.1});
    EXPECT_EQ(assign(tracker, {{0, 0}}, 0.0), Ids{1});
    EXPECT_EQ(assign(tracker, {}, 0.05), Ids{});
    EXPECT_EQ(assign(tracker, {{3, 0}}, 0.0625), Ids{1});
    EXPECT_EQ(assign(tracker, {}, 0.07), Ids{});
    EXPECT_EQ(assign(tracker, {{3, 0}}, 0.1875), Ids{2}) << "0.125 s since it was seen";
}

TEST(ContactTracker, whileOneIsGoneAnotherDoesNotTakeItsIdentity) {
    ContactTracker tracker;
    EXPECT_EQ(assign(tracker, {{0, 0}, {40, 0}}, 0.0), (Ids{1, 2}));
    EXPECT_EQ(assign(tracker, {{40, 0}}, 0.01), Ids{2});
    EXPECT_EQ(assign(tracker, {{40, 0}, {80, 0}}, 0.02), (Ids{2, 3}));
    EXPECT_EQ(assign(tracker, {{0, 0}, {40, 0}, {80, 0}}, 0.03), (Ids{1, 2, 3}));
}

TEST(ContactTracker, slowFramesKeepTheIdentitiesOfTheFrameBefore) {
    // 10 Hz and slower: the pause between two frames is as long as the memory and longer.
    for (const double period_s : {0.1, 0.3, 5.0}) {
        ContactTracker tracker({.memory_s = 0.1});
        for (int frame = 0; frame < 30; ++frame)
            EXPECT_EQ(assign(tracker, {{0.5 * frame, 0}, {60, 0}}, period_s * frame), (Ids{1, 2}));
    }
}

TEST(ContactTracker, slowFramesForgetAContactThatWasMissingInAFrame) {
    ContactTracker tracker({.memory_s = 0.1});
    EXPECT_EQ(assign(tracker, {{0, 0}}, 0.0), Ids{1});
    EXPECT_EQ(assign(tracker, {}, 0.3), Ids{});
    EXPECT_EQ(assign(tracker, {{0, 0}}, 0.6), Ids{2});
}

TEST(ContactTracker, framesOfTheSameTimeKeepIdentities) {
    ContactTracker tracker({.memory_s = 0.0});
    EXPECT_EQ(assign(tracker, {{0, 0}}, 1.0), Ids{1});
    EXPECT_EQ(assign(tracker, {{1, 0}}, 1.0), Ids{1});
}

TEST(ContactTracker, identitiesAreNotReusedUntilReset) {
    ContactTracker tracker;
    for (int i = 1; i <= 10; ++i)
        EXPECT_EQ(assign(tracker, {{100.0 * i, 0}}, 1.0 * i), Ids{i});
    tracker.reset();
    EXPECT_EQ(assign(tracker, {{1000, 0}}, 11.0), Ids{1});
}

TEST(ContactTracker, aGateThatIsNotPositiveMatchesOnlyContactsThatStayInPlace) {
    for (const double gate_m : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        ContactTracker tracker({.gate_m = gate_m});
        EXPECT_EQ(assign(tracker, {{0, 0}, {40, 0}}, 0.0), (Ids{1, 2}));
        EXPECT_EQ(assign(tracker, {{0, 0}, {41, 0}}, 0.01), (Ids{1, 3}));
    }
}

TEST(ContactTracker, anInfiniteGateStillFindsTheOptimum) {
    ContactTracker tracker({.gate_m = std::numeric_limits<double>::infinity()});
    EXPECT_EQ(assign(tracker, {{0, 0}, {500, 0}}, 0.0), (Ids{1, 2}));
    EXPECT_EQ(assign(tracker, {{900, 0}, {300, 0}}, 0.01), (Ids{2, 1}));
}

TEST(ContactTracker, contactsInOnePlaceKeepDifferentIdentities) {
    ContactTracker tracker;
    EXPECT_EQ(assign(tracker, {{0, 0}, {0, 0}}, 0.0), (Ids{1, 2}));
    Ids ids = assign(tracker, {{0, 0}, {0, 0}}, 0.01);
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(ids, (Ids{1, 2}));
}

TEST(ContactTracker, fortyContactsKeepTheirIdentities) {
    // 8 x 5 contacts 20 mm apart, which stay within 3.5 mm of their places in x and y: at most 9.9 mm
    // from where they were, and at least 13 mm from where any other was.
    std::mt19937 random(8);
    std::uniform_real_distribution<double> jump_mm(-3.5, 3.5);
    ContactTracker tracker;
    Ids expected(40);
    std::iota(expected.begin(), expected.end(), 1);
    for (int frame = 0; frame < 100; ++frame) {
        Places places;
        for (int i = 0; i < 40; ++i)
            places.emplace_back(20.0 * (i % 8) + (jump_mm(random)), 20.0 * (i / 8) + (jump_mm(random)));
        ASSERT_EQ(assign(tracker, places, 0.005 * frame), expected) << "frame " << frame;
    }
}

TEST(ContactTracker, theCostIsTheLeastOfAllAssignments) {
    // All permutations of up to 5 contacts are tried; distance beyond the gate costs the gate.
    std::mt19937 random(9);
    std::uniform_real_distribution<double> place_mm(0.0, 30.0);
    std::uniform_int_distribution<int> count(1, 5);
    constexpr double kGate_mm = 12.0;
    for (int trial = 0; trial < 500; ++trial) {
        Places before(static_cast<std::size_t>(count(random)));
        Places after(static_cast<std::size_t>(count(random)));
        for (auto* places : {&before, &after})
            for (auto& place : *places)
                place = {place_mm(random), place_mm(random)};
        ContactTracker tracker({.gate_m = 1e-3 * kGate_mm});
        (void)assign(tracker, before, 0.0);
        const Ids ids = assign(tracker, after, 0.01);

        const auto costOf = [&](std::size_t contact, std::size_t track) {
            if (contact >= after.size() || track >= before.size())
                return kGate_mm;
            return std::min(kGate_mm, std::hypot(after[contact].first - before[track].first,
                                                 after[contact].second - before[track].second));
        };
        const std::size_t size = std::max(before.size(), after.size());
        std::vector<std::size_t> order(size);
        std::iota(order.begin(), order.end(), std::size_t{0});
        double least_mm = std::numeric_limits<double>::infinity();
        do {
            double sum_mm = 0.0;
            for (std::size_t i = 0; i < size; ++i)
                sum_mm += costOf(i, order[i]);
            least_mm = std::min(least_mm, sum_mm);
        } while (std::next_permutation(order.begin(), order.end()));

        double cost_mm = 0.0;
        std::size_t matched = 0;
        for (std::size_t i = 0; i < after.size(); ++i) {
            if (ids[i] <= static_cast<int>(before.size())) {
                const double distance_mm = costOf(i, static_cast<std::size_t>(ids[i] - 1));
                ASSERT_LT(distance_mm, kGate_mm);
                cost_mm += distance_mm;
                ++matched;
            }
        }
        cost_mm += kGate_mm * static_cast<double>(size - matched);
        ASSERT_NEAR(cost_mm, least_mm, 1e-9) << "trial " << trial;
        ASSERT_EQ(std::set<int>(ids.begin(), ids.end()).size(), ids.size());
    }
}

TEST(ContactTracker, moreContactsThanTheExactLimitAreMatchedToTheNearest) {
    // A chain of 200 contacts 5 mm apart in one group that moves by 1 mm.
    ContactTracker tracker;
    Places places;
    for (int i = 0; i < 200; ++i)
        places.emplace_back(5.0 * i, 0.0);
    const Ids first = assign(tracker, places, 0.0);
    for (auto& place : places)
        place.second = 1.0;
    EXPECT_EQ(assign(tracker, places, 0.01), first);
}

TEST(ContactTracker, assignAllocatesNothingAfterTheFirstFrames) {
    ContactTracker tracker;
    std::vector<Contact> contacts(20);
    for (std::size_t i = 0; i < contacts.size(); ++i)
        contacts[i].x_m = 0.01 * static_cast<double>(i);
    for (int frame = 0; frame < 3; ++frame)
        tracker.assign(contacts, 0.005 * frame);
    const std::size_t before = test::allocationCount();
    for (int frame = 3; frame < 50; ++frame) {
        contacts[0].x_m += 1e-4;
        tracker.assign(contacts, 0.005 * frame);
    }
    EXPECT_EQ(test::allocationCount(), before);
    EXPECT_EQ(contacts[19].id, 20);
}

TEST(ContactTracker, theGateFollowsThePitchOfACoarseArray) {
    EXPECT_DOUBLE_EQ(trackingFor(teleta::core::ArrayLayout{6, 14, 0.0034}).gate_m, TrackingSettings{}.gate_m);
    EXPECT_DOUBLE_EQ(trackingFor(teleta::core::ArrayLayout{64, 27, 0.025}).gate_m, 0.05);
}
