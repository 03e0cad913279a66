// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/motor_file.h"
#include "tests/app/console/study/study_bench.h"

#include <QMessageBox>

using namespace teleta;
using test::kPatience_ms;

/// What results of a study change at the connected bracelet.
class StudyBraceletTest : public QObject, protected test::StudyBench {
    Q_OBJECT

    QTemporaryDir m_settings;

    [[nodiscard]] QMessageBox* question() { return m_page->findChild<QMessageBox*>("useForBracelet"); }
    void answerQuestion(QMessageBox::ButtonRole role) {
        for (QAbstractButton* button : question()->buttons()) {
            if (question()->buttonRole(button) == role) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        }
        QFAIL("there is no such button");
    }
    [[nodiscard]] pattern::MotorProfiles weaker() const {
        pattern::MotorProfiles profiles = m_station->calibration().profiles();
        profiles[1].fullDrive = 0.75;
        return profiles;
    }

private slots:
    void initTestCase() { qputenv("XDG_CONFIG_HOME", m_settings.path().toUtf8()); }
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void fullDrivesAreUsedAndSavedOnlyAfterAQuestion() {
        openStudy();
        const std::string serial = m_station->calibration().bracelet;
        const std::string path = motors::profilePath(serial);
        QVERIFY2(!path.empty(), "the simulated bracelet has a serial number");
        QCOMPARE(m_station->calibration().motors[1].profile.fullDrive, 1.0);

        emit resultsView().useRequested(weaker(), QStringLiteral("P01"));
        QVERIFY(question() != nullptr);
        QVERIFY(question()->informativeText().contains(QStringLiteral("P01")));
        answerQuestion(QMessageBox::RejectRole);
        QTRY_VERIFY_WITH_TIMEOUT(question() == nullptr, kPatience_ms);
        QCOMPARE(m_station->calibration().motors[1].profile.fullDrive, 1.0);

        emit resultsView().useRequested(weaker(), QStringLiteral("P01"));
        answerQuestion(QMessageBox::AcceptRole);
        QCOMPARE(m_station->calibration().motors[1].profile.fullDrive, 0.75);
        QTRY_VERIFY_WITH_TIMEOUT(motors::findMotors(serial).value().has_value(), kPatience_ms);
        const auto saved = motors::findMotors(serial);
        QCOMPARE((*saved)->motors[1].profile.fullDrive, 0.75);
        QCOMPARE((*saved)->motors[1].startFrom, motors::CalibratedMotor::Origin::answers);
        QCOMPARE((*saved)->motors[1].lagFrom, motors::CalibratedMotor::Origin::assumed);
    }
};

QTEST_MAIN(StudyBraceletTest)
#include "study_bracelet_test.moc"
