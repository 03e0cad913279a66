// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/patterns/patterns_page.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "tests/app/console/bracelet/patient_bracelet.h"
#include "widgets/bracelet/bracelet_view.h"
#include "widgets/pattern/pattern_editor.h"
#include "widgets/pattern/timeline/timeline_view.h"

#include <QAction>
#include <QApplication>
#include <QPushButton>
#include <QStackedWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <cmath>
#include <memory>

using namespace teleta;
using namespace teleta::console;
using pattern::Pattern;

namespace {

Pattern steadyPattern(double intensity, double duration_s) {
    Pattern pattern;
    pattern.id = "mine.steady";
    pattern.name = "Steady";
    pattern.duration_s = duration_s;
    pattern.tracks[1] = {{0.0, intensity}, {duration_s, intensity}};
    return pattern;
}

} // namespace

/// What the Patterns page plays, with and without a simulated bracelet.
class PatternPlaybackTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;
    core::StopSwitch m_stop;
    std::unique_ptr<BraceletService> m_station;
    std::unique_ptr<PatternCollection> m_collection;
    std::unique_ptr<PatternsPage> m_page;
    QTimer m_clock;

    [[nodiscard]] pattern::PatternEditor& editor() const { return m_page->editor(); }
    [[nodiscard]] double playhead_s() const { return editor().timeline()->playhead_s(); }
    [[nodiscard]] core::Intensities pictured() const {
        return m_page->findChild<bracelet::BraceletView*>()->intensities();
    }
    /// While nothing is played.
    [[nodiscard]] QToolButton* playButton() const {
        for (auto* button : editor().findChildren<QToolButton*>())
            if (button->text() == "Play")
                return button;
        return nullptr;
    }
    void space() { QTest::keyClick(editor().timeline(), Qt::Key_Space); }
    void connectBracelet() {
        m_station->choose(BraceletChoice::simulated);
        QTRY_VERIFY(m_station->isReady());
    }

private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_stop.release();
        m_station = test::patientBracelet(m_stop);
        m_collection = std::make_unique<PatternCollection>(m_folder->filePath("patterns"));
        m_page = std::make_unique<PatternsPage>(*m_station, *m_collection, QString());
        m_page->resize(1500, 900);
        m_page->show();
        m_clock.disconnect();
        connect(&m_clock, &QTimer::timeout, this, [this] {
            m_station->tick();
            m_page->tick();
        });
        m_clock.start(10);
    }
    void cleanup() {
        m_clock.stop();
        m_page.reset();
        m_collection.reset();
        m_station.reset();
    }

    void whileStoppedNothingPlaysAndThePictureIsAPreview() {
        connectBracelet();
        const auto* picture = m_page->findChild<bracelet::BraceletView*>();
        QToolButton* play = playButton();
        QVERIFY(play != nullptr);
        QVERIFY(play->isEnabled());
        m_stop.engage();
        QTRY_VERIFY(!play->isEnabled());
        QVERIFY2(play->toolTip().contains("STOP"), qPrintable(play->toolTip()));
        QTest::mouseClick(play, Qt::LeftButton);
        space();
        QVERIFY(!editor().isPlaying());
        QVERIFY(picture->isPreview());
        m_stop.release();
        QTRY_VERIFY(play->isEnabled() && m_station->isFree());
        QTest::mouseClick(play, Qt::LeftButton);
        QVERIFY(editor().isPlaying());
        QTRY_VERIFY(!picture->isPreview());
    }

    void stopEndsAPatternThatIsOnlyShown() {
        QVERIFY(!m_station->isFree());
        space();
        QVERIFY(editor().isPlaying());
        m_stop.engage();
        QTRY_VERIFY(!editor().isPlaying());
    }

    void spacePlaysWhenThePageIsComeTo() {
        QStackedWidget pages;
        auto* other = new QPushButton;
        pages.addWidget(other);
        pages.addWidget(m_page.get());
        pages.resize(1500, 900);
        pages.show();
        pages.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&pages));
        other->setFocus();
        pages.setCurrentWidget(m_page.get());
        QTRY_VERIFY(editor().timeline()->hasFocus());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        QVERIFY(editor().isPlaying());
        pages.removeWidget(m_page.get());
        m_page->setParent(nullptr);
    }

    void thePictureShowsThePatternAtThePlayheadWhileNothingDrivesTheBracelet() {
        Pattern ramp = steadyPattern(0.0, 2.0);
        ramp.tracks[4] = {{0.0, 0.0}, {2.0, 1.0}};
        editor().document()->setPattern(ramp);
        editor().setPlayhead(0.5);
        QTRY_COMPARE(pictured()[4], 0.25);
        connectBracelet();
        editor().setPlayhead(1.5);
        QTRY_COMPARE(pictured()[4], 0.75);
        QCOMPARE(m_station->given()[4], 0.0);
    }

    void withoutABraceletItPlaysOnTheScreenAndSaysSo() {
        editor().document()->setPattern(steadyPattern(0.5, 60.0));
        space();
        QVERIFY(editor().isPlaying());
        QTRY_VERIFY(
            m_page->findChild<bracelet::BraceletView*>()->accessibleDescription().contains("not felt"));
        QTRY_VERIFY(playhead_s() > 0.1);
        QCOMPARE(pictured()[1], 0.5);
        space();
        QVERIFY(!editor().isPlaying());
        editor().document()->setPattern(steadyPattern(0.5, 0.4));
        editor().setPlayhead(0.0);
        space();
        QVERIFY(editor().isPlaying());
        QTRY_VERIFY(!editor().isPlaying());
        QCOMPARE(playhead_s(), 0.4);
        // Again, as a loop: it repeats until it is stopped.
        editor().findChild<QAction*>("loop")->setChecked(true);
        space();
        QTRY_VERIFY(playhead_s() > 0.2);
        QTRY_VERIFY(playhead_s() < 0.2);
        QTRY_VERIFY(playhead_s() > 0.2);
        QVERIFY(editor().isPlaying());
        space();
        QVERIFY(!editor().isPlaying());
    }

    void editsAreFeltWhileThePatternPlays() {
        connectBracelet();
        editor().document()->setPattern(steadyPattern(0.5, 60.0));
        space();
        QTRY_COMPARE(m_station->given()[1], 0.5);
        const std::int64_t begun_ns = m_station->session()->player().status().begun_ns;
        const double before_s = playhead_s();
        // More edits at once than take effect: the last one counts.
        for (int k = 1; k <= 20; ++k) {
            editor().document()->replacePoint({1, 0}, {0.0, 0.5 + 0.01 * k});
            editor().document()->replacePoint({1, 1}, {60.0, 0.5 + 0.01 * k});
        }
        QTRY_VERIFY(std::abs(m_station->given()[1] - 0.7) < 1e-9);
        QVERIFY(editor().isPlaying());
        QVERIFY(playhead_s() >= before_s);
        QCOMPARE(m_station->session()->player().status().begun_ns, begun_ns);
        // An undo is an edit like any other.
        editor().document()->undoStack()->undo();
        editor().document()->undoStack()->undo();
        QTRY_VERIFY(std::abs(m_station->given()[1] - 0.69) < 1e-9);
    }

    void theLoopAndItsRangeCanBeChangedWhileItPlays() {
        connectBracelet();
        Pattern ramp = steadyPattern(0.0, 3.0);
        ramp.tracks[1] = {{0.0, 0.0}, {3.0, 1.0}};
        editor().document()->setPattern(ramp);
        auto* loop = editor().findChild<QAction*>("loop");
        space();
        loop->setChecked(true);
        const auto status = [this] { return m_station->session()->player().status(); };
        QTRY_VERIFY(status().loop);
        QTRY_VERIFY(playhead_s() > 1.8);
        QTRY_VERIFY(playhead_s() < 1.2);
        editor().timeline()->setLoop(pattern::Span{1.2, 1.8});
        QTRY_COMPARE(status().duration_s, 1.8 - 1.2);
        const auto inRange = [](double at_s) { return at_s >= 1.2 - 1e-9 && at_s <= 1.8 + 1e-9; };
        QTRY_VERIFY(playhead_s() > 1.56);
        QTRY_VERIFY(playhead_s() < 1.44);
        QVERIFY(inRange(playhead_s()));
        QVERIFY(editor().isPlaying());
        loop->setChecked(false);
        QTRY_VERIFY(!editor().isPlaying());
        QCOMPARE(status().ending, playback::PlayerEnding::finished);
        QCOMPARE(status().duration_s, 3.0);
    }

    void aPatternThatSomebodyElsePlaysMovesNoPlayhead() {
        connectBracelet();
        editor().document()->setPattern(steadyPattern(0.5, 60.0));
        editor().setPlayhead(5.0);
        const playback::Program other{[](double) { return core::Intensities{0.25}; }, 30.0};
        m_station->play(other, false);
        QTRY_COMPARE(m_station->given()[0], 0.25);
        QTRY_COMPARE(pictured()[0], 0.25);
        QVERIFY(!editor().isPlaying());
        QCOMPARE(playhead_s(), 5.0);
        // It takes the bracelet, and loses it to the next one.
        space();
        QTRY_COMPARE(m_station->given()[1], 0.5);
        QTRY_VERIFY(playhead_s() > 5.05);
        m_station->play(other, false, 20.0);
        QTRY_VERIFY(!editor().isPlaying());
        QVERIFY(playhead_s() < 20.0);
        editor().document()->setName("Another name");
        editor().timeline()->setLoop(pattern::Span{1.0, 2.0});
        QTRY_COMPARE(m_station->given()[0], 0.25);
        QVERIFY(m_station->playingPosition_s().value_or(0.0) >= 20.0);
    }

    void itStopsWithTheBraceletAndWithSTOP() {
        connectBracelet();
        editor().document()->setPattern(steadyPattern(0.5, 60.0));
        const QToolButton* play = playButton();
        QVERIFY(play != nullptr);
        space();
        QTRY_COMPARE(m_station->given()[1], 0.5);
        m_stop.engage();
        QTRY_VERIFY(!editor().isPlaying() && !play->isEnabled());
        m_stop.release();
        QTRY_VERIFY(play->isEnabled());
        space();
        QTRY_COMPARE(m_station->given()[1], 0.5);
        m_station->choose(BraceletChoice::none);
        QTRY_VERIFY(!editor().isPlaying());
    }
};

QTEST_MAIN(PatternPlaybackTest)
#include "pattern_playback_test.moc"
