// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/base/console_settings.h"
#include "app/console/plot/plot_layouts_menu.h"
#include "app/console/plot/plot_signals.h"
#include "widgets/chrome/message_bar.h"

#include <QElapsedTimer>
#include <QString>
#include <QStringList>
#include <QWidget>

#include <array>
#include <cstdint>
#include <utility>

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QMenu;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QToolButton;

namespace teleta::base {
class ProvenanceBadge;
}
namespace teleta::chrome {
class EmptyState;
}
namespace teleta::signal {
class SignalPlot;
class SignalTable;
class SignalTree;
} // namespace teleta::signal

namespace teleta::console {

/// The Plot page: the signals of all open sources and recordings as a tree, and those that were dropped onto
/// the plot or chosen by key, with cursors, derivatives and spectra. Thread: GUI.
class PlotPage : public QWidget {
    Q_OBJECT

public:
    PlotPage(SourceManager& sources, ConsoleSettings& settings, QWidget* parent = nullptr);

    /// A newest value in the list of signals: three digits, of small ones after the zeros.
    [[nodiscard]] static QString newestText(double value);

    [[nodiscard]] PlotSignals& plotSignals() { return *m_signals; }
    [[nodiscard]] signal::SignalPlot& plot() { return *m_plot; }
    [[nodiscard]] signal::SignalTable& table() { return *m_table; }
    [[nodiscard]] signal::SignalTree& tree() { return *m_tree; }
    [[nodiscard]] PlotLayoutsMenu& layouts() { return *m_layouts; }
    [[nodiscard]] chrome::MessageBar& messages() { return *m_messages; }

    /// Plots these signals and no others, SOURCE/STREAM/COLUMN each; one whose source is not open waits for
    /// it.
    void plotNamed(const QStringList& names);
    /// Takes what has come and draws it.
    void tick();
    /// Writes what is in view on a pool thread.
    void saveData(const QString& path);

signals:
    void demoRequested();

private:
    [[nodiscard]] QWidget* makeSignalColumn();
    [[nodiscard]] QWidget* makeToolBar();
    [[nodiscard]] QWidget* makeStatusLine();
    [[nodiscard]] QWidget* makeMiddle();
    void connectViews();
    void retranslate();
    void showSignals();
    void showSources();
    void showReadings();
    void showProgress();
    void showState();
    void setClockTime(bool clock);
    /// Signals of which no sample lies in view.
    [[nodiscard]] int outsideView() const;
    void refreshSpectra();
    void askForRecording();
    void askForData();
    void popUpMenu(const QPoint& global);
    [[nodiscard]] PlotLayout layoutNow() const;
    void restore(const PlotLayout& layout);
    [[nodiscard]] QString valueText(const signal::SignalId& id) const;

    PlotSignals* m_signals;
    chrome::MessageBar* m_messages;
    PlotLayoutsMenu* m_layouts;
    signal::SignalTree* m_tree;
    QPushButton* m_addRecording;
    QProgressBar* m_progress;
    QToolButton* m_cancelReading;
    QCheckBox* m_follow;
    QToolButton* m_everything;
    QCheckBox* m_cursors;
    QCheckBox* m_density;
    QComboBox* m_time;
    QToolButton* m_layoutsButton;
    QToolButton* m_saveButton;
    QMenu* m_saveMenu;
    std::array<base::ProvenanceBadge*, 4> m_badges{}; ///< what counts for most first
    QWidget* m_status;
    QLabel* m_state;
    QStackedWidget* m_stack;
    chrome::EmptyState* m_empty;
    signal::SignalPlot* m_plot;
    signal::SignalTable* m_table;
    QAction* m_undo;

    QElapsedTimer m_valuesShown;
    QElapsedTimer m_spectraComputed;
    std::pair<double, double> m_spectraOf{0.0, 0.0}; ///< time range
    std::uint64_t m_spectraAppended = 0;
    bool m_hadSignals = false;
};

} // namespace teleta::console
