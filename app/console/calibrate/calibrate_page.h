// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/calibrate/camera/camera_calibrator.h"
#include "app/console/calibrate/gain_calibrator.h"
#include "app/console/calibrate/motor_calibrator.h"
#include "widgets/chrome/message_bar.h"

#include <QPointer>
#include <QString>
#include <QWidget>

#include <functional>

class QListWidget;
class QMessageBox;

namespace teleta::console {

class PageStack;

/// The Calibrate page: on the left what can be calibrated, on the right how. Thread: GUI.
class CalibratePage : public QWidget {
    Q_OBJECT

public:
    /// station and sources outlive this.
    CalibratePage(BraceletStation& station, SourceManager& sources, QWidget* parent = nullptr);

    [[nodiscard]] chrome::MessageBar& messages() { return *m_messages; }
    [[nodiscard]] MotorCalibrator& motors() { return *m_motors; }
    [[nodiscard]] CameraCalibrator& camera() { return *m_camera; }
    [[nodiscard]] GainCalibrator& gains() { return *m_gains; }
    /// Brings the camera forward and reads its pairs.
    void openPairs(const QString& path);
    /// Shows what the devices do.
    void tick();

    /// Something was calibrated that is in no file.
    [[nodiscard]] bool hasUnsaved() const;
    /// Goes on at once when there is no such thing; else brings one after another forward, asks whether it
    /// may be lost, and does not go on where it may not. It stays until then.
    void whenSettled(std::function<void()> goOn);

signals:
    /// A scene to try the calibration with.
    void demoRequested(const QString& scene);

protected:
    void changeEvent(QEvent* event) override;

private:
    void addPart(QWidget* content);
    [[nodiscard]] bool isSaved(int part) const;
    void settle(int part);
    void retranslate();

    chrome::MessageBar* m_messages;
    QListWidget* m_parts;
    PageStack* m_contents;
    MotorCalibrator* m_motors;
    CameraCalibrator* m_camera;
    GainCalibrator* m_gains;
    QPointer<QMessageBox> m_question;
    std::function<void()> m_goOn; ///< when all is answered
};

} // namespace teleta::console
