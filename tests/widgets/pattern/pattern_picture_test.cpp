// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/built_in_patterns.h"
#include "tests/widgets/test_registry.h"
#include "widgets/base/theme.h"
#include "widgets/pattern/pattern_picture.h"

#include <QTest>

using namespace teleta;

/// Small pictures of patterns.
class PatternPictureTest : public QObject {
    Q_OBJECT

private slots:
    /// The first tactor at half its intensity during the first half, the last one at full intensity in the
    /// second.
    void everyTactorHasARowOverTime() {
        pattern::Pattern pattern;
        pattern.duration_s = 2.0;
        pattern.tracks[0] = {{0.0, 0.5, pattern::Easing::hold}, {1.0, 0.0, pattern::Easing::hold}};
        pattern.tracks[5] = {
            {0.0, 0.0, pattern::Easing::hold}, {1.0, 1.0, pattern::Easing::hold}, {2.0, 1.0}};
        const QPalette palette = base::designedPalette(false);
        const QRgb strong = palette.color(QPalette::Link).rgb();
        const QImage picture = patternPicture(pattern, QSize(40, 60), palette); // rows of 10 px
        QCOMPARE(picture.size(), QSize(40, 60));
        QCOMPARE(picture.pixel(10, 8), strong);
        QVERIFY2(picture.pixel(10, 3) != strong, "half of its row");
        QVERIFY(picture.pixel(30, 8) != strong);
        QCOMPARE(picture.pixel(30, 53), strong);
        QCOMPARE(picture.pixel(30, 58), strong);
        QVERIFY(picture.pixel(10, 58) != strong);
        for (int y = 12; y < 49; ++y)
            QVERIFY(picture.pixel(20, y) != strong);
    }

    void aPatternWithoutTimeIsEmptyRows() {
        pattern::Pattern nothing;
        nothing.duration_s = 0.0;
        const QPalette palette = base::designedPalette(true);
        const QImage picture = patternPicture(nothing, QSize(40, 60), palette);
        for (int y = 0; y < 60; ++y)
            QVERIFY(picture.pixel(20, y) != palette.color(QPalette::Link).rgb());
    }

    void builtInPatternsDiffer() {
        const QPalette palette = base::designedPalette(false);
        const auto of = [&](const char* id) {
            return patternPicture(*pattern::findBuiltIn(id), QSize(48, 24), palette);
        };
        QVERIFY(of("shape.A.dynamic") != of("shape.B.dynamic"));
        QVERIFY(of("shape.A.dynamic") != of("shape.A.static"));
    }
};

static const test::Registration<PatternPictureTest> registration;

#include "pattern_picture_test.moc"
