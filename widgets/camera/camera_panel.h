// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/camera_snapshot.h"
#include "widgets/base/controls/badge.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace teleta::camera {

class CameraView;
class ReactionRow;
class StageBar;

/// The camera in the soft tube: its picture, the arm's reaction to contacts, the rung of the ladder that
/// finds them, and the time it takes. Requests are signals; the state in use comes back with the snapshot.
/// Thread: GUI.
class CameraPanel : public QWidget {
    Q_OBJECT
public:
    explicit CameraPanel(QWidget* parent = nullptr);

    /// Null: no camera; the panel is disabled. nominalRate_Hz: of the camera; 0: unknown.
    void setSnapshot(const pipeline::CameraSnapshot* snapshot, double nominalRate_Hz = 0.0);
    void setProvenance(base::Provenance provenance);

    [[nodiscard]] CameraView& view() const { return *m_view; }
    [[nodiscard]] StageBar& stages() const { return *m_stages; }
    [[nodiscard]] bool isPaused() const;

public slots:
    void setPaused(bool paused);

signals:
    void rungChosen(const QString& name);
    void referenceRequested();
    void mayReactChanged(bool mayReact);
    void exportFailed(const QString& message);

private:
    void retranslate();
    void showTexts();

    QComboBox* m_rungs;
    QToolButton* m_pause;
    QCheckBox* m_arrows;
    QPushButton* m_reference;
    QLabel* m_rungName;
    QLabel* m_problem;
    ReactionRow* m_arm;
    CameraView* m_view;
    StageBar* m_stages;

    // From the newest snapshot.
    bool m_hasCamera = false;
    QString m_why;
    QString m_whyRefused; ///< why the requested finder cannot be used
    QString m_nextRung;   ///< being prepared
    bool m_hasReference = false;
    QString m_wish; ///< requested rung that is not in use yet
};

} // namespace teleta::camera
