// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/event_table.h"

namespace teleta::camera {

EventTable::EventTable(EventModel* model, QWidget* parent)
    : EventList(*model, parent)
    , m_model(model) {
    model->setParent(this);
    retranslate();
}

QString EventTable::fileName() const {
    return tr("camera-events");
}

QString EventTable::explanation() const {
    return tr("What happened to the tube, newest first. The context menu copies and saves the list.");
}

} // namespace teleta::camera
