// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/controls/badge.h"
#include "widgets/base/figure/figure_export.h"
#include "widgets/camera/event_model.h"

#include <QWidget>

class QTableView;

namespace teleta::camera {

/// List of the tube's events, newest first. Ctrl+C copies it as CSV. Thread: GUI.
class EventTable : public QWidget {
    Q_OBJECT
public:
    explicit EventTable(QWidget* parent = nullptr);

    void append(const pipeline::CameraEvent& event) { m_model->append(event); }
    void clear() { m_model->clear(); }
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
    base::FigureExport* m_export;
};

} // namespace teleta::camera
