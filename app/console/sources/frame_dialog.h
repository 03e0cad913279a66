// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/frames/frame_request.h"

#include <QDialog>
#include <QString>

#include <string>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace teleta::console {

class FramePreview;

/// Asks what a file of frames leaves open: which array, its shape, columns of a table, times. Says first why
/// it is asked, and shows the first frames as they are read with what is chosen. Window modal, opened by the
/// user, never by a device. Thread: GUI.
class FrameDialog : public QDialog {
    Q_OBJECT

public:
    /// why: what is wrong with the file as it was read, a sentence. request: what was known of it.
    FrameDialog(const frames::FrameRequest& request, const QString& why, QWidget* parent = nullptr);

    [[nodiscard]] frames::FrameRequest request() const;

private:
    void check();
    void chooseLayout();
    void offerArrays(const std::vector<std::string>& names);

    frames::FrameRequest m_request;
    QComboBox* m_array;
    QLineEdit* m_layout;
    QComboBox* m_axis;
    QSpinBox* m_rows;
    QSpinBox* m_columns;
    QDoubleSpinBox* m_pitch_mm;
    QLineEdit* m_taxelColumns;
    QLineEdit* m_timeColumn;
    QComboBox* m_timeUnit;
    QDoubleSpinBox* m_rate_Hz;
    QDoubleSpinBox* m_threshold;
    QLabel* m_verdict;
    FramePreview* m_preview;
    QPushButton* m_accept;
};

} // namespace teleta::console
