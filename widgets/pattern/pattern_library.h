// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"

#include <QString>
#include <QStringList>
#include <QWidget>

#include <vector>

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace teleta::editor {

/// A pattern of one's own, by its file.
struct OwnPattern {
    QString path;
    QString name;
    double duration_s = 0.0;
    QStringList tags;
    QString notes;
    QString problem; ///< why the file cannot be read; empty: it can
    bool renamable = true;
};

/// The built-in patterns by what they tell, and one's own: a filter over names, tags and ids; keys and a menu
/// to open, rename, duplicate, compare and delete. It asks for all of that; it does no file I/O. Thread: GUI.
class PatternLibrary : public QWidget {
    Q_OBJECT
public:
    explicit PatternLibrary(QWidget* parent = nullptr);

    void setOwn(std::vector<OwnPattern> own);
    /// Marks what is open by a sign and bold letters, and selects it, now or as soon as it is in the list: an
    /// id of a built-in pattern or a path.
    void setCurrent(const QString& idOrPath);
    /// A line below the list on what was done last; with a button that undoes it.
    void setNotice(const QString& text, bool undoable);
    [[nodiscard]] QTreeWidget* tree() const { return m_tree; }
    [[nodiscard]] QLineEdit* filter() const { return m_filter; }
    [[nodiscard]] QPushButton* undoButton() const { return m_undo; }

signals:
    /// Id of a built-in pattern, or a path.
    void openRequested(const QString& idOrPath);
    void duplicateRequested(const QString& idOrPath);
    void compareRequested(const QString& idOrPath);
    void renameRequested(const QString& path, const QString& name);
    void deleteRequested(const QString& path);
    /// The last deletion or new name is to be taken back.
    void undoRequested();

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fill();
    void addOwn(QTreeWidgetItem* group, const OwnPattern& own);
    void applyFilter();
    void showMenu(const QPoint& at);
    void rename(const QString& key);
    [[nodiscard]] const OwnPattern* ownOf(const QString& key) const;
    [[nodiscard]] QString currentKey() const;

    QLineEdit* m_filter;
    QTreeWidget* m_tree;
    QLabel* m_notice;
    QPushButton* m_undo;
    std::vector<OwnPattern> m_own;
    QString m_current;
    QString m_wanted; ///< to be selected; empty: what is selected stays
};

} // namespace teleta::editor
