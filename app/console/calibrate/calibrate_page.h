// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/calibrate/camera/camera_calibrator.h"
#include "app/console/calibrate/gain_calibrator.h"
#include "app/console/calibrate/load_calibrator.h"
#include "app/console/calibrate/motor_calibrator.h"
#include "widgets/chrome/message_bar.h"

#include <QPointer>
#include <QString>
#include <QWidget>

#include <functional>

class QMessageBox;

namespace teleta::calibrate {
class StepList;
}

namespace teleta::console {

class PageStack;

/// The Calibrate page: the things to calibrate as numbered steps with their states on the left, the chosen
/// one on the right. Thread: GUI.
class CalibratePage : public QWidget {
    Q_OBJECT

public:
    /// station and sources must outlive this.
    CalibratePage(BraceletService& station, SourceManager& sources, QWidget* parent = nullptr);

    [[nodiscard]] chrome::MessageBar& messages() { return *m_messages; }
    [[nodiscard]] MotorCalibrator& motors() { return *m_motors; }
    [[nodiscard]] CameraCalibrator& camera() { return *m_camera; }
    [[nodiscard]] GainCalibrator& gains() { return *m_gains; }
    [[nodiscard]] LoadCalibrator& loads() { return *m_loads; }
    /// Shows the camera's calibration and reads pairs for it.
    void openPairs(const QString& path);
    /// Shows the state of the devices.
    void tick();

    /// A calibration has not been saved.
    [[nodiscard]] bool hasUnsaved() const;
    /// Calls goOn at once if everything is saved. Otherwise it shows one unsaved calibration after another
    /// and asks whether it may be lost; goOn is not called if the user refuses. The page must exist until
    /// then.
    void whenSettled(std::function<void()> goOn);
    /// Calls goOn when the taxel gains of this source are saved, or the person discards them.
    void whenGainsSettled(pipeline::ChannelKey key, const QString& name, std::function<void()> goOn);

signals:
    /// A scene to try the calibration with.
    void demoRequested(const QString& scene);

private:
    void addPart(QWidget* content);
    [[nodiscard]] bool isSaved(int part) const;
    [[nodiscard]] bool canSave(int part) const;
    /// done: called once it is saved.
    void save(int part, std::function<void()> done);
    void settle(int part);
    void retranslate();

    chrome::MessageBar* m_messages;
    calibrate::StepList* m_parts;
    PageStack* m_contents;
    MotorCalibrator* m_motors;
    CameraCalibrator* m_camera;
    GainCalibrator* m_gains;
    LoadCalibrator* m_loads;
    QPointer<QMessageBox> m_question;
    std::function<void()> m_goOn; ///< called when the user agreed to lose every unsaved calibration
};

} // namespace teleta::console
