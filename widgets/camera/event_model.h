// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/camera_snapshot.h"
#include "widgets/camera/event_list.h"

#include <cstddef>
#include <deque>

namespace teleta::camera {

/// Events of the tube, newest first; the oldest are dropped. Thread: GUI.
class EventModel : public EventListModel {
    Q_OBJECT
public:
    enum Column { time, event, contact, along, around, depth };
    static constexpr int kColumns = 6;
    static constexpr std::size_t kCapacity = 1000;

    explicit EventModel(QObject* parent = nullptr)
        : EventListModel(kColumns, parent) {}

    void append(const pipeline::CameraEvent& event);
    void clear() override { setEvents({}); }

    /// Moves out the events, newest first.
    [[nodiscard]] std::deque<pipeline::CameraEvent> takeEvents();
    /// Restores events returned by takeEvents().
    void setEvents(std::deque<pipeline::CameraEvent> events);

    /// One line per event: time_s,event,contact_id,x_m,y_m,z_m,depth_m; C locale, NA where unknown.
    [[nodiscard]] QString csv() const override;

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_events.size()); }
    [[nodiscard]] QStringList titles() const override;

    std::deque<pipeline::CameraEvent> m_events; ///< newest first
};

} // namespace teleta::camera
