// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/chrome/message_bar.h"

#include <QAbstractTableModel>
#include <QDateTime>
#include <QString>

#include <deque>

namespace teleta::chrome {

/// All messages since the program started, newest last: the notices of all views and the messages of Qt and
/// the libraries. One per program. Thread: GUI; append() from any.
class MessageLog : public QAbstractTableModel {
    Q_OBJECT

public:
    static constexpr int kKept = 5000; ///< older ones are dropped
    enum Column { kTime, kKind, kText, kColumns };

    /// The program's log; the first call, on the GUI thread, creates it.
    static MessageLog& instance();

    void append(Message::Severity severity, const QString& text);
    void append(const Message& message);
    /// From now on Qt messages are also added here.
    void takeQtMessages();
    /// One line per entry: time (ISO 8601, to the millisecond), kind, text.
    [[nodiscard]] QString asText() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    using QAbstractTableModel::QAbstractTableModel;

    struct Entry {
        QDateTime time;
        Message::Severity severity = Message::Severity::information;
        QString text;
    };
    void add(Entry entry);
    [[nodiscard]] static QString kindOf(Message::Severity severity);

    std::deque<Entry> m_entries;
};

} // namespace teleta::chrome
