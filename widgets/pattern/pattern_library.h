// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pattern/model/pattern.h"
#include "widgets/base/compose.h"

#include <QIcon>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSize>
#include <QString>
#include <QStringList>
#include <QTreeWidget>
#include <QWidget>

#include <map>
#include <memory>
#include <utility>
#include <vector>

class QTreeWidgetItem;

namespace teleta::pattern {

/// One of the user's own patterns, by its file.
struct OwnPattern {
    QString path;
    QString name;
    double duration_s = 0.0;
    QStringList tags;
    QString notes;
    QString problem; ///< why the file cannot be read; empty if it can
    bool renamable = true;
    std::shared_ptr<const Pattern> pattern{}; ///< for its picture; null if it cannot be read
};

/// List of the built-in patterns by task and of the user's own ones, with a filter over names, tags and ids,
/// and keys and a menu to open, rename, duplicate, compare and delete. Does no file I/O but emits requests.
/// Thread: GUI.
class PatternLibrary : public QWidget {
    Q_OBJECT
public:
    explicit PatternLibrary(QWidget* parent = nullptr);

    void setOwn(std::vector<OwnPattern> own);
    /// Marks the open pattern by a bar and bold letters, and selects it as soon as it is in the list; until
    /// then nothing is selected. idOrPath: id of a built-in pattern, or a path.
    void setCurrent(const QString& idOrPath);
    /// Shows a line below the list about the last change, with a button that undoes it.
    void setNotice(const QString& text, bool undoable);
signals:
    /// Id of a built-in pattern, or a path.
    void openRequested(const QString& idOrPath);
    void duplicateRequested(const QString& idOrPath);
    void compareRequested(const QString& idOrPath);
    void renameRequested(const QString& path, const QString& name);
    void deleteRequested(const QString& path);
    /// Undo the last deletion or renaming.
    void undoRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /// What all pictures depend on.
    struct PictureStyle {
        QSize size;
        double scale = 0.0;
        qint64 palette = 0;
        bool operator==(const PictureStyle&) const = default;
    };

    void fill();
    void addOwn(QTreeWidgetItem* group, const OwnPattern& own);
    /// A small picture of a pattern, drawn once; the open one has a bar in front.
    [[nodiscard]] QIcon pictureOf(const QString& key, const Pattern& pattern);
    void refill();
    /// Where names would be cut otherwise it hides the lengths, which the editor shows too, and then makes
    /// the pictures smaller. Returns whether the pictures' size changed.
    bool fitPictures();
    void applyFilter();
    void showMenu(const QPoint& at);
    void rename(const QString& key);
    [[nodiscard]] const OwnPattern* ownOf(const QString& key) const;
    [[nodiscard]] QString currentKey() const;

    QLineEdit* m_filter = base::named<QLineEdit>("filter", this);
    QTreeWidget* m_tree = new QTreeWidget(this);
    QLabel* m_notice = new QLabel(this);
    QPushButton* m_undo = base::named<QPushButton>("undo", this);
    PictureStyle m_pictureStyle;
    std::map<std::pair<QString, bool>, QIcon> m_pictures; ///< by key, and whether it is open
    std::vector<OwnPattern> m_own;
    QString m_current;
    QString m_wanted; ///< to be selected; empty: keep the selection
};

} // namespace teleta::pattern
