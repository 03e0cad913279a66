// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/camera/event_list.h"
#include "widgets/camera/gel/gel_event_model.h"

namespace teleta::camera {

/// List of the events of a flat gel. Thread: GUI.
class GelEventTable : public EventList {
    Q_OBJECT
public:
    explicit GelEventTable(QWidget* parent = nullptr)
        : GelEventTable(new GelEventModel, parent) {}

    void append(const pipeline::GelEvent& event) { m_model->append(event); }
    [[nodiscard]] GelEventModel& model() const { return *m_model; }

private:
    GelEventTable(GelEventModel* model, QWidget* parent);
    [[nodiscard]] QString fileName() const override;
    [[nodiscard]] QString explanation() const override;

    GelEventModel* m_model;
};

} // namespace teleta::camera
