// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/recording/recording_service.h"
#include "app/console/session_recorder.h"
#include "app/console/sources/source_manager.h"
#include "backend/recording/recording.h"
#include "tests/app/console/study/study_bench.h"
#include "tests/support/pseudo_terminal.h"

#include <QDir>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

using namespace teleta;
using console::RecordingService;
using test::kPatience_ms;
using Bytes = std::vector<std::uint8_t>;

/// Triggers and recordings of sessions on the Study page.
class SessionMarksTest : public QObject, protected test::StudyBench {
    Q_OBJECT

    std::unique_ptr<console::SourceManager> m_sources;
    std::unique_ptr<RecordingService> m_service;
    std::unique_ptr<console::SessionRecorder> m_recorder;
    std::unique_ptr<QTimer> m_recorderTick;

    void openStudyThat(const std::string& more) {
        m_more = more;
        openStudy();
        m_sources = std::make_unique<console::SourceManager>(*m_stop);
        m_service = std::make_unique<RecordingService>(*m_sources, *m_station, *m_stop);
        m_recorder = std::make_unique<console::SessionRecorder>(*m_service);
        controller().setRecording(m_recorder.get());
        m_recorderTick = std::make_unique<QTimer>();
        QObject::connect(m_recorderTick.get(), &QTimer::timeout, m_service.get(), &RecordingService::tick);
        m_recorderTick->start(5);
    }
    void abortSession() {
        controller().abort();
        QTRY_VERIFY_WITH_TIMEOUT(!controller().isBusy() && runner().flow()->isOver(), kPatience_ms);
    }

private slots:
    void init() { setUp(); }
    void cleanup() {
        m_recorderTick.reset();
        if (m_page)
            controller().setRecording(nullptr);
        m_recorder.reset();
        m_service.reset();
        m_sources.reset();
        tearDown();
    }

    void everyEventIsAByteOnTheLine() {
        const test::PseudoTerminal line;
        openStudyThat("[trigger]\nkind = \"serial\"\npulse_ms = 0.0\ndevice = \"" + line.name() + "\"\n");
        QTRY_VERIFY_WITH_TIMEOUT(controller().trigger()->state == study::TriggerStatus::State::open,
                                 kPatience_ms);
        beginSession();
        QCOMPARE(line.read(1), Bytes{1});
        startTrial();
        const auto stimulus = static_cast<std::uint8_t>(101 + current().stimulus);
        const std::size_t given = 1 - current().stimulus;
        QCOMPARE(line.read(1), Bytes{stimulus});
        answer(given);
        QCOMPARE(line.read(1), Bytes{static_cast<std::uint8_t>(201 + given)});
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(1), kPatience_ms);
        const auto& result = kept().front().result;
        QVERIFY(result.trigger_ms.has_value());
        QVERIFY(*result.trigger_ms > 0.0);
        QVERIFY(result.recording.empty());
        abortSession();
        QCOMPARE(line.read(2), (Bytes{5, 2}));
        QCOMPARE(controller().trigger()->failures, std::uint64_t(0));
    }

    void aMissingDeviceIsACheckBeforeTheSession() {
        openStudyThat("[trigger]\nkind = \"serial\"\ndevice = \"" +
                      m_folder->filePath(QStringLiteral("ttyUSB9")).toStdString() + "\"\n");
        QTRY_VERIFY_WITH_TIMEOUT(controller().trigger()->state == study::TriggerStatus::State::failed,
                                 kPatience_ms);
        const std::vector<study::RunCheck> checks = controller().checks();
        QCOMPARE(checks.back().kind, study::RunCheckKind::trigger);
        QVERIFY(!checks.back().passed);
        QVERIFY(QString::fromStdString(checks.back().finding).contains(QStringLiteral("ttyUSB9")));
    }

    void aDeviceThatGoesAwayHoldsNoSession() {
        test::PseudoTerminal line;
        openStudyThat("[trigger]\nkind = \"serial\"\npulse_ms = 0.0\ndevice = \"" + line.name() + "\"\n");
        QTRY_VERIFY_WITH_TIMEOUT(controller().trigger()->state == study::TriggerStatus::State::open,
                                 kPatience_ms);
        beginSession();
        QCOMPARE(line.read(1), Bytes{1});
        line.hangUp();
        doTrial();
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(1), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(controller().trigger()->failures > 0, kPatience_ms);
        QVERIFY(!kept().front().result.trigger_ms);
        QTRY_VERIFY_WITH_TIMEOUT(
            sessionPanel().scene().device.contains(QStringLiteral("could not be written")), kPatience_ms);
    }

    void aSessionIsRecordedOnOneClockWithItsRows() {
        openStudyThat("[recording]\nsessions = true\n");
        beginSession();
        QTRY_VERIFY_WITH_TIMEOUT(m_service->isRecording(), kPatience_ms);
        doTrial();
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(1), kPatience_ms);
        QTest::keyClick(window(), Qt::Key_Space);
        doTrial();
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(2), kPatience_ms);
        abortSession();
        QTRY_COMPARE_WITH_TIMEOUT(m_service->state(), RecordingService::State::idle, kPatience_ms);

        const auto trials = kept();
        const std::string name = trials.front().result.recording;
        QVERIFY2(name.starts_with("recordings/P01_"), name.c_str());
        const auto file = recording::Recording::open(studyFolder().toStdString() + '/' + name);
        QVERIFY2(file.has_value(), file ? "" : core::describe(file.error()).c_str());
        std::map<std::string, int> kinds;
        std::vector<double> onsets_s;
        for (const recording::RecordingEvent& event : file->events()) {
            if (!event.kind.starts_with("study."))
                continue;
            ++kinds[event.kind];
            const auto text = nlohmann::json::parse(event.text);
            QCOMPARE(text["attempt"].get<int>(), 1);
            QCOMPARE(text["steady_ns"].get<std::int64_t>(), event.time_ns);
            if (event.kind == "study.onset") {
                QCOMPARE(text["trial"].get<std::size_t>(), onsets_s.size() + 1);
                onsets_s.push_back(file->time_s(event.time_ns));
            }
        }
        QCOMPARE(kinds,
                 (std::map<std::string, int>{{"study.answer", 2}, {"study.end", 2}, {"study.onset", 2}}));
        // The row, the event and the bracelet's own stream agree.
        const auto stream = file->first(recording::StreamKind::tactors);
        QVERIFY(stream.has_value());
        const std::size_t channels = file->streams()[*stream].channels();
        recording::StreamReader reader = file->reader(*stream);
        core::TappedFrames block;
        std::vector<double> begun_s;
        bool silent = true;
        while (reader.next(block).value()) {
            for (std::size_t i = 0; i < block.frames(); ++i) {
                const auto values = recording::valuesOf<float>(block, i, channels);
                const bool off = std::ranges::all_of(values, [](float value) { return value == 0.0F; });
                if (silent && !off)
                    begun_s.push_back(file->time_s(block.time_ns[i]));
                silent = off;
            }
        }
        QVERIFY(begun_s.size() >= 2);
        for (std::size_t i = 0; i < 2; ++i) {
            QVERIFY(trials[i].result.recording_s.has_value());
            QVERIFY(std::abs(*trials[i].result.recording_s - onsets_s[i]) < 1e-3);
            const auto nearest = std::ranges::min(
                begun_s, {}, [&](double time_s) { return std::abs(time_s - *trials[i].result.recording_s); });
            QVERIFY2(std::abs(nearest - *trials[i].result.recording_s) < 1e-3,
                     qPrintable(QString::number(nearest - *trials[i].result.recording_s)));
        }
    }

    void aRecorderThatFailsStopsNoSession() {
        openStudyThat("[recording]\nsessions = true\n");
        // A file is where the folder of the recordings should be.
        QFile inTheWay(QDir(studyFolder()).filePath(QStringLiteral("recordings")));
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        bool failed = false;
        connect(m_service.get(), &RecordingService::failed, this, [&] { failed = true; });
        beginSession();
        QTRY_VERIFY_WITH_TIMEOUT(failed, kPatience_ms);
        doTrial();
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(1), kPatience_ms);
        QVERIFY(kept().front().result.recording.empty());
        QVERIFY(!kept().front().result.recording_s);
        QCOMPARE(runner().hold(), Hold::none);
    }
};

QTEST_MAIN(SessionMarksTest)
#include "session_marks_test.moc"
