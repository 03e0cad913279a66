// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure/figure_export.h"

#include <QStringList>
#include <QTableWidget>

#include <vector>

namespace teleta::study {

/// A cell's text, and its value in files, in the C locale; data empty: the same.
struct ResultCell {
    QString shown;
    QString data = {};
};

/// A table of results, as high as its rows, that can be copied and saved. A long text in the last column
/// is wrapped where the table would be wider than its room. Thread: GUI.
class ResultTable : public QTableWidget {
    Q_OBJECT

public:
    /// name: of the file.
    explicit ResultTable(QString name, QWidget* parent = nullptr);

    /// header: one per column; tips: explanations of the columns, may be fewer.
    void setRows(const QStringList& header, const QStringList& tips,
                 const std::vector<std::vector<ResultCell>>& rows);
    [[nodiscard]] QString csv() const;
    [[nodiscard]] base::FigureExport& exporter() { return *m_export; }

protected:
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void fitColumns();

    QString m_name;
    base::FigureExport* m_export;
};

} // namespace teleta::study
