// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/calibrate_page.h"
#include "app/console/main_window.h"
#include "app/console/study/forms/protocol_dialog.h"
#include "app/console/study/study_page.h"
#include "backend/equilibration/taxel_gain_file.h"
#include "backend/motors/motor_file.h"
#include "backend/study/store/study_store.h"
#include "tests/app/console/study/study_bench.h"
#include "widgets/base/theme.h"
#include "widgets/calibrate/gains_view.h"
#include "widgets/calibrate/motors_view.h"
#include "widgets/chrome/page_rail.h"
#include "widgets/view3d/vtk/gl_setup.h"

#include <QApplication>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QStandardPaths>
#include <QTest>

#include <memory>

using namespace teleta;
using console::ConsoleOptions;
using console::ConsoleSettings;
using console::MainWindow;
using test::kPatience_ms;

/// The program is left while a session runs, or something is not saved.
class MainWindowClosingTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<core::StopSwitch> m_stop;
    std::unique_ptr<ConsoleSettings> m_settings;
    std::unique_ptr<MainWindow> m_window;

    [[nodiscard]] QString studyFolder() const { return m_folder->filePath(QStringLiteral("study")); }
    [[nodiscard]] console::StudyPage& page() const { return *m_window->findChild<console::StudyPage*>(); }
    [[nodiscard]] const console::StudyRunner& runner() const { return page().controller().runner(); }
    [[nodiscard]] QMessageBox* question(const char* name) const {
        return m_window->findChild<QMessageBox*>(QString::fromLatin1(name));
    }
    void choose(const char* name, QMessageBox::ButtonRole role) const {
        for (QAbstractButton* button : question(name)->buttons())
            if (question(name)->buttonRole(button) == role) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        QFAIL("there is no such button");
    }
    [[nodiscard]] std::size_t kept() const {
        const auto store = study::StudyStore::open(studyFolder().toStdString());
        return store->trials(store->sessions(store->participants()->front())->front())->size();
    }
    void execute(const QString& sql) const {
        {
            QSqlDatabase database = QSqlDatabase::addDatabase("QSQLITE", "beside");
            database.setDatabaseName(studyFolder() + "/study.sqlite");
            QVERIFY(database.open());
            QVERIFY(QSqlQuery(database).exec(sql));
        }
        QSqlDatabase::removeDatabase("beside");
    }
    [[nodiscard]] bool isFelt() const {
        const study::Session* session = runner().session();
        return session != nullptr &&
               (session->stage() == study::Stage::stimulus || session->stage() == study::Stage::answering);
    }
    void press(Qt::Key key) const { QTest::keyClick(&page().participantWindow(), key); }

    void openWindow(const ConsoleOptions& options) {
        m_window = std::make_unique<MainWindow>(options, *m_settings, *m_stop);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->openRequested(options);
    }
    /// Without a bracelet, whose profile would come in place of what is calibrated here.
    static ConsoleOptions withoutBracelet() {
        ConsoleOptions options;
        options.bracelet = QStringLiteral("none");
        return options;
    }
    void calibrateMotorsAndCamera() const {
        auto& view = m_window->calibratePage().motors().view();
        motors::MotorCalibration profile = view.calibration();
        profile.motors[0].profile.startDrive += 0.05;
        view.takeProfile(profile);
        QVERIFY(!view.isSaved());
        m_window->calibratePage().camera().addPair({});
        QVERIFY(!m_window->calibratePage().camera().isSaved());
    }

    /// The window with a session whose first trial is felt.
    void beginTrial() {
        {
            study::StudyHead head;
            head.protocol = study::parseProtocol(test::kShort, "short.toml").value();
            head.mode = study::Mode::pilot;
            head.created = QDateTime::currentDateTimeUtc();
            QVERIFY(study::StudyStore::create(studyFolder().toStdString(), head)->enrol("P01"));
        }
        ConsoleOptions options;
        options.study = studyFolder();
        options.bracelet = QStringLiteral("simulated");
        openWindow(options);
        QTRY_VERIFY_WITH_TIMEOUT(page().controller().overview().has_value(), kPatience_ms);
        page().controller().setNoiseConfirmed(true);
        QTRY_VERIFY_WITH_TIMEOUT(study::allPassed(page().controller().checks()), kPatience_ms);
        page().controller().begin();
        QTRY_VERIFY_WITH_TIMEOUT(runner().isActive(), kPatience_ms);
        press(Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(isFelt(), kPatience_ms);
    }

private slots:
    void initTestCase() { base::applyTheme(base::ThemeChoice::light); }
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_stop = std::make_unique<core::StopSwitch>();
        m_settings = std::make_unique<ConsoleSettings>(true);
    }
    void cleanup() { m_window.reset(); }

    void aSessionThatRunsIsEndedOnlyWhenThatIsConfirmed() {
        beginTrial();
        QVERIFY(!m_window->close());
        QVERIFY(m_window->isVisible() && question("endSession") != nullptr);
        QVERIFY2(!m_stop->engaged(), "the participant still feels the stimulus");
        // It is decided later; meanwhile the participant answers.
        press(Qt::Key_1);
        QTRY_VERIFY_WITH_TIMEOUT(!runner().isKeeping(), kPatience_ms);
        choose("endSession", QMessageBox::RejectRole);
        QTRY_VERIFY_WITH_TIMEOUT(question("endSession") == nullptr, kPatience_ms);
        QVERIFY(m_window->isVisible());
        QVERIFY(runner().isActive());
        QVERIFY(!m_window->close());
        choose("endSession", QMessageBox::AcceptRole);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isVisible(), kPatience_ms);
        QVERIFY(m_stop->engaged());
        m_window.reset();
        QCOMPARE(kept(), std::size_t(1));
    }

    void anAnswerThatIsNotKeptHoldsTheWindowUntilItIsOrIsGivenUp() {
        beginTrial();
        execute("ALTER TABLE trial RENAME TO hidden");
        press(Qt::Key_1);
        QTRY_COMPARE_WITH_TIMEOUT(runner().hold(), study::Hold::notKept, kPatience_ms);
        QVERIFY(!m_window->close());
        QVERIFY(question("notKept") != nullptr);
        choose("notKept", QMessageBox::RejectRole);
        QTRY_VERIFY_WITH_TIMEOUT(question("notKept") == nullptr, kPatience_ms);
        QVERIFY(m_window->isVisible());
        execute("ALTER TABLE hidden RENAME TO trial");
        QVERIFY(!m_window->close());
        choose("notKept", QMessageBox::AcceptRole);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isVisible(), kPatience_ms);
        m_window.reset();
        QCOMPARE(kept(), std::size_t(1));
    }

    void eachCalibrationThatIsNotSavedIsAskedAbout() {
        openWindow(withoutBracelet());
        calibrateMotorsAndCamera();
        const auto* rail = m_window->findChild<chrome::PageRail*>();
        QVERIFY(rail->currentPage() != QStringLiteral("calibrate"));
        QVERIFY(!m_window->close());
        QCOMPARE(rail->currentPage(), QStringLiteral("calibrate"));
        choose("unsavedCalibration0", QMessageBox::RejectRole);
        QTRY_VERIFY_WITH_TIMEOUT(question("unsavedCalibration0") == nullptr, kPatience_ms);
        QVERIFY(m_window->isVisible() && !m_stop->engaged());
        QVERIFY2(question("unsavedCalibration1") == nullptr, "who thinks better of it is asked no more");
        QVERIFY(!m_window->close());
        choose("unsavedCalibration0", QMessageBox::DestructiveRole);
        QVERIFY(m_window->isVisible());
        choose("unsavedCalibration1", QMessageBox::DestructiveRole);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isVisible(), kPatience_ms);
    }

    void aMeasuredMotorIsSavedByTheFirstAnswer() {
        QStandardPaths::setTestModeEnabled(true);
        const QString profile = QString::fromStdString(motors::profilePath("simulated"));
        QFile::remove(profile);
        ConsoleOptions options;
        options.bracelet = QStringLiteral("simulated");
        openWindow(options);
        auto& view = m_window->calibratePage().motors().view();
        QTRY_VERIFY_WITH_TIMEOUT(!view.calibration().bracelet.empty(), kPatience_ms);
        motors::MotorCalibration measured = view.calibration();
        measured.motors[0].profile.startDrive = 0.21;
        measured.motors[0].startFrom = measured.motors[0].lagFrom =
            motors::CalibratedMotor::Origin::recording;
        view.takeProfile(measured);
        QVERIFY(!view.isSaved());
        QVERIFY(!m_window->close());
        QMessageBox* ask = question("unsavedCalibration0");
        QCOMPARE(ask->text(), QString("Motor 1 was measured and is not saved."));
        QCOMPARE(ask->defaultButton(), ask->button(QMessageBox::Save));
        QTest::keyClick(ask, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isVisible(), kPatience_ms);
        m_window.reset();
        const auto kept = motors::readMotors(profile.toStdString());
        QVERIFY(kept.has_value());
        QCOMPARE(kept->motors[0].profile.startDrive, 0.21);
        QFile::remove(profile);
    }

    void gainsThatAreNotSavedAreAskedAbout() {
        openWindow(withoutBracelet());
        auto& gains = m_window->calibratePage().gains().view();
        gains.take({});
        QVERIFY(!gains.isSaved());
        QVERIFY(!m_window->close());
        choose("unsavedCalibration2", QMessageBox::DestructiveRole);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isVisible(), kPatience_ms);
    }

    void gainsAreSavedByTheFirstAnswer() {
        openWindow(withoutBracelet());
        auto gains = std::make_shared<equilibration::TaxelGains>();
        gains->layout = {.rows = 1, .columns = 2, .pitchX_m = 0.01};
        for (const double gain : {1.25, 0.75})
            gains->taxels.push_back({.state = equilibration::TaxelState::good, .gain = gain, .error = 0.01});
        m_window->calibratePage().gains().view().take({{}, gains});
        QVERIFY(!m_window->close());
        QMessageBox* ask = question("unsavedCalibration2");
        QCOMPARE(ask->defaultButton(), ask->button(QMessageBox::Save));
        QTest::keyClick(ask, Qt::Key_Return);
        const auto dialog = [&] { return m_window->findChild<QFileDialog*>(); };
        QTRY_VERIFY_WITH_TIMEOUT(dialog() != nullptr, kPatience_ms);
        QVERIFY(m_window->isVisible());
        const QString path = m_folder->filePath(QStringLiteral("gains.csv"));
        dialog()->selectFile(path);
        QTest::keyClick(dialog()->findChild<QLineEdit*>(QStringLiteral("fileNameEdit")), Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isVisible(), kPatience_ms);
        const auto kept = equilibration::readTaxelGains(path.toStdString(), gains->layout);
        QVERIFY(kept.has_value());
        QCOMPARE(kept->taxels[0].gain, 1.25);
    }

    void gainsThatAreNotSavedKeepTheirSourceOpen() {
        ConsoleOptions options = withoutBracelet();
        options.scenes << QStringLiteral("tactile-even-load");
        openWindow(options);
        QTRY_VERIFY_WITH_TIMEOUT(
            m_window->sources().active() != nullptr && m_window->sources().active()->isOpen(), kPatience_ms);
        auto& gains = m_window->calibratePage().gains().view();
        gains.take({});
        QVERIFY(!gains.isSaved());
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QTest::keyClick(m_window.get(), Qt::Key_W, Qt::ControlModifier);
        QTRY_VERIFY(question("unsavedGains") != nullptr);
        choose("unsavedGains", QMessageBox::RejectRole);
        QTRY_VERIFY_WITH_TIMEOUT(question("unsavedGains") == nullptr, kPatience_ms);
        QVERIFY(m_window->sources().active() != nullptr && !gains.isSaved());
        QTest::keyClick(m_window.get(), Qt::Key_W, Qt::ControlModifier);
        QTRY_VERIFY(question("unsavedGains") != nullptr);
        choose("unsavedGains", QMessageBox::DestructiveRole);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->sources().active() == nullptr, kPatience_ms);
    }

    void aProtocolThatIsNotSavedIsAskedAbout() {
        openWindow(withoutBracelet());
        QFile file(m_folder->filePath(QStringLiteral("short.toml")));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(test::kShort) > 0);
        file.close();
        const auto form = [this]() -> console::ProtocolDialog* {
            for (auto* each : m_window->findChildren<console::ProtocolDialog*>())
                if (each->isVisible())
                    return each;
            return nullptr;
        };
        page().open(file.fileName());
        QTRY_VERIFY_WITH_TIMEOUT(form() != nullptr, kPatience_ms);
        console::ProtocolDialog* first = form();
        // One that is opened in its place has to wait.
        first->findChild<QLineEdit*>("protocolName")->setText(QStringLiteral("Mine"));
        page().open(file.fileName());
        QTRY_VERIFY_WITH_TIMEOUT(question("unsavedProtocol") != nullptr, kPatience_ms);
        choose("unsavedProtocol", QMessageBox::RejectRole);
        QTRY_VERIFY_WITH_TIMEOUT(question("unsavedProtocol") == nullptr, kPatience_ms);
        QCOMPARE(form(), first);
        QVERIFY(first->isChanged());
        page().open(file.fileName());
        QTRY_VERIFY_WITH_TIMEOUT(question("unsavedProtocol") != nullptr, kPatience_ms);
        choose("unsavedProtocol", QMessageBox::DestructiveRole);
        QTRY_VERIFY_WITH_TIMEOUT(form() != nullptr && form() != first, kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(m_window->findChildren<console::ProtocolDialog*>().size(), 1, kPatience_ms);
        QVERIFY(!form()->isChanged());

        form()->findChild<QLineEdit*>("protocolName")->setText(QStringLiteral("Mine"));
        QVERIFY(!m_window->close());
        choose("unsavedProtocol", QMessageBox::RejectRole);
        QTRY_VERIFY_WITH_TIMEOUT(question("unsavedProtocol") == nullptr, kPatience_ms);
        QVERIFY(m_window->isVisible() && form() != nullptr);
        QVERIFY(!m_window->close());
        choose("unsavedProtocol", QMessageBox::DestructiveRole);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isVisible(), kPatience_ms);
    }

    void nobodyIsAskedWhereNobodyIsThere() {
        ConsoleOptions options = withoutBracelet();
        options.screenshot = m_folder->filePath(QStringLiteral("picture.png"));
        openWindow(options);
        calibrateMotorsAndCamera();
        QVERIFY(m_window->close());
    }

    void whatIsGivenUpIsGone() {
        beginTrial();
        execute("ALTER TABLE trial RENAME TO hidden");
        press(Qt::Key_1);
        QTRY_COMPARE_WITH_TIMEOUT(runner().hold(), study::Hold::notKept, kPatience_ms);
        QVERIFY(!m_window->close());
        choose("notKept", QMessageBox::DestructiveRole);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isVisible(), kPatience_ms);
        m_window.reset();
        execute("ALTER TABLE hidden RENAME TO trial");
        QCOMPARE(kept(), std::size_t(0));
    }
};

int main(int argc, char* argv[]) {
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    MainWindowClosingTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "main_window_closing_test.moc"
