// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/chrome/source_chooser.h"

#include <QScrollArea>

#include <vector>

class QGridLayout;

namespace teleta::chrome {

/// Scenes to try the program with, each with a title and a sentence, as large buttons in as many columns as
/// fit. Thread: GUI.
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

    QGridLayout* m_grid;
    std::vector<QWidget*> m_buttons;
    int m_columns = 0;
};

} // namespace teleta::chrome
