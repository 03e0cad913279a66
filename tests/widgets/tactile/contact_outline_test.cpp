// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/tactile/contact_outline.h"

#include <QTest>

#include <numeric>

using namespace teleta::tactile;

namespace {

/// Labels from a drawing whose last line is row 0, as the array is seen.
struct Labels {
    std::vector<std::int32_t> values;
    int columns = 0, rows = 0;

    explicit Labels(std::initializer_list<const char*> lines)
        : rows(static_cast<int>(lines.size())) {
        std::vector<const char*> upward(lines);
        std::ranges::reverse(upward);
        for (const char* line : upward) {
            columns = static_cast<int>(qstrlen(line));
            for (const char* c = line; *c != '\0'; ++c)
                values.push_back(*c == '.' ? 0 : *c - '0');
        }
    }
    [[nodiscard]] std::vector<OutlineLoop> outline(std::int32_t region) const {
        return traceOutline(values, columns, region, {0, rows - 1, 0, columns - 1});
    }
};

/// Signed area by the shoelace formula: positive for a loop with the region on its left.
double areaOf(const OutlineLoop& loop) {
    double twice = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const OutlineCorner& a = loop[i];
        const OutlineCorner& b = loop[(i + 1) % loop.size()];
        twice += a.column * b.row - b.column * a.row;
    }
    return 0.5 * twice;
}

} // namespace

class ContactOutlineTest : public QObject {
    Q_OBJECT
private slots:
    void oneTaxelIsASquareWithCornersThatPointInwards() {
        const auto loops = Labels({"...", ".1.", "..."}).outline(1);
        QCOMPARE(loops.size(), std::size_t(1));
        const OutlineLoop expected{{2, 1, -1, 1}, {2, 2, -1, -1}, {1, 2, 1, -1}, {1, 1, 1, 1}};
        QCOMPARE(loops[0], expected);
    }

    void aStraightBorderHasNoCornersOnIt() {
        const auto loops = Labels({"1111"}).outline(1);
        QCOMPARE(loops.size(), std::size_t(1));
        QCOMPARE(loops[0].size(), std::size_t(4));
        QCOMPARE(areaOf(loops[0]), 4.0);
    }

    void anInnerCornerPointsIntoTheRegionToo() {
        const auto loops = Labels({"1.", "11"}).outline(1);
        QCOMPARE(loops.size(), std::size_t(1));
        QCOMPARE(loops[0].size(), std::size_t(6));
        QCOMPARE(areaOf(loops[0]), 3.0);
        const auto inner = std::ranges::find_if(
            loops[0], [](const OutlineCorner& c) { return c.column == 1 && c.row == 1; });
        QVERIFY(inner != loops[0].end());
        QCOMPARE(*inner, (OutlineCorner{1, 1, -1, -1}));
    }

    void aHoleIsALoopTheOtherWayRound() {
        const auto loops = Labels({"111", "1.1", "111"}).outline(1);
        QCOMPARE(loops.size(), std::size_t(2));
        QCOMPARE(areaOf(loops[0]) + areaOf(loops[1]), 8.0);
        QVERIFY(areaOf(loops[0]) * areaOf(loops[1]) < 0.0);
    }

    void taxelsThatTouchAtACornerGetALoopEach() {
        for (const Labels& labels : {Labels({"1.", ".1"}), Labels({".1", "1."})}) {
            const auto loops = labels.outline(1);
            QCOMPARE(loops.size(), std::size_t(2));
            QCOMPARE(areaOf(loops[0]), 1.0);
            QCOMPARE(areaOf(loops[1]), 1.0);
        }
    }

    void aDiagonalRingIsFollowedToItsEnd() {
        const auto loops = Labels({".1.", "1.1", ".1."}).outline(1);
        const double area =
            std::accumulate(loops.begin(), loops.end(), 0.0,
                            [](double sum, const OutlineLoop& loop) { return sum + areaOf(loop); });
        QCOMPARE(area, 4.0);
    }

    void neighboursWithOtherLabelsAreOutside() {
        const Labels labels({"1122", "1122"});
        for (const std::int32_t region : {1, 2}) {
            const auto loops = labels.outline(region);
            QCOMPARE(loops.size(), std::size_t(1));
            QCOMPARE(areaOf(loops[0]), 4.0);
        }
        QVERIFY(labels.outline(3).empty());
    }

    /// Any region: the loops enclose as much as it has taxels.
    void theLoopsOfARandomRegionEncloseItsTaxels() {
        std::uint32_t state = 7;
        for (int round = 0; round < 200; ++round) {
            constexpr int kSide = 9;
            std::vector<std::int32_t> labels(kSide * kSide);
            for (auto& label : labels) {
                state = state * 1664525U + 1013904223U;
                label = (state >> 24) & 1U;
            }
            const auto taxels = std::ranges::count(labels, 1);
            double area = 0.0;
            for (const auto& loop : traceOutline(labels, kSide, 1, {0, kSide - 1, 0, kSide - 1}))
                area += areaOf(loop);
            QCOMPARE(area, static_cast<double>(taxels));
        }
    }
};

static const teleta::test::Registration<ContactOutlineTest> registration;

#include "contact_outline_test.moc"
