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

void SceneLayers::retranslate() {
    const auto layer = [this](Layer which, const QString& text, const QString& help) {
        m_actions[which]->setText(text);
        m_actions[which]->setToolTip(help);
        m_actions[which]->setWhatsThis(help);
    };
    layer(grid, tr("Grid"), tr("Show the ground with a grid in millimetres"));
    layer(axes, tr("Axes"), tr("Show the axes of the array's frame"));
    layer(displacement, tr("Displacement"), tr("Show how far each contact moved since it began"));
    layer(contactLabels, tr("Contact labels"), tr("Show number and force at each contact"));
    layer(trail, tr("Trail of the tip"), tr("Show where the arm's tip was in the last 5 s"));
    layer(jointLimits, tr("Joint limits"),
          tr("Show range and angle of each joint that is near the end of its range"));
    layer(forces, tr("Forces"), tr("Show forces as arrows"));
    layer(moments, tr("Moments"),
          tr("Show the moment of the loads on a flat array about their centre, as an arrow that turns"));
    layer(scenery, tr("Objects of the scene"), tr("Show what a simulated scene has around the arm"));
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
