// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QList>
#include <QObject>
#include <QStringList>

#include <array>

namespace teleta::view3d {

/// What of the 3-D view can be switched off, an action each. All are shown at first. Thread: GUI.
class SceneLayers : public QObject {
    Q_OBJECT
public:
    enum Layer {
        grid,
        axes,
        displacement,
        contactLabels,
        trail,
        jointLimits,
        forces,
        moments,
        scenery,
        kLayers,
    };

    explicit SceneLayers(QObject* parent = nullptr);

    [[nodiscard]] QAction* action(Layer layer) const { return m_actions[layer]; }
    [[nodiscard]] QList<QAction*> actions() const { return {m_actions.begin(), m_actions.end()}; }
    [[nodiscard]] bool shows(Layer layer) const { return m_actions[layer]->isChecked(); }
    /// Names the actions in the present language.
    void retranslate();
    /// Names of those that are switched off, for the settings.
    [[nodiscard]] QStringList hidden() const;
    /// Unknown names, of another version, are passed over.
    void setHidden(const QStringList& names);

signals:
    void changed();

private:
    std::array<QAction*, kLayers> m_actions{};
};

} // namespace teleta::view3d
