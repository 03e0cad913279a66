// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/calibrate/camera/calibration_work.h"
#include "backend/core/device/camera_source.h"
#include "backend/core/error.h"
#include "backend/vision/calibration/camera_file.h"
#include "backend/vision/camera/hole_grid.h"
#include "widgets/calibrate/step_list.h"
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
class QLayout;
class QPushButton;
class QTableView;
class QTableWidget;
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

/// Calibrates the cylinder camera: pairs from a file, typed in, or probed with a camera or a simulated tube;
/// four methods side by side; residuals on the image and on the unrolled cylinder; pairs are excluded and
/// removed with undo; pairs and camera are saved. Files and fits run on pool threads; changes made during a
/// fit are fitted afterwards. Thread: GUI.
class CameraCalibrator : public QWidget {
    Q_OBJECT

public:
    using Answer = CameraAnswer;
    using Answers = CameraAnswers;
    /// The data to fit; every change can be undone.
    using Work = CalibrationWork;

    explicit CameraCalibrator(QWidget* parent = nullptr);
    ~CameraCalibrator() override;

    /// Reads pairs from a CSV file and fits them.
    void open(const QString& path);
    /// Saves the camera of the chosen method, or reports that there is none.
    void save(const QString& path);
    /// Whether a camera was found that can be saved.
    [[nodiscard]] bool canSave() const { return cameraFile().has_value() && !isSaved(); }
    /// Asks for a file for it. done: called once it is saved, not after a failure or a refusal.
    void askToSave(std::function<void()> done = {});
    /// Saves all pairs, including excluded ones.
    void savePairs(const QString& path);
    /// Replaces the present ones.
    void setPairs(std::vector<vision::CalibrationPair> pairs);
    void addPair(const vision::CalibrationPair& pair);
    void removePairs(const std::vector<std::size_t>& pairs);
    /// Includes or excludes pairs.
    void setUsed(const std::vector<std::size_t>& pairs, bool used);
    void setSettings(const vision::CalibrationSettings& settings);
    /// Sets the factor from the holes of a shell to the surface, for x and y of the pairs' points; > 0.
    void setHoleFactor(double factor);
    /// Collects pairs from a simulated tube; they replace the present ones.
    void probe(std::uint64_t seed = 1);
    [[nodiscard]] CameraProbing& probing() { return *m_probing; }
    /// Starts a probing with a camera: a person presses a stick through the holes of a shell. Pairs of the
    /// same tube and image are kept, and holes that have a pair are skipped.
    void probeWith(const std::function<core::Expected<std::unique_ptr<core::CameraSource>>()>& opener,
                   const vision::HoleGrid& grid);
    [[nodiscard]] LiveProbingPanel& live() { return *m_live; }
    void chooseMethod(vision::CalibrationMethod method);

    /// Whether nothing would be lost: there are no pairs, they are as in their file, or camera or pairs were
    /// saved since the last change.
    [[nodiscard]] bool isSaved() const;
    [[nodiscard]] QUndoStack& undoStack() { return *m_undo; }
    [[nodiscard]] const Work& work() const { return m_work; }
    [[nodiscard]] const camera::CalibratedPairs& shown() const { return m_shown; }
    /// Fit of the chosen method; empty until there is one.
    [[nodiscard]] const Answer* answer() const;
    [[nodiscard]] bool isBusy() const { return m_fitting; }
    [[nodiscard]] QString verdict() const;
    [[nodiscard]] calibrate::StepReading step() const;

signals:
    /// A message for the page's message bar.
    void message(const QString& text, bool isError);
    /// All methods have finished.
    void calibrated();

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    class Edit;

    /// run: edits with the same number are undone together; 0: alone.
    void edit(Work after, const QString& text, int run = 0);
    void buildProbing();
    void buildLive();
    void askForCamera();
    /// Passes the pairs on to the probing with a camera, and ends it if its touches no longer belong to them.
    void followProbing();
    void apply(const Work& work);
    void takeAnswers(Answers answers, const Work& fitted);
    void build();
    QWidget* buildTables();
    void buildTools();
    QLayout* buildHead();
    void fit();
    void refresh();
    void showComparison();
    void retranslate();
    void selectPair(std::size_t pair);
    void excludeOutliers();
    void toggle(std::size_t pair);
    [[nodiscard]] std::vector<std::size_t> selectedPairs() const;
    void sizeColumns();
    /// Empty while a fit runs, and without a camera.
    [[nodiscard]] std::optional<vision::CameraFile> cameraFile() const;
    /// changes: value of m_changes for the written data; if it is still the same, everything is saved.
    void saveCamera(const std::optional<vision::CameraFile>& file, const QString& path, std::uint64_t changes,
                    const std::function<void()>& done = {});
    void write(const QString& path, std::uint64_t changes, std::function<core::Expected<void>()> writer,
               const std::function<void()>& done = {});

    Work m_work;
    vision::CalibrationMethod m_method = vision::CalibrationMethod::robust;
    camera::CalibratedPairs m_shown;
    std::optional<Answers> m_answers;
    bool m_fitting = false;
    bool m_again = false;
    std::uint64_t m_changes = 0; ///< of the work
    int m_opened = 0;            ///< number of the last requested file
    QString m_file;

    QUndoStack* m_undo;
    QLabel* m_title;
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
    double m_probedShare = 0.0; ///< of the simulated tube
    int m_probingRun = 0;       ///< number of the newest probing
    QAction* m_probe;
    QPushButton* m_probeButton; ///< the filled one while there are no pairs
    ProbingStrip* m_strip;
    LiveProbingPanel* m_live;
    QAction* m_probeWith;
    std::optional<vision::CalibrationSettings> m_probed; ///< settings of the pairs probed with a camera
    QString m_camera;                                    ///< of the last probing
    vision::HoleGrid m_grid;
    QLabel* m_origin; ///< label saying that the pairs are simulated
    TubeFields* m_tube;
    PairEntry* m_entry;
};

} // namespace teleta::console
