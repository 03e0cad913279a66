// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include <cstdint>
#include <vector>

class QLabel;
class QTableWidget;
class QTableWidgetItem;

namespace teleta::console {

/// The marks of a recording, with time and note. A note is edited in its row, Delete
/// removes a mark, Ctrl+Z undoes; double-clicking a time, or a mark that cannot be edited, seeks there.
/// Thread: GUI.
class MarkList : public QWidget {
    Q_OBJECT

public:
    struct Row {
        std::uint64_t number = 0;
        double time_s = 0.0;
        QString text;

        friend bool operator==(const Row&, const Row&) = default;
    };

    explicit MarkList(QWidget* parent = nullptr);

    void setMarks(std::vector<Row> rows, bool editable);
    [[nodiscard]] const std::vector<Row>& marks() const { return m_rows; }
    /// Starts editing the text of a mark.
    void edit(std::uint64_t number);
    /// Accepts the text that is being typed, like Enter.
    void finishEditing();

signals:
    void renamed(std::uint64_t number, const QString& text);
    void removed(std::uint64_t number);
    void timeChosen(double time_s);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void rebuild();
    /// The item of a cell, created if missing.
    QTableWidgetItem* itemAt(int row, int column);
    void retranslate();

    QTableWidget* m_table;
    QLabel* m_hint;
    QLabel* m_fixed; ///< why marks cannot be changed
    std::vector<Row> m_rows;
    bool m_editable = false;
    bool m_building = false;
};

} // namespace teleta::console
