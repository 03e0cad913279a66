// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/recording/mark_views.h"
#include "widgets/charts/strip_chart_view.h"

#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>

#include <memory>

using namespace teleta;
using console::MarkList;
using console::MarkViews;
using console::RecordingMark;

namespace {

/// Time of the first frame since the recording's start.
constexpr double kFirstFrame_s = 0.125;

/// A recording of 2 s with a mark at 1 s.
class MarkedPlayback : public core::PlaybackControl {
public:
    void play() override {}
    void pause() override {}
    void step(int /*frames*/) override {}
    void setSpeed(double /*factor*/) override {}
    void seek(double /*time_s*/) override {}
    void setLoop(bool /*loop*/) override {}
    [[nodiscard]] core::PlaybackPosition position() const override { return {}; }
    [[nodiscard]] std::vector<core::PlaybackMark> marks() const override {
        return {{1.0 - kFirstFrame_s, 1.0, "slip"}};
    }
};

constexpr std::int64_t kBegin_ns = 7'000'000'000;

} // namespace

/// Marks in the strip charts and in their list.
class MarkViewsTest : public QObject {
    Q_OBJECT

    std::unique_ptr<charts::StripChartView> m_charts;
    std::unique_ptr<MarkViews> m_marks;

    /// Samples of the stream's time from .. to, 0.01 s apart, that pass in step_ns each.
    std::int64_t feed(double from_s, double to_s, std::int64_t begin_ns, std::int64_t step_ns) {
        const int samples = qRound((to_s - from_s) / 0.01);
        pipeline::FeatureSample sample;
        for (int i = 0; i < samples; ++i) {
            sample.time_ns = begin_ns + i * step_ns;
            sample.sourceTime_s = from_s + 0.01 * i;
            sample.discontinuity = i == 0;
            m_charts->append(sample);
            m_marks->take(sample);
            m_marks->tick();
        }
        m_charts->refresh();
        return sample.time_ns;
    }

private slots:
    void init() {
        m_charts = std::make_unique<charts::StripChartView>();
        m_charts->resize(800, 500);
        m_charts->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_charts.get()));
        m_marks = std::make_unique<MarkViews>(*m_charts, m_charts.get());
    }
    void cleanup() {
        m_marks.reset();
        m_charts.reset();
    }

    void aMarkOfALoopIsOneMarkHoweverOftenItIsPassed() {
        const MarkedPlayback playback;
        m_marks->setSource(1, &playback);
        for (int pass = 0; pass < 5; ++pass)
            feed(0.0, 2.0, kBegin_ns + pass * 2'000'000'000LL, 10'000'000);
        QCOMPARE(m_charts->marks(), std::size_t(1));
    }

    void aMarkHasTheSameTimeWhereverItIsListed() {
        const MarkedPlayback playback;
        QSignalSpy sought(m_marks.get(), &MarkViews::seekRequested);
        m_marks->setRecorded({{1, kBegin_ns, 1.0, "slip"}}, true);
        const double live_s = m_marks->list().marks().at(0).time_s;
        m_marks->setRecorded({}, false);
        m_marks->setSource(1, &playback);
        QCOMPARE(m_marks->list().marks().size(), std::size_t(1));
        QCOMPARE(m_marks->list().marks()[0].time_s, live_s);
        // The playback's own times are from its first frame.
        auto* table = m_marks->list().findChild<QTableWidget*>();
        m_marks->list().resize(400, 200);
        m_marks->list().show();
        table->setCurrentCell(0, 0);
        QTest::keyClick(table, Qt::Key_Return);
        QCOMPARE(sought.size(), 1);
        QCOMPARE(sought[0][0].toDouble(), 1.0 - kFirstFrame_s);
    }

    void marksOfTheLastRecordingAreListedBesideItsSourcesOnly() {
        m_marks->setSource(1, nullptr);
        m_marks->setRecorded({}, true);
        m_marks->setRecorded({{1, kBegin_ns, 1.0, "slip"}}, true);
        m_marks->setSource(2, nullptr);
        m_marks->setRecorded({{1, kBegin_ns, 1.0, "slip"}}, false);
        const auto count = [this] { return m_marks->list().marks().size(); };
        QCOMPARE(count(), std::size_t(1));
        m_marks->setSource(3, nullptr); // opened afterwards
        QCOMPARE(count(), std::size_t(0));
        m_marks->setSource(1, nullptr);
        QCOMPARE(count(), std::size_t(1));
        m_marks->setRecorded({}, true); // the next recording, of this source only
        m_marks->setRecorded({{1, kBegin_ns, 2.0, "press"}}, false);
        QCOMPARE(count(), std::size_t(1));
        m_marks->setSource(2, nullptr);
        QCOMPARE(count(), std::size_t(0));
    }

    void theListOfAPlaybackSaysWhyNothingCanBeTyped() {
        const MarkedPlayback playback;
        MarkList& list = m_marks->list();
        list.resize(400, 200);
        list.show();
        auto* why = list.findChild<QLabel*>("marksAreFixed");
        m_marks->setSource(1, nullptr);
        m_marks->setRecorded({{1, kBegin_ns, 1.0, "slip"}}, true);
        QVERIFY(!why->isVisible());
        m_marks->setRecorded({}, false);
        m_marks->setSource(2, &playback);
        QVERIFY(why->isVisible());
        auto* table = list.findChild<QTableWidget*>();
        table->setCurrentCell(0, 1);
        QTest::keyClick(table, Qt::Key_F2);
        QVERIFY(table->findChild<QLineEdit*>() == nullptr);
    }

    void aDoubleClickAnywhereOnAPlayedMarkGoesThere_data() {
        QTest::addColumn<int>("column");
        QTest::newRow("time") << 0;
        QTest::newRow("text") << 1;
    }
    void aDoubleClickAnywhereOnAPlayedMarkGoesThere() {
        QFETCH(int, column);
        const MarkedPlayback playback;
        QSignalSpy sought(m_marks.get(), &MarkViews::seekRequested);
        m_marks->setSource(1, &playback);
        m_marks->list().resize(400, 200);
        m_marks->list().show();
        auto* table = m_marks->list().findChild<QTableWidget*>();
        const QPoint at = table->visualItemRect(table->item(0, column)).center();
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, at);
        QCOMPARE(sought.size(), 1);
        QCOMPARE(sought[0][0].toDouble(), 1.0 - kFirstFrame_s);
    }

    void aMarkIsAskedForWhenTheSampleAtTheCursorCame() {
        // Played at twice its speed.
        const std::int64_t newest_ns = feed(0.0, 4.0, kBegin_ns, 5'000'000);
        QSignalSpy asked(m_marks.get(), &MarkViews::markRequested);
        m_charts->setCursorTime(-2.0);
        QTest::keyClick(m_charts.get(), Qt::Key_M);
        QCOMPARE(asked.size(), 1);
        QVERIFY(std::abs(asked[0][0].toLongLong() - (newest_ns - 1'000'000'000)) <= 5'000'000);
    }

    void aMarkSetWhileThePlaybackIsPausedIsShownWhereItStood() {
        const std::int64_t paused_ns = feed(0.0, 4.0, kBegin_ns, 10'000'000);
        const RecordingMark mark{1, paused_ns + 20'000'000'000, 30.0, "paused"};
        m_marks->setRecorded({mark}, true);
        m_marks->tick();
        QCOMPARE(m_charts->marks(), std::size_t(1));
        feed(4.0, 6.0, paused_ns + 60'000'000'000, 10'000'000);
        QCOMPARE(m_charts->marks(), std::size_t(1));
    }

    void aTextThatIsBeingTypedIsTakenAsItIs() {
        MarkList& list = m_marks->list();
        QSignalSpy renamed(&list, &MarkList::renamed);
        list.setMarks({{4, 1.0, "old"}, {5, 2.0, "other"}}, true);
        list.finishEditing(); // nothing is typed
        QCOMPARE(renamed.size(), 0);
        list.edit(4);
        auto* editor = list.findChild<QTableWidget*>()->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        QTest::keyClicks(editor, "it slipped");
        list.finishEditing();
        QCOMPARE(renamed.size(), 1);
        QCOMPARE(renamed[0][0].toULongLong(), 4ULL);
        QCOMPARE(renamed[0][1].toString(), QString("it slipped"));
    }

    void aTextThatIsBeingTypedStaysWhereOtherMarksChange() {
        MarkList& list = m_marks->list();
        list.setMarks({{4, 1.0, "old"}}, true);
        list.edit(4);
        auto* editor = list.findChild<QTableWidget*>()->findChild<QLineEdit*>();
        QTest::keyClicks(editor, "it sl");
        list.setMarks({{4, 1.0, "old"}, {5, 2.0, ""}}, true);
        QTest::keyClicks(editor, "ipped");
        QCOMPARE(editor->text(), QString("it slipped"));
    }
};

QTEST_MAIN(MarkViewsTest)
#include "mark_views_test.moc"
