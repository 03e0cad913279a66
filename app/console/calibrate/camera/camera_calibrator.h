// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/calibrate/camera/calibration_work.h"
#include "app/console/calibrate/camera/camera_fits.h"
#include "backend/core/device/camera_source.h"
#include "backend/core/error.h"
#include "backend/vision/calibration/camera_file.h"
#include "backend/vision/camera/hole_grid.h"
#include "widgets/camera/residual_picture.h"

#include <QString>
#include <QWidget>

#include <cstddef>
#include <cstdint>
#include <functional>
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

class CameraProbing;
class LiveProbingPanel;
class PairEntry;
class ProbingStrip;
class TubeFields;

/// Calibration of the cylinder camera: pairs from a file, from probing with a camera or a simulated tube, or
/// typed in, four methods side by side, their residuals on the image and on the unrolled cylinder, pairs
/// excluded, removed and taken back with undo, pairs and camera saved. Files and fits run on pool threads;
/// while one runs, later changes wait for the next. Thread: GUI.
class CameraCalibrator : public QWidget {
    Q_OBJECT

public:
    using Answer = CameraAnswer;
    using Answers = CameraAnswers;
    /// What is fitted; every change of it can be undone.
    using Work = CalibrationWork;

    explicit CameraCalibrator(QWidget* parent = nullptr);
    ~CameraCalibrator() override;

    /// Reads pairs from a CSV file and calibrates.
    void open(const QString& path);
    /// Writes the camera of the chosen method; says so when a fit runs and there is none.
    void save(const QString& path);
    /// Writes all pairs, those that are left out too.
    void savePairs(const QString& path);
    /// In place of the present ones.
    void setPairs(std::vector<vision::CalibrationPair> pairs);
    void addPair(const vision::CalibrationPair& pair);
    void removePairs(const std::vector<std::size_t>& pairs);
    /// Uses pairs or leaves them out.
    void setUsed(const std::vector<std::size_t>& pairs, bool used);
    void setSettings(const vision::CalibrationSettings& settings);
    /// The pairs' points are holes of a shell: x and y times this are on the surface; > 0.
    void setHoleFactor(double factor);
    /// Collects pairs from a simulated tube, in place of the present ones.
    void probe(std::uint64_t seed = 1);
    [[nodiscard]] CameraProbing& probing() { return *m_probing; }
    /// Has a person lead a stick through the holes of a shell while a camera watches; pairs of the same tube
    /// and image stay, and a hole that has one is passed over.
    void probeWith(const std::function<core::Expected<std::unique_ptr<core::CameraSource>>()>& opener,
                   const vision::HoleGrid& grid);
    [[nodiscard]] LiveProbingPanel& live() { return *m_live; }
    void chooseMethod(vision::CalibrationMethod method);

    /// There are no pairs, or they are as in their file, or camera or pairs were saved since the last change.
    [[nodiscard]] bool isSaved() const;
    [[nodiscard]] QUndoStack& undoStack() { return *m_undo; }
    [[nodiscard]] const Work& work() const { return m_work; }
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
    class Edit;
    enum class File { pairs, camera };

    /// run: edits of the same one are undone together; 0: by itself.
    void edit(Work after, const QString& text, int run = 0);
    void buildProbing();
    void buildLive();
    void askForCamera();
    /// Tells the probing with a camera of the pairs, and ends it where its touches do not belong to them.
    void followProbing();
    void apply(const Work& work);
    void takeAnswers(Answers answers, const Work& fitted);
    void build();
    QWidget* buildTables();
    void buildTools();
    void fit();
    void refresh();
    void showComparison();
    void retranslate();
    void selectPair(std::size_t pair);
    void excludeOutliers();
    void toggle(std::size_t pair);
    [[nodiscard]] std::vector<std::size_t> selectedPairs() const;
    void sizeColumns();
    void askForFile(File file, bool save);
    /// Empty while a fit runs, and without a camera.
    [[nodiscard]] std::optional<vision::CameraFile> cameraFile() const;
    /// changes: what m_changes was for what is written; nothing is unsaved when it is so still.
    void saveCamera(const std::optional<vision::CameraFile>& file, const QString& path,
                    std::uint64_t changes);
    void write(const QString& path, std::uint64_t changes, std::function<core::Expected<void>()> writer);

    Work m_work;
    vision::CalibrationMethod m_method = vision::CalibrationMethod::robust;
    camera::CalibratedPairs m_shown;
    std::optional<Answers> m_answers;
    bool m_fitting = false;
    bool m_again = false;
    std::uint64_t m_changes = 0; ///< of the work
    int m_opened = 0;            ///< number of the newest file that was asked for
    QString m_file;

    QUndoStack* m_undo;
    QToolBar* m_tools;
    QAction* m_load;
    QAction* m_savePairs;
    QAction* m_save;
    QAction* m_exclude;
    QAction* m_toggle;
    QAction* m_remove;
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
    CameraProbing* m_probing;
    int m_probingRun = 0; ///< number of the newest probing
    QAction* m_probe;
    ProbingStrip* m_strip;
    LiveProbingPanel* m_live;
    QAction* m_probeWith;
    std::optional<vision::CalibrationSettings> m_probed; ///< with a camera: what its pairs belong to
    QString m_camera;                                    ///< that was probed with the last time
    vision::HoleGrid m_grid;
    QLabel* m_origin; ///< that the pairs are simulated
    TubeFields* m_tube;
    PairEntry* m_entry;
};

} // namespace teleta::console
