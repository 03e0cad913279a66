// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/gel_snapshot.h"
#include "widgets/camera/event_list.h"

#include <cstddef>
#include <deque>

namespace teleta::camera {

/// Events of a flat gel, newest first; the oldest are dropped. Thread: GUI.
class GelEventModel : public EventListModel {
    Q_OBJECT
public:
    enum Column { time, event, contact, x, y, shear, slipIndex };
    static constexpr int kColumns = 7;
    static constexpr std::size_t kCapacity = 1000;

    explicit GelEventModel(QObject* parent = nullptr)
        : EventListModel(kColumns, parent) {}

    void append(const pipeline::GelEvent& happened) { putFirst(m_events, happened, kCapacity); }
    void clear() override { setEvents({}); }

    /// Moves out the events, newest first.
    [[nodiscard]] std::deque<pipeline::GelEvent> takeEvents();
    /// Restores events returned by takeEvents().
    void setEvents(std::deque<pipeline::GelEvent> events);

    /// One line per event: time_s,event,contact_id,x_m,y_m,shear_x_m,shear_y_m,slip_index.
    [[nodiscard]] QString csv() const override;

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_events.size()); }
    [[nodiscard]] QStringList titles() const override;

    std::deque<pipeline::GelEvent> m_events; ///< newest first
};

} // namespace teleta::camera
