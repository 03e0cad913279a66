// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene_layers.h"

#include "widgets/view3d/view_icons.h"

namespace teleta::view3d {

namespace {

constexpr std::array kNames{"grid",        "axes",   "displacement", "contactLabels", "trail",
                            "jointLimits", "forces", "moments",      "scenery"};
static_assert(kNames.size() == SceneLayers::kLayers);

} // namespace

SceneLayers::SceneLayers(QObject* parent)
    : QObject(parent) {
    for (std::size_t i = 0; i < m_actions.size(); ++i) {
        auto* layer = new QAction(this);
        layer->setObjectName(QLatin1String(kNames[i]));
        layer->setCheckable(true);
        layer->setChecked(true);
        connect(layer, &QAction::toggled, this, &SceneLayers::changed);
        m_actions[i] = layer;
    }
    // The first three are on the tool bar.
    m_actions[grid]->setIcon(viewIcon(ViewIcon::grid));
    m_actions[axes]->setIcon(viewIcon(ViewIcon::axes));
    m_actions[displacement]->setIcon(viewIcon(ViewIcon::displacement));
}

QStringList SceneLayers::hidden() const {
    QStringList names;
    for (const QAction* layer : m_actions)
        if (!layer->isChecked())
            names << layer->objectName();
    return names;
}

void SceneLayers::setHidden(const QStringList& names) {
    for (QAction* layer : m_actions)
        layer->setChecked(!names.contains(layer->objectName()));
}

} // namespace teleta::view3d
