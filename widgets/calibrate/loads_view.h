// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/equilibration/load_calibration.h"
#include "widgets/calibrate/calibration_view.h"
#include "widgets/calibrate/step_list.h"

#include <QString>
#include <QStringList>

#include <memory>

class QLabel;
class QListWidget;
class QTableWidget;

namespace teleta::base {
class PictureCard;
}

namespace teleta::calibrate {

/// A table of presses with a known load.
struct PressTable {
    QString name{};        ///< of its file; empty: none
    QStringList loads{};   ///< its columns that are loads
    QStringList columns{}; ///< the others, which may be signals
};

using LoadsFound = std::shared_ptr<const equilibration::LoadCalibration>;

/// Calibrates signals of a sensor to newtons: open a table of presses with a known load, choose the columns
/// that are signals, look at the gains. Every result can be undone. The view computes nothing itself: it
/// emits requests. Thread: GUI.
class LoadsView : public CalibrationView {
    Q_OBJECT
public:
    explicit LoadsView(QWidget* parent = nullptr);

    /// Shows another table. Columns that were signals before are chosen again.
    void setTable(const PressTable& table);
    [[nodiscard]] const PressTable& table() const { return m_table; }
    /// The columns that are chosen, in their order in the table.
    [[nodiscard]] QStringList chosen() const;

    /// Replaces the present calibration; can be undone.
    void take(const LoadsFound& found);
    [[nodiscard]] const LoadsFound& found() const { return m_found; }

    /// While a table is read or gains are computed nothing can be changed.
    void setBusy(bool busy);
    /// Shows why nothing has changed.
    void showTrouble(const QString& text);
    [[nodiscard]] StepReading step() const;

signals:
    void pressesRequested();
    void fitRequested(const QStringList& columns);

private:
    void undo() override;
    void redo() override;
    void refresh() override;
    void fillResult();
    void retranslate();
    [[nodiscard]] QString describeFound() const;

    PressTable m_table;
    LoadsFound m_found;
    bool m_busy = false;
    QString m_trouble;
    QLabel* m_openText;
    QLabel* m_chooseText;
    QListWidget* m_columns;
    QTableWidget* m_result;
    base::PictureCard* m_none;
};

} // namespace teleta::calibrate
