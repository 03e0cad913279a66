// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/edit/edit.h"
#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/model/built_in_patterns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace teleta::pattern;
using teleta::core::Expected;
using teleta::core::Intensities;

namespace {

/// One object of each kind over tracks.
Pattern everything() {
    const Expected<Pattern> read =
        loadPattern(std::string(TELETA_SOURCE_DIR) + "/tests/data/patterns/everything.json");
    EXPECT_TRUE(read);
    return read ? *read : Pattern{};
}

/// Tactor i of a is tactor place(i) of b, at every time.
template <typename Place>
void expectMoved(const Pattern& a, const Pattern& b, Place place) {
    for (double t_s = 0.003; t_s < a.duration_s; t_s += 0.017) {
        const Intensities before = evaluate(a, t_s);
        const Intensities after = evaluate(b, t_s);
        for (int i = 0; i < 6; ++i)
            EXPECT_NEAR(before[static_cast<std::size_t>(i)], after[static_cast<std::size_t>(place(i))], 1e-6)
                << t_s << ' ' << i;
    }
}

} // namespace

TEST(Edit, rotatingMovesTracksAndObjectsAroundTheRing) {
    const Pattern pattern = everything();
    for (const int steps : {1, 2, 5, -1, 7})
        expectMoved(pattern, rotated(pattern, steps), [steps](int i) { return (i + steps + 12) % 6; });
    EXPECT_EQ(rotated(pattern, 0), pattern);
}

TEST(Edit, mirroringMovesTracksAndObjectsToTheOtherSide) {
    const Pattern pattern = everything();
    for (const int axis : {0, 1, 2, 5})
        expectMoved(pattern, mirrored(pattern, axis), [axis](int i) { return (axis - i + 12) % 6; });
    expectMoved(pattern, forOtherArm(forOtherArm(pattern)), [](int i) { return i; });
    EXPECT_EQ(pattern.arm, Arm::right);
    EXPECT_EQ(forOtherArm(pattern).arm, Arm::left);
    EXPECT_EQ(forOtherArm(forOtherArm(pattern)).arm, Arm::right);
    EXPECT_EQ(mirrored(pattern, 0).arm, Arm::right) << "on the same arm";
}

TEST(Edit, stretchingMultipliesAllTimes) {
    Pattern pattern = everything();
    std::get<Sweep>(pattern.objects[0].form).onset_s = 0.08;
    std::get<Ring>(pattern.objects[1].form).burst_s = 0.12;
    const Expected<Pattern> longer = stretched(pattern, 3.0);
    ASSERT_TRUE(longer);
    EXPECT_DOUBLE_EQ(longer->duration_s, 13.5);
    for (double t_s = 0.0031; t_s < pattern.duration_s; t_s += 0.017) {
        for (std::size_t i = 0; i < 6; ++i)
            EXPECT_NEAR(evaluate(*longer, 3.0 * t_s)[i], evaluate(pattern, t_s)[i], 1e-9) << t_s;
    }
    for (const double factor : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e9})
        EXPECT_FALSE(stretched(pattern, factor)) << factor;
}
