// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/controls/badge.h"
#include "widgets/base/figure/figure_export.h"
#include "widgets/base/titled_model.h"

#include <QString>
#include <QWidget>

class QTableView;

namespace teleta::camera {

/// Events of a camera, newest first. Thread: GUI.
class EventListModel : public base::TitledModel {
public:
    using TitledModel::TitledModel;
    static constexpr int kEventColumn = 1; ///< the one with words
    /// Titles stand over their cells: words at the left, numbers at the right.
    [[nodiscard]] static int alignmentOf(int column) {
        return int(Qt::AlignVCenter | (column == kEventColumn ? Qt::AlignLeft : Qt::AlignRight));
    }
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
        return orientation == Qt::Horizontal && role == Qt::TextAlignmentRole
                   ? QVariant(alignmentOf(section))
                   : TitledModel::headerData(section, orientation, role);
    }
    virtual void clear() = 0;
    /// One line per event, the oldest first; C locale, NA where unknown.
    [[nodiscard]] virtual QString csv() const = 0;
};

/// Shows such a list. Ctrl+C copies it as CSV. Thread: GUI.
class EventList : public QWidget {
    Q_OBJECT
public:
    void clear() { m_list.clear(); }
    void setProvenance(base::Provenance provenance);
    [[nodiscard]] QTableView& table() const { return *m_table; }

signals:
    void exported(const QString& path);
    void exportFailed(const QString& message);

protected:
    /// model: outlives it.
    EventList(EventListModel& model, QWidget* parent);
    /// Of an exported file.
    [[nodiscard]] virtual QString fileName() const = 0;
    [[nodiscard]] virtual QString explanation() const = 0;
    /// Once the views are made, and when language or colours change.
    void retranslate();
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] base::Figure figure() const;

    EventListModel& m_list;
    QTableView* m_table;
    base::FigureExport* m_export;
};

} // namespace teleta::camera
