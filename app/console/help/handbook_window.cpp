// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/help/handbook_window.h"

#include "app/common/translation.h"
#include "app/console/help/handbook.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QAction>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QFileInfo>
#include <QFont>
#include <QHBoxLayout>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QSignalBlocker>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace teleta::console {

namespace {

constexpr int kLineHeight_percent = 125;
constexpr double kFirstColumn_percent = 24.0;
constexpr int kPage = Qt::UserRole; ///< name of an item's page; a heading has none
constexpr double kWidest_em = 48.0; ///< widest picture

/// Shows pages of the handbook by name; QTextBrowser keeps the history.
class HandbookText : public QTextBrowser {
public:
    using QTextBrowser::QTextBrowser;

    /// Adds line spacing and cell padding, which Markdown cannot specify.
    void dress() {
        QTextCursor cursor(document());
        cursor.select(QTextCursor::Document);
        QTextBlockFormat lines;
        lines.setLineHeight(kLineHeight_percent, QTextBlockFormat::ProportionalHeight);
        cursor.mergeBlockFormat(lines);
        // A picture needs no room between lines, which would be a share of its own height.
        lines.setLineHeight(100.0, QTextBlockFormat::ProportionalHeight);
        for (QTextBlock block = document()->begin(); block.isValid(); block = block.next())
            if (!block.begin().atEnd() && block.begin().fragment().charFormat().isImageFormat())
                QTextCursor(block).mergeBlockFormat(lines);
        for (QTextFrame* frame : document()->rootFrame()->childFrames()) {
            auto* table = qobject_cast<QTextTable*>(frame);
            if (table == nullptr)
                continue;
            QTextTableFormat format = table->format();
            format.setBorder(0);
            format.setCellSpacing(0);
            format.setCellPadding(base::grid(this, 0.75));
            format.setMargin(base::grid(this));
            format.setColumnWidthConstraints(
                {QTextLength(QTextLength::PercentageLength, kFirstColumn_percent),
                 QTextLength(QTextLength::VariableLength, 0)});
            table->setFormat(format);
            for (int row = 0; row < table->rows(); row += 2) {
                for (int column = 0; column < table->columns(); ++column) {
                    QTextTableCell cell = table->cellAt(row, column);
                    QTextCharFormat ground = cell.format();
                    ground.setBackground(palette().alternateBase());
                    cell.setFormat(ground);
                }
            }
        }
    }

protected:
    /// A picture that is wider than the text is shown smaller, on a fine screen with all its dots.
    [[nodiscard]] QImage fitted(const QImage& picture) const {
        const double ratio = devicePixelRatioF();
        const int widest_px = qRound(base::em(this, kWidest_em) * ratio);
        if (picture.width() <= widest_px)
            return picture;
        QImage smaller = picture.scaledToWidth(widest_px, Qt::SmoothTransformation);
        smaller.setDevicePixelRatio(ratio);
        return smaller;
    }
    void doSetSource(const QUrl& url, QTextDocument::ResourceType) override {
        QTextBrowser::doSetSource(url, QTextDocument::MarkdownResource);
        dress();
    }
    void changeEvent(QEvent* event) override {
        QTextBrowser::changeEvent(event);
        if (event->type() == QEvent::PaletteChange)
            dress();
    }
    QVariant loadResource(int type, const QUrl& url) override {
        // The same in each language.
        if (type == QTextDocument::ImageResource)
            return fitted(QImage(QStringLiteral(":/handbook/pictures/") + QFileInfo(url.path()).fileName()));
        const auto page = handbookPage(QFileInfo(url.path()).completeBaseName(),
                                       app::installedLocale(*QCoreApplication::instance()).name());
        return page ? QVariant(page->text) : QTextBrowser::loadResource(type, url);
    }
};

QUrl urlOf(const QString& page) {
    return QUrl(page + QStringLiteral(".md"));
}

} // namespace

HandbookWindow::HandbookWindow(QWidget* parent)
    : QWidget(parent, Qt::Window)
    , m_list(new QListWidget(this))
    , m_text(new HandbookText(this))
    , m_search(new QLineEdit(this))
    , m_back(new QAction(this))
    , m_forward(new QAction(this))
    , m_find(new QAction(this))
    , m_close(new QAction(this)) {
    auto* bar = new QToolBar(this);
    m_back->setShortcuts(QKeySequence::Back);
    m_forward->setShortcuts(QKeySequence::Forward);
    m_find->setShortcuts(QKeySequence::Find);
    m_close->setShortcuts({QKeySequence(QKeySequence::Close), QKeySequence(Qt::Key_Escape)});
    bar->addAction(m_back);
    bar->addAction(m_forward);
    auto* space = new QWidget(bar);
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(space);
    m_search->setClearButtonEnabled(true);
    m_search->setMaximumWidth(base::em(this, 16));
    bar->addWidget(m_search);
    addActions({m_find, m_close});

    m_list->setMaximumWidth(base::em(this, 14));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setSpacing(base::grid(this, 0.25));
    m_text->setFrameShape(QFrame::NoFrame);
    m_text->setOpenExternalLinks(true);
    m_text->document()->setDocumentMargin(base::grid(this, 2));
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    row->addWidget(m_list);
    row->addWidget(m_text, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar);
    layout->addLayout(row, 1);
    resize(base::em(this, kWidest_em + 18), base::em(this, 48));

    connect(m_back, &QAction::triggered, m_text, &QTextBrowser::backward);
    connect(m_forward, &QAction::triggered, m_text, &QTextBrowser::forward);
    connect(m_text, &QTextBrowser::backwardAvailable, m_back, &QAction::setEnabled);
    connect(m_text, &QTextBrowser::forwardAvailable, m_forward, &QAction::setEnabled);
    m_back->setEnabled(false);
    m_forward->setEnabled(false);
    connect(m_close, &QAction::triggered, this, &QWidget::close);
    connect(m_find, &QAction::triggered, this, [this] {
        m_search->setFocus(Qt::ShortcutFocusReason);
        m_search->selectAll();
    });
    connect(m_search, &QLineEdit::returnPressed, this, &HandbookWindow::search);
    connect(m_list, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (item != nullptr && item->data(kPage).isValid())
            showPage(item->data(kPage).toString());
    });
    // Links, back and forward change the page too.
    connect(m_text, &QTextBrowser::sourceChanged, this, [this](const QUrl& url) {
        m_page = QFileInfo(url.path()).completeBaseName();
        markPage();
    });
    load();
    retranslate();
    base::onChange(this,
                   [this] {
                       load();
                       retranslate();
                   },
                   {QEvent::LanguageChange});
}

void HandbookWindow::showPage(const QString& name) {
    const QString known = handbookPages().contains(name) ? name : handbookPages().front();
    if (known != m_page)
        m_text->setSource(urlOf(known));
}

void HandbookWindow::load() {
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    const QString language = app::installedLocale(*QCoreApplication::instance()).name();
    for (const auto& [heading, pages] :
         {std::pair{tr("Guide"), handbookGuide()}, std::pair{tr("Reference"), handbookReference()}}) {
        auto* item = new QListWidgetItem(heading, m_list);
        item->setFlags(Qt::NoItemFlags);
        QFont bold = m_list->font();
        bold.setBold(true);
        item->setFont(bold);
        for (const QString& name : pages) {
            if (const auto page = handbookPage(name, language))
                (new QListWidgetItem(page->title, m_list))->setData(kPage, name);
        }
    }
    markPage();
    if (!m_page.isEmpty())
        m_text->reload();
}

void HandbookWindow::markPage() {
    const QSignalBlocker quiet(m_list);
    for (int row = 0; row < m_list->count(); ++row) {
        if (m_list->item(row)->data(kPage).toString() == m_page)
            m_list->setCurrentRow(m_page.isEmpty() ? -1 : row);
    }
}

void HandbookWindow::search() {
    const QString wanted = m_search->text();
    const QStringList pages = handbookPages();
    if (wanted.isEmpty() || m_text->find(wanted))
        return;
    // The next page with the text, from its top; this one last.
    const QString language = app::installedLocale(*QCoreApplication::instance()).name();
    const auto here = std::max<qsizetype>(pages.indexOf(m_page), 0);
    for (qsizetype step = 1; step <= pages.size(); ++step) {
        const QString& name = pages.at((here + step) % pages.size());
        const auto page = handbookPage(name, language);
        if (!page || !page->text.contains(wanted, Qt::CaseInsensitive))
            continue;
        showPage(name);
        m_text->moveCursor(QTextCursor::Start);
        if (m_text->find(wanted))
            return;
    }
}

void HandbookWindow::retranslate() {
    setWindowTitle(tr("Handbook of the TeleTA Console"));
    m_back->setText(tr("\u2190 Back"));
    m_forward->setText(tr("Forward \u2192"));
    m_find->setText(tr("Find"));
    m_close->setText(tr("Close"));
    m_search->setPlaceholderText(tr("Find in the handbook (Ctrl+F)"));
    m_search->setAccessibleName(tr("Find in the handbook"));
    m_list->setAccessibleName(tr("Pages of the handbook"));
    m_text->setAccessibleName(tr("Page of the handbook"));
}

} // namespace teleta::console
