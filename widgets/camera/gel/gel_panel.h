// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/gel_snapshot.h"
#include "widgets/base/controls/badge.h"
#include "widgets/base/numbers/number_format.h"

#include <QString>
#include <QWidget>

#include <cstddef>
#include <cstdint>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace teleta::camera {

class GelView;
class ReactionRow;

/// A flat gel with markers: its picture, what is wrong with it, and the button that takes the gel at rest
/// anew. Requests are signals. Thread: GUI.
class GelPanel : public QWidget {
    Q_OBJECT
public:
    explicit GelPanel(QWidget* parent = nullptr);

    /// Null: no gel; the panel is disabled.
    void setSnapshot(const pipeline::GelSnapshot* snapshot);
    void setProvenance(base::Provenance provenance);

    [[nodiscard]] GelView& view() const { return *m_view; }
    [[nodiscard]] bool isPaused() const;

public slots:
    void setPaused(bool paused);

signals:
    void referenceRequested();
    void mayReactChanged(bool mayReact);
    void exportFailed(const QString& message);

private:
    void retranslate();
    void showTexts();
    [[nodiscard]] QString counts() const;

    QCheckBox* m_arrows;
    QLabel* m_enlargementName;
    QComboBox* m_enlargement;
    QPushButton* m_reference;
    QToolButton* m_pause;
    QLabel* m_problem;
    QLabel* m_counts;
    ReactionRow* m_arm;
    GelView* m_view;

    // From the newest snapshot.
    bool m_hasGel = false;
    bool m_hasReference = false;
    bool m_usable = false;
    QString m_why;
    std::size_t m_missing = 0, m_markers = 0, m_found = 0;
    std::uint64_t m_passedOver = 0, m_unusable = 0;
    base::SteadyNumber m_work_ms{0.1};
    base::SteadyNumber m_rate_Hz{0.5};
};

} // namespace teleta::camera
