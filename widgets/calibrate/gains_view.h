// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/frame_conditioner.h"
#include "backend/equilibration/taxel_gains.h"
#include "backend/equilibration/unevenness.h"
#include "widgets/base/controls/elided_label.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/calibrate/calibration_view.h"
#include "widgets/calibrate/gain_map.h"
#include "widgets/calibrate/step_list.h"

#include <QBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QString>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace teleta::calibrate {

/// State of the array.
struct ArrayFacts {
    QString name; ///< empty: no array is open
    bool simulated = false;
    bool recorded = false;
    bool tared = false;
    std::size_t usable = 0; ///< taxels that are not dead
    std::size_t loaded = 0; ///< usable taxels above the threshold now

    bool operator==(const ArrayFacts&) const = default;
};

/// Progress of collecting a press.
struct PressProgress {
    bool waiting = true; ///< for a load on more than half of the taxels
    double collected_s = 0.0;
    double wanted_s = 1.0;
};

/// Raw frames of one press, with the settings used to read them: a later tare must not change them.
struct RecordedPress {
    std::vector<float> frames;
    contact::ConditioningSettings conditioning;
};
using Press = std::shared_ptr<const RecordedPress>;

/// The gains of an array's taxels, and the presses that they were computed from.
struct GainCalibration {
    std::vector<Press> presses;
    std::shared_ptr<const equilibration::TaxelGains> gains; ///< null: all gains are 1
};

/// Calibrates an array's taxels: tare it, press on the whole array any number of times, look at the gains.
/// Every added press can be undone. The view computes nothing itself: it emits requests. Thread: GUI.
class GainsView : public CalibrationView {
    Q_OBJECT
public:
    explicit GainsView(QWidget* parent = nullptr);

    void setFacts(const ArrayFacts& facts);
    /// Takes a picture of the loads of the array, to be shown before and beside the gains.
    void setLivePicture(QWidget* picture);
    /// Of the newest frame; empty while the array is not pressed evenly enough to tell.
    void setUnevenness(const std::optional<equilibration::Unevenness>& unevenness);
    /// Shows the gains of another array and clears the undo history.
    void setCalibration(const GainCalibration& calibration, bool isSaved = true);
    /// Replaces the present calibration; can be undone.
    void take(const GainCalibration& calibration);
    [[nodiscard]] const GainCalibration& calibration() const { return m_calibration; }

    /// Progress of the press being collected; empty: none.
    void setProgress(const std::optional<PressProgress>& progress);
    /// While frames are read or gains computed nothing can be changed.
    void setBusy(bool busy);
    /// Shows why nothing has changed.
    void showTrouble(const QString& text);
    [[nodiscard]] StepReading step() const;

signals:
    void tareRequested();
    void collectRequested();
    void endRequested();
    void pressFilesRequested();
    void demoRequested();
    /// The calibration has changed and takes effect at once.
    void calibrationChanged(const teleta::calibrate::GainCalibration& calibration);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeSteps();
    void apply(const GainCalibration& calibration);
    void undo() override;
    void redo() override;
    void refresh() override;
    void showUnevenness();
    void retranslate();
    [[nodiscard]] QString describeGains() const;

    ArrayFacts m_facts;
    GainCalibration m_calibration;
    std::optional<PressProgress> m_pressing;
    bool m_busy = false;
    QString m_trouble;
    QLabel* m_tareText = new QLabel(this);
    QLabel* m_pressText = new QLabel(this);
    QLabel* m_loadText = new QLabel(this);
    QProgressBar* m_progress = new QProgressBar(this);
    GainMap* m_map = new GainMap(this);
    QLabel* m_readout = new base::ElidedLabel(this);
    QLabel* m_uneven = new QLabel(this);
    QBoxLayout* m_pictures = new QBoxLayout(QBoxLayout::TopToBottom);
    bool m_isUneven = false; ///< whether that is known
    base::SteadyNumber m_with;
    base::SteadyNumber m_without;
};

} // namespace teleta::calibrate
