// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QAction;
class QLabel;
class QTreeWidget;

namespace teleta::signal {

/// A signal of the plot, as the table lists it.
struct SignalRow {
    QString name;
    QString note; ///< why nothing is drawn; empty: it is
    QString unit;
    int colour = 1;
    bool isDerivative = false;
    bool hasSpectrum = false;
    bool operator==(const SignalRow& other) const = default;
};

/// Values of a signal at the cursors; empty: none there.
struct SignalReading {
    std::optional<double> a, b; ///< without cursors, a is the newest value
};

/// The signals of the plot: legend, values at the cursors and their differences, and what can be done with
/// each. Delete removes, D adds the derivative, S shows the spectrum. Thread: GUI.
class SignalTable : public QWidget {
    Q_OBJECT

public:
    explicit SignalTable(QWidget* parent = nullptr);

    void setRows(const std::vector<SignalRow>& rows);
    /// One a row. cursors: difference of their times; empty: there are no cursors.
    void setReadings(const std::vector<SignalReading>& readings, std::optional<double> cursors_s);

    [[nodiscard]] QTreeWidget& view() { return *m_view; }
    [[nodiscard]] QString times() const;
    /// Of the row that is chosen, for menus.
    [[nodiscard]] QList<QAction*> rowActions() const { return {m_derivative, m_spectrum, m_remove}; }

signals:
    void removeRequested(const std::vector<int>& rows);
    void derivativeRequested(int row);
    void spectrumRequested(int row, bool shown);

private:
    void retranslate();
    void labelColumns();
    void recolour();
    void showActions();
    [[nodiscard]] std::vector<int> chosenRows() const;

    std::vector<SignalRow> m_rows;
    QTreeWidget* m_view;
    QLabel* m_times;
    QAction* m_derivative;
    QAction* m_spectrum;
    QAction* m_remove;
    std::optional<double> m_cursors_s;
};

} // namespace teleta::signal
