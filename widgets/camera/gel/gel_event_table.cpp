// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/gel/gel_event_table.h"

namespace teleta::camera {

GelEventTable::GelEventTable(GelEventModel* model, QWidget* parent)
    : EventList(*model, parent)
    , m_model(model) {
    model->setParent(this);
    retranslate();
}

QString GelEventTable::fileName() const {
    return tr("gel-events");
}

QString GelEventTable::explanation() const {
    return tr("What happened to the gel, newest first. Shear is the mean displacement of the contact's "
              "markers less that of the others. The context menu copies and saves the list.");
}

} // namespace teleta::camera
