// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/contact_segmenter.h"
#include "backend/scene/scene_reader.h"
#include "backend/simulation/array/simulated_array.h"
#include "tests/backend/contact/allocation_count.h"
#include "tests/backend/contact/contact_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace teleta;
using namespace teleta::contact;
using namespace teleta::contact::test;

namespace {

constexpr double kPitch_m = kPaperArray.pitchX_m;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Segmentation {
    std::vector<Contact> contacts;
    std::vector<std::int32_t> labels;
};

Segmentation segment(const Frame& frame, const SegmentationSettings& settings = {},
                     const std::vector<std::uint8_t>& dead = {}) {
    ContactSegmenter segmenter(frame.layout, settings);
    const std::span<Contact> contacts = segmenter.segment(frame.load_N, dead);
    return {{contacts.begin(), contacts.end()}, {segmenter.labels().begin(), segmenter.labels().end()}};
}

Frame row(const std::vector<float>& loads) {
    Frame frame({1, static_cast<int>(loads.size()), kPitch_m});
    frame.load_N = loads;
    return frame;
}

std::vector<std::int32_t> labelsOf(const std::vector<float>& loads, const SegmentationSettings& settings) {
    return segment(row(loads), settings).labels;
}

SegmentationSettings noise(double share, double height_N = 0.0) {
    return {.threshold_N = 0.2, .noiseHeight = share, .noiseHeight_N = height_N};
}

/// Two cones whose flanks meet; peaks of the given loads, 6 columns apart.
Frame twoCones(float left_N, float right_N) {
    Frame frame;
    for (int r = 0; r < 6; ++r) {
        for (int c = 0; c < 14; ++c) {
            const auto left = static_cast<float>(std::hypot(r - 2, c - 3));
            const auto right = static_cast<float>(std::hypot(r - 2, c - 9));
            frame.at(r, c) = std::max({0.0F, left_N * (1.0F - left / 4.0F), right_N * (1.0F - right / 4.0F)});
        }
    }
    return frame;
}

scene::Scene shipped(const char* name) {
    const auto scene = scene::readScene(std::string(TELETA_SOURCE_DIR "/resources/scenes/") + name);
    EXPECT_TRUE(scene) << describe(scene.error());
    return *scene;
}

} // namespace

TEST(ContactSegmenter, anEmptyFrameHasNoContact) {
    const Segmentation result = segment(Frame());
    EXPECT_TRUE(result.contacts.empty());
    EXPECT_EQ(result.labels, std::vector<std::int32_t>(84, 0));
}

TEST(ContactSegmenter, aFrameOfAnotherSizeHasNoContactAndNoLabels) {
    ContactSegmenter segmenter(kPaperArray);
    EXPECT_EQ(segmenter.segment(block(kPaperArray, 1, 2, 3, 4, 1.0F).load_N).size(), 1U);
    EXPECT_TRUE(segmenter.segment(std::vector<float>(83, 1.0F)).empty());
    EXPECT_TRUE(std::ranges::all_of(segmenter.labels(), [](std::int32_t label) { return label == 0; }));
}

TEST(ContactSegmenter, aSaturatedFrameIsOneContact) {
    const Segmentation result = segment(block(kPaperArray, 0, 5, 0, 13, 2.0F), noise(0.0));
    ASSERT_EQ(result.contacts.size(), 1U);
    const Contact& contact = result.contacts[0];
    EXPECT_EQ(contact.taxels, 84);
    EXPECT_EQ(contact.force_N, 168.0);
    EXPECT_EQ(contact.peak_N, 2.0);
    EXPECT_EQ(contact.x_m, 0.0);
    EXPECT_EQ(contact.y_m, 0.0);
    EXPECT_DOUBLE_EQ(contact.area_m2, 84 * kPitch_m * kPitch_m);
    EXPECT_EQ(result.labels, std::vector<std::int32_t>(84, 1));
}

TEST(ContactSegmenter, aPlateauOfAnyShapeIsOneContact) {
    // A U whose arms are joined only at one end, and a staircase joined at corners only.
    Frame u = block(kPaperArray, 0, 5, 2, 2, 1.0F);
    for (int c = 3; c < 12; ++c)
        u.at(0, c) = u.at(5, c) = 1.0F;
    EXPECT_EQ(segment(u, noise(0.0)).contacts.size(), 1U);
    Frame stairs;
    for (int i = 0; i < 6; ++i)
        stairs.at(i, 3 + i) = 1.0F;
    EXPECT_EQ(segment(stairs, noise(0.0)).contacts.size(), 1U);
    EXPECT_EQ(segment(stairs.mirrored(), noise(0.0)).contacts.size(), 1U);
}

TEST(ContactSegmenter, twoPlateausWithAPassBetweenThemAreTwoContacts) {
    EXPECT_EQ(labelsOf({0, 3, 3, 3, 1, 3, 3, 0}, noise(0.3)),
              (std::vector<std::int32_t>{0, 1, 1, 1, 1, 2, 2, 0}));
}

TEST(ContactSegmenter, twoBlobsThatTouchAreTwoContacts) {
    // The cones meet at column 6, where the load is 0.5 N.
    const Segmentation result = segment(twoCones(2.0F, 1.6F));
    ASSERT_EQ(result.contacts.size(), 2U);
    const Contact& left = result.contacts[0];
    const Contact& right = result.contacts[1];
    EXPECT_EQ(left.peak_N, 2.0);
    EXPECT_FLOAT_EQ(static_cast<float>(right.peak_N), 1.6F);
    EXPECT_LT(left.x_m, 0.0);
    EXPECT_GT(right.x_m, 0.0);
    EXPECT_EQ(result.labels[2 * 14 + 3], 1);
    EXPECT_EQ(result.labels[2 * 14 + 9], 2);
    EXPECT_EQ(result.labels[2 * 14 + 5], 1);
    EXPECT_EQ(result.labels[2 * 14 + 7], 2);
}

TEST(ContactSegmenter, blobsThatTouchAtACornerAreOneRegionOrTwoByTheirSaddle) {
    Frame frame;
    frame.at(2, 3) = 3.0F;
    frame.at(3, 4) = 2.0F;
    EXPECT_EQ(segment(frame).contacts.size(), 1U) << "diagonal neighbours: the second one is a flank";
    frame.at(4, 5) = 2.9F;
    // The pass rises 0.9 of 3: 30 %.
    EXPECT_EQ(segment(frame, noise(0.29)).contacts.size(), 2U);
    EXPECT_EQ(segment(frame, noise(0.31)).contacts.size(), 1U);
}

TEST(ContactSegmenter, blobsWithAGapAreTwoContactsWhateverTheNoiseHeight) {
    EXPECT_EQ(labelsOf({1, 1, 0.1F, 1, 2}, noise(1.0, 100.0)), (std::vector<std::int32_t>{2, 2, 0, 1, 1}));
}

TEST(ContactSegmenter, oneTaxelIsAContactAtItsCentre) {
    Frame frame;
    frame.at(4, 9) = 0.5F;
    const Segmentation result = segment(frame);
    ASSERT_EQ(result.contacts.size(), 1U);
    const Contact& contact = result.contacts[0];
    EXPECT_EQ(contact.id, 0);
    EXPECT_EQ(contact.region, 1);
    EXPECT_DOUBLE_EQ(contact.x_m, 2.5 * kPitch_m);
    EXPECT_DOUBLE_EQ(contact.y_m, 1.5 * kPitch_m);
    EXPECT_EQ(contact.force_N, 0.5);
    EXPECT_EQ(contact.peak_N, 0.5);
    EXPECT_EQ(contact.taxels, 1);
    EXPECT_DOUBLE_EQ(contact.area_m2, kPitch_m * kPitch_m);
    EXPECT_EQ(contact.minRow, 4);
    EXPECT_EQ(contact.maxRow, 4);
    EXPECT_EQ(contact.minColumn, 9);
    EXPECT_EQ(contact.maxColumn, 9);
}

TEST(ContactSegmenter, theCentroidIsWeightedWithTheLoad) {
    // Eq. (1) by hand: columns 3, 4, 5 with 1, 2, 3 N in row 2 and 4 N at (3, 4).
    Frame frame;
    frame.at(2, 3) = 1.0F;
    frame.at(2, 4) = 2.0F;
    frame.at(2, 5) = 3.0F;
    frame.at(3, 4) = 4.0F;
    const Segmentation result = segment(frame);
    ASSERT_EQ(result.contacts.size(), 1U);
    const Contact& contact = result.contacts[0];
    EXPECT_NEAR(contact.x_m, kPitch_m * ((3 * 1 + 4 * 2 + 5 * 3 + 4 * 4) / 10.0 - 6.5), 1e-17);
    EXPECT_NEAR(contact.y_m, kPitch_m * ((2 * 6 + 3 * 4) / 10.0 - 2.5), 1e-17);
    EXPECT_EQ(contact.force_N, 10.0);
    EXPECT_EQ(contact.taxels, 4);
    EXPECT_EQ(contact.minRow, 2);
    EXPECT_EQ(contact.maxRow, 3);
    EXPECT_EQ(contact.minColumn, 3);
    EXPECT_EQ(contact.maxColumn, 5);
}

TEST(ContactSegmenter, blobsOnTheBordersAreContactsOfTheirOwn) {
    Frame frame;
    // The last taxel of a row and the first of the next one are neighbours in memory only.
    frame.at(2, 13) = 2.0F;
    frame.at(3, 0) = 1.5F;
    frame.at(0, 0) = 1.0F;
    frame.at(5, 13) = 0.5F;
    const Segmentation result = segment(frame);
    ASSERT_EQ(result.contacts.size(), 4U);
    EXPECT_DOUBLE_EQ(result.contacts[0].x_m, 6.5 * kPitch_m);
    EXPECT_DOUBLE_EQ(result.contacts[1].x_m, -6.5 * kPitch_m);
    EXPECT_DOUBLE_EQ(result.contacts[2].y_m, -2.5 * kPitch_m);
    EXPECT_DOUBLE_EQ(result.contacts[3].y_m, 2.5 * kPitch_m);

    const Segmentation corner = segment(block(kPaperArray, 0, 1, 12, 13, 1.0F));
    ASSERT_EQ(corner.contacts.size(), 1U);
    EXPECT_EQ(corner.contacts[0].taxels, 4);
    EXPECT_DOUBLE_EQ(corner.contacts[0].x_m, 6.0 * kPitch_m);
    EXPECT_DOUBLE_EQ(corner.contacts[0].y_m, -2.0 * kPitch_m);
}

TEST(ContactSegmenter, taxelsThatAreNotFiniteOrNegativeBelongToNoContact) {
    Frame broken = block(kPaperArray, 1, 4, 4, 9, 1.0F);
    Frame holes = broken;
    const std::vector<float> values{kNan, kInfinity, -kInfinity, -1.0F};
    for (int i = 0; i < 4; ++i) {
        broken.at(2, 4 + i) = values[static_cast<std::size_t>(i)];
        holes.at(2, 4 + i) = 0.0F;
    }
    const Segmentation result = segment(broken);
    const Segmentation expected = segment(holes);
    EXPECT_EQ(result.labels, expected.labels);
    ASSERT_EQ(result.contacts.size(), 1U);
    EXPECT_EQ(result.contacts[0].taxels, 20);
    EXPECT_EQ(result.contacts[0].force_N, 20.0);
    EXPECT_EQ(result.contacts[0].x_m, expected.contacts[0].x_m);
    EXPECT_TRUE(segment(block(kPaperArray, 0, 5, 0, 13, kNan)).contacts.empty());
    EXPECT_TRUE(segment(block(kPaperArray, 0, 5, 0, 13, kInfinity)).contacts.empty());
}

TEST(ContactSegmenter, deadTaxelsBelongToNoContact) {
    const Frame frame = block(kPaperArray, 0, 5, 2, 8, 1.0F);
    std::vector<std::uint8_t> dead(84, 0);
    for (int r = 0; r < 6; ++r)
        dead[frame.index(r, 5)] = 1;
    const Segmentation result = segment(frame, {}, dead);
    ASSERT_EQ(result.contacts.size(), 2U) << "a dead column parts the contact";
    EXPECT_EQ(result.contacts[0].taxels, 18);
    EXPECT_EQ(result.contacts[1].taxels, 18);
    for (int r = 0; r < 6; ++r)
        EXPECT_EQ(result.labels[frame.index(r, 5)], 0);
}

TEST(ContactSegmenter, aTaxelAtTheThresholdIsInContact) {
    EXPECT_EQ(labelsOf({0.2F, std::nextafter(0.2F, 0.0F)}, noise(0.0)), (std::vector<std::int32_t>{1, 0}));
    EXPECT_EQ(labelsOf({1e-30F, 0.0F}, {.threshold_N = 0.0}), (std::vector<std::int32_t>{1, 0}));
}

TEST(ContactSegmenter, aSummitThatRisesLessThanTheNoiseHeightIsMerged) {
    // Rises 1 over its saddle, the peak is 4: 25 %.
    const std::vector<float> loads{1, 4, 2, 3, 1};
    EXPECT_EQ(segment(row(loads), noise(0.25)).contacts.size(), 2U) << "not less than";
    EXPECT_EQ(segment(row(loads), noise(0.26)).contacts.size(), 1U);
    EXPECT_EQ(segment(row(loads), noise(0.0, 1.0)).contacts.size(), 2U);
    EXPECT_EQ(segment(row(loads), noise(0.0, 1.01)).contacts.size(), 1U);
    EXPECT_EQ(segment(row(loads), noise(0.26, 0.5)).contacts.size(), 1U) << "the larger one acts";
    EXPECT_EQ(segment(row(loads), noise(0.0)).contacts.size(), 2U);
}

TEST(ContactSegmenter, mergingGoesByTheHighestSummitThatARegionReached) {
    // Flooded from the top: 3 joins 5 over the saddle 2.5 (rises 0.5); the region is then as high as 5, and 4
    // rises 2 over the saddle 2 to it, although only 1 lies between 3 and that saddle.
    const Segmentation result = segment(row({5, 2.5F, 3, 2, 4}), noise(0.0, 1.5));
    EXPECT_EQ(result.labels, (std::vector<std::int32_t>{1, 1, 1, 2, 2}))
        << "the taxel of the saddle climbs to its highest neighbour";
}

TEST(ContactSegmenter, aLowSummitBetweenTwoHighOnesJoinsOverTheHigherSaddle) {
    const Segmentation result = segment(row({5, 2.9F, 3, 2, 6}), noise(0.0, 1.5));
    ASSERT_EQ(result.contacts.size(), 2U);
    EXPECT_EQ(result.labels[2], result.labels[0]);
    EXPECT_NE(result.labels[2], result.labels[4]);
}

TEST(ContactSegmenter, contactsComeInOrderOfFallingForce) {
    const Segmentation result = segment(row({1, 0, 3, 0, 2, 2, 0, 0.5F}));
    ASSERT_EQ(result.contacts.size(), 4U);
    EXPECT_EQ(result.labels, (std::vector<std::int32_t>{3, 0, 2, 0, 1, 1, 0, 4}));
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(result.contacts[i].region, static_cast<int>(i) + 1);
}

TEST(ContactSegmenter, smallRegionsAreDropped) {
    const Segmentation result =
        segment(row({3, 0, 1, 1, 0, 1, 1, 1}), {.threshold_N = 0.2, .minimumTaxels = 2});
    ASSERT_EQ(result.contacts.size(), 2U);
    EXPECT_EQ(result.labels, (std::vector<std::int32_t>{0, 0, 2, 2, 0, 1, 1, 1}));
}

TEST(ContactSegmenter, anArrayOfOneTaxelHasOneContactOrNone) {
    EXPECT_TRUE(segment(row({0.1F})).contacts.empty());
    EXPECT_TRUE(segment(row({kNan})).contacts.empty());
    const Segmentation result = segment(row({1.0F}));
    ASSERT_EQ(result.contacts.size(), 1U);
    EXPECT_EQ(result.contacts[0].x_m, 0.0);
    EXPECT_EQ(result.contacts[0].y_m, 0.0);
}

TEST(ContactSegmenter, aFrameLeavesNothingBehindForTheNextOne) {
    std::mt19937 random(5);
    for (const core::ArrayLayout& layout :
         {kPaperArray, core::ArrayLayout{1, 24, kPitch_m}, core::ArrayLayout{24, 1, kPitch_m},
          core::ArrayLayout{3, 2, kPitch_m}}) {
        ContactSegmenter segmenter(layout);
        for (int trial = 0; trial < 200; ++trial) {
            Frame frame = randomFrame(random, layout, 0.02 * (trial % 50));
            std::vector<std::uint8_t> dead(layout.taxels(), 0);
            if (trial % 3 == 0) {
                std::uniform_int_distribution<std::size_t> taxel(0, layout.taxels() - 1);
                for (const float value : {kNan, kInfinity, -1.0F})
                    frame.load_N[taxel(random)] = value;
                const std::size_t broken = taxel(random);
                dead[broken] = 1;
                frame.load_N[broken] = 100.0F;
            }
            const std::span<Contact> contacts = segmenter.segment(frame.load_N, dead);
            const Segmentation fresh = segment(frame, {}, dead);
            ASSERT_EQ(std::vector<std::int32_t>(segmenter.labels().begin(), segmenter.labels().end()),
                      fresh.labels);
            ASSERT_EQ(contacts.size(), fresh.contacts.size());
        }
    }
}

// A dead taxel may hold any value; it is no way from one contact to another.
TEST(ContactSegmenter, aHeavyDeadTaxelBesideAPassJoinsNothing) {
    Frame frame({2, 3, kPitch_m});
    frame.load_N = {2.0F, 0.5F, 2.0F, 0.0F, 50.0F, 0.0F};
    const Segmentation result = segment(frame, noise(0.3), {0, 0, 0, 0, 1, 0});
    EXPECT_EQ(result.contacts.size(), 2U);
    EXPECT_EQ(result.labels, (std::vector<std::int32_t>{1, 1, 2, 0, 0, 0}));
}

TEST(ContactSegmenter, segmentAllocatesNothingAfterTheFirstFrames) {
    ContactSegmenter segmenter(kPaperArray, noise(0.0));
    std::mt19937 random(6);
    std::vector<Frame> frames;
    for (int i = 0; i < 50; ++i)
        frames.push_back(randomFrame(random, kPaperArray, 0.02 * i));
    Frame chess;
    for (int r = 0; r < 6; r += 2)
        for (int c = 0; c < 14; c += 2)
            chess.at(r, c) = 1.0F;
    frames.push_back(chess);
    frames.push_back(block(kPaperArray, 0, 5, 0, 13, 1.0F));
    std::size_t contacts = 0;
    for (const Frame& frame : frames)
        contacts += segmenter.segment(frame.load_N).size();
    const std::size_t before = allocationCount();
    std::size_t again = 0;
    for (const Frame& frame : frames)
        again += segmenter.segment(frame.load_N).size();
    EXPECT_EQ(allocationCount(), before);
    EXPECT_EQ(again, contacts);
}

// The shipped scene presses a bar, turns it by 180 degrees (12.2 s to 18.6 s) and lifts it. On a grid of
// taxels an oblique bar has a chain of summits, one wherever its axis crosses the centre of a taxel.
TEST(ContactSegmenter, aBarThatTurnsStaysOneContact) {
    const scene::Scene scene = shipped("tactile-indenter.toml");
    const auto array = simulation::SimulatedArray::make(scene, 1);
    ASSERT_TRUE(array);
    ContactSegmenter segmenter(scene.array().sensor.layout);
    ContactSegmenter fine(scene.array().sensor.layout, noise(0.1));
    std::vector<float> load_N(scene.array().sensor.layout.taxels());
    int frames = 0;
    std::size_t most = 0;
    for (int i = 0; i < 3720; ++i) {
        (*array)->next(load_N, false);
        if ((*array)->time_s() < 12.2)
            continue;
        ++frames;
        most = std::max(most, fine.segment(load_N).size());
        const std::span<Contact> contacts = segmenter.segment(load_N);
        ASSERT_EQ(contacts.size(), 1U)
            << "at " << (*array)->time_s() << " s, "
            << (*array)->truth().indenters[1].pose.angle_rad * 57.29578 << " degrees";
    }
    EXPECT_GT(frames, 1200);
    EXPECT_GE(most, 4U) << "the case is a hard one: with a tenth of the peak the bar falls apart";
}

// Two balls press (both from 2 s on), approach until they touch (7 s to 9 s) and part until 13 s.
TEST(ContactSegmenter, twoBallsStayTwoContactsAlsoWhereTheyTouch) {
    const scene::Scene scene = shipped("tactile-two-contacts.toml");
    const auto array = simulation::SimulatedArray::make(scene, 1);
    ASSERT_TRUE(array);
    ContactSegmenter segmenter(scene.array().sensor.layout);
    std::vector<float> load_N(scene.array().sensor.layout.taxels());
    double nearest_m = 1.0;
    for (int i = 0; i < 2600; ++i) {
        (*array)->next(load_N, false);
        if ((*array)->time_s() < 2.0)
            continue;
        const std::span<Contact> contacts = segmenter.segment(load_N);
        ASSERT_EQ(contacts.size(), 2U) << "at " << (*array)->time_s() << " s";
        // Each contact is at a ball, up to the taxel that the dead one removes.
        for (const simulation::IndenterTruth& ball : (*array)->truth().indenters) {
            double error_m = 1.0;
            for (const Contact& contact : contacts)
                error_m =
                    std::min(error_m, std::hypot(contact.x_m - ball.pose.x_m, contact.y_m - ball.pose.y_m));
            ASSERT_LT(error_m, kPitch_m) << ball.name << " at " << (*array)->time_s() << " s";
        }
        nearest_m = std::min(
            nearest_m, std::hypot(contacts[0].x_m - contacts[1].x_m, contacts[0].y_m - contacts[1].y_m));
    }
    EXPECT_LT(nearest_m, 3.2 * kPitch_m);
}
