// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/chrome/recent_name.h"

#include <QComboBox>
#include <QMenu>
#include <QString>
#include <QToolButton>
#include <QWidget>

#include <cstdint>
#include <vector>

namespace teleta::chrome {

/// The source shown, and the ways to open another one. Thread: GUI.
class SourceChooser : public QWidget {
    Q_OBJECT

public:
    struct Source {
        std::uint64_t key = 0;
        QString name;
        base::Provenance provenance = base::Provenance::live;
        bool opening = false;
    };
    struct Demo {
        QString path;
        QString title;
        QString description;
        QString group; ///< heading; demos of a group follow each other
    };

    explicit SourceChooser(QWidget* parent = nullptr);

    void setSources(const std::vector<Source>& sources, std::uint64_t active);
    void setDemos(const std::vector<Demo>& demos);
    void setRecent(const QStringList& paths);
    /// What the menu calls them; a file of an unknown name has that of the file.
    void setRecentNames(const RecentNames& names);

    /// The menu of sources to open, for the File menu too.
    [[nodiscard]] QMenu* openMenu() const { return m_menu; }

signals:
    void sourceChosen(std::uint64_t key);
    void closeRequested(std::uint64_t key);
    void demoRequested(const QString& path);
    void openRecordingRequested();
    void openSceneRequested();
    void openCameraRequested();
    void openArmRequested();
    void openListRequested();
    void recentRequested(const QString& path);

private:
    void rebuildMenu();
    void retranslate();

    QComboBox* m_box = new QComboBox(this);
    base::ProvenanceBadge* m_badge = new base::ProvenanceBadge(this);
    QToolButton* m_open = new QToolButton(this);
    QToolButton* m_close = new QToolButton(this);
    QMenu* m_menu = new QMenu(this);
    std::vector<Source> m_sources;
    std::vector<Demo> m_demos;
    RecentNames m_recentNames;
    QStringList m_recent;
};

} // namespace teleta::chrome
