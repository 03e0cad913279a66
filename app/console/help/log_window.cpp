// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/help/log_window.h"

#include "widgets/base/background.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/chrome/message_log.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QSaveFile>
#include <QScrollBar>
#include <QShortcut>
#include <QSysInfo>
#include <QTableView>
#include <QVBoxLayout>

namespace teleta::console {

void beginLog() {
    chrome::MessageLog& log = chrome::MessageLog::instance();
    log.append(chrome::Message::Severity::information,
               QStringLiteral("%1 %2, Qt %3, %4, %5, %6")
                   .arg(QCoreApplication::applicationName(), QCoreApplication::applicationVersion(),
                        QString::fromLatin1(qVersion()), QSysInfo::prettyProductName(),
                        QSysInfo::currentCpuArchitecture(), QGuiApplication::platformName()));
    log.takeQtMessages();
}

LogWindow::LogWindow(QWidget* parent)
    : QWidget(parent, Qt::Window)
    , m_table(new QTableView)
    , m_copy(new QPushButton)
    , m_save(new QPushButton)
    , m_close(new QPushButton) {
    chrome::MessageLog& log = chrome::MessageLog::instance();
    m_table->setModel(&log);
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->setColumnWidth(chrome::MessageLog::kTime, base::em(this, 8.0));
    m_table->setColumnWidth(chrome::MessageLog::kKind, base::em(this, 8.0));
    QScrollBar& bar = *m_table->verticalScrollBar();
    connect(&log, &QAbstractItemModel::rowsInserted, m_table, [this, &bar] {
        if (bar.value() >= bar.maximum() - 1)
            m_table->scrollToBottom();
    });

    connect(m_copy, &QPushButton::clicked, this,
            [] { QGuiApplication::clipboard()->setText(chrome::MessageLog::instance().asText()); });
    connect(m_save, &QPushButton::clicked, this, &LogWindow::save);
    connect(m_close, &QPushButton::clicked, this, &QWidget::close);
    connect(new QShortcut(QKeySequence(Qt::Key_Escape), this), &QShortcut::activated, this, &QWidget::close);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_copy);
    buttons->addWidget(m_save);
    buttons->addStretch(1);
    buttons->addWidget(m_close);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_table, 1);
    layout->addLayout(buttons);
    resize(base::em(this, 70.0), base::em(this, 30.0));
    base::keepTranslated(this, &LogWindow::retranslate);
}

void LogWindow::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_table->scrollToBottom(); // only now it has its size
}

void LogWindow::save() {
    base::askToSave(this,
                    {.title = tr("Save log"),
                     .filters = {tr("Text (*.txt)")},
                     .suffix = QStringLiteral("txt"),
                     .name = QStringLiteral("teleta-console.txt")},
                    [this](const QString& path) { write(path); });
}

void LogWindow::write(const QString& path) {
    const auto written = [path, text = chrome::MessageLog::instance().asText().toUtf8()] {
        QSaveFile file(path);
        const bool done = file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit();
        return done ? QString() : file.errorString();
    };
    base::runInBackground(this, written, [path](const QString& trouble) {
        using Severity = chrome::Message::Severity;
        // The log itself is visible: report it there.
        if (trouble.isEmpty())
            chrome::MessageLog::instance().append(Severity::information, tr("Saved %1").arg(path));
        else
            chrome::MessageLog::instance().append(Severity::error,
                                                  tr("%1 could not be saved: %2").arg(path, trouble));
    });
}

void LogWindow::retranslate() {
    setWindowTitle(tr("Log"));
    m_table->setAccessibleName(tr("Messages since the program started"));
    m_copy->setText(tr("&Copy"));
    m_save->setText(tr("&Save\u2026"));
    m_close->setText(tr("C&lose"));
}

} // namespace teleta::console
