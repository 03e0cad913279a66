// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/pattern.h"

#include <QString>
#include <QWidget>

#include <vector>

class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace teleta::editor {

/// A pattern of one's own, by its file.
struct OwnPattern {
    QString path;
    QString name;
    double duration_s = 0.0;
};

/// The built-in patterns by what they tell, and one's own; with a filter. Thread: GUI.
class PatternLibrary : public QWidget {
    Q_OBJECT
public:
    explicit PatternLibrary(QWidget* parent = nullptr);

    void setOwn(std::vector<OwnPattern> own);
    /// Marks what is open: an id of a built-in pattern or a path.
    void setCurrent(const QString& idOrPath);
    [[nodiscard]] QTreeWidget* tree() const { return m_tree; }
    [[nodiscard]] QLineEdit* filter() const { return m_filter; }

signals:
    /// Id of a built-in pattern, or a path.
    void openRequested(const QString& idOrPath);
    void duplicateRequested(const QString& idOrPath);
    void compareRequested(const QString& idOrPath);

protected:
    void changeEvent(QEvent* event) override;

private:
    void fill();
    void applyFilter();
    void showMenu(const QPoint& at);

    QLineEdit* m_filter;
    QTreeWidget* m_tree;
    std::vector<OwnPattern> m_own;
    QString m_current;
};

} // namespace teleta::editor
