// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/message_log.h"

#include <QCoreApplication>
#include <QPointer>
#include <QStringList>

#include <utility>

namespace teleta::chrome {

namespace {

QPointer<MessageLog> theLog;
QtMessageHandler theHandlerBefore = nullptr;

void handleQtMessage(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    if (theHandlerBefore != nullptr)
        theHandlerBefore(type, context, text);
    if (type == QtDebugMsg || QCoreApplication::instance() == nullptr || theLog.isNull())
        return;
    const auto severity = type == QtInfoMsg      ? Message::Severity::information
                          : type == QtWarningMsg ? Message::Severity::warning
                                                 : Message::Severity::error;
    theLog->append(severity, text);
}

/// Joins the lines of a text.
QString line(const QString& text) {
    return text.split(u'\n', Qt::SkipEmptyParts).join(QStringLiteral(" \u00b7 "));
}

} // namespace

MessageLog& MessageLog::instance() {
    if (theLog.isNull())
        theLog = new MessageLog(QCoreApplication::instance());
    return *theLog;
}

void MessageLog::append(Message::Severity severity, const QString& text) {
    // Always through the event loop: a view of the log may have caused the message.
    QMetaObject::invokeMethod(
        this, [this, entry = Entry{QDateTime::currentDateTime(), severity, text}] { add(entry); },
        Qt::QueuedConnection);
}

void MessageLog::append(const Message& message) {
    QStringList parts{message.text};
    for (const QString& part : {message.advice, message.details}) {
        if (!part.isEmpty())
            parts << part;
    }
    append(message.severity, parts.join(u'\n'));
}

void MessageLog::takeQtMessages() {
    if (theHandlerBefore == nullptr)
        theHandlerBefore = qInstallMessageHandler(handleQtMessage);
}

void MessageLog::add(Entry entry) {
    if (m_entries.size() >= static_cast<std::size_t>(kKept)) {
        beginRemoveRows({}, 0, 0);
        m_entries.pop_front();
        endRemoveRows();
    }
    const int row = rowCount();
    beginInsertRows({}, row, row);
    m_entries.push_back(std::move(entry));
    endInsertRows();
}

QString MessageLog::kindOf(Message::Severity severity) {
    return severity == Message::Severity::error     ? tr("Error")
           : severity == Message::Severity::warning ? tr("Warning")
                                                    : tr("Information");
}

QString MessageLog::asText() const {
    QString text;
    for (const Entry& entry : m_entries)
        text += QStringLiteral("%1 %2: %3\n")
                    .arg(entry.time.toString(Qt::ISODateWithMs), kindOf(entry.severity), line(entry.text));
    return text;
}

int MessageLog::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_entries.size());
}

int MessageLog::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kColumns;
}

QVariant MessageLog::data(const QModelIndex& index, int role) const {
    if (!index.isValid())
        return {};
    const Entry& entry = m_entries[static_cast<std::size_t>(index.row())];
    if (role == Qt::ToolTipRole)
        return entry.text;
    if (role != Qt::DisplayRole)
        return {};
    return index.column() == kTime   ? entry.time.toString(QStringLiteral("HH:mm:ss.zzz"))
           : index.column() == kKind ? kindOf(entry.severity)
                                     : line(entry.text);
}

QVariant MessageLog::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    return section == kTime ? tr("Time") : section == kKind ? tr("Kind") : tr("Message");
}

} // namespace teleta::chrome
