// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/camera/camera_calibrator.h"
#include "app/console/calibrate/camera/pair_entry.h"
#include "app/console/calibrate/camera/probing_strip.h"
#include "app/console/calibrate/camera/tube_fields.h"
#include "backend/vision/calibration/camera_file.h"
#include "tests/backend/vision/simulated_pairs.h"
#include "tests/widgets/parts.h"
#include "widgets/base/background.h"
#include "widgets/base/numbers/number_format.h"

#include <QAction>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>
#include <QUndoStack>

#include <algorithm>
#include <array>
#include <cmath>

using namespace teleta;
using console::CameraCalibrator;
using vision::CalibrationMethod;

/// The camera's part of the Calibrate page.
class CameraCalibratorTest : public QObject {
    Q_OBJECT

    static vision::SimulatedPairs simulated() {
        vision::CameraLottery lottery(5);
        return vision::simulatePairs(vision::paperCamera(), {0.5, 0.1}, lottery);
    }

    static QAction* action(const CameraCalibrator& calibrator, const char* text) {
        for (QAction* one : calibrator.findChildren<QAction*>())
            if (one->text().remove(u'&').contains(QLatin1String(text)))
                return one;
        return nullptr;
    }

    static QString remarkOfRobust(const CameraCalibrator& calibrator) {
        for (const QTableWidget* table : calibrator.findChildren<QTableWidget*>())
            if (table->columnCount() == 6 && table->rowCount() == 4)
                return table->item(3, 5)->text();
        return QStringLiteral("no table");
    }

    static void calibrate(CameraCalibrator& calibrator) {
        QSignalSpy done(&calibrator, &CameraCalibrator::calibrated);
        calibrator.setPairs(simulated().pairs);
        QVERIFY(done.wait(60'000));
    }

private slots:
    void saysWhatToDoWithoutPairs() {
        const CameraCalibrator calibrator;
        QVERIFY(calibrator.verdict().contains("Load pairs"));
        QVERIFY(calibrator.answer() == nullptr);
    }

    void calibratesWithAllMethodsAndShowsTheRobustOne() {
        CameraCalibrator calibrator;
        calibrate(calibrator);
        const auto* answer = calibrator.answer();
        QVERIFY(answer != nullptr && answer->calibration);
        QCOMPARE(answer->calibration->method, CalibrationMethod::robust);
        QCOMPARE(calibrator.shown().residuals.size(), calibrator.shown().pairs.size());
        QVERIFY2(calibrator.verdict().contains("no pattern"), qPrintable(calibrator.verdict()));
        // The valid radius is told, and what was kept is within it.
        const vision::CameraModel& found = answer->calibration->camera.camera();
        const Eigen::Vector2d centre(found.parameters().cx_px, found.parameters().cy_px);
        for (std::size_t i = 0; i < calibrator.shown().pairs.size(); ++i) {
            if (answer->calibration->residuals[i].kept)
                QVERIFY((calibrator.shown().pairs[i].pixel - centre).norm() < found.validRadius_px() + 5.0);
        }
        // Where it is larger than the image, the image is what counts.
        const auto& image = calibrator.work().settings;
        const bool isLarger = found.validRadius_px() >= std::hypot(image.width_px, image.height_px);
        const QString valid = isLarger
                                  ? QStringLiteral("valid in the whole image")
                                  : "valid within " + base::threeDigits(found.validRadius_px()).trimmed();
        QVERIFY2(calibrator.verdict().contains(valid), qPrintable(calibrator.verdict()));
        calibrator.chooseMethod(CalibrationMethod::dlt);
        QVERIFY2(calibrator.verdict().contains("lens distortion") ||
                     calibrator.verdict().contains("No calibration"),
                 qPrintable(calibrator.verdict()));
    }

    void theStepsBackSpeakTheLanguageOfNow() {
        CameraCalibrator calibrator;
        const auto texts = [&] {
            QStringList all;
            for (const QAction* action : calibrator.findChildren<QAction*>())
                if (action->shortcut() == QKeySequence(QKeySequence::Undo) ||
                    action->shortcut() == QKeySequence(QKeySequence::Redo))
                    all << action->text() << (action->isEnabled() ? "on" : "off");
            return all;
        };
        QCOMPARE(texts(), QStringList({"&Undo", "off", "&Redo", "off"}));
        struct Capitals : QTranslator {
            bool isEmpty() const override { return false; }
            QString translate(const char*, const char* text, const char*, int) const override {
                return QString(text).toUpper();
            }
        } capitals;
        QCoreApplication::installTranslator(&capitals);
        QTRY_COMPARE(texts(), QStringList({"&UNDO", "off", "&REDO", "off"}));
        QCoreApplication::removeTranslator(&capitals);
        calibrator.setPairs(simulated().pairs);
        QTRY_COMPARE(texts(), QStringList({"&Undo", "on", "&Redo", "off"}));
    }

    void anExclusionCanBeUndone() {
        CameraCalibrator calibrator;
        calibrate(calibrator);
        QSignalSpy done(&calibrator, &CameraCalibrator::calibrated);
        calibrator.setUsed({3, 4}, false);
        QVERIFY(done.wait(60'000));
        QCOMPARE(calibrator.shown().state(3), camera::CalibratedPairs::State::excluded);
        // What the camera makes of an excluded pair is still shown.
        QVERIFY(calibrator.shown().residuals[3].error_px.has_value());
        QCOMPARE(calibrator.undoStack().count(), 2); // after the loading
        calibrator.undoStack().undo();
        QVERIFY(done.wait(60'000));
        QVERIFY(calibrator.shown().used[3]);
        calibrator.undoStack().redo();
        QVERIFY(!calibrator.shown().used[3]);
        calibrator.setUsed({3}, false);
        QCOMPARE(calibrator.undoStack().count(), 2);
        QVERIFY(done.wait(60'000));
    }

    void changesDuringAFitAreFittedNext() {
        CameraCalibrator calibrator;
        QSignalSpy done(&calibrator, &CameraCalibrator::calibrated);
        calibrator.setPairs(simulated().pairs);
        QVERIFY(calibrator.isBusy());
        calibrator.setUsed({0}, false);
        calibrator.setUsed({1}, false);
        QVERIFY(done.wait(60'000));
        QCOMPARE(done.count(), 1);
        QVERIFY(!calibrator.isBusy());
        QVERIFY(!calibrator.shown().residuals[0].kept);
        QVERIFY(!calibrator.shown().residuals[1].kept);
    }

    void savesNoCameraOfAnEarlierFit() {
        const QTemporaryDir folder;
        CameraCalibrator calibrator;
        calibrate(calibrator);
        QAction* save = action(calibrator, "Save camera");
        QVERIFY(save->isEnabled());
        QSignalSpy told(&calibrator, &CameraCalibrator::message);
        QSignalSpy done(&calibrator, &CameraCalibrator::calibrated);
        calibrator.setUsed({0, 1, 2}, false);
        QVERIFY(calibrator.isBusy());
        QVERIFY(!save->isEnabled());
        QVERIFY(!action(calibrator, "Exclude wrong")->isEnabled());
        QVERIFY(!calibrator.isSaved());
        calibrator.save(folder.filePath("early.json"));
        QCOMPARE(told.count(), 1);
        QVERIFY(told[0][1].toBool());
        QVERIFY(done.wait(60'000));
        QVERIFY(save->isEnabled());
        calibrator.save(folder.filePath("camera.json"));
        QVERIFY(told.wait(60'000));
        QCOMPARE(told.count(), 2);
        QVERIFY(!told[1][1].toBool());
        QVERIFY(calibrator.isSaved());
        calibrator.undoStack().undo();
        QVERIFY(!calibrator.isSaved());
        calibrator.undoStack().redo();
        QVERIFY(calibrator.isSaved());
        QVERIFY(!QFile::exists(folder.filePath("early.json")));
        const auto camera = vision::readCamera(folder.filePath("camera.json").toStdString());
        QVERIFY(camera.has_value());
        QCOMPARE(camera->summary.pairs, simulated().pairs.size());
        QVERIFY(camera->summary.kept <= simulated().pairs.size() - 3);
    }

    void ofTwoFilesTheOneThatWasAskedForLastIsShown() {
        const QTemporaryDir folder;
        // The first one takes longer to read.
        const std::vector<vision::CalibrationPair> few = simulated().pairs;
        std::vector<vision::CalibrationPair> many;
        for (int i = 0; i < 400; ++i)
            many.insert(many.end(), few.begin(), few.end());
        QVERIFY(vision::writePairs(many, folder.filePath("many.csv").toStdString()));
        QVERIFY(vision::writePairs(few, folder.filePath("few.csv").toStdString()));
        CameraCalibrator calibrator;
        QSignalSpy done(&calibrator, &CameraCalibrator::calibrated);
        calibrator.open(folder.filePath("many.csv"));
        calibrator.open(folder.filePath("few.csv"));
        QVERIFY(done.wait(60'000));
        base::backgroundPool().waitForDone();
        QCoreApplication::processEvents();
        QCOMPARE(calibrator.shown().pairs.size(), few.size());
    }

    void aPairIsTypedInRemovedAndBroughtBack() {
        CameraCalibrator calibrator;
        calibrator.resize(1400, 900);
        calibrator.show();
        QVERIFY(QTest::qWaitForWindowActive(&calibrator));
        auto* entry = calibrator.findChild<console::PairEntry*>();
        constexpr std::array<const char*, 5> kFields{"u", "v", "x", "y", "z"};
        const std::array<const char*, 5> texts{"812.5", "300.25", "-12.5", "21.65", "40"};
        for (std::size_t i = 0; i < texts.size(); ++i) {
            auto* field = test::part<QDoubleSpinBox>(*entry, kFields[i]);
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, texts[i]);
        }
        QTest::keyClick(test::part<QDoubleSpinBox>(*entry, "z"), Qt::Key_Return);
        QCOMPARE(calibrator.work().pairs.size(), std::size_t(1));
        const vision::CalibrationPair& pair = calibrator.work().pairs[0];
        QCOMPARE(pair.pixel, Eigen::Vector2d(812.5, 300.25));
        QVERIFY((pair.p_Sensor_m - Eigen::Vector3d(-0.0125, 0.02165, 0.04)).norm() < 1e-9);
        QTest::mouseClick(test::part(*entry, "add"), Qt::LeftButton);
        QCOMPARE(calibrator.work().pairs.size(), std::size_t(2));
        auto* table = calibrator.findChild<QTableView*>("pairs");
        table->setFocus();
        table->selectRow(0);
        QTest::keyClick(table, Qt::Key_Delete);
        QCOMPARE(calibrator.work().pairs.size(), std::size_t(1));
        QTest::keyClick(table, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(calibrator.work().pairs.size(), std::size_t(2));
        QTest::keyClick(table, Qt::Key_Z, Qt::ControlModifier);
        QTest::keyClick(table, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(calibrator.work().pairs.empty());
        QTRY_VERIFY_WITH_TIMEOUT(!calibrator.isBusy(), 60'000);
        QVERIFY(calibrator.answer() == nullptr);
    }

    void anotherRemovalKeepsWhatIsKnownOfTheOthersUntilTheNextFit() {
        CameraCalibrator calibrator;
        calibrate(calibrator);
        const auto before = calibrator.shown().residuals;
        calibrator.removePairs({0, 7});
        QCOMPARE(calibrator.shown().residuals.size(), before.size() - 2);
        QCOMPARE(*calibrator.shown().residuals[0].error_px, *before[1].error_px);
        QCOMPARE(*calibrator.shown().residuals[6].error_px, *before[8].error_px);
        calibrator.undoStack().undo();
        QCOMPARE(calibrator.shown().residuals.size(), before.size());
        QCOMPARE(*calibrator.shown().residuals[7].error_px, *before[7].error_px);
        // A loading can be undone too.
        calibrator.undoStack().undo();
        QVERIFY(calibrator.shown().pairs.empty());
        QVERIFY(calibrator.shown().residuals.empty());
        QTRY_VERIFY_WITH_TIMEOUT(!calibrator.isBusy(), 60'000);
    }

    void calibratesAnotherTubeWithAnotherCamera() {
        // Half the image and half the tube: the same camera, its pixels and points halved.
        std::vector<vision::CalibrationPair> half = simulated().pairs;
        for (vision::CalibrationPair& pair : half) {
            pair.pixel *= 0.5;
            pair.p_Sensor_m *= 0.5;
        }
        CameraCalibrator calibrator;
        calibrator.resize(1400, 900);
        calibrator.show();
        QVERIFY(QTest::qWaitForWindowActive(&calibrator));
        auto* tube = calibrator.findChild<console::TubeFields*>();
        const auto type = [](QAbstractSpinBox* box, const char* text) {
            box->setFocus();
            box->selectAll();
            QTest::keyClicks(box, text);
            QTest::keyClick(box, Qt::Key_Tab);
        };
        type(test::part<QSpinBox>(*tube, "width"), "820");
        type(test::part<QSpinBox>(*tube, "height"), "616");
        type(test::part<QDoubleSpinBox>(*tube, "radius"), "12.5");
        type(test::part<QDoubleSpinBox>(*tube, "length"), "50");
        QCOMPARE(calibrator.undoStack().count(), 4);
        QSignalSpy done(&calibrator, &CameraCalibrator::calibrated);
        calibrator.setPairs(half);
        QVERIFY(done.wait(60'000));
        const auto* answer = calibrator.answer();
        QVERIFY(answer != nullptr && answer->calibration);
        QCOMPARE(answer->calibration->camera.camera().parameters().width_px, 820);
        QCOMPARE(answer->calibration->camera.surface().radius_m, 0.0125);
        QVERIFY(answer->calibration->mean_error_m < 0.1e-3);
        // Undone and redone with what they were fitted with.
        for (int i = 0; i < 5; ++i)
            calibrator.undoStack().undo();
        QCOMPARE(test::part<QSpinBox>(*tube, "width")->value(), 1640);
        QCOMPARE(test::part<QDoubleSpinBox>(*tube, "radius")->value(), 25.0);
        QTRY_VERIFY_WITH_TIMEOUT(!calibrator.isBusy(), 60'000);
    }

    void swappedPixelsAreTold() {
        std::vector<vision::CalibrationPair> pairs = simulated().pairs;
        for (vision::CalibrationPair& pair : pairs)
            std::swap(pair.pixel.x(), pair.pixel.y());
        CameraCalibrator calibrator;
        QSignalSpy done(&calibrator, &CameraCalibrator::calibrated);
        calibrator.setPairs(pairs);
        QVERIFY(done.wait(60'000));
        QVERIFY2(calibrator.verdict().contains("Caution: u and v seem to be swapped"),
                 qPrintable(calibrator.verdict()));
        QCOMPARE(remarkOfRobust(calibrator), "u and v swapped?");
    }

    void holesOfAShellAreMovedToTheSurfaceByTheFactorThatIsTypedIn() {
        constexpr double kFactor = 0.97;
        std::vector<vision::CalibrationPair> holes = simulated().pairs;
        for (vision::CalibrationPair& pair : holes)
            pair.p_Sensor_m.head<2>() /= kFactor;
        const QTemporaryDir folder;
        CameraCalibrator calibrator;
        calibrator.resize(1400, 900);
        calibrator.show();
        QVERIFY(QTest::qWaitForWindowActive(&calibrator));
        QSignalSpy done(&calibrator, &CameraCalibrator::calibrated);
        calibrator.setPairs(holes);
        QVERIFY(done.wait(60'000));
        const auto& onTheShell = calibrator.answer()->calibration; // 0.77 mm above the surface
        QVERIFY(onTheShell && onTheShell->mean_error_m > 0.5e-3);
        QVERIFY2(calibrator.verdict().contains("Caution: the points are 25.77 mm from the axis") &&
                     calibrator.verdict().contains("a hole factor of 0.97 "),
                 qPrintable(calibrator.verdict()));
        QCOMPARE(remarkOfRobust(calibrator), "points off the cylinder");
        auto* factor = test::part<QDoubleSpinBox>(calibrator, "holeFactor");
        factor->setFocus();
        factor->selectAll();
        QTest::keyClicks(factor, QLocale().toString(kFactor));
        QTest::keyClick(factor, Qt::Key_Tab);
        QVERIFY(done.wait(60'000));
        QVERIFY(calibrator.answer()->calibration);
        QVERIFY(calibrator.answer()->calibration->mean_error_m < 0.25e-3);
        QVERIFY2(!calibrator.verdict().contains("Caution"), qPrintable(calibrator.verdict()));
        QCOMPARE(remarkOfRobust(calibrator), QString());
        const vision::CalibrationPair shown = calibrator.shown().pairs[7];
        QVERIFY((shown.p_Sensor_m - simulated().pairs[7].p_Sensor_m).norm() < 1e-12);
        // The file holds them as they were loaded, and those that follow are moved alike.
        QSignalSpy told(&calibrator, &CameraCalibrator::message);
        const QString file = folder.filePath("pairs.csv");
        calibrator.savePairs(file);
        QVERIFY(told.wait(60'000));
        const auto saved = vision::readPairs(file.toStdString());
        QVERIFY(saved && (saved->at(7).p_Sensor_m - holes[7].p_Sensor_m).norm() < 1e-9);
        calibrator.open(file);
        QVERIFY(done.wait(60'000));
        QVERIFY((calibrator.shown().pairs[7].p_Sensor_m - shown.p_Sensor_m).norm() < 1e-9);
        calibrator.undoStack().undo();
        calibrator.undoStack().undo();
        QCOMPARE(factor->value(), 1.0);
        QVERIFY((calibrator.shown().pairs[7].p_Sensor_m - holes[7].p_Sensor_m).norm() < 1e-12);
        QTRY_VERIFY_WITH_TIMEOUT(!calibrator.isBusy(), 60'000);
    }

    void probingTheSimulatedTubeBringsPairsOneByOneAndStoppingKeepsThem() {
        CameraCalibrator calibrator;
        calibrator.resize(1400, 900);
        calibrator.show();
        QVERIFY(QTest::qWaitForWindowActive(&calibrator));
        calibrator.addPair({{100.0, 200.0}, {0.025, 0.0, 0.05}});
        const auto simulatedLabel = [&] {
            const auto labels = calibrator.findChildren<QLabel*>();
            return std::ranges::any_of(labels, [](const QLabel* label) {
                return label->isVisible() && label->text() == QLatin1String("SIMULATED");
            });
        };
        QVERIFY(!simulatedLabel());
        auto* strip = calibrator.findChild<console::ProbingStrip*>();
        QVERIFY(!strip->isVisible());
        action(calibrator, "Probe the simulated")->trigger();
        QVERIFY(strip->isVisible());
        QVERIFY(!action(calibrator, "Probe the simulated")->isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(calibrator.work().simulated && calibrator.work().pairs.size() >= 2, 240'000);
        QVERIFY(simulatedLabel());
        QVERIFY(strip->findChild<QProgressBar*>()->value() > 0);
        QTest::mouseClick(test::part(*strip, "stop"), Qt::LeftButton);
        QVERIFY(!calibrator.probing().isRunning());
        QVERIFY(!strip->isVisible());
        const std::vector<vision::CalibrationPair> pairs = calibrator.work().pairs;
        QVERIFY(pairs.size() >= 2);
        for (const vision::CalibrationPair& pair : pairs) {
            // The marked places are on the tube, and what is seen of them is in the image.
            QVERIFY(std::abs(pair.p_Sensor_m.head<2>().norm() - 0.025) < 1e-9);
            QVERIFY(pair.pixel.x() > 0.0 && pair.pixel.x() < 1640.0);
            QVERIFY(pair.pixel.y() > 0.0 && pair.pixel.y() < 1232.0);
        }
        // All of it is one step back.
        QTest::keyClick(&calibrator, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(calibrator.work().pairs.size(), std::size_t(1));
        QCOMPARE(calibrator.work().pairs[0].pixel, Eigen::Vector2d(100.0, 200.0));
        QVERIFY(!simulatedLabel());
        calibrator.undoStack().redo();
        QCOMPARE(calibrator.work().pairs.size(), pairs.size());
        QTRY_VERIFY_WITH_TIMEOUT(!calibrator.isBusy(), 60'000);
    }

    void aProbingEndsWithWhatItWasFor() {
        CameraCalibrator calibrator;
        calibrator.probe();
        calibrator.setPairs(simulated().pairs);
        QVERIFY(!calibrator.probing().isRunning());
        QVERIFY(!calibrator.work().simulated);
        calibrator.probe();
        QVERIFY(calibrator.probing().isRunning());
        // And with its page, at the end of this test.
    }

    void pairsAreSavedAsTheyAreLoaded() {
        const QTemporaryDir folder;
        CameraCalibrator calibrator;
        QVERIFY(!action(calibrator, "Save pairs")->isEnabled());
        calibrate(calibrator);
        QVERIFY(action(calibrator, "Save pairs")->isEnabled());
        QSignalSpy told(&calibrator, &CameraCalibrator::message);
        calibrator.savePairs(folder.filePath("pairs.csv"));
        QVERIFY(told.wait(60'000));
        const auto read = vision::readPairs(folder.filePath("pairs.csv").toStdString());
        QVERIFY(read.has_value());
        QCOMPARE(read->size(), simulated().pairs.size());
        QCOMPARE(read->back().pixel, simulated().pairs.back().pixel);
    }

    void tooFewPairsAreRefusedInWords() {
        CameraCalibrator calibrator;
        QSignalSpy done(&calibrator, &CameraCalibrator::calibrated);
        calibrator.setPairs({{{1.0, 2.0}, {0.025, 0.0, 0.01}}});
        QVERIFY(done.wait(60'000));
        QVERIFY2(calibrator.verdict().contains("too few pairs"), qPrintable(calibrator.verdict()));
    }

    void aFileIsReadCalibratedAndItsCameraSaved() {
        const QTemporaryDir folder;
        const QString pairs = folder.filePath("pairs.csv");
        QFile file(pairs);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("u_px,v_px,x_m,y_m,z_m\n");
        for (const vision::CalibrationPair& pair : simulated().pairs)
            file.write(QStringLiteral("%1,%2,%3,%4,%5\n")
                           .arg(pair.pixel.x(), 0, 'g', 17)
                           .arg(pair.pixel.y(), 0, 'g', 17)
                           .arg(pair.p_Sensor_m.x(), 0, 'g', 17)
                           .arg(pair.p_Sensor_m.y(), 0, 'g', 17)
                           .arg(pair.p_Sensor_m.z(), 0, 'g', 17)
                           .toLatin1());
        file.close();
        CameraCalibrator calibrator;
        QSignalSpy done(&calibrator, &CameraCalibrator::calibrated);
        QVERIFY(calibrator.isSaved());
        calibrator.open(pairs);
        QVERIFY(done.wait(60'000));
        QVERIFY(calibrator.isSaved());
        QSignalSpy told(&calibrator, &CameraCalibrator::message);
        calibrator.save(folder.filePath("camera.json"));
        QVERIFY(told.wait(60'000));
        QCOMPARE(told[0][1].toBool(), false);
        const auto camera = vision::readCamera(folder.filePath("camera.json").toStdString());
        QVERIFY(camera.has_value());
        QCOMPARE(camera->summary.method, std::string("robust"));
    }

    void aDamagedFileIsToldWithItsPlace() {
        const QTemporaryDir folder;
        QFile file(folder.filePath("pairs.csv"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("u_px,v_px,x_m,y_m,z_m\n1,2,3,4,x\n");
        file.close();
        CameraCalibrator calibrator;
        QSignalSpy told(&calibrator, &CameraCalibrator::message);
        calibrator.open(file.fileName());
        QVERIFY(told.wait(60'000));
        QVERIFY(told[0][0].toString().contains("pairs.csv:2:9"));
        QVERIFY(told[0][1].toBool());
    }
};

QTEST_MAIN(CameraCalibratorTest)
#include "camera_calibrator_test.moc"
