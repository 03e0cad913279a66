// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/playback_bar.h"

#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

using teleta::chrome::PlaybackBar;
using teleta::core::PlaybackPosition;

/// The playback bar: shows a position, asks for another.
class PlaybackBarTest : public QObject {
    Q_OBJECT

    static PlaybackPosition position(double time_s, bool paused) {
        PlaybackPosition made;
        made.time_s = time_s;
        made.duration_s = 60.0;
        made.frame = 9;
        made.frames = 600;
        made.indexed = true;
        made.paused = paused;
        return made;
    }

private slots:
    void asksToPauseWhilePlayingAndToPlayWhilePaused() {
        PlaybackBar bar;
        QSignalSpy plays(&bar, &PlaybackBar::playRequested);
        QSignalSpy pauses(&bar, &PlaybackBar::pauseRequested);
        bar.setPosition(position(0.0, false));
        QTest::keyClick(&bar, Qt::Key_Space);
        QCOMPARE(pauses.size(), 1);
        bar.setPosition(position(0.0, true));
        QTest::mouseClick(bar.findChild<QToolButton*>("play"), Qt::LeftButton);
        QCOMPARE(plays.size(), 1);
        QCOMPARE(pauses.size(), 1);
    }

    void stepsWithKeysAndButtons() {
        PlaybackBar bar;
        bar.setPosition(position(30.0, true));
        QSignalSpy steps(&bar, &PlaybackBar::stepRequested);
        QTest::keyClick(&bar, Qt::Key_Left);
        QTest::keyClick(&bar, Qt::Key_Right);
        QTest::mouseClick(bar.findChild<QToolButton*>("forward"), Qt::LeftButton);
        QCOMPARE(steps.size(), 3);
        QCOMPARE(steps[0][0].toInt(), -1);
        QCOMPARE(steps[1][0].toInt(), 1);
        QCOMPARE(steps[2][0].toInt(), 1);
    }

    void seeksToWhereTheTimeBarIsClicked() {
        PlaybackBar bar;
        bar.resize(900, 40);
        bar.show();
        bar.setPosition(position(0.0, false));
        auto* slider = bar.findChild<QSlider*>();
        QSignalSpy seeks(&bar, &PlaybackBar::seekRequested);
        QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() / 2, slider->height() / 2));
        QCOMPARE(seeks.size(), 1);
        QVERIFY2(qAbs(seeks[0][0].toDouble() - 30.0) < 0.5, qPrintable(seeks[0][0].toString()));
    }

    void seeksToTheMarkThatIsClicked() {
        PlaybackBar bar;
        bar.resize(900, 40);
        bar.show();
        bar.setPosition(position(0.0, true));
        auto* slider = bar.findChild<QSlider*>();
        for (const double mark_s : {3.0, 57.0}) {
            bar.setMarks({});
            bar.setPosition(position(0.0, true));
            const QImage without = slider->grab().toImage();
            bar.setMarks({{mark_s, mark_s, "a"}});
            const QImage with = slider->grab().toImage();
            // The point of the flag is in the middle of what is drawn.
            int left = with.width();
            int right = 0;
            for (int x = 0; x < with.width(); ++x)
                if (with.pixel(x, 1) != without.pixel(x, 1)) {
                    left = std::min(left, x);
                    right = std::max(right, x);
                }
            QVERIFY(left <= right);
            QSignalSpy seeks(&bar, &PlaybackBar::seekRequested);
            QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint((left + right) / 2, slider->height() / 2));
            QCOMPARE(seeks.size(), 1);
            const double pixel_s = 60.0 / slider->width();
            QVERIFY2(qAbs(seeks[0][0].toDouble() - mark_s) < 2.0 * pixel_s,
                     qPrintable(seeks[0][0].toString()));
        }
    }

    void showingAPositionAsksForNothing() {
        PlaybackBar bar;
        QSignalSpy seeks(&bar, &PlaybackBar::seekRequested);
        QSignalSpy speeds(&bar, &PlaybackBar::speedRequested);
        QSignalSpy loops(&bar, &PlaybackBar::loopRequested);
        PlaybackPosition shown = position(15.0, false);
        shown.speed = 10.0;
        shown.loop = true;
        bar.setPosition(shown);
        QCOMPARE(seeks.size() + speeds.size() + loops.size(), 0);
        const auto* slider = bar.findChild<QSlider*>();
        QCOMPARE(slider->value() * 4, slider->maximum());
        QCOMPARE(bar.findChild<QComboBox*>()->currentData().toDouble(), 10.0);
        QVERIFY(bar.findChild<QToolButton*>("loop")->isChecked());
    }

    void countsAsTheMarksDo() {
        PlaybackBar bar;
        bar.setMarks({{7.5, 10.0, "a"}});
        bar.setPosition(position(15.0, false));
        QCOMPARE(bar.findChild<QLabel*>()->text(), QStringLiteral("0:17.5 / 1:02.5"));
        QCOMPARE(bar.findChild<QSlider*>()->value() * 4, bar.findChild<QSlider*>()->maximum());
    }

    void saysThatTheDurationIsNotKnownYet() {
        PlaybackBar bar;
        PlaybackPosition growing = position(1.0, false);
        growing.indexed = false;
        bar.setPosition(growing);
        QVERIFY(bar.findChild<QLabel*>()->text().contains(QChar(0x2026)));
        bar.setPosition(position(61.25, false));
        QCOMPARE(bar.findChild<QLabel*>()->text(), QString("1:01.2 / 1:00.0"));
    }

    void goesFromMarkToMark() {
        PlaybackBar bar;
        bar.setPosition(position(15.0, true));
        bar.setMarks({{10.0, 10.0, "a"}, {20.0, 20.0, "b"}, {30.0, 30.0, "c"}});
        QSignalSpy seeks(&bar, &PlaybackBar::seekRequested);
        auto* slider = bar.findChild<QSlider*>();
        QTest::keyClick(slider, Qt::Key_PageDown);
        bar.setPosition(position(20.0, true));
        QTest::keyClick(slider, Qt::Key_PageDown);
        QTest::keyClick(&bar, Qt::Key_PageUp);
        bar.setPosition(position(30.0, true));
        QTest::keyClick(&bar, Qt::Key_PageDown);
        QCOMPARE(seeks.size(), 3);
        QCOMPARE(seeks[0][0].toDouble(), 20.0);
        QCOMPARE(seeks[1][0].toDouble(), 30.0);
        QCOMPARE(seeks[2][0].toDouble(), 10.0);
    }

    void drawsMarksWhereTheyAre() {
        PlaybackBar bar;
        bar.resize(900, 40);
        bar.show();
        bar.setPosition(position(0.0, true));
        auto* slider = bar.findChild<QSlider*>();
        const QImage without = slider->grab().toImage();
        bar.setMarks({{30.0, 30.0, "half"}, {90.0, 90.0, "behind the end"}});
        const QImage with = slider->grab().toImage();
        int left = with.width();
        int right = 0;
        for (int x = 0; x < with.width(); ++x)
            for (int y = 0; y < with.height(); ++y)
                if (with.pixel(x, y) != without.pixel(x, y)) {
                    left = std::min(left, x);
                    right = std::max(right, x);
                }
        QVERIFY2(left < with.width() / 2 + 1 && right >= with.width() / 2 - 1 && right - left < 24,
                 qPrintable(QString("%1 to %2 of %3").arg(left).arg(right).arg(with.width())));
    }

    void survivesAnEmptyRecording() {
        PlaybackBar bar;
        PlaybackPosition empty;
        empty.speed = 0.0;
        bar.setPosition(empty);
        QCOMPARE(bar.findChild<QSlider*>()->value(), 0);
    }
};

QTEST_MAIN(PlaybackBarTest)
#include "playback_bar_test.moc"
