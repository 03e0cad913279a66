// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/chrome/source_chooser.h"

#include <QGridLayout>
#include <QScrollArea>

#include <vector>

namespace teleta::chrome {

/// Scenes to try the program with, as large buttons in as many columns as fit. Thread: GUI.
class DemoList : public QScrollArea {
    Q_OBJECT

public:
    explicit DemoList(QWidget* parent = nullptr);

    void setDemos(const std::vector<SourceChooser::Demo>& demos);
    [[nodiscard]] int columns() const { return m_columns; }
    /// Height of all of them without scrolling, at the present width.
    [[nodiscard]] QSize sizeHint() const override;

signals:
    void demoRequested(const QString& path);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();

    QGridLayout* m_grid = new QGridLayout;
    std::vector<QWidget*> m_buttons;
    int m_columns = 0;
};

} // namespace teleta::chrome
