// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/console/study/study_bench.h"
#include "tests/support/small_disk.h"

#include <QLabel>

#include <algorithm>
#include <memory>

using namespace teleta;
using test::kPatience_ms;

/// A study on a disk that fills up during a session.
class StudyDiskTest : public QObject, protected test::StudyBench {
    Q_OBJECT

    std::unique_ptr<test::SmallDisk> m_disk;

private slots:
    void init() { setUp(); }
    void cleanup() {
        tearDown();
        m_disk.reset();
    }

    void theAnswerStaysAndIsKeptOnceThereIsRoomAgain() {
        // More than the free space that a run needs.
        m_disk = std::make_unique<test::SmallDisk>(studyFolder().toStdString(), 110);
        if (!m_disk->exists())
            QSKIP("No disk can be mounted here");
        openStudy();
        beginSession();
        doTrial();
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(1), kPatience_ms);
        startTrial();
        const std::size_t stimulus = current().stimulus;
        QVERIFY(m_disk->fill());
        // The write-ahead log may have some room of its own.
        int answers = 1;
        answer(stimulus);
        for (; answers < 2000 && runner().hold() != Hold::notKept && stage() != Stage::finished; ++answers) {
            QTRY_VERIFY_WITH_TIMEOUT(!runner().isKeeping(), kPatience_ms);
            if (runner().hold() == Hold::notKept)
                break;
            if (runner().hold() == Hold::blockEnd)
                controller().goOn();
            startTrial();
            answer(current().stimulus);
        }
        QTRY_COMPARE_WITH_TIMEOUT(runner().hold(), Hold::notKept, kPatience_ms);
        const std::size_t answered = runner().flow()->results().size();
        QVERIFY2(runner().reason().contains(studyFolder()), qPrintable(runner().reason()));
        QVERIFY(sessionPanel().scene().state.contains(runner().reason()));
        QCOMPARE(sessionPanel().scene().tone, study::Tone::alarm);
        QCOMPARE(window()->scene().state, study::ParticipantScene::State::paused);
        QTest::keyClick(window(), Qt::Key_Space);
        QCOMPARE(runner().hold(), Hold::notKept);
        // The disk is still full.
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!runner().isKeeping() && runner().hold() == Hold::notKept, kPatience_ms);
        QCOMPARE(runner().flow()->results().size(), answered);

        m_disk->empty();
        QTRY_VERIFY_WITH_TIMEOUT(nextButton()->isEnabled(), kPatience_ms);
        QTest::mouseClick(nextButton(), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), answered, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(!runner().isKeeping(), kPatience_ms);
        const auto trials = kept();
        for (const study::StoredTrial& trial : trials)
            QCOMPARE(trial.result.outcome, study::Outcome::correct);
    }

    void aDiskWithoutRoomPassesNoCheck() {
        m_disk = std::make_unique<test::SmallDisk>(studyFolder().toStdString(), 110);
        if (!m_disk->exists())
            QSKIP("No disk can be mounted here");
        openStudy();
        QVERIFY(m_disk->fill());
        controller().setNoiseConfirmed(true);
        const auto isRefused = [this] {
            const auto& checks = sessionPanel().scene().checks;
            return std::any_of(checks.begin(), checks.end(), [](const auto& check) {
                return !check.passed && check.remedy.contains(QStringLiteral("Free up space"));
            });
        };
        QTRY_VERIFY_WITH_TIMEOUT(isRefused(), kPatience_ms);
        controller().begin();
        QVERIFY(!runner().isActive());
        m_disk->empty();
        QTRY_VERIFY_WITH_TIMEOUT(!isRefused() && nextButton()->isEnabled(), kPatience_ms);
    }
};

QTEST_MAIN(StudyDiskTest)
#include "study_disk_test.moc"
