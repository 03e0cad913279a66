// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/camera_calibration.h"
#include "widgets/camera/residual_picture.h"

#include <QString>
#include <QWidget>

#include <array>
#include <memory>
#include <optional>
#include <vector>

class QAction;
class QComboBox;
class QLabel;
class QTableView;
class QTableWidget;
class QToolBar;
class QUndoStack;

namespace teleta::camera {
class PairModel;
class ResidualView;
} // namespace teleta::camera

namespace teleta::console {

/// Calibration of the cylinder camera: pairs from a file, four methods side by side, their residuals on the
/// image and on the unrolled cylinder, pairs excluded and taken back with undo, the camera saved. Files and
/// fits run on pool threads; while one runs, later changes wait for the next. Thread: GUI.
class CameraCalibrator : public QWidget {
    Q_OBJECT

public:
    /// What one method makes of the pairs.
    struct Answer {
        std::optional<vision::Calibration> calibration; ///< residuals of all pairs, also of excluded ones
        QString refusal;                                ///< why there is none
    };
    using Answers = std::array<Answer, vision::kCalibrationMethods.size()>;

    explicit CameraCalibrator(QWidget* parent = nullptr);
    ~CameraCalibrator() override;

    /// Reads pairs from a CSV file and calibrates.
    void open(const QString& path);
    /// Writes the camera of the chosen method.
    void save(const QString& path);
    void setPairs(std::vector<vision::CalibrationPair> pairs);
    /// Uses pairs or leaves them out; can be undone.
    void setUsed(const std::vector<std::size_t>& pairs, bool used);
    void chooseMethod(vision::CalibrationMethod method);

    [[nodiscard]] QUndoStack& undoStack() { return *m_undo; }
    [[nodiscard]] const camera::CalibratedPairs& shown() const { return m_shown; }
    /// Of the chosen method; empty while nothing was fitted.
    [[nodiscard]] const Answer* answer() const;
    [[nodiscard]] bool isBusy() const { return m_fitting; }
    [[nodiscard]] QString verdict() const;

signals:
    /// Something for the message bar of the page.
    void message(const QString& text, bool isError);
    /// All methods have answered.
    void calibrated();

protected:
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    friend class UseCommand;
    void applyUsed(const std::vector<std::size_t>& pairs, bool used);
    void build();
    void buildTools();
    void fit();
    void refresh();
    void showComparison();
    void retranslate();
    void selectPair(std::size_t pair);
    void excludeOutliers();
    void toggle(std::size_t pair);
    void askForFile(bool save);

    vision::CalibrationSettings m_settings;
    vision::CalibrationMethod m_method = vision::CalibrationMethod::robust;
    camera::CalibratedPairs m_shown;
    std::optional<Answers> m_answers;
    bool m_fitting = false;
    bool m_again = false;
    QString m_file;

    QUndoStack* m_undo;
    QToolBar* m_tools;
    QAction* m_load;
    QAction* m_save;
    QAction* m_exclude;
    QAction* m_undoAction;
    QAction* m_redoAction;
    QLabel* m_methodLabel;
    QComboBox* m_methods;
    QLabel* m_verdict;
    QTableWidget* m_comparison;
    camera::ResidualView* m_image;
    camera::ResidualView* m_cylinder;
    camera::PairModel* m_model;
    QTableView* m_table;
};

} // namespace teleta::console
