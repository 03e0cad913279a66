// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>
#include <QString>

#include <optional>
#include <vector>

namespace teleta::calibrate {

/// How far a calibration is.
enum class StepState { toDo, running, notSaved, done, failed };

struct StepReading {
    StepState state = StepState::toDo;
    int number = 0;                ///< of those of a step: the one that runs, else how many are done
    int of = 0;                    ///< 0: a step that is one thing
    std::optional<double> share{}; ///< of what runs, 0 .. 1; empty: not known
    bool operator==(const StepReading&) const = default;
};

/// The things to calibrate as a list of numbered steps. Each row has its name, its state as a word on a
/// coloured chip, and while it runs a bar along its lower edge. Thread: GUI.
class StepList : public QListWidget {
    Q_OBJECT

public:
    explicit StepList(int steps, QWidget* parent = nullptr);

    void setName(int step, const QString& name);
    void setReading(int step, const StepReading& reading);
    [[nodiscard]] const StepReading& reading(int step) const {
        return m_readings[static_cast<std::size_t>(step)];
    }
    /// What its chip says: "to do", "2 of 6 running", "done".
    [[nodiscard]] QString stateText(int step) const;

private:
    void describe(int step);
    void retranslate();
    void sizeRows();

    std::vector<StepReading> m_readings;
};

} // namespace teleta::calibrate
