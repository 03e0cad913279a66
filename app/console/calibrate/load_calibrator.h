// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "widgets/calibrate/loads_view.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <functional>

namespace teleta::console {

/// Calibrates signals of a sensor to newtons as `teleta loads fit` does: reads tables of presses, finds the
/// gains and handles files on pool threads. Thread: GUI; nothing blocks.
class LoadCalibrator : public QObject {
    Q_OBJECT

public:
    explicit LoadCalibrator(QWidget* parent);

    [[nodiscard]] calibrate::LoadsView& view() { return *m_view; }
    [[nodiscard]] bool isSaved() const { return m_view->isSaved(); }

    void openPresses(const QString& path);
    void fit(const QStringList& columns);
    void load(const QString& path);
    void save(const QString& path, const std::function<void()>& done = {});
    /// Whether there is something that can be saved.
    [[nodiscard]] bool canSave() const { return m_view->found() && !m_view->isSaved(); }
    /// Asks for a file for it. done: called once it is saved, not after a failure or a refusal.
    void askToSave(std::function<void()> done = {});

signals:
    void trouble(const QString& what, const QString& details);

private:
    /// work: run on a pool thread; what it finds replaces the calibration, and can be undone. isSaved: it is
    /// in a file already.
    void find(std::function<core::Expected<equilibration::LoadCalibration>()> work, bool isSaved);
    void showTrouble(const core::Error& error);

    calibrate::LoadsView* m_view;
    QString m_path; ///< of the table
};

} // namespace teleta::console
