// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/signal/signal_name.h"

#include <QString>
#include <QWidget>

#include <functional>
#include <vector>

class QLineEdit;
class QModelIndex;
class QSortFilterProxyModel;
class QTreeView;

namespace teleta::signal {

class SignalModel;

/// A source with its streams, as the tree lists it.
struct SourceEntry {
    struct Stream {
        std::string name;
        std::vector<recording::Column> columns;
        std::vector<QString> meanings = {}; ///< of the columns, in words; may be fewer, or empty
        bool operator==(const Stream& other) const;
    };
    std::string name;
    QString note; ///< beside the name; may be empty
    std::vector<Stream> streams;
    bool operator==(const SourceEntry& other) const;
};

/// All signals as a tree: source, stream, signal with its unit and its newest value; a search above it.
/// Signals can be dragged away, a double click or Enter chooses them. Thread: GUI.
class SignalTree : public QWidget {
    Q_OBJECT

public:
    explicit SignalTree(QWidget* parent = nullptr);

    /// Asked for each signal in view whenever it is painted; empty: nothing is known.
    void setValues(std::function<QString(const SignalId&)> valueOf);
    /// What was open or chosen stays so.
    void setSources(const std::vector<SourceEntry>& sources);
    /// Paints newer values.
    void refreshValues();

    [[nodiscard]] QTreeView& view() { return *m_view; }
    [[nodiscard]] QLineEdit& search() { return *m_search; }
    [[nodiscard]] std::vector<SignalId> selected() const;

signals:
    void chosen(const std::vector<signal::SignalId>& signalIds);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void onSearch(const QString& text);
    void retranslate();
    void choose();

    std::vector<SourceEntry> m_sources;
    QLineEdit* m_search;
    QTreeView* m_view;
    SignalModel* m_model;
    QSortFilterProxyModel* m_found;
};

} // namespace teleta::signal
