// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/motors/motor_model.h"
#include "backend/study/protocol/trial.h"
#include "widgets/base/compose.h"
#include "widgets/study/results/level_content.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QString>

#include <memory>
#include <optional>

namespace teleta::study {

class ResultTable;

/// The motors of the connected bracelet.
struct BraceletMotors {
    QString name;
    pattern::MotorProfiles profiles;
    bool simulated = false;
};

/// What a task says of the bracelet: the best timing of a motion, how many intensities can be told apart, and
/// the full drives at which all tactors are equally strong, which can be used for the connected bracelet.
/// Thread: GUI.
class BraceletView : public QScrollArea {
    Q_OBJECT

public:
    explicit BraceletView(QWidget* parent = nullptr);

    /// results: with the task; null: none. motors: empty without a bracelet. mode: of the study; what
    /// simulated participants felt cannot be used for a real bracelet.
    void setContent(std::shared_ptr<const LevelResults> results, const QString& task,
                    const ConditionNames& names, const std::optional<BraceletMotors>& motors, Mode mode);

signals:
    /// Full drives that the user wants for the connected bracelet.
    void useRequested(const teleta::pattern::MotorProfiles& balanced, const QString& from);
    void figureFailed(const QString& message);

private:
    struct Section {
        QLabel* title = nullptr;
        ResultTable* table = nullptr;
    };
    [[nodiscard]] Section addSection(const char* name);
    void fillPeople();
    void showStrength();
    void retranslate();

    std::shared_ptr<const LevelResults> m_results;
    QString m_task;
    std::optional<BraceletMotors> m_motors;
    Mode m_mode = Mode::run;
    std::optional<pattern::MotorProfiles> m_balanced;
    QWidget* m_content = new QWidget;
    Section m_onsets;
    Section m_steps;
    Section m_strength;
    QWidget* m_line;
    QLabel* m_whoLabel;
    QComboBox* m_who;
    QLabel* m_note;
    QPushButton* m_use;
};

} // namespace teleta::study
