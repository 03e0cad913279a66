// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/contact_segmenter.h"
#include "tests/backend/contact/contact_frames.h"
#include "tests/backend/contact/slow_watershed.h"
#include "tests/support/floating_point_traps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

using namespace teleta::contact;
using namespace teleta::contact::test;
using teleta::core::ArrayLayout;

namespace {

struct Segmentation {
    std::vector<Contact> contacts;
    std::vector<std::int32_t> labels;
};

Segmentation segment(const Frame& frame, const SegmentationSettings& settings) {
    ContactSegmenter segmenter(frame.layout, settings);
    const std::span<Contact> contacts = segmenter.segment(frame.load_N);
    return {{contacts.begin(), contacts.end()}, {segmenter.labels().begin(), segmenter.labels().end()}};
}

SegmentationSettings settingsOf(double height, int minimumTaxels = 1) {
    return {.threshold_N = 0.2, .noiseHeight = height, .minimumTaxels = minimumTaxels};
}

/// All loads differ, so that no tie depends on the order in memory.
Frame distinctFrame(std::mt19937& random, const ArrayLayout& layout, double share, int margin = 0) {
    Frame frame(layout);
    std::vector<int> values(layout.taxels());
    std::iota(values.begin(), values.end(), 1);
    std::shuffle(values.begin(), values.end(), random);
    std::bernoulli_distribution empty(share);
    for (int row = margin; row < layout.rows - margin; ++row)
        for (int column = margin; column < layout.columns - margin; ++column)
            if (!empty(random))
                frame.at(row, column) = 3.0F * static_cast<float>(values[frame.index(row, column)]) /
                                        static_cast<float>(layout.taxels());
    return frame;
}

double heightOf(const Frame& frame, double share) {
    const float peak = *std::max_element(frame.load_N.begin(), frame.load_N.end());
    return share * static_cast<double>(peak);
}

/// Labels of a segmentation, region for region those of the moved frame: same forces, same taxels.
template <typename Place>
void expectMoved(const Frame& frame, const Segmentation& before, const ArrayLayout& shape,
                 const Segmentation& after, const Place& place) {
    ASSERT_EQ(before.contacts.size(), after.contacts.size());
    Frame moved(shape);
    for (int row = 0; row < frame.layout.rows; ++row) {
        for (int column = 0; column < frame.layout.columns; ++column) {
            const std::pair<int, int> to = place(row, column);
            if (before.labels[frame.index(row, column)] != 0) {
                ASSERT_EQ(after.labels[moved.index(to.first, to.second)],
                          before.labels[frame.index(row, column)]);
            }
        }
    }
    for (std::size_t i = 0; i < before.contacts.size(); ++i) {
        ASSERT_NEAR(after.contacts[i].force_N, before.contacts[i].force_N,
                    1e-12 * before.contacts[i].force_N);
        ASSERT_EQ(after.contacts[i].peak_N, before.contacts[i].peak_N);
        ASSERT_EQ(after.contacts[i].taxels, before.contacts[i].taxels);
    }
}

} // namespace

TEST(SegmentationStability, equalsAPlainFloodingOnRandomFrames) {
    std::mt19937 random(21);
    std::uniform_int_distribution<int> side(1, 12);
    std::uniform_int_distribution<int> level(0, 6);
    for (int trial = 0; trial < 4000; ++trial) {
        const ArrayLayout layout{side(random), side(random), 0.0034};
        Frame frame = randomFrame(random, layout, 0.1 * (trial % 10));
        // Every third frame has few levels, and with them plateaus and ties.
        if (trial % 3 == 0)
            for (float& load : frame.load_N)
                load = 0.5F * static_cast<float>(level(random));
        const double share =
            std::vector<double>{0.0, 0.1, 0.3, 0.6, 1.0}[static_cast<std::size_t>(trial % 5)];
        const Segmentation result = segment(frame, settingsOf(share));
        ASSERT_EQ(canonical(result.labels), slowWatershed(frame, 0.2F, heightOf(frame, share)))
            << "trial " << trial << ", " << layout.rows << " x " << layout.columns << ", height " << share;
    }
}

TEST(SegmentationStability, contactsAreTheSumsOfTheirRegions) {
    std::mt19937 random(22);
    std::uniform_int_distribution<int> side(1, 20);
    for (int trial = 0; trial < 1000; ++trial) {
        const ArrayLayout layout{side(random), side(random), 0.0034};
        const Frame frame = randomFrame(random, layout, 0.1 * (trial % 10));
        const int minimum = trial % 4;
        const Segmentation result = segment(frame, settingsOf(0.3, minimum));
        std::vector<Contact> sums(result.contacts.size());
        for (int row = 0; row < layout.rows; ++row) {
            for (int column = 0; column < layout.columns; ++column) {
                const std::int32_t label = result.labels[frame.index(row, column)];
                ASSERT_LE(label, static_cast<std::int32_t>(sums.size()));
                if (label == 0) {
                    if (minimum <= 1) {
                        ASSERT_LT(frame.at(row, column), 0.2F);
                    }
                    continue;
                }
                ASSERT_GE(frame.at(row, column), 0.2F);
                Contact& sum = sums[static_cast<std::size_t>(label - 1)];
                const auto load = static_cast<double>(frame.at(row, column));
                if (sum.taxels == 0) {
                    sum.minRow = sum.maxRow = row;
                    sum.minColumn = sum.maxColumn = column;
                }
                ++sum.taxels;
                sum.force_N += load;
                sum.x_m += load * layout.x_m(column);
                sum.y_m += load * layout.y_m(row);
                sum.peak_N = std::max(sum.peak_N, load);
                sum.maxRow = std::max(sum.maxRow, row);
                sum.minColumn = std::min(sum.minColumn, column);
                sum.maxColumn = std::max(sum.maxColumn, column);
            }
        }
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const Contact& contact = result.contacts[i];
            ASSERT_EQ(contact.region, static_cast<int>(i) + 1);
            ASSERT_EQ(contact.taxels, sums[i].taxels);
            ASSERT_GE(contact.taxels, minimum);
            ASSERT_NEAR(contact.force_N, sums[i].force_N, 1e-12 * sums[i].force_N);
            ASSERT_NEAR(contact.x_m, sums[i].x_m / sums[i].force_N, 1e-15);
            ASSERT_NEAR(contact.y_m, sums[i].y_m / sums[i].force_N, 1e-15);
            ASSERT_EQ(contact.peak_N, sums[i].peak_N);
            ASSERT_EQ(contact.minRow, sums[i].minRow);
            ASSERT_EQ(contact.maxRow, sums[i].maxRow);
            ASSERT_EQ(contact.minColumn, sums[i].minColumn);
            ASSERT_EQ(contact.maxColumn, sums[i].maxColumn);
            ASSERT_NEAR(contact.area_m2, sums[i].taxels * 0.0034 * 0.0034, 1e-12);
            if (i > 0) {
                ASSERT_LE(contact.force_N, result.contacts[i - 1].force_N);
            }
        }
    }
}

TEST(SegmentationStability, followsATranslation) {
    std::mt19937 random(23);
    const ArrayLayout layout{16, 20, 0.0034};
    for (int trial = 0; trial < 300; ++trial) {
        const Frame frame = distinctFrame(random, layout, 0.3, 4);
        const int rows = trial % 9 - 4;
        const int columns = trial % 7 - 3;
        const Segmentation before = segment(frame, settingsOf(0.3));
        const Segmentation after = segment(frame.shifted(rows, columns), settingsOf(0.3));
        expectMoved(frame, before, layout, after, [&](int row, int column) {
            return std::pair{row + rows, column + columns};
        });
        for (std::size_t i = 0; i < before.contacts.size(); ++i) {
            ASSERT_NEAR(after.contacts[i].x_m, before.contacts[i].x_m + columns * 0.0034, 1e-14);
            ASSERT_NEAR(after.contacts[i].y_m, before.contacts[i].y_m + rows * 0.0034, 1e-14);
        }
    }
}

TEST(SegmentationStability, followsAMirrorAndAQuarterTurn) {
    std::mt19937 random(24);
    const ArrayLayout layout{9, 17, 0.0034};
    for (int trial = 0; trial < 300; ++trial) {
        const Frame frame = distinctFrame(random, layout, 0.2);
        const Segmentation before = segment(frame, settingsOf(0.3));
        const Segmentation mirrored = segment(frame.mirrored(), settingsOf(0.3));
        expectMoved(frame, before, layout, mirrored, [&](int row, int column) {
            return std::pair{row, layout.columns - 1 - column};
        });
        const Frame turnedFrame = frame.turned();
        const Segmentation turned = segment(turnedFrame, settingsOf(0.3));
        expectMoved(frame, before, turnedFrame.layout, turned, [&](int row, int column) {
            return std::pair{column, layout.rows - 1 - row};
        });
        for (std::size_t i = 0; i < before.contacts.size(); ++i) {
            ASSERT_NEAR(mirrored.contacts[i].x_m, -before.contacts[i].x_m, 1e-15);
            ASSERT_NEAR(mirrored.contacts[i].y_m, before.contacts[i].y_m, 1e-15);
            ASSERT_NEAR(turned.contacts[i].x_m, -before.contacts[i].y_m, 1e-15);
            ASSERT_NEAR(turned.contacts[i].y_m, before.contacts[i].x_m, 1e-15);
        }
    }
}

TEST(SegmentationStability, scalesFromTinyToHugeLoads) {
    // Powers of two near 1e-12 and 1e12 change no digit.
    std::mt19937 random(25);
    for (int trial = 0; trial < 300; ++trial) {
        const Frame frame = randomFrame(random, kPaperArray, 0.2);
        const Segmentation before = segment(frame, settingsOf(0.3));
        for (const double factor : {0x1p-40, 0x1p40, 0x1p-120, 0x1p120}) {
            SegmentationSettings settings = settingsOf(0.3);
            settings.threshold_N = static_cast<double>(0.2F) * factor;
            const Segmentation after = segment(frame.scaled(static_cast<float>(factor)), settings);
            ASSERT_EQ(after.labels, before.labels);
            for (std::size_t i = 0; i < before.contacts.size(); ++i) {
                ASSERT_EQ(after.contacts[i].force_N, before.contacts[i].force_N * factor);
                ASSERT_EQ(after.contacts[i].x_m, before.contacts[i].x_m);
                ASSERT_EQ(after.contacts[i].taxels, before.contacts[i].taxels);
            }
        }
    }
}

TEST(SegmentationStability, loadsOf1eMinus12And1e12SegmentAlike) {
    for (const float scale : {1e-12F, 1.0F, 1e12F}) {
        Frame frame = block(kPaperArray, 1, 2, 2, 3, 2.0F * scale);
        frame.at(1, 4) = scale;
        frame.at(1, 5) = 3.0F * scale;
        SegmentationSettings settings = settingsOf(0.3);
        settings.threshold_N = 0.2 * static_cast<double>(scale);
        const Segmentation result = segment(frame, settings);
        ASSERT_EQ(result.contacts.size(), 2U) << scale;
        EXPECT_NEAR(result.contacts[0].force_N, 8.0 * static_cast<double>(scale),
                    1e-6 * static_cast<double>(scale));
        EXPECT_NEAR(result.contacts[0].x_m, -4.0 * 0.0034, 1e-9);
    }
}

TEST(SegmentationStability, aSaturatedArrayOf256By256IsOneContact) {
    const ArrayLayout layout{256, 256, 0.001};
    const Segmentation result = segment(block(layout, 0, 255, 0, 255, 2.5F), settingsOf(0.0));
    ASSERT_EQ(result.contacts.size(), 1U);
    EXPECT_EQ(result.contacts[0].taxels, 65536);
    EXPECT_EQ(result.contacts[0].force_N, 2.5 * 65536);
    EXPECT_NEAR(result.contacts[0].x_m, 0.0, 1e-15);
    EXPECT_NEAR(result.contacts[0].y_m, 0.0, 1e-15);
}

TEST(SegmentationStability, anArrayOf256By256WithAContactOnEverySecondTaxelHasThemAll) {
    const ArrayLayout layout{256, 256, 0.001};
    Frame frame(layout);
    for (int row = 0; row < 256; row += 2)
        for (int column = 0; column < 256; column += 2)
            frame.at(row, column) = 1.0F;
    const Segmentation result = segment(frame, settingsOf(0.3));
    ASSERT_EQ(result.contacts.size(), 128U * 128U);
    for (const Contact& contact : result.contacts)
        ASSERT_EQ(contact.taxels, 1);
}

TEST(SegmentationStability, anArrayOf256By256OfNoiseEqualsThePlainFloodingInItsParts) {
    // Blocks of 14 x 14 with an empty taxel around each are independent of each other.
    const ArrayLayout layout{256, 256, 0.001};
    std::mt19937 random(26);
    Frame frame = randomFrame(random, layout, 0.1);
    frame.at(1, 1) = 3.0F;
    for (int i = 0; i < 256; ++i)
        for (int line = 0; line < 256; line += 16)
            frame.at(i, line) = frame.at(line, i) = 0.0F;
    const Segmentation result = segment(frame, settingsOf(0.3));
    const double height_N = heightOf(frame, 0.3);
    std::size_t regions = 0;
    for (int top = 0; top < 256; top += 16) {
        for (int left = 0; left < 256; left += 16) {
            Frame part({16, 16, 0.001});
            std::vector<std::int32_t> labels;
            for (int row = 0; row < 16; ++row) {
                for (int column = 0; column < 16; ++column) {
                    part.at(row, column) = frame.at(top + row, left + column);
                    labels.push_back(result.labels[frame.index(top + row, left + column)]);
                }
            }
            const std::vector<std::int32_t> expected = slowWatershed(part, 0.2F, height_N);
            std::vector<std::int32_t> sorted = labels;
            std::ranges::sort(sorted);
            std::vector<std::int32_t> names(sorted.begin(), std::ranges::unique(sorted).begin());
            for (std::int32_t& label : labels)
                label = static_cast<std::int32_t>(std::ranges::lower_bound(names, label) - names.begin());
            ASSERT_EQ(names.front(), 0);
            ASSERT_EQ(canonical(labels), expected) << top << ", " << left;
            regions += names.size() - 1;
        }
    }
    EXPECT_EQ(result.contacts.size(), regions);
}

TEST(SegmentationStability, spiralsAndCombsAreOneContact) {
    // Long winding crests, whose summits are all equal.
    const ArrayLayout layout{64, 64, 0.001};
    Frame comb(layout);
    for (int row = 0; row < 64; row += 2)
        for (int column = 0; column < 64; ++column)
            comb.at(row, column) = 1.0F;
    for (int row = 1; row < 64; row += 2)
        comb.at(row, row % 4 == 1 ? 63 : 0) = 1.0F;
    EXPECT_EQ(segment(comb, settingsOf(0.0)).contacts.size(), 1U);
    EXPECT_EQ(segment(comb.turned(), settingsOf(0.0)).contacts.size(), 1U);
}

TEST(SegmentationStability, nanInfinityAndHugeLoadsAreSafeAnywhere) {
    const teleta::test::WithoutFloatingPointTraps noNumbers;
    std::mt19937 random(27);
    const std::vector<float> odd{
        std::numeric_limits<float>::quiet_NaN(),  std::numeric_limits<float>::infinity(),
        -std::numeric_limits<float>::infinity(),  std::numeric_limits<float>::max(),
        std::numeric_limits<float>::denorm_min(), -1.0F};
    std::uniform_int_distribution<std::size_t> choice(0, odd.size() - 1);
    std::bernoulli_distribution replaced(0.3);
    for (int trial = 0; trial < 500; ++trial) {
        Frame frame = randomFrame(random, kPaperArray, 0.2);
        Frame usable = frame;
        for (std::size_t i = 0; i < frame.load_N.size(); ++i) {
            if (!replaced(random))
                continue;
            frame.load_N[i] = odd[choice(random)];
            usable.load_N[i] = frame.load_N[i] == std::numeric_limits<float>::max() ? frame.load_N[i] : 0.0F;
        }
        const Segmentation result = segment(frame, settingsOf(0.3));
        ASSERT_EQ(result.labels, segment(usable, settingsOf(0.3)).labels);
        for (const Contact& contact : result.contacts)
            ASSERT_TRUE(std::isfinite(contact.force_N) && std::isfinite(contact.x_m) &&
                        std::isfinite(contact.y_m));
    }
}
