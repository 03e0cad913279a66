// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/files/pattern_format.h"

#include <QDialog>
#include <QString>

class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;

namespace teleta::console {

/// Asks in which format a pattern is to be written, and for samples at which rate and of what; then where.
/// Writes nothing. Thread: GUI.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    /// motors: of predicted samples. suggested: path without an ending.
    ExportDialog(pattern::MotorProfiles motors, QString suggested, QWidget* parent = nullptr);

    /// As in the list of formats.
    void choose(pattern::PatternFormat format);
    [[nodiscard]] pattern::SampleOptions samples() const;
    [[nodiscard]] QString ending() const;
    [[nodiscard]] QDoubleSpinBox* rateBox() const { return m_rate; }
    [[nodiscard]] QComboBox* contentBox() const { return m_content; }

signals:
    void chosen(const QString& path, const teleta::pattern::SampleOptions& samples);

private:
    void showFormat();
    void askWhere();

    pattern::MotorProfiles m_motors;
    QString m_suggested;
    QComboBox* m_format;
    QLabel* m_about;
    QDoubleSpinBox* m_rate;
    QComboBox* m_content;
    QDialogButtonBox* m_buttons;
};

} // namespace teleta::console
