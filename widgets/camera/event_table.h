// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/camera_snapshot.h"
#include "widgets/base/controls/badge.h"
#include "widgets/base/figure_export.h"

#include <QWidget>

class QLabel;
class QTableView;

namespace teleta::camera {

class EventModel;

/// List of the tube's events, newest first. Ctrl+C copies it as CSV. Thread: GUI.
class EventTable : public QWidget {
    Q_OBJECT
public:
    explicit EventTable(QWidget* parent = nullptr);

    void append(const pipeline::CameraEvent& event);
    void clear();
    void setProvenance(base::Provenance provenance);
    [[nodiscard]] EventModel& model() const { return *m_model; }
    [[nodiscard]] QTableView& table() const { return *m_table; }

signals:
    void exported(const QString& path);
    void exportFailed(const QString& message);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void retranslate();
    [[nodiscard]] base::Figure figure() const;

    EventModel* m_model;
    QTableView* m_table;
    QLabel* m_provenance;
    base::Provenance m_shownProvenance = base::Provenance::live;
    base::FigureExport* m_export;
};

} // namespace teleta::camera
