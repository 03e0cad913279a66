// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/equilibration/taxel_gains.h"

#include <QString>
#include <QWidget>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

class QLabel;
class QProgressBar;
class QPushButton;
class QUndoStack;

namespace teleta::calibrate {

class GainMap;

/// What the calibration has to know of the array.
struct ArrayFacts {
    QString name; ///< empty: no array is open
    bool simulated = false;
    bool recorded = false;
    bool tared = false;
    std::size_t usable = 0; ///< taxels that are not dead
    std::size_t loaded = 0; ///< of these, over the threshold now

    bool operator==(const ArrayFacts&) const = default;
};

/// How far the collection of a press is.
struct PressProgress {
    bool waiting = true; ///< for a load on more than half of the taxels
    double collected_s = 0.0;
    double wanted_s = 1.0;
};

/// Raw frames of one press, and how the array was read then: what it is compared with must not be a later
/// tare.
struct RecordedPress {
    std::vector<float> frames;
    contact::ConditioningSettings conditioning;
};
using Press = std::shared_ptr<const RecordedPress>;

/// Frames of which the gains of an array's taxels were made, and the gains.
struct GainCalibration {
    std::vector<Press> presses;
    std::shared_ptr<const equilibration::TaxelGains> gains; ///< null: every taxel counts as it is
};

/// The calibration of an array's taxels: tare it, press on all of it as often as one likes, look at the
/// gains. Every change can be undone, a press too. It collects and computes nothing and does no file I/O: it
/// asks for that. Thread: GUI.
class GainsView : public QWidget {
    Q_OBJECT
public:
    explicit GainsView(QWidget* parent = nullptr);
    ~GainsView() override;

    void setFacts(const ArrayFacts& facts);
    /// Of another array, as it is in use: nothing is left to undo.
    void setCalibration(const GainCalibration& calibration, bool isSaved = true);
    /// In place of what was known; can be undone.
    void take(const GainCalibration& calibration, const QString& text);
    [[nodiscard]] const GainCalibration& calibration() const { return m_calibration; }
    [[nodiscard]] bool isSaved() const;
    void markSaved();

    /// A press is being collected; empty: none is.
    void setProgress(const std::optional<PressProgress>& progress);
    /// Frames are being read or gains found: nothing can be changed meanwhile.
    void setBusy(bool busy);
    /// Why nothing has changed.
    void showTrouble(const QString& text);

    [[nodiscard]] GainMap* map() const { return m_map; }
    [[nodiscard]] QPushButton* button(const char* name) const;
    [[nodiscard]] QString verdict() const;
    [[nodiscard]] QString state() const;
    void undo();
    void redo();

signals:
    void tareRequested();
    void collectRequested();
    void endRequested();
    void pressFilesRequested();
    void loadRequested();
    void saveRequested();
    void demoRequested();
    /// By a person: is to take effect at once.
    void calibrationChanged(const teleta::calibrate::GainCalibration& calibration);
    void exportFailed(const QString& message);

protected:
    void changeEvent(QEvent* event) override;

private:
    class Edit;

    QWidget* makeSteps();
    QPushButton* addButton(const char* name, QWidget* parent);
    void apply(const GainCalibration& calibration);
    void refresh();
    void retranslate();
    void showReadout();
    [[nodiscard]] QString describeGains() const;

    ArrayFacts m_facts;
    GainCalibration m_calibration;
    std::optional<PressProgress> m_pressing;
    bool m_busy = false;
    QString m_trouble;
    QUndoStack* m_undo;
    QLabel* m_title;
    QLabel* m_state;
    QLabel* m_tareText;
    QLabel* m_pressText;
    QLabel* m_loadText;
    QProgressBar* m_progress;
    QLabel* m_verdict;
    GainMap* m_map;
    QLabel* m_readout;
    QLabel* m_none;
};

} // namespace teleta::calibrate
