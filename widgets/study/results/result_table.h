// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure_export.h"

#include <QStringList>
#include <QTableWidget>

#include <vector>

namespace teleta::studyview {

/// What a cell shows, and what its file has, in the C locale; data empty: the same.
struct ResultCell {
    QString shown;
    QString data = {};
};

/// A table of results that is as high as its rows, and copies and saves its data. Thread: GUI.
class ResultTable : public QTableWidget {
    Q_OBJECT

public:
    /// name: of the file.
    explicit ResultTable(QString name, QWidget* parent = nullptr);

    /// header: one a column; tips: explanations of the columns, may be fewer.
    void setRows(const QStringList& header, const QStringList& tips,
                 const std::vector<std::vector<ResultCell>>& rows);
    [[nodiscard]] QString csv() const;
    [[nodiscard]] base::FigureExport& exporter() { return *m_export; }

protected:
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    QString m_name;
    base::FigureExport* m_export;
};

} // namespace teleta::studyview
