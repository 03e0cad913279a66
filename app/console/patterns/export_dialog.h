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

/// Asks for the format of an exported pattern, the rate and content of samples, and the file. Writes nothing.
/// Thread: GUI.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    /// motors: for predicted samples. suggested: path without extension.
    ExportDialog(pattern::MotorProfiles motors, QString suggested, QWidget* parent = nullptr);

    /// Selects a format in the list.
    void choose(pattern::PatternFormat format);
    [[nodiscard]] pattern::SampleOptions samples() const;
    [[nodiscard]] QString ending() const;

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
    QComboBox* m_signal; ///< of a WAV file
    QDoubleSpinBox* m_carrier;
    QDialogButtonBox* m_buttons;
};

} // namespace teleta::console
