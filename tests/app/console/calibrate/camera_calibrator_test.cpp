// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/camera_calibrator.h"
#include "backend/vision/camera_file.h"
#include "tests/backend/vision/simulated_pairs.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

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
        calibrator.chooseMethod(CalibrationMethod::dlt);
        QVERIFY2(calibrator.verdict().contains("no lens") || calibrator.verdict().contains("No calibration"),
                 qPrintable(calibrator.verdict()));
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
        QCOMPARE(calibrator.undoStack().count(), 1);
        calibrator.undoStack().undo();
        QVERIFY(done.wait(60'000));
        QVERIFY(calibrator.shown().used[3]);
        calibrator.undoStack().redo();
        QVERIFY(!calibrator.shown().used[3]);
        calibrator.setUsed({3}, false);
        QCOMPARE(calibrator.undoStack().count(), 1);
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
        calibrator.open(pairs);
        QVERIFY(done.wait(60'000));
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
