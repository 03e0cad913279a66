// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sources/source_request.h"

#include <QDialog>

class QCheckBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace teleta::console {

/// Asks how a recording is to be read: shape of the array, tare, sign, gain, threshold, rate. Filled in with
/// what the file itself tells. Window modal, opened by the user, never by a device. Thread: GUI.
class RecordingDialog : public QDialog {
    Q_OBJECT

public:
    RecordingDialog(app::CsvRequest request, QWidget* parent = nullptr);

    [[nodiscard]] app::CsvRequest request() const;

private:
    void check();
    /// A line for a file, with a button that asks for it.
    QHBoxLayout* fileRow(QLineEdit* line, const QString& toolTip, const QString& title,
                         const QString& filter);

    app::CsvRequest m_request;
    std::size_t m_taxels;
    QSpinBox* m_rows;
    QSpinBox* m_columns;
    QDoubleSpinBox* m_pitch_mm;
    QLineEdit* m_tare;
    QLineEdit* m_gains;
    QCheckBox* m_inverted;
    QDoubleSpinBox* m_gain;
    QDoubleSpinBox* m_threshold;
    QLineEdit* m_unit;
    QDoubleSpinBox* m_rate_Hz;
    QCheckBox* m_loop;
    QLabel* m_verdict;
    QPushButton* m_accept;
};

} // namespace teleta::console
