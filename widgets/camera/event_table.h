// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/camera/event_list.h"
#include "widgets/camera/event_model.h"

namespace teleta::camera {

/// List of the tube's events. Thread: GUI.
class EventTable : public EventList {
    Q_OBJECT
public:
    explicit EventTable(QWidget* parent = nullptr)
        : EventTable(new EventModel, parent) {}

    void append(const pipeline::CameraEvent& event) { m_model->append(event); }
    [[nodiscard]] EventModel& model() const { return *m_model; }

private:
    EventTable(EventModel* model, QWidget* parent);
    [[nodiscard]] QString fileName() const override;
    [[nodiscard]] QString explanation() const override;

    EventModel* m_model;
};

} // namespace teleta::camera
