// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/chrome/source_chooser.h"

#include <QHash>
#include <QHBoxLayout>
#include <QImage>
#include <QScrollArea>

#include <vector>

class QLabel;

namespace teleta::chrome {

class DemoCard;

/// All demo scenes as cards under the headings of their groups, in as many columns as there is room for; a
/// group is never torn apart. Where large cards do not fit they are small; it scrolls when these do not.
/// Thread: GUI.
class DemoList : public QScrollArea {
    Q_OBJECT

public:
    explicit DemoList(QWidget* parent = nullptr);

    void setDemos(const std::vector<SourceChooser::Demo>& demos);
    /// A picture of what a demo shows; unknown paths are ignored.
    void setPicture(const QString& path, const QImage& picture);

    [[nodiscard]] QSize sizeHint() const override;

signals:
    void demoRequested(const QString& path);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /// A heading and the cards below it.
    struct Group {
        QWidget* box = nullptr;
        QLabel* heading = nullptr;
        int cards = 0;
    };
    /// Which groups stand in which column, one below the other.
    struct Plan {
        bool isSmall = false;
        std::vector<std::vector<std::size_t>> columns;
        int height = 0;
        bool operator==(const Plan&) const = default;
    };

    [[nodiscard]] Plan planOf(bool isSmall, int width) const;
    void arrange();

    QHBoxLayout* m_row = new QHBoxLayout;
    std::vector<Group> m_groups;
    QHash<QString, DemoCard*> m_cards; ///< by the path of the demo
    Plan m_plan;
};

} // namespace teleta::chrome
